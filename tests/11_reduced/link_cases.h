// Exercises 11.1 to 11.4: links in any state, and what each function makes of them by matrices of
// six rows, which the recursion avoids.
#pragma once

#include <algorithm>

#include "chapters/11_reduced/reduced.h"
#include "tests/checker/cases.h"
#include "tests/checker/drawn.h"

namespace joints::testing {

// ---- six rows -----------------------------------------------------------------------------------

using Six = std::array<real, 6>;        // angular, then linear
using SixBySix = std::array<Six, 6>;

inline Six six(const vec3& angular, const vec3& linear) {
  return {angular.x, angular.y, angular.z, linear.x, linear.y, linear.z};
}
inline vec3 angular_of(const Six& a) { return {a[0], a[1], a[2]}; }
inline vec3 linear_of(const Six& a) { return {a[3], a[4], a[5]}; }
inline real dot6(const Six& a, const Six& b) {
  real sum = 0;
  for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}
inline Six times(const SixBySix& A, const Six& x) {
  Six out{};
  for (std::size_t i = 0; i < 6; ++i) out[i] = dot6(A[i], x);
  return out;
}
inline Six added(Six a, const Six& b, real factor = 1) {
  for (std::size_t i = 0; i < 6; ++i) a[i] += factor * b[i];
  return a;
}
inline SixBySix turned_over(const SixBySix& A) {
  SixBySix out{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) out[i][j] = A[j][i];
  return out;
}
inline SixBySix times(const SixBySix& A, const SixBySix& B) {
  const SixBySix columns = turned_over(B);
  SixBySix out{};
  for (std::size_t i = 0; i < 6; ++i) out[i] = times(columns, A[i]);
  return out;
}
// [A B; C D]
inline SixBySix from_blocks(const mat3& A, const mat3& B, const mat3& C, const mat3& D) {
  SixBySix out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const std::size_t a = std::size_t(i), b = std::size_t(j);
      out[a][b] = A[j][i], out[a][b + 3] = B[j][i];
      out[a + 3][b] = C[j][i], out[a + 3][b + 3] = D[j][i];
    }
  return out;
}
inline mat3 block_of(const SixBySix& A, std::size_t row, std::size_t column) {
  mat3 out(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[j][i] = A[row + std::size_t(i)][column + std::size_t(j)];
  return out;
}
inline SixBySix inertia_of(const TreeLink& link) {
  return from_blocks(link.J, link.H, transpose(link.H), link.M);
}
// The motion of a child's anchor, rigidly with its parent.
inline SixBySix carried(const vec3& d) {
  return from_blocks(mat3(1), mat3(0), -skew(d), mat3(1));
}
// The free motion S.
inline Six free_motion(const TreeLink& link) {
  return link.freedom == Freedom::slider ? six(vec3(0), link.a) : six(link.a, vec3(0));
}
inline bool has_axis(const TreeLink& link) {
  return link.freedom == Freedom::hinge || link.freedom == Freedom::slider;
}

// ---- the functions of the exercises, once more --------------------------------------------------

namespace by_matrices {

inline void place(TreeLink& link, const TreeLink& parent) {
  const vec3 slide = link.freedom == Freedom::slider ? link.x * link.axis_local : vec3(0);
  const vec3 turn = link.freedom == Freedom::hinge ? link.x * link.axis_local : vec3(0);
  link.d = parent.R * (link.from_parent_local + slide);
  if (link.freedom != Freedom::ball)
    link.R = parent.R * mat3_cast(rotation(turn)) * mat3_cast(link.start);
}
inline void move(TreeLink& link, const TreeLink& parent) {
  const mat3 W = skew(parent.w);
  const Six S = free_motion(link);
  if (has_axis(link)) {
    link.w = parent.w + link.rate * angular_of(S);
    link.zeta = W * (link.rate * angular_of(S));
  }
  if (link.freedom == Freedom::weld) link.w = parent.w;
  link.gamma = W * W * link.d;
  if (has_axis(link)) link.gamma += real(2) * (W * (link.rate * linear_of(S)));
}
inline void begin_inertia(TreeLink& link) {
  const mat3 X = skew(link.c);
  link.M = mat3(link.mass);
  link.H = link.mass * X;
  link.J = link.inertia - link.mass * (X * X);
}
inline void begin_bias(TreeLink& link) {
  const mat3 W = skew(link.w);
  link.f = link.mass * (W * W * link.c) - link.force;
  link.n = W * (link.inertia * link.w) + skew(link.c) * link.f - link.torque;
}
inline void eliminate(TreeLink& link) {
  SixBySix I = inertia_of(link);
  const Six S = free_motion(link), U = times(I, S);
  link.Uw = angular_of(U), link.Uv = linear_of(U), link.D = dot6(S, U);
  const real whole = dot6(S, U) + link.added;
  link.over_D = whole > 0 ? 1 / whole : real(0);
  if (link.held) return;
  for (std::size_t i = 0; i < 6; ++i) I[i] = added(I[i], U, -link.over_D * U[i]);
  link.J = block_of(I, 0, 0), link.H = block_of(I, 0, 3), link.M = block_of(I, 3, 3);
}
inline void add_inertia(const TreeLink& link, TreeLink& parent) {
  const SixBySix X = carried(link.d);
  const SixBySix I = times(turned_over(X), times(inertia_of(link), X));
  parent.J += block_of(I, 0, 0), parent.H += block_of(I, 0, 3), parent.M += block_of(I, 3, 3);
}
inline void add_bias(TreeLink& link, TreeLink& parent) {
  const Six p = six(link.n, link.f), S = free_motion(link);
  Six out = added(p, times(inertia_of(link), six(link.zeta, link.gamma)));
  if (has_axis(link)) {
    link.k = link.tau - dot6(S, p);
    const real free = link.over_D * link.k;
    out = added(out, six(link.Uw, link.Uv), link.held ? link.acceleration : free);
  }
  out = times(turned_over(carried(link.d)), out);
  parent.n += angular_of(out), parent.f += linear_of(out);
}
inline void accelerate(TreeLink& link, const TreeLink& parent) {
  Six A = times(carried(link.d), six(parent.alpha, parent.a_A));
  A = added(A, six(link.zeta, link.gamma));
  const real missing = link.k - dot6(six(link.Uw, link.Uv), A);
  if (!link.held) link.acceleration = missing * link.over_D;
  if (link.held) link.tau += link.D * link.acceleration - missing;
  A = added(A, free_motion(link), link.acceleration);
  link.alpha = angular_of(A), link.a_A = linear_of(A);
}

}  // namespace by_matrices

// ---- links in any state -------------------------------------------------------------------------

struct LinkCase {
  std::string words;
  TreeLink link, parent;
};

// The inertia of three bodies about a point.
inline void set_inertia(TreeLink& link, Draw& d, const Draw::Units& u) {
  mat3 J(0), H(0), M(0);
  for (int body = 0; body < 3; ++body) {
    TreeLink one;
    one.mass = real(std::abs(d.number()) * u.kg);
    one.c = d.vector(u.m);
    const mat3 R = mat3_cast(d.turn());
    for (int k = 0; k < 3; ++k)
      one.inertia += outerProduct(R[k], R[k]) * real(std::abs(d.number()) * u.kg * u.m * u.m);
    by_matrices::begin_inertia(one);
    J += one.J, H += one.H, M += one.M;
  }
  link.J = J, link.H = H, link.M = M;
}

/// A link in which every number that a function may read is set, and of a scale.
inline LinkCase link_case(Draw& d, Freedom freedom, const Draw::Units& u) {
  const double rate = 1 / u.s, force = u.kg * u.m / u.s / u.s, torque = force * u.m;
  LinkCase c;
  for (TreeLink* one : {&c.parent, &c.link}) {
    one->q = d.turn();
    one->R = mat3_cast(one->q);
    one->w = d.vector(rate), one->v = d.vector(u.m * rate), one->centre = d.vector(u.m);
    one->mass = real(std::abs(d.number()) * u.kg);
    one->c = d.vector(u.m);
    one->rotates_inertia = true;
    for (int k = 0; k < 3; ++k)
      one->inertia_local[k] = real(std::abs(d.number()) * u.kg * u.m * u.m);
    const vec3& I = one->inertia_local;
    one->inertia = mat3(I.x * one->R[0], I.y * one->R[1], I.z * one->R[2]) * transpose(one->R);
    one->force = d.vector(force), one->torque = d.vector(torque);
    one->n = d.vector(torque), one->f = d.vector(force);
    one->alpha = d.vector(rate * rate), one->a_A = d.vector(u.m * rate * rate);
    set_inertia(*one, d, u);
  }
  TreeLink& link = c.link;
  link.freedom = freedom;
  link.parent = 0;
  link.start = d.turn();
  const double along = freedom == Freedom::slider ? u.m : 1;
  if (has_axis(link)) {
    link.axis_local = normalize(d.vector());
    link.start_axis = quat(0, link.axis_local.x, link.axis_local.y, link.axis_local.z) * link.start;
    const bool turns = freedom == Freedom::hinge;  // by a millionth, or many times around
    link.x = real(turns ? d.any_size(is_float ? 3 : 6) : d.number() * along);
    link.rate = real(d.number() * along * rate);
    link.acceleration = real(d.number() * along * rate * rate);
  }
  link.centre_local = d.vector(u.m), link.from_parent_local = d.vector(u.m);
  link.a = c.parent.R * link.axis_local;
  link.d = d.vector(u.m);
  if (d.chance("the parent's anchor is that of the link")) link.d = vec3(0);
  if (d.chance("the centre is at the anchor")) link.c = vec3(0);
  if (freedom == Freedom::hinge) link.zeta = d.vector(rate * rate);
  link.gamma = d.vector(u.m * rate * rate);
  link.held = d.chance("the link is held");
  const double inertia = u.kg * u.m * u.m / along / along;
  if (d.chance("inertia is added")) link.added = real(std::abs(d.number()) * inertia);
  link.tau = real(d.number() * inertia * along * rate * rate);
  link.Uw = d.vector(inertia * along), link.Uv = d.vector(inertia * along / u.m);  // of nothing
  link.D = real(d.number() * inertia), link.over_D = real(d.number() / inertia);
  link.k = real(d.number() * inertia * along * rate * rate);
  if (d.chance("the subtree has no mass")) {
    link.J = link.H = link.M = mat3(0);
    link.added = 0;
  }
  return c;
}

inline const char* name_of(Freedom freedom) {
  switch (freedom) {
    case Freedom::hinge: return "hinge";
    case Freedom::slider: return "slider";
    case Freedom::weld: return "weld";
    case Freedom::ball: return "ball joint";
    default: return "root";
  }
}
/// How far the recursion has come when a function is called.
enum class After { nothing, eliminate, add_bias };
inline void come(TreeLink& link, After done) {
  if (!has_axis(link) || done == After::nothing) return;
  by_matrices::eliminate(link);
  if (done == After::add_bias) link.k = link.tau - dot6(free_motion(link), six(link.n, link.f));
}

/// Four states of each kind of link, of which each second one is held, and one without mass.
inline std::vector<LinkCase> link_cases(const std::vector<Freedom>& kinds, After done) {
  std::vector<LinkCase> out;
  for (const Freedom kind : kinds)
    for (unsigned draw = 0; draw < 5; ++draw) {
      Draw d(draw + 11);
      LinkCase c = link_case(d, kind, {1, 1, 1});
      c.link.held = has_axis(c.link) && draw % 2 == 1;
      const bool massless = draw == 4 && has_axis(c.link);
      if (massless) c.link.J = c.link.H = c.link.M = mat3(0);
      if (massless) c.link.added = 0;
      come(c.link, done);
      c.words = std::string(name_of(kind)) + (c.link.held ? ", held" : massless ? ", no mass" : "");
      out.push_back(c);
    }
  return out;
}

// ---- tables -------------------------------------------------------------------------------------

/// A number, vector or matrix that a function sets, with its unit.
struct Output {
  const char* name;
  std::vector<vec3> (*of)(const LinkCase& c);
  double (*unit)(const Draw::Units& u);
  int numbers = 3;  ///< of each vector; 1: a number, in x
};
using Outputs = std::vector<Output>;

inline std::vector<vec3> columns(const mat3& A) { return {A[0], A[1], A[2]}; }
inline double unit_of_angle(const Draw::Units&) { return 1; }
inline double unit_of_length(const Draw::Units& u) { return u.m; }
inline double unit_of_rate(const Draw::Units& u) { return 1 / u.s; }
inline double unit_of_alpha(const Draw::Units& u) { return 1 / u.s / u.s; }
inline double unit_of_acceleration(const Draw::Units& u) { return u.m / u.s / u.s; }
inline double unit_of_force(const Draw::Units& u) { return u.kg * u.m / u.s / u.s; }
inline double unit_of_torque(const Draw::Units& u) { return u.kg * u.m * u.m / u.s / u.s; }
inline double unit_of_J(const Draw::Units& u) { return u.kg * u.m * u.m; }
inline double unit_of_H(const Draw::Units& u) { return u.kg * u.m; }
inline double unit_of_M(const Draw::Units& u) { return u.kg; }

/// Calls a function of a link, of a link and its parent, or of both in the other way.
template <class Function>
LinkCase after(Function* function, LinkCase c) {
  if constexpr (std::is_invocable_v<Function, TreeLink&>) function(c.link);
  else function(c.link, c.parent);
  return c;
}
inline Numbers numbers_of(const LinkCase& c, const Outputs& outputs) {
  Numbers out;
  for (const Output& output : outputs)
    for (const vec3& a : output.of(c))
      for (int i = 0; i < output.numbers; ++i) out.push_back(double(a[i]));
  return out;
}
inline std::vector<std::string> entries_of(const Outputs& outputs) {
  std::vector<std::string> out;
  for (const Output& output : outputs) {
    const std::size_t vectors = output.of(LinkCase{}).size();
    for (std::size_t k = 0; k < vectors; ++k)
      for (int i = 0; i < output.numbers; ++i)
        out.push_back(output.name +
                      (vectors == 3 ? "[" + std::to_string(i) + ", " + std::to_string(k) + "]"
                       : output.numbers == 1 ? "" : std::string(".") + "xyz"[i]));
  }
  return out;
}

/// A function as a table over links of some kinds.
template <class Function>
CaseTable<LinkCase> link_table(const Subject& subject, Function* yours, Function* right,
                               const Outputs& outputs, const std::vector<Freedom>& kinds,
                               After done = After::nothing) {
  CaseTable<LinkCase> table{subject, entries_of(outputs)};
  judge(table, yours, [=](auto f, const LinkCase& c) { return numbers_of(after(f, c), outputs); });
  table.right = [=](const LinkCase& c) { return numbers_of(after(right, c), outputs); };
  table.cases = link_cases(kinds, done);
  table.whole = true;
  table.tolerance = 100 * rounding;
  return table;
}

/// The same of a drawn link, in its units.
template <class Function>
Drawn drawn_link(Draw& d, Function* yours, Function* right, const Outputs& outputs,
                 Freedom kind, After done) {
  const Draw::Units u = d.units(is_float ? 2 : 12);
  LinkCase c = link_case(d, kind, u);
  come(c.link, done);
  const LinkCase mine = after(yours, c), wanted = after(right, c);
  Drawn out{entries_of(outputs), {}, {}, {100}};
  for (const Output& output : outputs) {
    const real unit = real(output.unit(u));
    const std::vector<vec3> a = output.of(mine), b = output.of(wanted);
    for (std::size_t k = 0; k < a.size(); ++k)
      for (int i = 0; i < output.numbers; ++i) {
        out.yours.push_back(double(a[k][i] / unit));
        out.right.push_back(double(b[k][i] / unit));
      }
  }
  return out;
}

}  // namespace joints::testing
