// Exercise 5.2, does a weld break, as a table of cases with its usual mistakes.
#pragma once

#include "chapters/05_fixed/fixed.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

struct BreakCase {
  std::string words;
  vec3 force, torque;
  Strength strength{10, 2};
};

/// What the answer is made of: two sizes, two bounds, how they are compared and joined.
struct BreakReference {
  enum class Join { either, both, one, force, torque, sum, shares, product, never, always };
  using Size = Call<real(const vec3&)>;
  BreakCase c;
  std::array<Size, 2> size;
  std::array<real, 2> bound;
  std::array<bool, 2> at_bound{};  ///< does it break there?
  Join join = Join::either;
  bool negated = false;

  explicit BreakReference(const BreakCase& c) : c(c), bound{c.strength.force, c.strength.torque} {
    size.fill([](const vec3& a) { return length(a); });
  }
  bool breaks() const {
    const real F = size[0](c.force), T = size[1](c.torque);
    const bool f = at_bound[0] ? F >= bound[0] : F > bound[0];
    const bool t = at_bound[1] ? T >= bound[1] : T > bound[1];
    bool out = false;
    switch (join) {
      case Join::either: out = f || t; break;
      case Join::both: out = f && t; break;
      case Join::one: out = f != t; break;
      case Join::force: out = f; break;
      case Join::torque: out = t; break;
      case Join::sum: out = F + T > bound[0] + bound[1]; break;
      case Join::shares: out = F / bound[0] + T / bound[1] > 1; break;
      case Join::product: out = F * T > bound[0] * bound[1]; break;
      case Join::never: break;
      case Join::always: out = true;
    }
    return out != negated;
  }
};

inline Pieces<BreakReference> wrong_breaks() {
  using T = BreakReference;
  using Join = T::Join;
  const auto join = [](Join how) { return Call<void(T&)>([=](T& t) { t.join = how; }); };
  const auto bounds = [](auto change) {
    return Call<void(T&)>([=](T& t) { change(t.bound); });
  };
  Pieces<T> out = {
      {"`and` where `or` belongs: one of the two is enough to break a weld", join(Join::both)},
      {"one of the two and not the other: it breaks with both as well, || and not !=",
       join(Join::one)},
      {"the torque is ignored", join(Join::force)},
      {"the force is ignored", join(Join::torque)},
      {"the other way round: true means that it breaks", [](T& t) { t.negated = true; }},
      {"force and torque are exchanged: each has a bound of its own",
       bounds([](std::array<real, 2>& bound) { std::swap(bound[0], bound[1]); })},
      {"#bound-force the torque is compared with the bound of the force",
       bounds([](std::array<real, 2>& bound) { bound[1] = bound[0]; })},
      {"the force is compared with the bound of the torque",
       bounds([](std::array<real, 2>& bound) { bound[0] = bound[1]; })},
      {"newtons and newton metres do not add up: each has a bound of its own", join(Join::sum)},
      {"#by-shares the fractions of the two bounds are added up: each is compared separately",
       join(Join::shares)},
      {"#by-the-product force times torque is compared: each has a bound of its own",
       join(Join::product)},
      {"it never breaks", join(Join::never)},
      {"it always breaks", join(Join::always)}};
  const std::pair<const char*, T::Size> sizes[] = {
      {"the largest entry where the length belongs: the strength of a weld is independent of the "
       "world's axes",
       [](const vec3& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }},
      {"the largest entry where the length belongs, and entries may be negative",
       [](const vec3& a) { return std::max({a.x, a.y, a.z}); }},
      {"the sum of the entries where the length belongs",
       [](const vec3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }},
      {"the sum of the entries where the length belongs, and entries may be negative",
       [](const vec3& a) { return a.x + a.y + a.z; }},
      {"the square of the length beside the bound itself: take length(...)",
       [](const vec3& a) { return dot(a, a); }},
      {"#in-whole-numbers the length is cut to a whole number: an int has no fraction",
       [](const vec3& a) { return std::trunc(length(a)); }}};
  for (const int which : {3, 1, 2}) {
    const std::string after = which == 3 ? "" : which == 1 ? " (force)" : " (torque)";
    const auto add = [&](const std::string& words, auto change) {
      out.push_back({words + after, [=](T& t) {
                       for (std::size_t k = 0; k < 2; ++k)
                         if (which >> k & 1) change(t, k);
                     }});
    };
    add("at its bound a weld still holds: > and not >=",
        [](T& t, std::size_t k) { t.at_bound[k] = true; });
    for (const auto& [words, size] : sizes)
      add(words, [size = size](T& t, std::size_t k) { t.size[k] = size; });
    for (int entry = 0; entry < 3; ++entry)
      for (const bool signless : {false, true})
        add("#by-one-entry one entry where the length belongs", [=](T& t, std::size_t k) {
          t.size[k] = [=](const vec3& a) { return signless ? std::abs(a[entry]) : a[entry]; };
        });
  }
  return out;
}

