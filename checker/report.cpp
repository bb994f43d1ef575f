// Numbers as text, tables, folded lines. A report is made for a terminal: lines of at most 76
// columns, so that Catch2 does not fold them anew.
#include "checker/report.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>

namespace joints::testing {

namespace {

constexpr std::size_t report_width = 76, longest_name = 30;  // a longer one has its own line

// Decimal points stand below one another; what the check takes for zero is written 0.
std::string text(double number, double tolerance) {
  if (std::isnan(number)) return "nan     ";
  if (std::abs(number) <= tolerance) return "0       ";
  const double size = std::abs(number);
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, size >= 1e-4 && size < 1e7 ? "%.6f" : "%.3e", number);
  return buffer;
}

std::string padded(const std::string& words, std::size_t width) {
  return std::string(words.size() < width ? width - words.size() : 1, ' ') + words;
}

}  // namespace

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

bool close(const Numbers& a, const Numbers& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!near(a[i], b[i], tolerance)) return false;
  return true;
}

bool same_numbers(const Numbers& a, const Numbers& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i] && !near(a[i], b[i], tolerance) && !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return true;
}

bool all_finite(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double a) { return std::isfinite(a); });
}

namespace {

// Another compiler fills with ones: an undefined number that no division gives.
bool all_ones(double a) {
  const std::uint64_t places = std::bit_cast<std::uint64_t>(a) << 12;
  return std::isnan(a) && places >> 35 == 0x1fffffff;  // so many has a float
}

}  // namespace

bool any_unset(const Numbers& yours, const Numbers& right) {
  const double huge = is_float ? 1e35 : 1e290, whole = 16843010;
  for (std::size_t i = 0; i < yours.size(); ++i) {
    const double a = std::abs(yours[i]);
    if (all_ones(yours[i])) return true;
    if (std::abs(right[i]) > whole / 2) continue;  // here it might be meant
    if ((a > huge && std::isfinite(a)) || std::abs(a - whole) < 100) return true;
  }
  return false;
}

std::string no_number(const Numbers& numbers) {
  if (any_unset(numbers, Numbers(numbers.size(), 0))) return never_set;
  return all_finite(numbers) ? "" : division_by_zero;
}

bool five_digits(const Numbers& yours, const Numbers& right, double tolerance) {
  for (std::size_t i = 0; i < yours.size(); ++i)
    if (!near(yours[i], right[i], std::max(tolerance, 1e-5 * std::abs(right[i])))) return false;
  return !is_float;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return out;
}

void Table::entry(const std::string& name, double yours, double right, double tolerance) {
  unwritten_ = unwritten_ || yours == unwritten;
  if (lines_.size() > 9) ++hidden_;
  else line(name, text(yours, tolerance), text(right, tolerance), text(yours - right, tolerance));
}

std::string Table::words() const {
  std::size_t width = 0;
  for (const auto& line : lines_)
    if (line[0].size() <= longest_name) width = std::max(width, line[0].size());
  std::string out;
  for (std::size_t i = 0; i < lines_.size() - (hidden_ > 0); ++i) {  // at most 9: no "1 more"
    const auto& line = lines_[i];
    const bool fits = line[0].size() <= longest_name;
    if (!fits) out += "  " + line[0] + "\n";
    std::string row = "  " + (fits ? line[0] : "") +
                      std::string(width - (fits ? line[0].size() : 0), ' ') +
                      padded(line[1], 14) + padded(line[2], 14) + padded(line[3], 14);
    row.erase(row.find_last_not_of(' ') + 1);
    out += row + "\n";
  }
  if (hidden_ > 0) out += "  and " + std::to_string(hidden_ + 1) + " more\n";
  if (unwritten_) out += "  -12345 stood there before: nothing was written to this place\n";
  return out;
}

std::string without_ids(std::string words) {
  for (std::size_t at = 0; (at = words.find('#', at)) != words.npos;)
    words.erase(at, words.find(' ', at) + 1 - at);
  return words;
}

std::string folded(std::string line) {
  const std::size_t colon = line.find(": ");
  const std::string margin(colon < 20 ? colon + 2 : 0, ' ');
  std::string out;
  while (line.size() > report_width) {
    const std::size_t space = line.rfind(' ', report_width);
    if (space == std::string::npos || space <= margin.size()) break;
    out += line.substr(0, space) + "\n";
    line = margin + line.substr(space + 1);
  }
  return out + line + "\n";
}

std::string likely(const std::string& mistake) { return "Likely mistake: " + mistake + "\n"; }

}  // namespace joints::testing
