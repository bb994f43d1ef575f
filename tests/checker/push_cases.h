// What the impulse of rows does to two bodies, exercises 1.3 (one row) and 2.3 (a block of three):
// V += M^-1 J^T lambda.
#pragma once

#include "checker/report.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct PushCase {
  std::string words;
  std::vector<Row> J;
  std::vector<real> lambda;
  Pair pair;
};

inline const std::vector<std::string> push_entries{
    "v1.x", "v1.y", "v1.z", "w1.x", "w1.y", "w1.z", "v2.x", "v2.y", "v2.z", "w2.x", "w2.y", "w2.z",
    "x1.x", "x1.y", "x1.z", "x2.x", "x2.y", "x2.z"};

inline Numbers numbers_of(const Pair& pair) {
  Numbers out;
  for (const vec3& a : {pair.body1.v, pair.body1.w, pair.body2.v, pair.body2.w, pair.body1.x,
                        pair.body2.x})
    for (int i = 0; i < 3; ++i) out.push_back(double(a[i]));
  return out;
}

inline Numbers pushed(const PushCase& c) {
  Pair pair = c.pair;
  auto& [one, two] = pair;
  std::vector<Row> responses(c.J.size());
  form_responses(c.J.data(), int(c.J.size()), one, two, responses.data());
  for (std::size_t i = 0; i < c.J.size(); ++i) {
    const auto& [v1, w1, v2, w2] = responses[i];
    one.v += c.lambda[i] * v1, one.w += c.lambda[i] * w1;
    two.v += c.lambda[i] * v2, two.w += c.lambda[i] * w2;
  }
  return numbers_of(pair);
}

/// Of each of the four velocities that is wrong, which mistake makes it so in all cases; "" where
/// none is known.
inline std::string velocity_by_velocity(const CaseTable<PushCase>& table) {
  const char* const names[] = {"v1", "w1", "v2", "w2"};
  std::vector<std::pair<std::string, std::vector<std::string>>> found;  // words, velocities
  std::vector<Numbers> mine;
  for (const PushCase& c : table.cases) mine.push_back(table.yours(c));
  // Is this block of three numbers yours in all cases?
  const auto fits = [&](std::size_t block, const auto& answer) {
    for (std::size_t k = 0; k < mine.size(); ++k) {
      const Numbers wanted = answer(table.cases[k]);
      for (std::size_t i = 3 * block; i < 3 * block + 3; ++i) {
        const bool none = !std::isfinite(mine[k][i]) && !std::isfinite(wanted[i]);  // a static body
        if (!none && !near(mine[k][i], wanted[i], table.tolerance)) return false;
      }
    }
    return true;
  };
  for (std::size_t block = 0; block < 4; ++block) {
    if (fits(block, pushed)) continue;
    bool known = false;
    for (const auto& [words, mistake] : table.mistakes) {
      if (!fits(block, mistake)) continue;
      known = true;
      auto same = std::find_if(found.begin(), found.end(),
                               [&, w = words](const auto& one) { return one.first == w; });
      if (same == found.end()) found.push_back({words, {names[block]}});
      else same->second.push_back(names[block]);
      break;
    }
    for (const Numbers& numbers : mine)  // of these the report says more by itself
      if (!known && !no_number(numbers).empty()) return "";
  }
  if (!fits(4, pushed) || !fits(5, pushed))
    found.push_back({"#positions-moved-too an impulse changes velocities and not positions",
                     {"x"}});
  std::string out;
  for (const auto& [words, where] : found)
    out += (out.empty() ? "" : "; ") + words + " (" + joined(where) + ")";
  return out;
}

/// The table of exercise 1.3 or 2.3. \param push (function, case, pair) changes its velocities
template <class Function, class Push>
CaseTable<PushCase> push_table(const Subject& subject, Function* yours, const Push& push,
                               std::vector<PushCase> cases) {
  CaseTable<PushCase> table{subject, push_entries, {}, pushed, {}, std::move(cases)};
  judge(table, yours, [=](auto f, const PushCase& c) {
    Pair pair = c.pair;
    push(f, c, pair);
    return numbers_of(pair);
  });
  table.whole = true;
  table.tolerance = 10 * rounding;
  if (const std::string words = velocity_by_velocity(table); !words.empty())
    table.mistakes.push_back({words, table.yours});
  return table;
}

}  // namespace joints::testing
