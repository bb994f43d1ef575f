// Comparing, guessing the mistake, and saying so.
#include "tests/check.h"

#include <algorithm>
#include <cstdio>

#include "tests/catch.h"
#include "tests/where.h"

namespace joints::testing {

namespace {

std::string text(double number) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.7g", number == 0 ? 0.0 : number);
  return buffer;
}
std::string pad(std::string words, std::size_t width) {
  return words.size() < width ? std::string(width - words.size(), ' ') + words : words + " ";
}

std::string table_line(const std::string& entry, const std::string& yours,
                       const std::string& numeric, const std::string& error) {
  return "  " + entry + std::string(entry.size() < 16 ? 16 - entry.size() : 1, ' ') +
         pad(yours, 15) + pad(numeric, 15) + pad(error, 15) + "\n";
}

const char* const block_names[] = {"v1", "w1", "v2", "w2"};

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

}  // namespace

bool close(const Numbers& a, const Numbers& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!near(a[i], b[i], tolerance)) return false;
  return true;
}

void fail(const Subject& subject, const std::string& words) {
  std::string report;
  const std::string id = subject.id;
  report += (id.empty() ? "" : "Exercise " + id + ": ") + subject.words + "\n\n" + words;
  const std::string place = exercise_place(id);
  if (!place.empty()) report += "\nWhere: " + place + "\nNext:  ./wb hint " + id + "\n";
  FAIL(report);
  throw std::logic_error("not reached");
}

void expect(const Subject& subject, const std::string& entry, double yours, double expected,
            double tolerance, const std::vector<Suspect>& suspects) {
  if (near(yours, expected, tolerance)) {
    CHECK(near(yours, expected, tolerance));
    return;
  }
  std::string words = table_line("entry", "yours", "expected", "error") +
                      table_line(entry, text(yours), text(expected), text(yours - expected));
  for (const Suspect& suspect : suspects)
    if (near(yours, suspect.value, tolerance) && !near(suspect.value, expected, tolerance)) {
      words += "\nLikely mistake: " + suspect.words + "\n";
      break;
    }
  if (!std::isfinite(yours)) words += "\nLikely mistake: a division by zero\n";
  fail(subject, words);
}

void expect(const Subject& subject, const std::string& entry, const vec3& yours,
            const vec3& expected, double tolerance, const std::vector<VectorSuspect>& suspects) {
  const auto same = [&](const vec3& a, const vec3& b) {
    for (int c = 0; c < 3; ++c)
      if (!near(double(a[c]), double(b[c]), tolerance)) return false;
    return true;
  };
  if (same(yours, expected)) {
    CHECK(same(yours, expected));
    return;
  }
  std::string words = table_line("entry", "yours", "expected", "error");
  for (int c = 0; c < 3; ++c)
    words += table_line(entry + "." + "xyz"[c], text(double(yours[c])), text(double(expected[c])),
                        text(double(yours[c] - expected[c])));
  for (const VectorSuspect& suspect : suspects)
    if (same(yours, suspect.value) && !same(suspect.value, expected)) {
      words += "\nLikely mistake: " + suspect.words + "\n";
      break;
    }
  if (!finite(yours)) words += "\nLikely mistake: a division by zero\n";
  fail(subject, words);
}

// ---- guessing what went wrong with a Jacobian ----------------------------------------------------

