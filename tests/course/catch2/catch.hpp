// What the exercises' tests use of Catch2, for a module that the page calls test by test: each test
// runs in an instance of its own, which ends where a test fails (tests/course/module.cpp).
#pragma once

#include <string>
#include <vector>

namespace workbook {

/// A test: its name, its tag such as "[1.1]", and what it calls.
struct Test {
  const char* name;
  const char* tag;
  void (*run)();
};
/// All tests of the module, in the order in which they stand.
inline std::vector<Test>& tests() {
  static std::vector<Test> all;
  return all;
}
struct Registered {
  Registered(void (*run)(), const char* name, const char* tag = "") {
    tests().push_back({name, tag, run});
  }
};

/// Text put together by <<.
struct Words {
  std::string text;
  template <class Part>
  Words& operator<<(const Part& part) {
    text += part;
    return *this;
  }
};
/// Ends the test.
[[noreturn]] void failed(const std::string& words);

}  // namespace workbook

namespace Catch::Matchers {
inline std::string Contains(const std::string& words) { return words; }
}  // namespace Catch::Matchers

#define WORKBOOK_JOIN(a, b) a##b
#define WORKBOOK_TEST(function, ...)                                                   \
  static void function();                                                              \
  static const workbook::Registered WORKBOOK_JOIN(function, _known){function, __VA_ARGS__}; \
  static void function()
#define WORKBOOK_NAMED(line, ...) WORKBOOK_TEST(WORKBOOK_JOIN(test_, line), __VA_ARGS__)

#define TEST_CASE(...) WORKBOOK_NAMED(__LINE__, __VA_ARGS__)
#define FAIL(words) workbook::failed((workbook::Words{} << words).text)
#define CHECK(...) \
  if (!(__VA_ARGS__)) workbook::failed(#__VA_ARGS__ " is not true")
#define REQUIRE(...) CHECK(__VA_ARGS__)
#define INFO(words) (void)(workbook::Words{} << words)
#define SUCCEED() (void)0
