// The tests of chapter 11's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "chapters/11_reduced/program/chain.h"
#include "tests/11_reduced/link_cases.h"
#include "tests/checker/catch.h"

using namespace joints;
using namespace joints::testing;

namespace {

using Kinds = std::vector<Freedom>;

// What a function sets, by name.
#define OUTPUT(name, value, unit) \
  Output { name, [](const LinkCase& c) { return std::vector<vec3>{value}; }, unit }
#define MATRIX(name, value, unit) \
  Output { name, [](const LinkCase& c) { return columns(value); }, unit }

const Outputs pose{MATRIX("R", c.link.R, unit_of_angle), OUTPUT("d", c.link.d, unit_of_length)};
const Outputs motion{OUTPUT("w", c.link.w, unit_of_rate),
                     OUTPUT("zeta", c.link.zeta, unit_of_alpha),
                     OUTPUT("gamma", c.link.gamma, unit_of_acceleration)};
const Outputs inertia{MATRIX("J", c.link.J, unit_of_J), MATRIX("H", c.link.H, unit_of_H),
                      MATRIX("M", c.link.M, unit_of_M)};
const Outputs bias{OUTPUT("n", c.link.n, unit_of_torque), OUTPUT("f", c.link.f, unit_of_force)};
const Outputs inertia_of_parent{MATRIX("J of the parent", c.parent.J, unit_of_J),
                                MATRIX("H of the parent", c.parent.H, unit_of_H),
                                MATRIX("M of the parent", c.parent.M, unit_of_M)};
const Outputs acceleration{OUTPUT("alpha", c.link.alpha, unit_of_alpha),
                           OUTPUT("a_A", c.link.a_A, unit_of_acceleration)};

// The numbers along the free motion have the units of a hinge or of a slider.
Outputs eliminated(bool slider) {
  Outputs out = inertia;
  out.push_back(OUTPUT("Uw", c.link.Uw, slider ? unit_of_H : unit_of_J));
  out.push_back(OUTPUT("Uv", c.link.Uv, slider ? unit_of_M : unit_of_H));
  return out;
}
#define NUMBER(name, value, unit) \
  Output { name, [](const LinkCase& c) { return std::vector<vec3>{vec3(value)}; }, unit, 1 }

double one_over_J(const Draw::Units& u) { return 1 / unit_of_J(u); }
double one_over_M(const Draw::Units& u) { return 1 / unit_of_M(u); }

Outputs of_elimination(bool slider) {
  Outputs out = eliminated(slider);
  out.push_back(NUMBER("D", c.link.D, slider ? unit_of_M : unit_of_J));
  out.push_back(NUMBER("over_D", c.link.over_D, slider ? one_over_M : one_over_J));
  return out;
}
Outputs of_bias(bool slider) {
  return {OUTPUT("n of the parent", c.parent.n, unit_of_torque),
          OUTPUT("f of the parent", c.parent.f, unit_of_force),
          NUMBER("k", c.link.k, slider ? unit_of_force : unit_of_torque)};
}
Outputs of_acceleration(bool slider) {
  Outputs out = acceleration;
  out.push_back(NUMBER("acceleration", c.link.acceleration,
                       slider ? unit_of_acceleration : unit_of_alpha));
  out.push_back(NUMBER("tau", c.link.tau, slider ? unit_of_force : unit_of_torque));
  return out;
}

const Kinds with_axis{Freedom::hinge, Freedom::slider};
const Kinds with_parent{Freedom::hinge, Freedom::slider, Freedom::weld};
const Kinds moving{Freedom::hinge, Freedom::slider, Freedom::weld, Freedom::ball};

CaseTable<LinkCase> place_table() {
  return link_table({"11.1", "the pose of a child", 1}, place, by_matrices::place, pose, moving);
}
CaseTable<LinkCase> move_table() {
  return link_table({"11.1", "what velocities cause", 2}, move, by_matrices::move, motion, moving);
}
CaseTable<LinkCase> inertia_table() {
  return link_table({"11.2", "the inertia about A", 1}, begin_inertia, by_matrices::begin_inertia,
                    inertia, {Freedom::hinge});
}
CaseTable<LinkCase> bias_table() {
  return link_table({"11.2", "the bias about A", 2}, begin_bias, by_matrices::begin_bias, bias,
                    {Freedom::hinge});
}
CaseTable<LinkCase> eliminate_table() {
  return link_table({"11.3", "what the parent feels", 1}, eliminate, by_matrices::eliminate,
                    of_elimination(false), with_axis);
}
CaseTable<LinkCase> add_inertia_table() {
  return link_table({"11.3", "inertia with a lever", 2}, add_inertia, by_matrices::add_inertia,
                    inertia_of_parent, with_parent);
}
CaseTable<LinkCase> add_bias_table() {
  return link_table({"11.3", "bias with a lever", 3}, add_bias, by_matrices::add_bias,
                    of_bias(false), with_parent, After::eliminate);
}
CaseTable<LinkCase> accelerate_table() {
  return link_table({"11.4", "the acceleration of a child", 1}, accelerate,
                    by_matrices::accelerate, of_acceleration(false), with_axis, After::add_bias);
}

// One of each kind, drawn in its own units.
template <class Function, class OutputsOf>
void check_drawn_links(const Subject& subject, Function* yours, Function* right,
                       const OutputsOf& outputs, const Kinds& kinds,
                       After done = After::nothing) {
  for (const Freedom kind : kinds)
    check_drawn(subject, [&](Draw& d) {
      return drawn_link(d, yours, right, outputs(kind == Freedom::slider), kind, done);
    });
}

// ---- the two bars of the text: 1 kg, 1 kg m^2, hinges along z at 0 and 2 m, centres at 1 m ------

TreeLink bar() {
  TreeLink link;
  link.freedom = Freedom::hinge;
  link.parent = 0;
  link.rotates_inertia = true;
  link.mass = 1;
  link.inertia_local = vec3(1);
  link.inertia = mat3(1);
  link.axis_local = link.a = vec3(0, 0, 1);
  link.start_axis = quat(0, 0, 0, 1);
  link.centre_local = link.c = vec3(1, 0, 0);
  link.force = vec3(0, -10, 0);
  return link;
}
// After the body's own inertia and bias.
TreeLink begun() {
  TreeLink link = bar();
  link.J = mat3(1, 0, 0, 0, 2, 0, 0, 0, 2);
  link.H = mat3(0, 0, 0, 0, 0, 1, 0, -1, 0);
  link.M = mat3(1);
  link.n = vec3(0, 0, 10), link.f = vec3(0, 10, 0);
  return link;
}
// After eliminate().
TreeLink felt() {
  TreeLink link = begun();
  link.J[2][2] = 0;
  link.H[1][2] = 0;
  link.M[1][1] = real(0.5);
  link.Uw = vec3(0, 0, 2), link.Uv = vec3(0, 1, 0);
  link.D = 2, link.over_D = real(0.5), link.k = -10;
  link.d = vec3(2, 0, 0);
  return link;
}

}  // namespace

