// Comparing, guessing the mistake, and saying so. A report is made for a terminal: lines of at most
// 76 columns, so that Catch2 does not fold them anew.
#include "tests/check.h"

#include <algorithm>
#include <cstdio>

#include "tests/catch.h"
#include "tests/where.h"

namespace joints::testing {

namespace {

constexpr std::size_t report_width = 76;
const char* const block_names[] = {"v1", "w1", "v2", "w2"};
const char* const division_by_zero = "a division by zero, or a value that was never set";

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

bool all_finite(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double a) { return std::isfinite(a); });
}

// "v1, w1 and v2"
std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return out;
}

// ---- tables and lines ---------------------------------------------------------------------------

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

// Yours beside what is right, a line an entry; at most eight lines where all are wrong.
class Table {
 public:
  explicit Table(const std::string& reference) { line("entry", "yours   ", reference, "error   "); }
  void entry(const std::string& name, double yours, double right, double tolerance) {
    if (lines_.size() > 8) ++hidden_;
    else line(name, text(yours, tolerance), text(right, tolerance), text(yours - right, tolerance));
  }
  std::string words() const {
    std::size_t width = 0;
    for (const auto& line : lines_) width = std::max(width, line[0].size());
    std::string out;
    for (const auto& line : lines_) {
      std::string row = "  " + line[0] + std::string(width - line[0].size(), ' ') +
                        padded(line[1], 14) + padded(line[2], 14) + padded(line[3], 14);
      row.erase(row.find_last_not_of(' ') + 1);
      out += row + "\n";
    }
    return out + (hidden_ > 0 ? "  and " + std::to_string(hidden_) + " more\n" : "");
  }

 private:
  void line(const std::string& a, const std::string& b, const std::string& c,
            const std::string& d) {
    lines_.push_back({a, b, c, d});
  }
  std::vector<std::array<std::string, 4>> lines_;
  int hidden_ = 0;
};

// A long line is folded at a space and goes on below its first word after ": ".
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

}  // namespace

bool close(const Numbers& a, const Numbers& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!near(a[i], b[i], tolerance)) return false;
  return true;
}

void check(const Subject& subject, const std::string& report) {
  if (!report.empty()) fail(subject, report);
  CHECK(report.empty());
}

void fail(const Subject& subject, const std::string& words) {
  const std::string id = subject.id;
  std::string all = (id.empty() ? "" : "Exercise " + id + ": ") + subject.words + "\n\n" + words;
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

template <class T>
void compare(const Subject& subject, const std::string& entry, const T& yours, const T& expected,
             double tolerance, const std::vector<SuspectOf<T>>& suspects) {
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
  std::string words = table.words();
  const auto fits = [&](const SuspectOf<T>& suspect) {
    return close(mine.numbers, named(entry, suspect.value).numbers, tolerance);
  };
  const auto suspect = std::find_if(suspects.begin(), suspects.end(), fits);
  if (!all_finite(mine.numbers)) words += "\n" + likely(division_by_zero);
  else if (suspect != suspects.end()) words += "\n" + likely(suspect->words);
  fail(subject, words);
}

}  // namespace

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
  compare(subject, entry, yours, expected, tolerance, suspects);
}
void expect(const Subject& subject, const std::string& entry, const quat& yours,
            const quat& expected, double tolerance, const std::vector<QuatSuspect>& suspects) {
  const auto beside = [](const quat& q, const quat& other) { return dot(q, other) < 0 ? -q : q; };
  const quat mine = beside(yours, expected);
  std::vector<QuatSuspect> turned = suspects;
  for (QuatSuspect& suspect : turned) suspect.value = beside(suspect.value, mine);
  compare(subject, entry, mine, expected, tolerance, turned);
}

// ---- guessing what went wrong -------------------------------------------------------------------

