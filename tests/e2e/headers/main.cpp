// headers MODULE: each part twice, in turns.
//
// A library of the program and TensorFlow's would find each other's functions of protobuf, of which both export the same
// names; linked into one program, one of them crashes. Loaded so, TensorFlow finds its own and nobody finds TensorFlow's.
#include "parts.h"

#include <dlfcn.h>

#include <cstdio>

int main(int, char** arguments) {
  void* const module = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  if (module == nullptr) return std::printf("%s\n", dlerror()), 1;
  const auto tensorflow = reinterpret_cast<decltype(&with_tensorflow)>(dlsym(module, "with_tensorflow"));
  if (tensorflow == nullptr) return std::printf("%s\n", dlerror()), 1;
  for (int i = 0; i < 2; ++i) {
    if (const int step = with_system()) return std::printf("with_system: %d\n", step), 1;
    if (const int step = tensorflow()) return std::printf("with_tensorflow: %d\n", step), 1;
  }
  std::puts("both: done");
}
