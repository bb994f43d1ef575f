// How a report is put together: numbers as text, tables, folded lines.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "checker/samples.h"

namespace joints::testing {

inline const char* const division_by_zero = "#division-by-zero a division by zero, or a value "
                                            "that was never set";

inline const char* const never_set = "#never-set a value that was never set, or that lies behind "
                                     "the end of an array: it is a huge number";

bool near(double a, double b, double tolerance);
bool all_finite(const Numbers& numbers);
/// Does one of the numbers come from a variable that was never set? The compiler fills these with
/// a pattern: g++ makes of it a huge number (about -5e303, in float -2e38), or an int of -16843010,
/// clang an undefined number.
bool any_unset(const Numbers& yours, const Numbers& right);
/// What made these numbers infinite, undefined or huge; "" where none of them is.
std::string no_number(const Numbers& numbers);
/// Are the wrong ones among yours right to five digits? In double alone: a float has no more.
bool five_digits(const Numbers& yours, const Numbers& right, double tolerance);
inline const char* const few_digits =
    "#few-digits right to a few digits only: is something small added or left out, is there a "
    "float among the reals, such as 0.5f or std::exp2f, or a constant with few digits?";
/// "v1, w1 and v2"
std::string joined(const std::vector<std::string>& words);
/// A diagnosis of a table begins with its id, "#sign-of-row the sign of the row". By it the known
/// answers name what they must be told; a reader does not see it.
std::string without_ids(std::string words);
/// A long line is folded at a space and goes on below its first word after ": ".
std::string folded(std::string line);
std::string likely(const std::string& mistake);

/// Stands in a place that an answer must write. A table explains it where it is shown.
inline constexpr double unwritten = -12345;

/// Your numbers beside the right ones, one line per entry, at most nine; the last line may be
/// "and 2 more".
class Table {
 public:
  explicit Table(const std::string& reference) { line("entry", "yours   ", reference, "error   "); }
  void entry(const std::string& name, double yours, double right, double tolerance);
  std::string words() const;

 private:
  void line(const std::string& a, const std::string& b, const std::string& c,
            const std::string& d) {
    lines_.push_back({a, b, c, d});
  }
  std::vector<std::array<std::string, 4>> lines_;
  int hidden_ = 0;
  bool unwritten_ = false;
};

}  // namespace joints::testing
