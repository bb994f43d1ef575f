// Exercise 9.1: what two blocks add to the matrix at a body, with the usual mistakes.
#pragma once

#include "chapters/09_direct/direct.h"
#include "tests/checker/arguments.h"
#include "tests/checker/padded.h"

namespace joints::testing {

struct CouplingCase {
  std::string words;
  int n, m;
  std::vector<HalfRow> J, other;  ///< seven each: behind the block's own stand another's
  InverseMass mass;
  Numbers before;                 ///< n x m
  /// M^-1 J^T of one row of the second block.
  HalfRow response(int j) const {
    const HalfRow& row = other[std::size_t(j)];
    return {mass.linear * row.v, mass.angular * row.w};
  }
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

/// A after add(A) on a matrix with much room behind it.
template <class Add>
Numbers coupled(const CouplingCase& c, const Add& add) {
  Numbers A = padded(c.before, 400);
  add(A.data());
  A.resize(numbers_of_coupling);
  return A;
}

/// One of the two products has other half-rows.
inline CaseTable<CouplingCase>::Mistakes other_halves() {
  CaseTable<CouplingCase>::Mistakes out;
  const char* const names[] = {"J[i]", "J[j]", "J[0]", "M^-1 other[i]", "M^-1 other[j]",
                               "M^-1 other[0]"};
  const auto half_of = [](const CouplingCase& c, int which, int i, int j) {
    const int at = which % 3 == 0 ? i : which % 3 == 1 ? j : 0;
    return which < 3 ? c.J[std::size_t(at)] : c.response(at);
  };
  for (const bool linear : {true, false})
    for (int one = 0; one < 6; ++one)
      for (int other = 0; other < 6; ++other) {
        if (one == 0 && other == 4) continue;
        const std::string v = linear ? ".v" : ".w";
        const auto product = [=](const HalfRow& a, const HalfRow& b, bool of_v) {
          return of_v ? dot(a.v, b.v) : dot(a.w, b.w);
        };
        out.push_back({std::string(linear ? "the linear" : "the angular") + " product is of " +
                           names[one] + v + " and " + names[other] + v + ": of J[i]" + v +
                           " and M^-1 other[j]" + v,
                       [=](const CouplingCase& c) {
                         return coupled(c, [&](double* A) {
                           for (int i = 0; i < c.n; ++i)
                             for (int j = 0; j < c.m; ++j)
                               A[i * c.m + j] +=
                                   product(half_of(c, one, i, j), half_of(c, other, i, j), linear) +
                                   product(half_of(c, 0, i, j), half_of(c, 4, i, j), !linear);
                         });
                       }});
      }
  return out;
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
  table.yours = [](const Case& c) {
    return coupled(c, [&](double* A) {
      add_coupling(c.J.data(), c.n, c.other.data(), c.m, c.mass, A);
    });
  };
  using Entry = Call<double(const HalfRow&, const HalfRow&)>;
  const Entry both = [](const HalfRow& a, const HalfRow& b) {
    return dot(a.v, b.v) + dot(a.w, b.w);
  };
  // adds another product
  const auto product = [](Entry entry) {
    return [=](const Case& c) {
      return coupled(c, [&](double* A) {
        for (int i = 0; i < c.n; ++i)
          for (int j = 0; j < c.m; ++j)
            A[i * c.m + j] += entry(c.J[std::size_t(i)], c.response(j));
      });
    };
  };
  // adds at another place, or in another way: change(A, i, j, product)
  const auto place = [=](auto change) {
    return [=](const Case& c) {
      return coupled(c, [&](double* A) {
        for (int i = 0; i < c.n; ++i)
          for (int j = 0; j < c.m; ++j)
            change(c, A, i, j, both(c.J[std::size_t(i)], c.response(j)));
      });
    };
  };
  // other loops: which rows and columns are gone through
  const auto loops = [=](auto rows, auto columns) {
    return [=](const Case& c) {
      return coupled(c, [&](double* A) {
        for (int i = 0; i < rows(c); ++i)
          for (int j = 0; j < columns(c, i); ++j)
            A[i * c.m + j] += both(c.J[std::size_t(i)], c.response(j));
      });
    };
  };
  const auto n = [](const Case& c) { return c.n; };
  const auto m = [](const Case& c, int) { return c.m; };
  const char* const set = "#set-instead-added the entries are set: they grow. Two blocks may "
                          "share both their bodies, and each of these adds its part";
  const char* const place_of = "entry (i, j) stands at A[i * m + j]: A is n x m, row by row";
  table.right = product(both);
  // another mass, or none
  const auto masses = [=](auto change) {
    return [=, right = product(both)](Case c) {
      change(c.mass);
      return right(c);
    };
  };
  using Mass = InverseMass;
  const glm::dmat3 one(1);
  table.mistakes = {
      {"#masses-missing J with J: an impulse is no velocity. How much do v and w of a body of this "
       "mass and inertia change?",
       masses([=](Mass& mass) { mass = {1, one}; })},
      {"#mass-missing the inverse mass is missing: how much does v of the body change?",
       masses([](Mass& mass) { mass.linear = 1; })},
      {"#inertia-missing the inverse inertia is missing: how much does w of the body change?",
       masses([=](Mass& mass) { mass.angular = one; })},
      {"#mass-inverted divided by the inverse mass: a heavy body changes its velocity less",
       masses([](Mass& mass) { mass.linear = 1 / mass.linear; })},
      {"#mass-squared the inverse mass is there twice: J M^-1 J^T has it once",
       masses([](Mass& mass) { mass.linear *= mass.linear; })},
      {"#mass-turns the inverse mass in the place of the inverse inertia: turning is opposed "
       "by the inertia",
       masses([](Mass& m) { m.angular = glm::dmat3(m.linear); })},
      {"#mass-at-both the inverse mass multiplies the angular part as well: it belongs to v alone",
       masses([](Mass& mass) { mass.angular *= mass.linear; })},
      {"#inertia-diagonal only the diagonal of the inverse inertia: mass.angular * other[j].w has "
       "all of it",
       masses([](Mass& m) {
         const glm::dmat3 I = m.angular;
         m.angular = {I[0][0], 0, 0, 0, I[1][1], 0, 0, 0, I[2][2]};
       })},
      {set, place([](const Case& c, double* A, int i, int j, double a) { A[i * c.m + j] = a; })},
      {"#minus-the-product the sign: the product is added",
       product([=](const HalfRow& a, const HalfRow& b) { return -both(a, b); })},
      {"#linear-part-alone only the linear halves: an impulse turns the body, too",
       product([](const HalfRow& a, const HalfRow& b) { return dot(a.v, b.v); })},
      {"#angular-part-alone only the angular halves: an impulse moves the centre, too",
       product([](const HalfRow& a, const HalfRow& b) { return dot(a.w, b.w); })},
      {"#angular-part-subtracted the sign of the angular part: both are added",
       product([](const HalfRow& a, const HalfRow& b) { return dot(a.v, b.v) - dot(a.w, b.w); })},
      {"#v-with-w linear halves with angular ones: v goes with v, w with w",
       product([](const HalfRow& a, const HalfRow& b) { return dot(a.v, b.w) + dot(a.w, b.v); })},
      {"#v-twice the linear halves twice: the second product is of the angular ones",
       product([](const HalfRow& a, const HalfRow& b) { return 2 * dot(a.v, b.v); })},
      {"the angular halves twice: the first product is of the linear ones",
       product([](const HalfRow& a, const HalfRow& b) { return 2 * dot(a.w, b.w); })},
      {"#linear-angular-multiplied the linear and the angular part are multiplied: they are added",
       product([](const HalfRow& a, const HalfRow& b) { return dot(a.v, b.v) * dot(a.w, b.w); })},
      {"the sums of both halves are multiplied: v with v and w with w, then add",
       product([](const HalfRow& a, const HalfRow& b) { return dot(a.v + a.w, b.v + b.w); })},
      {"#j-with-j J with itself: the impulse acts along a row of the other block",
       place([=](const Case& c, double* A, int i, int j, double) {
         A[i * c.m + j] += both(c.J[std::size_t(i)], c.J[std::size_t(j)]);
       })},
      {"the response with itself: the rate is that of a row of J",
       place([=](const Case& c, double* A, int i, int j, double) {
         A[i * c.m + j] += both(c.response(i), c.response(j));
       })},
      {"#rows-columns-blocks-exchanged i and j are exchanged at J and the response: row i is of "
       "J, column j of the other block's response",
       place([=](const Case& c, double* A, int i, int j, double) {
         A[i * c.m + j] += both(c.J[std::size_t(j)], c.response(i));
       })},
      {"#first-row-j-always always the first half-row of J: row i has J[i]",
       place([=](const Case& c, double* A, int i, int j, double) {
         A[i * c.m + j] += both(c.J[0], c.response(j));
       })},
      {"always the first half-row of the response: column j belongs to other[j]",
       place([=](const Case& c, double* A, int i, int j, double) {
         A[i * c.m + j] += both(c.J[std::size_t(i)], c.response(0));
       })},
      {std::string("column by column: ") + place_of,
       place([](const Case& c, double* A, int i, int j, double a) { A[j * c.n + i] += a; })},
      {std::string("transposed: ") + place_of,
       place([](const Case& c, double* A, int i, int j, double a) { A[j * c.m + i] += a; })},
      {std::string("a row is n numbers long, it has m: ") + place_of,
       place([](const Case& c, double* A, int i, int j, double a) { A[i * c.n + j] += a; })},
      {std::string("a row is six numbers long, it has m: ") + place_of,
       place([](const Case&, double* A, int i, int j, double a) { A[i * 6 + j] += a; })},
      {std::string("i is not multiplied by m: ") + place_of,
       place([](const Case&, double* A, int i, int j, double a) { A[i + j] += a; })},
      {"everything is added to the first entry: (i, j) stands at A[i * m + j]",
       place([](const Case&, double* A, int, int, double a) { A[0] += a; })},
      {"#only-entries-i-j only the entries with i = j: every row of one block is coupled with "
       "every row of the other",
       place([](const Case& c, double* A, int i, int j, double a) {
         if (i == j) A[i * c.m + j] += a;
       })},
      {"#lower-triangle-only only the entries with j <= i: this is no diagonal block, all n x m "
       "count",
       place([](const Case& c, double* A, int i, int j, double a) {
         if (j <= i) A[i * c.m + j] += a;
       })},
      {"only the entries with j >= i: this is no diagonal block, all n x m count",
       place([](const Case& c, double* A, int i, int j, double a) {
         if (j >= i) A[i * c.m + j] += a;
       })},
      {"#x-y-alone only x and y count in the linear product: all three do",
       product([=](const HalfRow& a, const HalfRow& b) { return both(a, b) - a.v.z * b.v.z; })},
      {"#angular-x-y-alone only x and y count in the angular product: all three do",
       product([=](const HalfRow& a, const HalfRow& b) { return both(a, b) - a.w.z * b.w.z; })},
      {"only x counts in the angular product: all three do",
       product([=](const HalfRow& a, const HalfRow& b) { return dot(a.v, b.v) + a.w.x * b.w.x; })},
      {"#nothing-done nothing is added: A[i * m + j] += the product",
       product([](const HalfRow&, const HalfRow&) { return 0.0; })},
      {"#half half of the product: all of it",
       product([=](const HalfRow& a, const HalfRow& b) { return both(a, b) / 2; })},
      {"#two-dimensional-index A[i, j] is A[j] in C++: A[i * m + j]",
       place([](const Case&, double* A, int, int j, double a) { A[j] += a; })},
      {"twice the product, or the loops run twice: once",
       product([=](const HalfRow& a, const HalfRow& b) { return 2 * both(a, b); })},
      {"the size of the product: it may have either sign",
       product([=](const HalfRow& a, const HalfRow& b) { return std::abs(both(a, b)); })},
      {"the old entry is taken away: it grows by the product",
       place([](const Case& c, double* A, int i, int j, double a) {
         A[i * c.m + j] = a - A[i * c.m + j];
       })},
      {"the old entry is counted twice: A[i * m + j] += has it already",
       place([](const Case& c, double* A, int i, int j, double a) {
         A[i * c.m + j] += A[i * c.m + j] + a;
       })},
      {"the old entry is multiplied: it grows by the product",
       place([](const Case& c, double* A, int i, int j, double a) { A[i * c.m + j] *= a; })},
      {"#j-to-n j runs to n: the second block has m rows",
       loops(n, [](const Case& c, int) { return c.n; })},
      {"#i-to-m i runs to m: the first block has n rows",
       loops([](const Case& c) { return c.m; }, m)},
      {"#loops-exchanged n and m are exchanged in the loops: i runs to n, j to m",
       loops([](const Case& c) { return c.m; }, [](const Case& c, int) { return c.n; })},
      {"#last-row-left-out-i-n the last row is left out: i < n",
       loops([](const Case& c) { return c.n - 1; }, m)},
      {"the last column is left out: j < m", loops(n, [](const Case& c, int) { return c.m - 1; })},
      {"the first row is left out: i begins with 0",
       place([](const Case& c, double* A, int i, int j, double a) {
         if (i > 0) A[i * c.m + j] += a;
       })},
      {"#begins-with-1 the first column is left out: j begins with 0",
       place([](const Case& c, double* A, int i, int j, double a) {
         if (j > 0) A[i * c.m + j] += a;
       })},
      {"#one-row-too-many one row too many: i < n",
       loops([](const Case& c) { return c.n + 1; }, m)},
      {"#one-column-too-many one column too many: j < m",
       loops(n, [](const Case& c, int) { return c.m + 1; })},
      {"#sum-goes-on a sum goes on from entry to entry: begin with 0 for each",
       [=](const Case& c) {
         double sum = 0;
         return coupled(c, [&](double* A) {
           for (int i = 0; i < c.n; ++i)
             for (int j = 0; j < c.m; ++j)
               A[i * c.m + j] += sum += both(c.J[std::size_t(i)], c.response(j));
         });
       }}};
  for (int most = 3; most < 6; ++most) {
    table.mistakes.push_back({"#rows-stop the rows stop at " + std::to_string(most) +
                                  ": a block has up to six",
                              loops([=](const Case& c) { return std::min(most, c.n); }, m)});
    table.mistakes.push_back({"#columns-stop the columns stop at " + std::to_string(most) +
                                  ": a block has up to six",
                              loops(n, [=](const Case& c, int) { return std::min(most, c.m); })});
  }
  for (const auto& mistake : other_halves()) table.mistakes.add(mistake.words, mistake.does.of);
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

}  // namespace joints::testing
