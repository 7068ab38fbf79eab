/* The C API, with the header's path of ONNX Runtime's own sources. */
#include <onnxruntime/core/session/onnxruntime_c_api.h>
#include <stdio.h>

int main(void) {
  const OrtApiBase* base = OrtGetApiBase();
  if (!base->GetApi(ORT_API_VERSION)) return 1;
  printf("onnxruntime %s, interface %d\n", base->GetVersionString(), ORT_API_VERSION);
  return 0;
}
