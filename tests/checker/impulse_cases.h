// Rows and their impulse, exercises 1.3 (one row) and 2.3 (a block of three): which impulse they
// lack, the usual mistakes, and cases. The effect of the impulse is in push_cases.h.
#pragma once

#include <valarray>

#include "tests/checker/cases.h"

namespace joints::testing {

inline const char* const told_minus_body_1_j =
    "#minus-body-1-j the sign of a body in J V: all four products are added";

using PerRow = std::valarray<double>;  ///< a number for each row

struct LackCase {
  std::string words;
  std::vector<Row> J;
  std::vector<real> K;  ///< row after row
  PerRow b;
  Pair pair;
  double unit = 1;  ///< lambda is shown in these [N s]
};

/// The numbers that lambda is made of, right or wrong.
struct Lack {
  const LackCase& c;
  PerRow b = c.b, JV = rates([](Row&) {}), none = 0 * c.b;
  std::vector<real> inverse = [this] {
    std::vector<real> K = c.K;
    invert_symmetric(K.data(), int(c.b.size()));  // of 0 it is 0
    return K;
  }();

  explicit Lack(const LackCase& lack) : c(lack) {}
  /// Where K = 0 is divided by.
  static Lack unguarded(const LackCase& lack) {
    Lack out(lack);
    if (lack.K == std::vector<real>{0}) out.inverse = {1 / lack.K[0]};
    return out;
  }
  /// J V, where something is changed in each row.
  PerRow rates(const Call<void(Row&)>& change) const {
    PerRow out(c.J.size());
    for (std::size_t i = 0; i < c.J.size(); ++i) {
      Row row = c.J[i];
      change(row);
      out[i] = double(row_velocity(row, c.pair.body1, c.pair.body2));
    }
    return out;
  }
  static PerRow times(const std::vector<real>& A, const PerRow& x) {
    PerRow out(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j) out[i] += double(A[i * x.size() + j]) * x[j];
    return out;
  }
  PerRow over_K(const PerRow& x) const { return times(inverse, x); }
  PerRow times_K(const PerRow& x) const { return times(c.K, x); }
  PerRow lambda() const { return -over_K(JV + b); }
};

inline bool all_below(const PerRow& x, double limit) { return std::abs(x).max() < limit; }

using LackMistakes = std::vector<Mistake<Call<PerRow(const Lack&)>>>;

/// Where nothing is done though something should be.
inline std::vector<Mistake<Call<bool(const Lack&)>>> lack_guards() {
  using L = const Lack&;
  const char* const no_bias = "#nothing-done-where-bias nothing is done where the bias is 0: even "
                              "where C = 0 the velocity J V would change C";
  const char* const no_rate = "#only-where-something-moves nothing is done where J V is 0: the "
                              "error still has to be corrected";
  const char* const heavy = "#small-k-taken-none nothing is done where K is small: K is small for "
                            "heavy bodies, and only 0 means that no body can move";
  return {
      {no_bias, [](L l) { return all_below(l.b, 1e-12); }},
      {no_bias, [](L l) { return all_below(l.b, 1e-8); }},
      {no_rate, [](L l) { return all_below(l.JV, 1e-12); }},
      {no_rate, [](L l) { return all_below(l.JV, 1e-8); }},
      {"#nothing-done-where-one nothing is done where one body is static: the other one can move",
       [](L l) { return l.c.pair.body1.is_static() || l.c.pair.body2.is_static(); }},
      {heavy, [](L l) { return l.c.K[0] < 0.1; }},
      {heavy, [](L l) { return l.c.K[0] < 1e-15; }},
      {"#small-rates-left-out nothing is done where J V + b is small: there is no such threshold",
       [](L l) { return all_below(l.JV + l.b, 1e-3); }},
  };
}

/// The mistakes that one row and a block have in common.
inline LackMistakes lack_mistakes() {
  using L = const Lack&;
  const auto reading = [](Call<void(Row&)> change) {
    return [change](L l) -> PerRow { return -l.over_K(l.rates(change) + l.b); };
  };
  const char* const bias_alone = "#brackets-forgotten-bias-over only the bias is divided by K: "
                                 "put J V + b in brackets";
  const char* const rate_alone = "#brackets-forgotten-rate-over only J V is divided by K: put J V "
                                 "+ b in brackets";
  const char* const four_blocks =
      "#j-v-rod J V is written out as if J.v1 and J.v2 were known: row_velocity reads all four "
      "blocks";
  const char* const either_sign = "#never-a-pull a row may push and pull: lambda has either sign";
  const char* const size = "#size-impulse the sign is lost: lambda is not a size";
  const char* const bias_as_it_is = "#beta-once-more the bias b is used as it is: neither beta "
                                    "nor h belongs here";
  return {
      {"0 is returned always", [](L l) { return l.none; }},
      {"#sign-impulse the sign: the impulse works against J V + b",
       [](L l) -> PerRow { return -l.lambda(); }},
      {"#times-k times K where its inverse belongs",
       [](L l) -> PerRow { return -l.times_K(l.JV + l.b); }},
      {"#without-k K is missing: a velocity is no impulse",
       [](L l) -> PerRow { return -(l.JV + l.b); }},
      {"#without-bias the bias is missing: the error is not fed back",
       [](L l) -> PerRow { return -l.over_K(l.JV); }},
      {"J V is missing", [](L l) -> PerRow { return -l.over_K(l.b); }},
      {"#sign-bias the sign of the bias", [](L l) -> PerRow { return -l.over_K(l.JV - l.b); }},
      {bias_alone, [](L l) -> PerRow { return l.over_K(l.b) - l.JV; }},
      {bias_alone, [](L l) -> PerRow { return -l.over_K(l.b) - l.JV; }},
      {rate_alone, [](L l) -> PerRow { return l.b - l.over_K(l.JV); }},
      {rate_alone, [](L l) -> PerRow { return -l.b - l.over_K(l.JV); }},
      {"#bodies-exchanged-j-v bodies 1 and 2 are exchanged in J V", reading([](Row& r) {
         std::swap(r.v1, r.v2);
         std::swap(r.w1, r.w2);
       })},
      {"#angular-velocities-left-out the angular velocities are missing in J V: row_velocity "
       "reads all four blocks",
       reading([](Row& r) { r.w1 = r.w2 = vec3(0); })},
      {"#body-1-left-out body 1 is missing in J V", reading([](Row& r) { r.v1 = r.w1 = vec3(0); })},
      {"body 2 is missing in J V", reading([](Row& r) { r.v2 = r.w2 = vec3(0); })},
      {told_minus_body_1_j,
       reading([](Row& r) { r.v1 = -r.v1, r.w1 = -r.w1; })},
      {told_minus_body_1_j,
       reading([](Row& r) { r.v2 = -r.v2, r.w2 = -r.w2; })},
      {four_blocks, reading([](Row& r) { r.v1 = -r.v2; })},
      {four_blocks, reading([](Row& r) { r = {-r.v2, vec3(0), r.v2, vec3(0)}; })},
      {"#cut-int the fraction is cut off: an int holds whole numbers only",
       [](L l) -> PerRow { return l.lambda().apply([](double a) { return std::trunc(a); }); }},
      {"a factor of 0.5", [](L l) -> PerRow { return 0.5 * l.lambda(); }},
      {"a factor of 2", [](L l) -> PerRow { return 2.0 * l.lambda(); }},
      {either_sign, [](L l) -> PerRow { return (l.lambda() + std::abs(l.lambda())) / 2; }},
      {either_sign, [](L l) -> PerRow { return (l.lambda() - std::abs(l.lambda())) / 2; }},
      {size, [](L l) -> PerRow { return std::abs(l.lambda()); }},
      {size, [](L l) -> PerRow { return -std::abs(l.lambda()); }},
      {bias_as_it_is, [](L l) -> PerRow { return -l.over_K(l.JV + 0.2 * l.b); }},
      {bias_as_it_is, [](L l) -> PerRow { return -l.over_K(l.JV + 60.0 * l.b); }},
      {bias_as_it_is, [](L l) -> PerRow { return -l.over_K(l.JV + l.b / 60); }},
  };
}

/// A table without cases: `yours` gives lambda. \param own mistakes that only this exercise knows
inline CaseTable<LackCase> lack_table(const Subject& subject, std::vector<std::string> entries,
                                      Call<PerRow(const LackCase&)> yours,
                                      const LackMistakes& own) {
  const auto shown = [](const PerRow& lambda, const LackCase& c) {
    Numbers out;
    for (double a : lambda) out.push_back(a / c.unit);
    return out;
  };
  CaseTable<LackCase> table{subject, std::move(entries), {}, {}, {}, {}};
  table.whole = true;
  table.tolerance = 1e2 * rounding;
  table.yours = [=](const LackCase& c) { return shown(yours(c), c); };
  table.right = [=](const LackCase& c) { return shown(Lack(c).lambda(), c); };
  for (const auto& [words, lambda] : own)
    table.mistakes.push_back(
        {words, [=, answer = lambda](const LackCase& c) { return shown(answer(Lack(c)), c); }});
  const auto unless = [=](const auto& guard, const auto& answer) {
    return [=](const LackCase& c) {
      const Lack lack(c);
      return shown(c.K[0] == 0 || guard(lack) ? lack.none : answer(lack), c);
    };
  };
  for (const auto& [words, lambda] : lack_mistakes())
    table.mistakes.push_back({words, unless([](const Lack&) { return false; }, lambda)});
  for (const auto& [words, guard] : lack_guards())
    table.mistakes.push_back({words, unless(guard, [](const Lack& l) { return l.lambda(); })});
  table.pairs = [=] {
    CaseTable<LackCase>::Mistakes out;
    for (const auto& [words, lambda] : lack_mistakes()) {
      for (const auto& [other, guard] : lack_guards())
        out.push_back({words + "; and " + other, unless(guard, lambda)});
      out.push_back({words + "; and K = 0 is divided by", [=, answer = lambda](const LackCase& c) {
                       return shown(answer(Lack::unguarded(c)), c);
                     }});
    }
    return out;
  };
  return table;
}

}  // namespace joints::testing