namespace {

Numbers negative(Numbers numbers) {
  for (double& number : numbers) number = -number;
  return numbers;
}

Numbers bodies_swapped(const Numbers& J) {
  Numbers out = J;
  for (std::size_t i = 0; i < J.size(); ++i) out[i] = J[i / 12 * 12 + (i + 6) % 12];
  return out;
}

// The number that all of what is right was multiplied by, or 0 where there is none.
double common_factor(const Sample& s, double tolerance) {
  std::size_t largest = 0;
  for (std::size_t i = 0; i < s.right.size(); ++i)
    if (std::abs(s.right[i]) > std::abs(s.right[largest])) largest = i;
  const double factor = s.yours[largest] / s.right[largest];
  for (std::size_t i = 0; i < s.right.size(); ++i)
    if (!near(s.yours[i], factor * s.right[i], tolerance * (1 + std::abs(factor)))) return 0;
  return factor;
}

// "the block w1", "the blocks w1 and w2"
std::string blocks(const std::vector<std::string>& names) {
  return (names.size() == 1 ? "the block " : "the blocks ") + joined(names);
}

// The wrong blocks of J, if each of them is the right one with its sign turned, or is missing, or
// should not be there.
std::string block_mistake(const Sample& s, double tolerance) {
  std::vector<std::string> signs, missing, superfluous, words;
  for (std::size_t block = 0; block < 4; ++block) {
    bool right = true, opposite = true, zero = true, should_be_zero = true;
    for (std::size_t i = 0; i < s.yours.size(); ++i) {
      if (i % 12 / 3 != block) continue;
      right = right && near(s.yours[i], s.right[i], tolerance);
      opposite = opposite && near(s.yours[i], -s.right[i], tolerance);
      zero = zero && near(s.yours[i], 0, tolerance);
      should_be_zero = should_be_zero && near(s.right[i], 0, tolerance);
    }
    if (right) continue;
    if (opposite) signs.push_back(block_names[block]);
    else if (zero) missing.push_back(block_names[block]);
    else if (should_be_zero) superfluous.push_back(block_names[block]);
    else return "";
  }
  if (!signs.empty())
    words.push_back("the sign of " + blocks(signs) +
                    (joined(signs) == "v1 and w1" ? ": body 1 carries the minus sign" : ""));
  if (!missing.empty())
    words.push_back(blocks(missing) + (missing.size() == 1 ? " is missing" : " are missing"));
  if (!superfluous.empty()) words.push_back(blocks(superfluous) + " should be zero");
  return joined(words);
}

// Adds what the sample alone tells: `first` for J or K comes before what is known already.
void guess(Sample& s, double tolerance, const std::string& first) {
  const double factor = common_factor(s, tolerance);
  std::string words = first;
  if (!all_finite(s.yours) && first.empty()) words = division_by_zero;
  else if (close(s.yours, Numbers(s.yours.size(), 0), tolerance)) words = "every entry is zero";
  if (!words.empty()) s.mistakes.insert(s.mistakes.begin(), words);
  if (!s.mistakes.empty()) return;
  for (const char* number : {"2", "4", "0.5", "0.25"})
    if (near(factor, std::atof(number), tolerance))
      s.mistakes.push_back(std::string("a factor of ") + number);
}

void guess_J(Sample& s, double tolerance) {
  const bool swapped = close(s.yours, bodies_swapped(s.right), tolerance);
  std::string words = swapped ? "bodies 1 and 2 swapped" : "";
  if (close(s.yours, negative(s.right), tolerance))
    words = swapped ? "the sign of the whole row, or bodies 1 and 2 swapped"
                    : "the sign of the whole row: C grows when body 2 moves positively";
  guess(s, tolerance, words);
  const std::string blocks = block_mistake(s, tolerance);
  if (!blocks.empty()) s.mistakes.push_back(blocks);
  if (s.mistakes.empty() && common_factor(s, tolerance) != 0)
    s.mistakes.push_back("a factor: is the direction a unit vector?");
}

void guess_K(Sample& s, double tolerance) {
  const bool opposite = close(s.yours, negative(s.right), tolerance);
  guess(s, tolerance,
        !all_finite(s.yours) ? "a division by zero: 1/m of a static body is 0, K adds it as it is"
        : opposite           ? "the sign: K is never negative"
                             : "");
}

// ---- the report ---------------------------------------------------------------------------------

std::vector<std::string> poses_of(const std::vector<const Sample*>& samples) {
  std::vector<std::string> names;
  for (const Sample* s : samples)
    if (names.empty() || names.back() != pose_names[s->pose]) names.push_back(pose_names[s->pose]);
  return names;
}

// The fewest mistakes that explain all samples, each with its poses. The pose of the text has many
// zeros, so that a mistake may fit there by chance: it must be one that shows elsewhere, too.
std::string likely_mistakes(std::vector<const Sample*> open) {
  std::string out;
  const auto names = [](const Sample* s, const std::string& words) {
    return std::find(s->mistakes.begin(), s->mistakes.end(), words) != s->mistakes.end();
  };
  const auto by_hand = [](const Sample* s) { return s->pose == pencil_and_paper; };
  const bool only_by_hand = std::all_of(open.begin(), open.end(), by_hand);
  while (only_by_hand ? !open.empty() : !std::all_of(open.begin(), open.end(), by_hand)) {
    std::string best;
    std::vector<const Sample*> explained;
    for (const Sample* s : open) {
      if (by_hand(s) && !only_by_hand) continue;
      for (const std::string& words : s->mistakes) {
        std::vector<const Sample*> also;
        std::copy_if(open.begin(), open.end(), std::back_inserter(also),
                     [&](const Sample* other) { return names(other, words); });
        if (also.size() <= explained.size()) continue;
        best = words;
        explained = also;
      }
    }
    if (explained.empty())
      return out + "None of the usual mistakes explains it (" + joined(poses_of(open)) +
             "): compare it with the equation, entry by entry.\n";
    std::string poses;
    for (const std::string& pose : poses_of(explained)) poses += (poses.empty() ? "" : ", ") + pose;
    out += likely(best + " (" + poses + ")");
    std::erase_if(open, [&](const Sample* s) { return names(s, best); });
  }
  return out;
}

// At which poses it holds, and what is likely to be wrong at the others.
std::string verdict(std::vector<Sample>& samples, double tolerance,
                    void (*guess)(Sample&, double)) {
  std::vector<const Sample*> right, wrong;
  for (Sample& s : samples) {
    const bool holds = close(s.yours, s.right, tolerance);
    (holds ? right : wrong).push_back(&s);
    if (!holds) guess(s, tolerance);
  }
  std::vector<std::string> holds = poses_of(right);
  const std::vector<std::string> fails = poses_of(wrong);
  std::erase_if(holds, [&](const std::string& pose) {
    return std::find(fails.begin(), fails.end(), pose) != fails.end();
  });
  return "\n" +
         (holds.empty() ? "Fails at all poses.\n"
                        : "Fails at " + joined(fails) + "; holds at " + joined(holds) + ".\n") +
         likely_mistakes(wrong);
}

const Sample* first_wrong(const std::vector<Sample>& samples, double tolerance) {
  for (const Sample& s : samples)
    if (!close(s.yours, s.right, tolerance)) return &s;
  return nullptr;
}

// Which pose, and what stands beside yours.
std::string heading(const Sample& s, const std::string& numeric) {
  return std::string("Pose: ") + pose_names[s.pose] + " (" + pose_words[s.pose] + ")." +
         (s.pose == pencil_and_paper ? "" : " Numeric: " + numeric) + "\n\n";
}
Table table_for(const Sample& s) {
  return Table(s.pose == pencil_and_paper ? "by hand " : "numeric ");
}

}  // namespace