// ---- 11.1 ---------------------------------------------------------------------------------------

TEST_CASE("11.1 a bar that hangs on a quarter turn has its own hinge straight above", "[11.1]") {
  LinkCase c{"two bars", bar(), bar()};
  c.parent.R = mat3(0, -1, 0, 1, 0, 0, 0, 0, 1);  // hangs: x points downwards
  const real half = std::sqrt(real(0.5));
  c.parent.q = quat(half, 0, 0, -half);
  c.link.from_parent_local = vec3(2, 0, 0);
  c.link.x = 2 * std::atan2(half, half);  // and the child is level again
  place_table().check(c, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -2, 0});
  place_table().check();
}

TEST_CASE("11.1 an arm stretched out on a carousel is accelerated inwards", "[11.1]") {
  LinkCase c{"carousel", bar(), bar()};
  c.parent.w = vec3(0, 0, 3), c.link.d = vec3(2, 0, 0), c.link.rate = 4;
  move_table().check(c, {0, 0, 7, 0, 0, 0, -18, 0, 0});
  move_table().check();
}

TEST_CASE("11.1 poses and velocities are right in all units", "[11.1]") {
  const auto pose_of = [](bool) { return pose; };
  const auto motion_of = [](bool) { return motion; };
  check_drawn_links(place_table().subject, place, by_matrices::place, pose_of, moving);
  check_drawn_links(move_table().subject, move, by_matrices::move, motion_of, moving);
}

// ---- 11.2 ---------------------------------------------------------------------------------------

TEST_CASE("11.2 a bar that is held at its end has the inertia 2 about it", "[11.2]") {
  inertia_table().check({"two bars", bar(), {}},
                        {1, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, -1, 0, 1, 0, 0, 0, 1, 0,
                         0, 0, 1});
  inertia_table().check();
}

TEST_CASE("11.2 a bar is held against its weight and its swing", "[11.2]") {
  bias_table().check({"two bars", bar(), {}}, {0, 0, 10, 0, 10, 0});
  bias_table().check();
}