namespace {

// How one 3-wide block of all rows compares with the right one.
enum class State { right, turned_sign, missing, superfluous, other };

State state(const JacobianSample& s, int block, double tolerance) {
  bool right = true, negative = true, zero = true, should_be_zero = true;
  for (std::size_t row = 0; row < s.yours.size() / 12; ++row)
    for (int c = 0; c < 3; ++c) {
      const double a = s.yours[row * 12 + block * 3 + c], b = s.numeric[row * 12 + block * 3 + c];
      right = right && near(a, b, tolerance);
      negative = negative && near(a, -b, tolerance);
      zero = zero && near(a, 0, tolerance);
      should_be_zero = should_be_zero && near(b, 0, tolerance);
    }
  return right ? State::right
         : negative ? State::turned_sign
         : zero ? State::missing
         : should_be_zero ? State::superfluous : State::other;
}

Numbers bodies_swapped(const Numbers& J) {
  Numbers out = J;
  for (std::size_t row = 0; row < J.size() / 12; ++row)
    for (std::size_t c = 0; c < 12; ++c) out[row * 12 + c] = J[row * 12 + (c + 6) % 12];
  return out;
}

// The common factor of all entries, or 0 where there is none.
double common_factor(const Numbers& yours, const Numbers& numeric, double tolerance) {
  std::size_t largest = 0;
  for (std::size_t i = 0; i < numeric.size(); ++i)
    if (std::abs(numeric[i]) > std::abs(numeric[largest])) largest = i;
  if (numeric[largest] == 0) return 0;
  const double factor = yours[largest] / numeric[largest];
  for (std::size_t i = 0; i < numeric.size(); ++i)
    if (!near(yours[i], factor * numeric[i], tolerance * (1 + std::abs(factor)))) return 0;
  return factor;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return out;
}

std::string jacobian_mistake(const JacobianSample& s, double tolerance) {
  for (double number : s.yours)
    if (!std::isfinite(number)) return "a division by zero, or a value that was never set";
  Numbers negative = s.numeric;
  for (double& number : negative) number = -number;
  const bool swapped = close(s.yours, bodies_swapped(s.numeric), tolerance);
  if (close(s.yours, negative, tolerance))
    return swapped ? "the sign of the whole row, or bodies 1 and 2 swapped"
                   : "the sign of the whole row: C grows when body 2 moves positively";
  if (swapped) return "bodies 1 and 2 swapped";

  std::vector<std::string> signs, missing, superfluous;
  bool other = false;
  for (int block = 0; block < 4; ++block) switch (state(s, block, tolerance)) {
      case State::right: break;
      case State::turned_sign: signs.push_back(block_names[block]); break;
      case State::missing: missing.push_back(block_names[block]); break;
      case State::superfluous: superfluous.push_back(block_names[block]); break;
      case State::other: other = true;
    }
  if (missing.size() == 4) return "every entry is zero";
  if (!other) {
    std::vector<std::string> words;
    if (!signs.empty()) words.push_back("the sign of the block " + joined(signs));
    if (!missing.empty()) words.push_back("the block " + joined(missing) + " is missing");
    if (!superfluous.empty())
      words.push_back("the block " + joined(superfluous) + " should be zero");
    return joined(words);
  }
  if (s.right_if_unturned[0]) return "body-space arm: the lever of body 1 is not turned into the world";
  if (s.right_if_unturned[1]) return "body-space arm: the lever of body 2 is not turned into the world";
  if (s.right_if_unturned[2])
    return "body-space arm: the levers of both bodies are not turned into the world";
  if (const double factor = common_factor(s.yours, s.numeric, tolerance); factor != 0)
    return "a factor: is the direction a unit vector?";
  return "";
}

// ---- guessing what went wrong with a K ------------------------------------------------------------

std::string K_mistake(const KSample& s, double tolerance) {
  for (double number : s.yours)
    if (!std::isfinite(number)) return "a division by zero, or a value that was never set";
  if (close(s.yours, Numbers(s.yours.size(), 0), tolerance)) return "every entry is zero";
  Numbers negative = s.numeric;
  for (double& number : negative) number = -number;
  if (close(s.yours, negative, tolerance)) return "the sign: K is never negative";
  for (const auto& [words, wrong] : s.mistakes)
    if (close(s.yours, wrong, tolerance) && !close(wrong, s.numeric, tolerance)) return words;
  if (common_factor(s.yours, s.numeric, tolerance) != 0)
    return "a factor: K has the square of the direction's length in it, which is 1 for a unit vector";
  return "";
}

// ---- the report ------------------------------------------------------------------------------------


// At which poses it holds, and the likely mistake with the poses where it shows.
template <class Sample>
std::string poses_and_mistake(const std::vector<Sample>& samples, double tolerance,
                              std::string (*mistake)(const Sample&, double)) {
  std::vector<std::string> holds, fails, words, where;
  for (int pose = 0; pose < 4; ++pose) {
    bool seen = false, right = true;
    for (const Sample& s : samples) {
      if (s.pose != pose) continue;
      seen = true;
      if (close(s.yours, s.numeric, tolerance)) continue;
      right = false;
      const std::string guess = mistake(s, tolerance);
      std::size_t k = std::size_t(std::find(words.begin(), words.end(), guess) - words.begin());
      if (k == words.size()) {
        words.push_back(guess);
        where.push_back("");
      }
      if (where[k].find(pose_names[pose]) == std::string::npos)
        where[k] += (where[k].empty() ? "" : ", ") + std::string(pose_names[pose]);
    }
    if (seen) (right ? holds : fails).push_back(pose_names[pose]);
  }
  std::string out = "\nFails at poses: " + joined(fails);
  if (!holds.empty()) out += "; holds at: " + joined(holds);
  out += "\n";
  for (std::size_t k = 0; k < words.size(); ++k)
    if (!words[k].empty()) out += "Likely mistake: " + words[k] + " (" + where[k] + ")\n";
  return out;
}

template <class Sample>
const Sample* first_wrong(const std::vector<Sample>& samples, double tolerance) {
  for (const Sample& s : samples)
    if (!close(s.yours, s.numeric, tolerance)) return &s;
  return nullptr;
}

}  // namespace

