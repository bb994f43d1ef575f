// What the impulse of rows does to two bodies, exercises 1.3 (one row) and 2.3 (a block of three):
// V += M^-1 J^T lambda, the usual mistakes, and cases.
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

/// One of the two bodies, and the parts of the rows that belong to it.
struct Pushed {
  const PushCase& c;
  bool second;
  const Body &self = second ? c.pair.body2 : c.pair.body1,
             &other = second ? c.pair.body1 : c.pair.body2;
  mat3 I = inverse_inertia(self);
  std::size_t rows = c.J.size();

  vec3 v(std::size_t i) const { return second ? c.J[i].v2 : c.J[i].v1; }
  vec3 w(std::size_t i) const { return second ? c.J[i].w2 : c.J[i].w1; }
  vec3 v_other(std::size_t i) const { return second ? c.J[i].v1 : c.J[i].v2; }
  vec3 w_other(std::size_t i) const { return second ? c.J[i].w1 : c.J[i].w2; }
};
using Block = vec3 (Pushed::*)(std::size_t) const;

/// J^T lambda of one block, or what a mistake makes of it.
using Sum = Call<vec3(const Pushed&, Block)>;
inline vec3 right_sum(const Pushed& p, Block block) {
  vec3 out(0);
  for (std::size_t i = 0; i < p.rows; ++i) out += p.c.lambda[i] * (p.*block)(i);
  return out;
}

/// Mistakes in J^T lambda, the same for v and w.
inline std::vector<Mistake<Sum>> sum_mistakes(std::size_t rows) {
  using P = const Pushed&;
  std::vector<Mistake<Sum>> out{
      {"a factor of 0.5", [](P p, Block b) { return real(0.5) * right_sum(p, b); }},
      {"a factor of 2", [](P p, Block b) { return real(2) * right_sum(p, b); }}};
  // a term for each row in place of lambda[i] (p.*b)(i)
  const auto add = [&](const char* words, auto term) {
    out.push_back({words, [term](P p, Block b) {
                     vec3 sum(0);
                     for (std::size_t i = 0; i < p.rows; ++i) sum += term(p, b, i);
                     return sum;
                   }});
  };
  add("#without-lambda lambda is missing", [](P p, Block b, std::size_t i) { return (p.*b)(i); });
  if (rows == 1) return out;
  const auto only = [&](const char* words, bool first, bool middle, bool last) {
    add(words, [=](P p, Block b, std::size_t i) {
      const bool here = i == 0 ? first : i == 1 ? middle : last;
      return here ? p.c.lambda[i] * (p.*b)(i) : vec3(0);
    });
  };
  only("#only-first-row only the first row pushes: all three do, each with its lambda[i]",
       true, false, false);
  only("only the last row pushes: all three do, each with its lambda[i]", false, false, true);
  only("#first-row-left-out the first row is left out: rows are J[0], J[1], J[2]",
       false, true, true);
  only("#last-row-left-out the last row is left out: rows are J[0], J[1], J[2]", true, true, false);
  const auto lambda = [](P p) { return vec3(p.c.lambda[0], p.c.lambda[1], p.c.lambda[2]); };
  add("#j-without-transpose J where J^T belongs: row i pushes along J[i] with lambda[i]",
      [=](P p, Block b, std::size_t i) {
        vec3 across(0);
        across[int(i)] = dot((p.*b)(i), lambda(p));
        return across;
      });
  add("#lambda-0-every-row lambda[0] in every row: row i has its own lambda[i]",
      [=](P p, Block b, std::size_t i) { return lambda(p).x * (p.*b)(i); });
  add("#j-0-every-row J[0] in every row: row i pushes along J[i]",
      [=](P p, Block b, std::size_t i) { return p.c.lambda[i] * (p.*b)(0); });
  add("#lambda-times-j-number a vector times a vector is taken number by number: row i pushes "
      "along J[i] with the number lambda[i]",
      [=](P p, Block b, std::size_t i) { return lambda(p) * (p.*b)(i); });
  add("the length of lambda: row i has its own lambda[i]",
      [=](P p, Block b, std::size_t i) { return length(lambda(p)) * (p.*b)(i); });
  return out;
}

/// What a mistake makes of one velocity.
using NewVelocity = Call<vec3(const Pushed&)>;

