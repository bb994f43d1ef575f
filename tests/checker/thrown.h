// What a call throws, as a value. In WebAssembly nothing can be caught: there the page that runs
// the tests (docs/course) lends its own try.
#pragma once

#include <optional>

#ifdef __wasm__
#include <typeinfo>
#endif

namespace joints::testing {

#ifdef __wasm__

/// What was thrown last, and its type.
struct Thrown {
  void* object;
  const std::type_info* type;
};
extern Thrown last_thrown;
/// False where the call threw.
bool attempt(void (*call)(const void*), const void* with);
/// Throws once more what was thrown last.
[[noreturn]] void throw_again();

template <class Error, class Call>
std::optional<Error> thrown_by(const Call& call) {
  if (attempt([](const void* with) { (*static_cast<const Call*>(with))(); }, &call)) return {};
  if (*last_thrown.type != typeid(Error)) throw_again();
  return *static_cast<const Error*>(last_thrown.object);
}

#else

/// The Error that a call throws, if it throws one; another exception passes.
template <class Error, class Call>
std::optional<Error> thrown_by(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  return {};
}

#endif

}  // namespace joints::testing
