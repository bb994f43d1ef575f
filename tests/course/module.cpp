// The functions of a chapter's tests that the page calls, and those of the page that they call. A
// test that fails or throws tells the page its words, and the page ends the instance.
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include <catch2/catch.hpp>

#include "tests/checker/thrown.h"

#define EXPORT(name) extern "C" __attribute__((export_name(#name), used)) auto name
#define IMPORT(name) extern "C" __attribute__((import_module("workbook"), import_name(#name)))

/// The page ends the instance: the test has failed with these words, or something was thrown.
IMPORT(fail) void page_fail(const char* words, std::size_t size) __attribute__((noreturn));
IMPORT(thrown) void page_thrown(const char* words, std::size_t size) __attribute__((noreturn));
/// False where the call threw: the page has caught it.
IMPORT(attempt) bool page_attempt(void (*call)(const void*), const void* with);

EXPORT(wb_count)() -> int { return int(workbook::tests().size()); }
EXPORT(wb_name)(int k) -> const char* { return workbook::tests()[std::size_t(k)].name; }
EXPORT(wb_tag)(int k) -> const char* { return workbook::tests()[std::size_t(k)].tag; }
EXPORT(wb_run)(int k) -> void {
  workbook::tests()[std::size_t(k)].run();
  std::fflush(nullptr);
}
EXPORT(wb_call)(void (*call)(const void*), const void* with) -> void { call(with); }

void workbook::failed(const std::string& words) {
  std::fflush(nullptr);
  page_fail(words.data(), words.size());
}

// ---- what is thrown ---------------------------------------------------------------------------

namespace joints::testing {

Thrown last_thrown{nullptr, nullptr};

bool attempt(void (*call)(const void*), const void* with) { return page_attempt(call, with); }

namespace {
// Does a type derive, by single bases, from std::exception? A type_info of such a class holds its
// name and the type_info of its base behind its table of functions (Itanium C++ ABI, 2.9.5).
bool is_exception(const std::type_info* type) {
  while (*type != typeid(std::exception)) {
    if (!std::strstr(typeid(*type).name(), "__si_class_type_info")) return false;
    type = reinterpret_cast<const std::type_info* const*>(type)[2];
  }
  return true;
}
}  // namespace

void throw_again() {
  std::fflush(nullptr);
  const char* const words = is_exception(last_thrown.type)
                                ? static_cast<std::exception*>(last_thrown.object)->what()
                                : "Unknown exception";
  page_thrown(words, std::strlen(words));
}

}  // namespace joints::testing

extern "C" {
void* __cxa_allocate_exception(std::size_t size) { return std::malloc(size); }
void __cxa_free_exception(void* thrown) { std::free(thrown); }
[[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*)(void*)) {
  joints::testing::last_thrown = {thrown, type};
  joints::testing::throw_again();
}
[[noreturn]] void __cxa_rethrow() { joints::testing::throw_again(); }
// Never reached: what is compiled for a `catch` calls them.
void* __cxa_begin_catch(void* thrown) { return thrown; }
void __cxa_end_catch() {}
}