/// Mistakes with w (or v).
inline std::vector<Mistake<NewVelocity>> velocity_mistakes(std::size_t rows, bool turns) {
  using P = const Pushed&;
  const Block mine = turns ? &Pushed::w : &Pushed::v;
  const auto old = [=](P p) { return turns ? p.self.w : p.self.v; };
  const auto answer = [=](P p, const vec3& a) {
    return turns ? p.I * a : p.self.inverse_mass * a;
  };
  const auto along = [=](Block block, real sign) {
    return [=](P p) { return old(p) + sign * answer(p, right_sum(p, block)); };
  };
  const auto by = [=](auto factor) {
    return [=](P p) { return old(p) + factor(p) * right_sum(p, mine); };
  };
  const char* const set = "#velocities-set the velocity is set where it must grow: += and not =";
  std::vector<Mistake<NewVelocity>> out{
      {"#not-changed not changed at all", old},
      {"#one-sign-too-many the sign: velocities grow by +M^-1 J^T lambda", along(mine, -1)},
      {set, [=](P p) { return answer(p, right_sum(p, mine)); }},
      {set, [=](P p) { return answer(p, p.c.lambda.back() * (p.*mine)(p.rows - 1)); }},
  };
  const auto more = [&](const char* words, NewVelocity mistake) {
    out.push_back({words, std::move(mistake)});
  };
  if (turns) {
    const auto diagonal = [](const vec3& a) { return mat3(a.x, 0, 0, 0, a.y, 0, 0, 0, a.z); };
    more("the block w of the other body", along(&Pushed::w_other, 1));
    more("the block w of the other body with its sign turned", along(&Pushed::w_other, -1));
    more("#blocks-v-w the block v of the row where w belongs", along(&Pushed::v, 1));
    more("#without-inertia the inverse inertia is missing", by([](P) { return mat3(1); }));
    more("#body-space-inertia body-space inertia: take inverse_inertia(body)",
         by([=](P p) { return diagonal(p.self.inverse_inertia_local); }));
    more("#inertia-inverse inertia where inverse inertia belongs",
         by([](P p) { return glm::inverse(p.I); }));
    more("#mass-for-inertia inverse mass where inverse inertia belongs",
         by([](P p) { return mat3(p.self.inverse_mass); }));
    more("#inertia-other-body the inertia of the other body",
         by([](P p) { return inverse_inertia(p.other); }));
  } else {
    more("the block v of the other body", along(&Pushed::v_other, 1));
    more("the block v of the other body with its sign turned: a row need not be (-n, ..., n, ...)",
         along(&Pushed::v_other, -1));
    more("the block w of the row where v belongs", along(&Pushed::w, 1));
    more("#without-inverse-masses the inverse mass is missing", by([](P) { return real(1); }));
    more("#masses-inverse-masses mass where inverse mass belongs",
         by([](P p) { return 1 / p.self.inverse_mass; }));
    more("#masses-exchanged the inverse mass of the other body",
         by([](P p) { return p.other.inverse_mass; }));
    more("the inverse masses of both bodies: each body has its own",
         by([](P p) { return p.self.inverse_mass + p.other.inverse_mass; }));
  }
  for (const auto& [words, sum] : sum_mistakes(rows))
    out.push_back({words, [=, sum = sum](P p) { return old(p) + answer(p, sum(p, mine)); }});
  for (const real sign : {real(1), real(-1)})
    if (rows == 1)
      more("#j-missing J is missing: lambda acts along J.v1, J.w1, J.v2 and J.w2. A number added "
           "to a vector is added to each of its components",
           [=](P p) { return old(p) + sign * answer(p, vec3(p.c.lambda[0])); });
  for (const real sign : {real(-1), real(1)})
    if (rows == 3)
      more(turns ? "lambda is added without J.w1 and J.w2"
                 : "#lambda-added-v lambda is added without J.v1 and J.v2: they are not -E and E "
                   "in every joint",
           [=](P p) {
             const vec3 lambda(p.c.lambda[0], p.c.lambda[1], p.c.lambda[2]);
             return old(p) + (p.second ? sign : -sign) * answer(p, lambda);
           });
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
  const std::size_t rows = table.cases.front().J.size();
  const std::vector<Mistake<NewVelocity>> kinds[] = {
      velocity_mistakes(rows, false), velocity_mistakes(rows, true)};
  std::vector<Numbers> mine;
  for (const PushCase& c : table.cases) mine.push_back(table.yours(c));
  const auto fits = [&](std::size_t block, const NewVelocity* mistake) {
    for (std::size_t k = 0; k < mine.size(); ++k) {
      const PushCase& c = table.cases[k];
      const vec3 a = mistake ? (*mistake)({c, block >= 2}) : vec3(0);
      const Numbers right = pushed(c);
      for (int i = 0; i < 3; ++i) {
        const double wanted = mistake ? double(a[i]) : right[3 * block + i];
        const double yours = mine[k][3 * block + i];
        const bool none = !std::isfinite(yours) && !std::isfinite(wanted);  // of a static body
        if (!none && !near(yours, wanted, table.tolerance)) return false;
      }
    }
    return true;
  };
  for (std::size_t block = 0; block < 4; ++block) {
    if (fits(block, nullptr)) continue;
    bool known = false;
    for (const auto& [words, mistake] : kinds[block % 2]) {
      if (!fits(block, &mistake)) continue;
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
  if (!fits(4, nullptr) || !fits(5, nullptr))
    found.push_back({"#positions-moved-too an impulse changes velocities and not positions",
                     {"x"}});
  std::string out;
  for (const auto& [words, where] : found)
    out += (out.empty() ? "" : "; ") + words + " (" + joined(where) + ")";
  return out;
}

/// Mistakes that do not concern one velocity alone.
inline CaseTable<PushCase>::Mistakes pair_mistakes() {
  const auto unless = [](auto condition) {
    return [=](const PushCase& c) { return condition(c) ? numbers_of(c.pair) : pushed(c); };
  };
  const auto below = [](const PushCase& c, real limit) {
    return std::all_of(c.lambda.begin(), c.lambda.end(), [=](real a) { return a < limit; });
  };
  return {
      {"#both-shares-body-1 the part of body 2 is given to body 1",
       [](const PushCase& c) {
         const Pushed p{c, true};
         Pair pair = c.pair;
         pair.body1.v += p.self.inverse_mass * right_sum(p, &Pushed::v);
         pair.body1.w += p.I * right_sum(p, &Pushed::w);
         Numbers out = numbers_of(pair);
         const Numbers right = pushed(c);
         for (int i = 0; i < 6; ++i)
           out[i] += right[i] - numbers_of(c.pair)[i];
         return out;
       }},
      {"#nothing-done-where-one nothing is done where one body is static: the other one can move",
       unless([](const PushCase& c) {
         return c.pair.body1.is_static() || c.pair.body2.is_static();
       })},
      {"#negative-impulses-left-out a negative lambda is left out: it pulls",
       unless([=](const PushCase& c) {
         return below(c, 0);
       })},
      {"#small-impulses-left-out a small lambda is left out: a light body needs only a small one",
       unless([=](const PushCase& c) { return below(c, real(1e-4)) && !below(c, 0); })},
  };
}

/// The table of exercise 1.3 or 2.3. \param yours changes the velocities of the pair
inline CaseTable<PushCase> push_table(const Subject& subject,
                                      const Call<void(const PushCase&, Pair&)>& yours,
                                      std::vector<PushCase> cases) {
  CaseTable<PushCase> table{subject, push_entries, {}, pushed, pair_mistakes(), std::move(cases)};
  table.whole = true;
  table.tolerance = 10 * rounding;
  table.yours = [=](const PushCase& c) {
    Pair pair = c.pair;
    yours(c, pair);
    return numbers_of(pair);
  };
  if (const std::string words = velocity_by_velocity(table); !words.empty())
    table.mistakes.push_back({words, table.yours});
  return table;
}

/// The mistakes with one velocity that are not called by their name and the velocity's.
inline std::vector<std::string> misnamed_velocities(CaseTable<PushCase> table) {
  std::vector<std::string> out;
  const char* const names[] = {"v1", "w1", "v2", "w2"};
  const std::size_t rows = table.cases[0].J.size();
  for (int block = 0; block < 4; ++block)
    for (const auto& [words, mistake] : velocity_mistakes(rows, block % 2 == 1)) {
      table.yours = [=, mistake = mistake](const PushCase& c) {
        Numbers numbers = pushed(c);
        const vec3 a = mistake({c, block >= 2});
        for (int i = 0; i < 3; ++i) numbers[3 * block + i] = double(a[i]);
        return numbers;
      };
      const std::string told = velocity_by_velocity(table);
      if (told != words + " (" + names[block] + ")") out.push_back(words + ": " + told);
    }
  return out;
}

}  // namespace joints::testing
