// Exercise 9.1: what two blocks add to the matrix at a body, as a table.
#pragma once

#include "chapters/09_direct/direct.h"
#include "tests/checker/arguments.h"
#include "tests/checker/drawn.h"
#include "tests/checker/padded.h"

namespace joints::testing {

struct CouplingCase {
  std::string words;
  int n, m;
  std::vector<HalfRow> J, other;  ///< seven each: behind the block's own stand another's
  InverseMass mass;
  Numbers before;                 ///< n x m
};

inline HalfRow half_row(const vec3& v, const vec3& w) {
  return {{double(v.x), double(v.y), double(v.z)}, {double(w.x), double(w.y), double(w.z)}};
}

/// Half-rows of a case, filled up with those of the next block.
inline std::vector<HalfRow> with_next(std::vector<HalfRow> own) {
  for (int k = 0; own.size() < 7; ++k) own.push_back(half_row(vec3(real(7 + k)), vec3(real(-5))));
  return own;
}

inline std::vector<CouplingCase> coupling_cases() {
  const vec3 x(1, 0, 0), none(0);
  std::vector<CouplingCase> out;
  InverseMass mass{1, glm::dmat3(1)};
  const auto add = [&](const std::string& words, std::vector<HalfRow> J,
                       std::vector<HalfRow> other, Numbers before) {
    const int n = int(J.size()), m = int(other.size());
    out.push_back({words, n, m, with_next(J), with_next(other), mass, before});
  };
  add("two rods that pull at a mass of 1 kg from both sides", {half_row(x, none)},
      {half_row(-x, none)}, {0});
  add("a rod with itself", {half_row(x, none)}, {half_row(x, none)}, {1});
  add("two rows that only turn", {half_row(none, {1, 2, -1})}, {half_row(none, {3, 1, 2})}, {0});
  Random random(91);
  for (const auto& [n, m] : {std::pair{1, 3}, {3, 1}, {2, 5}, {5, 2}, {3, 3}, {6, 4}, {4, 6}}) {
    std::vector<HalfRow> J, other;
    for (int i = 0; i < n; ++i) J.push_back(half_row(random.vector(2), random.vector(1)));
    for (int j = 0; j < m; ++j) other.push_back(half_row(random.vector(1), random.vector(3)));
    const auto number = [&](real from, real to) { return double(random.uniform(from, to)); };
    const double linear = number(real(0.2), 3), xx = number(1, 2), yy = number(2, 3),
                 zz = number(3, 4), xy = number(-1, 1), xz = number(-1, 1), yz = number(-1, 1);
    mass = {linear, glm::dmat3(xx, xy, xz, xy, yy, yz, xz, yz, zz)};
    Numbers before;
    for (int k = 0; k < n * m; ++k) before.push_back(double(random.uniform(-2, 2)));
    add("blocks of " + std::to_string(n) + " and " + std::to_string(m) + " rows", J, other,
        before);
  }
  return out;
}

inline constexpr std::size_t numbers_of_coupling = 72;  // what is written behind A is seen

using AddCoupling = void(const HalfRow*, int, const HalfRow*, int, const InverseMass&, double*);
/// A after a call on a matrix with much room behind it.
inline Numbers coupled(AddCoupling* add, const CouplingCase& c) {
  Numbers A = padded(c.before, 400);
  add(c.J.data(), c.n, c.other.data(), c.m, c.mass, A.data());
  A.resize(numbers_of_coupling);
  return A;
}
inline Numbers right_coupled(const CouplingCase& c) {
  Numbers A = c.before;
  for (std::size_t k = 0; k < A.size(); ++k) {
    const HalfRow &row = c.J[k / std::size_t(c.m)], &column = c.other[k % std::size_t(c.m)];
    A[k] += c.mass.linear * dot(row.v, column.v) + dot(row.w, c.mass.angular * column.w);
  }
  return padded(A, numbers_of_coupling);
}

inline CaseTable<CouplingCase> coupling_table() {
  using Case = CouplingCase;
  auto table = padded_table<Case>({"9.1", "the coupling of two blocks"}, numbers_of_coupling,
                                  [](const Case& c) {
    std::vector<std::string> names;
    for (int i = 0; i < c.n; ++i)
      for (int j = 0; j < c.m; ++j)
        names.push_back("A[" + std::to_string(i) + ", " + std::to_string(j) + "]");
    while (names.size() < numbers_of_coupling)
      names.push_back("behind A, place " + std::to_string(names.size()));
    return names;
  });
  judge(table, add_coupling, coupled);
  table.right = right_coupled;
  table.cases = coupling_cases();
  read_off(table, {[yours = table.yours, cases = table.cases] {
    const bool behind = std::any_of(cases.begin(), cases.end(), [&](const Case& c) {
      const Numbers A = yours(c);
      return std::any_of(A.begin() + c.n * c.m, A.end(), [](double a) { return a != 0; });
    });
    return std::string(behind ? "#both-triangles-once something is written behind the n x m "
                                "numbers of A: do the loops end, and is a row m numbers "
                                "long?" : "");
  }});
  tell_where_it_holds(table);
  return table;
}

/// Bodies of any mass and inertia, rows of any size, and entries that stand there before.
inline Drawn drawn_coupling(Draw& d) {
  CouplingCase c{"", d.count("rows of the first block", d.whole(1, 6)), 0, {}, {}, {}, {}};
  c.m = d.count("rows of the second block", d.whole(1, 6));
  c.mass.linear = d.size("1/m", d.scale(12), "1/kg");
  const double angular = d.size("1/I", d.scale(12), "1/(kg m^2)");
  c.mass.angular = angular * glm::dmat3(1.5, 0.3, -0.4, 0.3, 2, 0.6, -0.4, 0.6, 2.5);
  const bool turns = d.chance("the linear halves are 0");
  const bool moves = d.chance("the angular halves are 0");
  const double v = d.size("|J.v|", turns && !moves ? 0 : d.scale(6), "");
  const double w = d.size("|J.w|", moves && !turns ? 0 : d.scale(6), "m");
  const double size = c.mass.linear * v * v + 3 * angular * w * w;
  d.size("size of an entry", size, "1/kg");
  const double before = d.chance("the entries are 0 before") ? 0 : size;
  Random random = d.many();
  for (std::vector<HalfRow>* rows : {&c.J, &c.other}) {
    for (int k = 0; k < (rows == &c.J ? c.n : c.m); ++k) {
      const vec3 linear = random.vector(1);
      const HalfRow row = half_row(linear, random.vector(1));
      rows->push_back({v * row.v, w * row.w});
    }
    *rows = with_next(*rows);
  }
  Drawn out{{}, {}, {}, {10 * size}};
  for (int k = 0; k < c.n * c.m; ++k) {
    c.before.push_back(before * double(random.uniform(-1, 1)));
    out.entries.push_back("A[" + std::to_string(k / c.m) + ", " + std::to_string(k % c.m) + "]");
  }
  out.yours = coupled(add_coupling, c), out.right = right_coupled(c);
  out.yours.resize(c.before.size()), out.right.resize(c.before.size());
  return out;
}

}  // namespace joints::testing