std::string jacobian_report(const std::vector<std::string>& rows,
                            const std::vector<JacobianSample>& samples, double tolerance) {
  const JacobianSample* wrong = first_wrong(samples, tolerance);
  if (!wrong) {
    CHECK(wrong == nullptr);
    return "";
  }
  std::string entries, map = "\n                   v1    w1    v2    w2     (x wrong, . right)\n";
  int shown = 0, hidden = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    map += "  " + rows[row] + std::string(16 - std::min<std::size_t>(rows[row].size(), 15), ' ');
    for (std::size_t c = 0; c < 12; ++c) {
      const std::size_t i = row * 12 + c;
      const bool right = near(wrong->yours[i], wrong->numeric[i], tolerance);
      map += std::string(c % 3 == 0 ? " " : "") + (right ? "." : "x") + (c % 3 == 2 ? "  " : "");
      if (right) continue;
      if (shown++ >= 8) {
        ++hidden;
        continue;
      }
      entries += table_line(rows[row] + ", " + block_names[c / 3] + "." + "xyz"[c % 3],
                            text(wrong->yours[i]), text(wrong->numeric[i]),
                            text(wrong->yours[i] - wrong->numeric[i]));
    }
    map += "\n";
  }
  std::string out = "Pose: " + std::string(pose_names[wrong->pose]) +
                    ". The numeric value is how fast C really changes with that velocity.\n\n" +
                    table_line("entry", "yours", "numeric", "error") + entries;
  if (hidden > 0) out += "  and " + std::to_string(hidden) + " more\n";
  return out + map + poses_and_mistake(samples, tolerance, jacobian_mistake);
}

std::string K_report(const std::vector<std::string>& rows, const std::vector<KSample>& samples,
                     double tolerance) {
  const KSample* wrong = first_wrong(samples, tolerance);
  if (!wrong) {
    CHECK(wrong == nullptr);
    return "";
  }
  std::string entries;
  const std::size_t n = rows.size();
  for (std::size_t i = 0; i < n * n; ++i)
    if (!near(wrong->yours[i], wrong->numeric[i], tolerance))
      entries += table_line(n == 1 ? "K" : "K[" + rows[i / n] + ", " + rows[i % n] + "]",
                            text(wrong->yours[i]), text(wrong->numeric[i]),
                            text(wrong->yours[i] - wrong->numeric[i]));
  return "Pose: " + std::string(pose_names[wrong->pose]) +
         ". The numeric value is J M^-1 J^T with J by differences.\n\n" +
         table_line("entry", "yours", "numeric", "error") + entries +
         poses_and_mistake(samples, tolerance, K_mistake);
}

}  // namespace joints::testing
