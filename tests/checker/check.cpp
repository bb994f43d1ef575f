// Comparing numbers with the right ones, and reporting it.
#include <algorithm>

#include "checker/report.h"
#include "tests/checker/catch.h"
#include "tests/checker/check.h"
#include "tests/checker/where.h"

namespace joints::testing {

void check(const Subject& subject, const std::string& report) {
  if (!report.empty()) fail(subject, report);
  CHECK(report.empty());
}

void fail(const Subject& subject, const std::string& words) {
  const std::string id = subject.id;
  const bool known = std::getenv("WORKBOOK_ANSWER");  // see tools/check/answers.py
  std::string all = (id.empty() ? "" : "Exercise " + id + ": ") + subject.words +
                    (*subject.given ? std::string("\n") + subject.given : "") + "\n\n" +
                    (known ? words : without_ids(words));
  const std::string place = exercise_place(id, subject.region);
  if (!place.empty()) all += "\nWhere: " + place + "\nNext:  ./wb hint " + id + "\n";
  std::string report;
  for (std::size_t from = 0; from < all.size();) {
    const std::size_t end = all.find('\n', from);
    // Catch2 loses the margin of the line after an empty one: a space keeps it
    report += end == from ? " \n" : folded(all.substr(from, end - from));
    from = end + 1;
  }
  FAIL(report);
  throw std::logic_error("not reached");
}

// ---- numbers ------------------------------------------------------------------------------------

namespace {

struct Named {
  std::vector<std::string> entries;
  Numbers numbers;
};
Named named(const std::string& entry, double a) { return {{entry}, {a}}; }
Named named(const std::string& entry, const vec3& a) {
  return {{entry + ".x", entry + ".y", entry + ".z"}, {double(a.x), double(a.y), double(a.z)}};
}
Named named(const std::string& entry, const quat& a) {
  return {{entry + ".w", entry + ".x", entry + ".y", entry + ".z"},
          {double(a.w), double(a.x), double(a.y), double(a.z)}};
}
Named named(const std::string& entry, const mat3& a) {
  Named out;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      out.entries.push_back(entry + "[" + "xyz"[row] + ", " + "xyz"[column] + "]");
      out.numbers.push_back(double(a[column][row]));
    }
  return out;
}

// The line that names the mistake, "" where none is known.
std::string mistake_line(const Numbers& yours, const Numbers& right, double tolerance,
                         const std::vector<std::string>& mistakes) {
  std::string words;
  if (any_unset(yours, right)) words = never_set;
  else if (!mistakes.empty()) words = mistakes.front();
  else if (!all_finite(yours)) words = division_by_zero;
  else if (five_digits(yours, right, tolerance)) words = few_digits;
  return words.empty() ? "" : "\n" + likely(words);
}

template <class T>
void compare(const Subject& subject, const std::string& entry, const T& yours, const T& expected,
             double tolerance, const std::vector<SuspectOf<T>>& suspects,
             std::vector<std::string> mistakes = {}) {
  const Named mine = named(entry, yours);
  const Numbers right = named(entry, expected).numbers;
  const bool same = close(mine.numbers, right, tolerance);
  if (same) {
    CHECK(same);
    return;
  }
  Table table("expected");
  for (std::size_t i = 0; i < right.size(); ++i)
    if (right.size() < 9 || !near(mine.numbers[i], right[i], tolerance))
      table.entry(mine.entries[i], mine.numbers[i], right[i], tolerance);
  const bool a_number = std::none_of(mine.numbers.begin(), mine.numbers.end(),
                                     [](double a) { return std::isnan(a); });
  for (const SuspectOf<T>& suspect : suspects)
    if (a_number && same_numbers(mine.numbers, named(entry, suspect.value).numbers, tolerance))
      mistakes.push_back(suspect.words);
  fail(subject, table.words() + mistake_line(mine.numbers, right, tolerance, mistakes));
}

}  // namespace

void expect(const Subject& subject, const std::string& words,
            const std::vector<std::string>& entries, const Numbers& yours,
            const Numbers& expected, double tolerance, const std::vector<std::string>& likely) {
  const bool same = close(yours, expected, tolerance);
  if (same) {
    CHECK(same);
    return;
  }
  Table table("expected");
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (!near(yours[i], expected[i], tolerance))
      table.entry(entries[i], yours[i], expected[i], tolerance);
  fail(subject, (words.empty() ? "" : "Case: " + words + ".\n\n") + table.words() +
                    mistake_line(yours, expected, tolerance, likely));
}
void expect_or_say(const Subject& subject, const std::string& entry, double yours,
                   double expected, double tolerance, const std::vector<std::string>& words) {
  compare(subject, entry, yours, expected, tolerance, {}, words);
}
void expect_or_say(const Subject& subject, const std::string& entry, const vec3& yours,
                   const vec3& expected, double tolerance, const std::vector<std::string>& words) {
  compare(subject, entry, yours, expected, tolerance, {}, words);
}
void expect(const Subject& subject, const std::string& entry, double yours, double expected,
            double tolerance, const std::vector<Suspect>& suspects) {
  compare(subject, entry, yours, expected, tolerance, suspects);
}
void expect(const Subject& subject, const std::string& entry, const vec3& yours,
            const vec3& expected, double tolerance, const std::vector<VectorSuspect>& suspects) {
  compare(subject, entry, yours, expected, tolerance, suspects);
}
void expect(const Subject& subject, const std::string& entry, const mat3& yours,
            const mat3& expected, double tolerance, const std::vector<MatrixSuspect>& suspects) {
  std::vector<MatrixSuspect> all = suspects;
  const mat3 turned = transpose(expected);
  const bool opposite = length(turned[0] + expected[0]) + length(turned[1] + expected[1]) +
                            length(turned[2] + expected[2]) == 0;
  all.push_back({turned, opposite ? "the sign, or rows where columns belong: M[column][row]"
                                  : "transposed: mat3(a, b, c) takes columns, M[column][row]"});
  compare(subject, entry, yours, expected, tolerance, all);
}
void expect(const Subject& subject, const std::string& entry, const quat& yours,
            const quat& expected, double tolerance, const std::vector<QuatSuspect>& suspects) {
  const auto beside = [](const quat& q, const quat& other) { return dot(q, other) < 0 ? -q : q; };
  const quat mine = beside(yours, expected);
  std::vector<QuatSuspect> turned = suspects;
  const quat& q = expected;
  turned.push_back({quat(q.x, q.y, q.z, q.w), "the order of its numbers: quat(w, x, y, z)"});
  turned.push_back({conjugate(q), "the inverse rotation"});
  for (QuatSuspect& suspect : turned) suspect.value = beside(suspect.value, mine);
  compare(subject, entry, mine, expected, tolerance, turned);
}

}  // namespace joints::testing