std::string jacobian_report(const std::vector<std::string>& rows, std::vector<Sample> samples,
                            double tolerance) {
  const Sample* wrong = first_wrong(samples, tolerance);
  if (!wrong) return "";
  Table table = table_for(*wrong);
  std::string map = "\n        v1   w1   v2   w2     (x wrong, . right)\n";
  for (std::size_t row = 0; row < rows.size(); ++row) {
    map += "  " + rows[row] + std::string(6 - rows[row].size(), ' ');
    for (std::size_t c = 0; c < 12; ++c) {
      const double yours = wrong->yours[row * 12 + c], numeric = wrong->right[row * 12 + c];
      const bool right = near(yours, numeric, tolerance);
      map += std::string(right ? "." : "x") + (c % 3 == 2 && c < 11 ? "  " : "");
      if (!right)
        table.entry(rows[row] + ", " + block_names[c / 3] + "." + "xyz"[c % 3], yours, numeric,
                    tolerance);
    }
    map += "\n";
  }
  return heading(*wrong, "how fast C really changes.") + table.words() + map +
         verdict(samples, tolerance, guess_J);
}

std::string K_report(const std::vector<std::string>& rows, std::vector<Sample> samples,
                     double tolerance) {
  const Sample* wrong = first_wrong(samples, tolerance);
  if (!wrong) return "";
  Table table = table_for(*wrong);
  const std::size_t n = rows.size();
  for (std::size_t i = 0; i < n * n; ++i)
    if (!near(wrong->yours[i], wrong->right[i], tolerance))
      table.entry(n == 1 ? "K" : "K[" + rows[i / n] + ", " + rows[i % n] + "]", wrong->yours[i],
                  wrong->right[i], tolerance);
  return heading(*wrong, "J M^-1 J^T, J by differences.") + table.words() +
         verdict(samples, tolerance, guess_K);
}

}  // namespace joints::testing