TEST_CASE("11.2 inertia and bias are right in all units", "[11.2]") {
  const auto inertia_with = [](bool) { return inertia; };
  const auto bias_with = [](bool) { return bias; };
  const Kinds any{Freedom::hinge};
  check_drawn_links(inertia_table().subject, begin_inertia, by_matrices::begin_inertia,
                    inertia_with, any);
  check_drawn_links(bias_table().subject, begin_bias, by_matrices::begin_bias, bias_with, any);
}

// ---- 11.3 ---------------------------------------------------------------------------------------

TEST_CASE("11.3 half of the mass of a bar slips through its hinge", "[11.3]") {
  LinkCase c{"two bars", begun(), {}};
  Numbers right = numbers_of(LinkCase{"", felt(), {}}, of_elimination(false));
  eliminate_table().check(c, right);
  eliminate_table().check();
}

TEST_CASE("11.3 the bar of the wall feels the other one at the end of a lever of two", "[11.3]") {
  LinkCase c{"two bars", felt(), begun()}, after_inertia = c;
  after_inertia.parent.J += mat3(1, 0, 0, 0, 10, 0, 0, 0, 2);
  after_inertia.parent.H += mat3(0, 0, 0, 0, 0, 1, 0, -3, 0);
  after_inertia.parent.M += mat3(1, 0, 0, 0, real(0.5), 0, 0, 0, 1);
  add_inertia_table().check(c, numbers_of(after_inertia, inertia_of_parent));
  add_inertia_table().check();
  add_bias_table().check(c, {0, 0, 20, 0, 15, 0, -10});
  add_bias_table().check();
}

TEST_CASE("11.3 a subtree's inertia and bias are right in all units", "[11.3]") {
  const auto parents = [](bool) { return inertia_of_parent; };
  check_drawn_links(eliminate_table().subject, eliminate, by_matrices::eliminate, of_elimination,
                    with_axis);
  check_drawn_links(add_inertia_table().subject, add_inertia, by_matrices::add_inertia, parents,
                    with_parent);
  check_drawn_links(add_bias_table().subject, add_bias, by_matrices::add_bias, of_bias,
                    with_parent, After::eliminate);
}

// ---- 11.4 ---------------------------------------------------------------------------------------

TEST_CASE("11.4 the outer one of two bars falls without rotating", "[11.4]") {
  LinkCase c{"two bars", felt(), {}};
  c.parent.alpha = vec3(0, 0, -5);
  accelerate_table().check(c, {0, 0, 0, 0, -10, 0, 5, 0});
  accelerate_table().check();
}

TEST_CASE("11.4 accelerations are right in all units", "[11.4]") {
  check_drawn_links(accelerate_table().subject, accelerate, by_matrices::accelerate,
                    of_acceleration, with_axis, After::add_bias);
}

TEST_CASE("11.4 joints do no work on any motion that they allow", "[11.4]") {
  const Subject whole{"11.4", "a chain of eight bars in motion"};
  for (unsigned draw = 1; draw <= 4; ++draw) {
    Random random(draw);
    chapter11::Chain chain(8, vec3(0));
    for (TreeLink& link : chain.links) {
      if (link.parent < 0) continue;
      link.x = random.uniform(-3, 3);
      link.rate = random.uniform(-2, 2);
    }
    chain.pose();
    chain.accelerations();
    for (std::size_t k = 1; k < chain.links.size(); ++k) {
      // only hinge k moves, at 1 rad/s: the work of all that is not a joint's force
      chapter11::Chain allowed = chain;
      for (TreeLink& link : allowed.links) link.rate = 0;
      allowed.links[k].rate = 1;
      allowed.pose();
      double work = 0, size = 0;
      for (std::size_t i = 1; i < chain.links.size(); ++i) {
        const TreeLink& link = chain.links[i];
        const vec3 a = link.a_A + cross(link.alpha, link.c) + cross(link.w, cross(link.w, link.c));
        const vec3 force = link.mass * (a - chain.gravity);
        const vec3 torque = link.inertia * link.alpha + cross(link.w, link.inertia * link.w);
        const real by_force = dot(force, allowed.links[i].v);
        const real by_torque = dot(torque, allowed.links[i].w);
        work += double(by_force + by_torque);
        size += double(std::abs(by_force) + std::abs(by_torque));
      }
      expect(whole, "work on the motion of hinge " + std::to_string(k), work, 0,
             (is_float ? 1e-3 : 1e-10) * size);
    }
  }
}
