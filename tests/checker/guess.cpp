// Guessing what went wrong in a J or K from the entries that are wrong, and the reports of both.
#include <algorithm>

#include "tests/checker/proved.h"
#include "tests/checker/patterns.h"
#include "tests/checker/report.h"

namespace joints::testing {

namespace {

const char* const block_names[] = {"v1", "w1", "v2", "w2"};

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

// The factor 2 or 1/2 of one block, "" where there is none.
std::string block_factor(const Sample& s, std::size_t block, double tolerance) {
  for (const char* number : {"2", "0.5"}) {
    bool fits = true;
    for (std::size_t i = 0; i < s.yours.size(); ++i)
      if (i % 12 / 3 == block)
        fits = fits && near(s.yours[i], std::atof(number) * s.right[i], tolerance);
    if (fits) return std::string("a factor of ") + number + " in the block " + block_names[block];
  }
  return "";
}

// Is it the right row with its blocks in another order?
bool other_order(const Sample& s, double tolerance) {
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  while (std::next_permutation(order.begin(), order.end())) {
    Numbers J = s.right;
    for (std::size_t i = 0; i < J.size(); ++i)
      J[i] = s.right[i / 12 * 12 + 3 * order[i % 12 / 3] + i % 3];
    if (close(s.yours, J, tolerance)) return true;
  }
  return false;
}

// "the block w1", "the blocks w1 and w2"
std::string blocks(const std::vector<std::string>& names) {
  return (names.size() == 1 ? "the block " : "the blocks ") + joined(names);
}

// The wrong blocks of J, if each of them is the right one with its sign turned, doubled or halved,
// or is missing, or should not be there.
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
    else if (const std::string factor = block_factor(s, block, tolerance); !factor.empty())
      words.push_back(factor);
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
  std::string words = first.empty() ? no_number(s.yours) : first;
  if (close(s.yours, Numbers(s.yours.size(), 0), tolerance)) words = "every entry is zero";
  if (const std::string digits = seven_digits({{s.yours, s.right}}); !digits.empty())
    words = digits;
  if (!words.empty()) s.mistakes.insert(s.mistakes.begin(), words);
  if (!s.mistakes.empty()) return;
  for (const char* number : {"2", "4", "0.5", "0.25"})
    if (near(factor, std::atof(number), tolerance))
      s.mistakes.push_back(std::string("a factor of ") + number);
}

void guess_J(Sample& s, double tolerance) {
  const bool swapped = close(s.yours, bodies_swapped(s.right), tolerance);
  const bool told = std::any_of(s.mistakes.begin(), s.mistakes.end(), [](const auto& known) {
    return known.starts_with("the sign of the whole row");  // in the fixture's own words
  });
  std::string words = swapped ? "bodies 1 and 2 swapped" : "";
  if (close(s.yours, negative(s.right), tolerance) && !told)
    words = swapped ? "the sign of the whole row, or bodies 1 and 2 swapped"
                    : "the sign of the whole row: C grows when body 2 moves positively";
  guess(s, tolerance, words);
  const std::string blocks = block_mistake(s, tolerance);
  if (!blocks.empty()) s.mistakes.push_back(blocks);
  if (!swapped && all_finite(s.yours) && other_order(s, tolerance))
    s.mistakes.push_back("the order of the blocks: a row is {v1, w1, v2, w2}");
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

// The pose's name, and what it is for.
PoseWords pose_of(const Sample& s) {
  return s.pose == 3 ? s.broken : PoseWords{pose_names[s.pose], pose_words[s.pose]};
}

std::vector<std::string> poses_of(const std::vector<const Sample*>& samples) {
  std::vector<std::string> names;
  for (const Sample* s : samples)
    if (const char* name = pose_of(*s).name; names.empty() || names.back() != name)
      names.push_back(name);
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
  return std::string("Pose: ") + pose_of(s).name + " (" + pose_of(s).words + ")." +
         (s.pose == pencil_and_paper ? "" : " Numeric: " + numeric) + "\n\n";
}
Table table_for(const Sample& s) {
  return Table(s.pose == pencil_and_paper ? "by hand " : "numeric ");
}

}  // namespace

std::string jacobian_report(const std::vector<std::string>& rows, std::vector<Sample> samples,
                            double tolerance) {
  const Sample* wrong = first_wrong(samples, tolerance);
  if (!wrong) {
    proved("Jacobians");
    proved("poses of Jacobians", long(samples.size()));
    return "";
  }
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
  if (!wrong) {
    proved("effective masses");
    proved("poses of effective masses", long(samples.size()));
    return "";
  }
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
