#include "checker/guess.h"

#include <algorithm>

#include "checker/patterns.h"
#include "checker/report.h"

namespace joints::testing {

const char* const told_all_zero = "#all-zero every entry is zero";

namespace {

Numbers negative(Numbers numbers) {
  for (double& number : numbers) number = -number;
  return numbers;
}
bool zero(const Numbers& numbers, double tolerance) {
  return close(numbers, Numbers(numbers.size(), 0), tolerance);
}

// The number by which all right entries were multiplied, or 0 if there is none.
double common_factor(const Sample& s, double tolerance) {
  std::size_t largest = 0;
  for (std::size_t i = 0; i < s.right.size(); ++i)
    if (std::abs(s.right[i]) > std::abs(s.right[largest])) largest = i;
  const double factor = s.yours[largest] / s.right[largest];
  for (std::size_t i = 0; i < s.right.size(); ++i)
    if (!near(s.yours[i], factor * s.right[i], tolerance * (1 + std::abs(factor)))) return 0;
  return factor;
}

// ---- rows of a J or K ---------------------------------------------------------------------------

struct RowsOf {
  const Sample& s;
  double tolerance;
  std::size_t count, width;
  std::vector<std::size_t> wrong;

  RowsOf(const Sample& s, double tolerance, std::size_t count)
      : s(s), tolerance(tolerance), count(count), width(s.right.size() / count) {
    for (std::size_t i = 0; i < count; ++i)
      if (!close(of(s.yours, i), of(s.right, i), tolerance)) wrong.push_back(i);
  }
  Numbers of(const Numbers& all, std::size_t row) const {
    const auto begin = all.begin() + long(row * width);
    return {begin, begin + long(width)};
  }
  /// The right row that yours is, another than its own; `count` where there is none.
  std::size_t other(std::size_t row) const {
    for (std::size_t k = 0; k < count; ++k)
      if (k != row && close(of(s.yours, row), of(s.right, k), tolerance)) return k;
    return count;
  }
};

// What is wrong with the rows as they stand below one another. \param letter J or K
std::string row_mistake(const RowsOf& rows, const std::string& letter,
                        const std::vector<std::string>& names) {
  const auto called = [&](std::size_t i) {
    return letter + "[" + std::to_string(i) + "], the row " + names[i];
  };
  const auto& wrong = rows.wrong;
  std::vector<std::string> empty, repeated;
  bool exchanged = true;
  for (const std::size_t i : wrong) {
    const std::size_t k = rows.other(i);
    exchanged = exchanged && k < rows.count && rows.other(k) < rows.count;
    if (zero(rows.of(rows.s.yours, i), rows.tolerance)) empty.push_back(called(i));
    else if (k < rows.count && std::find(wrong.begin(), wrong.end(), k) == wrong.end())
      repeated.push_back(called(i) + ", repeats " + letter + "[" + std::to_string(k) + "]");
  }
  if (wrong.size() == 2 && empty.size() == 1)
    for (const std::size_t k : {0, 1})
      if (rows.other(wrong[k]) == wrong[1 - k])
        return letter + "[" + std::to_string(wrong[k]) + "] is written twice, " + letter + "[" +
               std::to_string(wrong[1 - k]) + "] never: the row " + names[wrong[1 - k]] +
               " stands in the place of " + names[wrong[k]];
  if (empty.size() == wrong.size())
    return joined(empty) + (empty.size() == 1 ? ", is zero: was it never written?"
                                              : ", are zero: were they never written?");
  if (repeated.size() == wrong.size()) return joined(repeated);
  if (exchanged && wrong.size() == 2)
    return "the rows " + names[wrong[0]] + " and " + names[wrong[1]] + " are exchanged";
  if (exchanged) return "the rows are in another order";
  return "";
}

// The blocks of a row that are another row's: copied, and not changed. "" where it is not so.
std::string copied_blocks(const RowsOf& rows) {
  std::vector<std::string> words;
  for (const std::size_t i : rows.wrong)
    for (std::size_t b = 0; b < 4; ++b) {
      const auto block = [&](const Numbers& all, std::size_t row) {
        const auto begin = all.begin() + long(12 * row + 3 * b);
        return Numbers(begin, begin + 3);
      };
      const Numbers yours = block(rows.s.yours, i);
      if (close(yours, block(rows.s.right, i), rows.tolerance)) continue;
      std::size_t k = 0;
      while (k < rows.count && !close(yours, block(rows.s.right, k), rows.tolerance)) ++k;
      if (k == rows.count || zero(yours, rows.tolerance)) return "";
      words.push_back(std::string(block_names[b]) + " of J[" + std::to_string(i) +
                      "] is that of J[" + std::to_string(k) + "]");
    }
  return joined(words);
}

// ---- blocks of a J ------------------------------------------------------------------------------

Numbers bodies_swapped(const Numbers& J) {
  Numbers out = J;
  for (std::size_t i = 0; i < J.size(); ++i) out[i] = J[i / 12 * 12 + (i + 6) % 12];
  return out;
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

// How a block of yours compares with the right one.
struct Block {
  bool right = true, opposite = true, zero = true, should_be_zero = true, transposed = true;

  Block(const Sample& s, std::size_t block, double tolerance) {
    transposed = s.right.size() == 36;
    for (std::size_t i = 0; i < s.yours.size(); ++i) {
      if (i % 12 / 3 != block) continue;
      right = right && near(s.yours[i], s.right[i], tolerance);
      opposite = opposite && near(s.yours[i], -s.right[i], tolerance);
      zero = zero && near(s.yours[i], 0, tolerance);
      should_be_zero = should_be_zero && near(s.right[i], 0, tolerance);
      if (transposed)
        transposed = near(s.yours[i], s.right[12 * (i % 3) + 3 * block + i / 12], tolerance);
    }
  }
};

// The wrong blocks of J, if each of them is the right one with its sign turned, doubled or halved,
// or transposed, or is missing, or should not be there.
std::string block_mistake(const Sample& s, double tolerance) {
  std::vector<std::string> signs, missing, superfluous, transposed, words;
  for (std::size_t b = 0; b < 4; ++b) {
    const Block block(s, b, tolerance);
    if (block.right) continue;
    if (block.opposite) signs.push_back(block_names[b]);
    else if (block.transposed) transposed.push_back(block_names[b]);
    else if (block.zero) missing.push_back(block_names[b]);
    else if (block.should_be_zero) superfluous.push_back(block_names[b]);
    else if (const std::string factor = block_factor(s, b, tolerance); !factor.empty())
      words.push_back(factor);
    else return "";
  }
  if (!signs.empty())
    words.push_back("the sign of " + blocks(signs) +
                    (joined(signs) == "v1 and w1" ? ": body 1 carries the minus sign" : ""));
  if (!transposed.empty())
    words.push_back(blocks(transposed) + (transposed.size() == 1 ? " is" : " are") +
                    " transposed: mat3(a, b, c) and M[k] are columns");
  if (!missing.empty())
    words.push_back(blocks(missing) + (missing.size() == 1 ? " is missing" : " are missing"));
  if (!superfluous.empty()) words.push_back(blocks(superfluous) + " should be zero");
  return joined(words);
}

// ---- common to J and K --------------------------------------------------------------------------

// Adds the conclusions from the numbers alone: `first`, for J or K, comes before the earlier ones.
void guess(Sample& s, double tolerance, const std::string& first) {
  std::string words = first;
  if (any_unset(s.yours, s.right)) {
    s.mistakes = {never_set};
    return;
  }
  if (!seven_digits({{s.yours, s.right}}).empty()) {
    s.mistakes = {few_digits};  // what fits within the tolerance fits by chance
    return;
  }
  if (!all_finite(s.yours) && first.empty()) words = division_by_zero;
  else if (zero(s.yours, tolerance)) words = told_all_zero;
  if (!words.empty()) s.mistakes.insert(s.mistakes.begin() + s.own, words);
  if (long(s.mistakes.size()) > s.own) return;
  const double factor = common_factor(s, tolerance);
  for (const char* number : {"2", "4", "0.5", "0.25"})
    if (near(factor, std::atof(number), tolerance))
      s.mistakes.push_back(std::string("a factor of ") + number);
}

// What is wrong with J if it is the same in all the rows of the sample.
void guess_rows(Sample& s, double tolerance) {
  const bool swapped = close(s.yours, bodies_swapped(s.right), tolerance);
  const bool told = std::any_of(s.mistakes.begin(), s.mistakes.end(), [](const auto& known) {
    // in the fixture's own words
    return without_ids(known).starts_with("the sign of the whole row");
  });
  std::string words = swapped && !told ? "#bodies-swapped bodies 1 and 2 swapped" : "";
  if (close(s.yours, negative(s.right), tolerance) && !told)
    words = swapped ? "#sign-row the sign of the whole row, or bodies 1 and 2 swapped"
                    : "#sign-all-rows the sign of the whole row: C grows when body 2 moves "
                      "positively";
  guess(s, tolerance, words);
  if (!all_finite(s.yours) || any_unset(s.yours, s.right)) return;
  Numbers sizes = s.right;
  for (double& number : sizes) number = std::abs(number);
  if (close(s.yours, sizes, tolerance))
    s.mistakes.push_back("absolute values: the numbers of J have a sign");
  if (!swapped && other_order(s, tolerance))
    s.mistakes.push_back("#order-of-blocks the order of the blocks: a row is {v1, w1, v2, w2}");
  const std::string blocks = block_mistake(s, tolerance);
  if (!blocks.empty()) s.mistakes.push_back(blocks);
}

// The rows of the sample that are wrong, as a sample of their own.
Sample wrong_rows(const RowsOf& rows) {
  Sample out{rows.s.pose, {}, {}, {}, rows.s.broken};
  for (const std::size_t i : rows.wrong) {
    const Numbers yours = rows.of(rows.s.yours, i), right = rows.of(rows.s.right, i);
    out.yours.insert(out.yours.end(), yours.begin(), yours.end());
    out.right.insert(out.right.end(), right.begin(), right.end());
  }
  return out;
}

bool pushes(const Numbers& J) {
  for (std::size_t i = 0; i < J.size(); ++i)
    if (i % 6 < 3 && J[i] != 0) return true;
  return false;
}

}  // namespace

void guess_J(Sample& s, double tolerance, const std::vector<std::string>& names) {
  guess_rows(s, tolerance);
  if (!all_finite(s.yours) || any_unset(s.yours, s.right)) return;
  const RowsOf rows(s, tolerance, names.size());
  if (const std::string words = row_mistake(rows, "J", names); !words.empty())
    s.mistakes.push_back(words);
  if (rows.wrong.size() < names.size()) {
    Sample part = wrong_rows(rows);
    guess_rows(part, tolerance);
    std::vector<std::string> wrong;
    for (const std::size_t i : rows.wrong) wrong.push_back(names[i]);
    for (const std::string& words : part.mistakes)
      if (words != told_all_zero)  // said of the row above
        s.mistakes.push_back("in " + joined(wrong) + " alone: " + words);
    if (const std::string words = copied_blocks(rows); !words.empty())
      s.mistakes.push_back(words);
  }
  bool opposite = true;
  for (std::size_t i = 0; i < s.right.size(); ++i)
    opposite = opposite && near(std::abs(s.yours[i]), std::abs(s.right[i]), tolerance);
  if (s.mistakes.empty() && opposite)
    s.mistakes.push_back("#one-sign the sign of single entries: those that are marked x");
  if (s.mistakes.empty() && common_factor(s, tolerance) != 0)
    s.mistakes.push_back(pushes(s.right) ? "a factor: is the direction a unit vector?"
                                         : "a factor: all of it is multiplied by one number");
}

void guess_K(Sample& s, double tolerance, const std::vector<std::string>& names) {
  const bool opposite = close(s.yours, negative(s.right), tolerance);
  guess(s, tolerance,
        !all_finite(s.yours) ? "a division by zero: 1/m of a static body is 0, K adds it as it is"
        : opposite           ? "the sign: K is never negative"
                             : "");
  const std::size_t n = names.size();
  if (!s.mistakes.empty() || n == 1) return;
  const RowsOf rows(s, tolerance, n);
  Numbers diagonal = s.right, beside = s.right, upper = s.right, lower = s.right;
  bool symmetric = true;
  for (std::size_t i = 0; i < n * n; ++i) {
    const std::size_t row = i / n, column = i % n;
    (row == column ? beside : diagonal)[i] = 0;
    if (row > column) upper[i] = 0;
    if (row < column) lower[i] = 0;
    symmetric = symmetric && near(s.yours[i], s.yours[column * n + row], tolerance);
  }
  for (const auto& [numbers, words] :
       {std::pair(diagonal, "#only-the-diagonal the entries beside the diagonal are missing"),
        std::pair(beside, "the diagonal is missing"),
        std::pair(upper, "the lower half is missing: K is symmetric"),
        std::pair(lower, "the upper half is missing: K is symmetric")})
    if (close(s.yours, numbers, tolerance)) s.mistakes.push_back(words);
  if (const std::string words = row_mistake(rows, "K", names); !words.empty())
    s.mistakes.push_back(words);
  if (s.mistakes.empty() && !symmetric) s.mistakes.push_back("#order-product K is symmetric, and "
                                                             "yours is not");
}

}  // namespace joints::testing