inline CaseTable<BreakCase> break_table() {
  CaseTable<BreakCase> table{{"5.2", "does a weld break? (1 yes, 0 no)", 3}, {"breaks"},
                             {}, {}, {}, {}};
  table.yours = [](const BreakCase& c) {
    return Numbers{breaks({c.force, c.torque}, c.strength) ? 1.0 : 0.0};
  };
  table.right = [](const BreakCase& c) { return Numbers{BreakReference(c).breaks() ? 1.0 : 0.0}; };
  table.cases = {
      {"12 N of 10, 0 N m of 2", vec3(0, 12, 0), vec3(0)},
      {"0 N of 10, 3 N m of 2", vec3(0), vec3(0, 0, 3)},
      {"12 N of 10 downwards", vec3(0, 0, -12), vec3(0)},
      {"3 N m of 2 the other way round", vec3(0), vec3(-3, 0, 0)},
      {"13.9 N of 10, askew", vec3(8, 8, 8), vec3(0)},
      {"2.3 N m of 2, askew", vec3(0), vec3(real(1.5), real(-1.5), 1)},
      {"12 N of 10, 3 N m of 2", vec3(12, 0, 0), vec3(0, 3, 0)},
      {"9 N of 10, 1.9 N m of 2", vec3(9, 0, 0), vec3(0, real(1.9), 0)},
      {"8.7 N of 10, askew", vec3(5, 5, 5), vec3(0)},
      {"1.7 N m of 2, askew", vec3(0), vec3(1, 1, 1)},
      {"10 N of 10, at the bound", vec3(6, 8, 0), vec3(0)},
      {"2 N m of 2, at the bound", vec3(0), vec3(0, 0, 2)},
      {"no load", vec3(0), vec3(0)},
      {"10.4 N of 10, 1.7 N m of 2, askew", vec3(6, -6, 6), vec3(-1, 1, 1)},
      {"12 N m of 2, above both bounds", vec3(0), vec3(-4, 8, 8)},
      {"1 N of 10, 2.9 N m of 2", vec3(0, -1, 0), vec3(2, 2, real(0.7))},
      {"2.4 N m of 2 along z", vec3(0), vec3(0, 0, real(2.4))},
      {"12 N of 10 along x", vec3(12, 0, 0), vec3(0)},
      {"3 N m of 2 along x", vec3(0), vec3(3, 0, 0)},
      {"30 N of 10, 1 N m of 2", vec3(0, 30, 0), vec3(0, 0, 1)},
      {"1e6 N and 1e6 N m, unbounded", vec3(1e6, 0, 0), vec3(0, 1e6, 0), {}},
      {"3 N m of 2, force unbounded", vec3(1e6, 0, 0), vec3(0, 3, 0), {unbounded, 2}},
      {"12 N of 10, torque unbounded", vec3(0, 0, 12), vec3(0, 1e6, 0), {10, unbounded}}};
  Random random(54);
  for (int draw = 0; draw < 30; ++draw) {
    BreakCase c{"", random.vector(8), random.vector(real(1.7))};
    c.words = short_number(std::round(10 * double(length(c.force))) / 10) + " N of 10, " +
              short_number(std::round(10 * double(length(c.torque))) / 10) + " N m of 2";
    table.cases.push_back(c);
  }
  table.whole = true;
  add_pieces(
      table, [](const BreakCase& c) { return BreakReference(c); },
      [](const BreakReference& t) { return Numbers{t.breaks() ? 1.0 : 0.0}; }, wrong_breaks());
  return table;
}

}  // namespace joints::testing
