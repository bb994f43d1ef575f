// Exceptions in WebAssembly, where none can be caught: the sentence is kept for the page, and the
// module stops. The page shows the sentence and begins with a fresh module.
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace {
char sentence[1000];
}

/// What was thrown last, in words; "" if nothing was.
extern "C" __attribute__((export_name("wb_sentence"), used)) const char* wb_sentence() {
  return sentence;
}

extern "C" void* __cxa_allocate_exception(std::size_t size) { return std::malloc(size); }
extern "C" void __cxa_free_exception(void* thrown) { std::free(thrown); }
extern "C" void __cxa_throw(void* thrown, void*, void (*)(void*)) {
  const char* what = static_cast<std::exception*>(thrown)->what();
  std::strncpy(sentence, what, sizeof sentence - 1);
  __builtin_trap();
}
