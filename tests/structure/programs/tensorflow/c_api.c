/* A program against TensorFlow's C API: a tensor, and the version of the library that was found. */
#include <stdio.h>
#include <tensorflow/c/c_api.h>

int main(void) {
  const int64_t shape[] = {2, 3};
  TF_Tensor* tensor = TF_AllocateTensor(TF_FLOAT, shape, 2, 6 * sizeof(float));
  if (TF_TensorByteSize(tensor) != 6 * sizeof(float)) return 1;
  TF_DeleteTensor(tensor);
  printf("tensorflow %s\n", TF_Version());
  return 0;
}
