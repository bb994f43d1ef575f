// The units of chapter 11's exercises.
#include "chapters/11_reduced/reduced.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

namespace {

constexpr Quantity kg_m = kg * m, kg_m2 = kg * m * m, torque = newton * m;

// A matrix of numbers that have the same unit.
mat3 matrix(Quantity unit) {
  mat3 out(1);
  for (int k = 0; k < 3; ++k) out[k] = (vec3(real(0.3)) + vec3(out[k])) * unit;
  return out;
}
// A link in which all has its unit. \param along of the coordinate
TreeLink link_of(Freedom freedom, Quantity along) {
  TreeLink link;
  const vec3 some(real(0.6), real(-0.3), 1);
  link.freedom = freedom;
  link.rotates_inertia = true;
  link.q = body1.q, link.start = body2.q;
  link.R = mat3_cast(link.q);
  link.axis_local = link.a = direction1;
  link.start_axis = quat(real(0.2), real(0.5), real(-0.3), real(0.7));
  link.from_parent_local = link.centre_local = link.c = link.d = some * m;
  link.centre = some * m, link.v = some * (m / s), link.w = some / s;
  link.mass = real(2) * kg;
  link.inertia_local = some * kg_m2;
  link.inertia = matrix(kg_m2);
  link.force = link.f = some * newton, link.torque = link.n = some * torque;
  link.J = matrix(kg_m2), link.H = matrix(kg_m), link.M = matrix(kg);
  link.alpha = some / (s * s), link.a_A = link.gamma = some * (m / (s * s));
  if (freedom == Freedom::hinge) link.zeta = some / (s * s);
  link.x = real(0.3) * along;
  link.rate = real(0.3) * along / s, link.acceleration = real(0.3) * along / (s * s);
  const Quantity D = kg_m2 / (along * along);
  link.Uw = some * (kg_m2 / along), link.Uv = some * (kg_m / along);
  link.D = D, link.over_D = pure / D, link.added = D;
  link.k = link.tau = D * along / (s * s);
  return link;
}
const TreeLink links[] = {link_of(Freedom::hinge, pure), link_of(Freedom::slider, m)};
const TreeLink parent = link_of(Freedom::free, pure);

}  // namespace

TEST_CASE("11.1 levers are lengths, rates are per second, and accelerations per second squared",
          "[11.1]") {
  for (TreeLink link : links) {
    in("place", [&] { place(link, parent); });
    expect_unit("q", link.q, pure);
    expect_unit("d", link.d, m);
    in("move", [&] { move(link, parent); });
    expect_unit("w", link.w, 1 / s);
    expect_unit("zeta", link.zeta, 1 / (s * s));
    expect_unit("gamma", link.gamma, m / (s * s));
  }
}

TEST_CASE("11.2 inertia is mass times length once more from block to block", "[11.2]") {
  TreeLink link = links[0];
  in("begin_inertia", [&] { begin_inertia(link); });
  expect_unit("J", link.J, kg_m2);
  expect_unit("H", link.H, kg_m);
  expect_unit("M", link.M, kg);
  in("begin_bias", [&] { begin_bias(link); });
  expect_unit("n", link.n, torque);
  expect_unit("f", link.f, newton);
}

TEST_CASE("11.3 what the parent feels has the units of inertia and force", "[11.3]") {
  for (TreeLink link : links) {
    const Quantity along = link.freedom == Freedom::slider ? m : pure;
    TreeLink above = parent;
    in("eliminate", [&] { eliminate(link); });
    expect_unit("Uw", link.Uw, kg_m2 / along);
    expect_unit("Uv", link.Uv, kg_m / along);
    expect_unit("D", link.D, kg_m2 / (along * along));
    expect_unit("over_D", link.over_D, along * along / kg_m2);
    expect_unit("J", link.J, kg_m2);
    in("add_inertia", [&] { add_inertia(link, above); });
    expect_unit("J of the parent", above.J, kg_m2);
    expect_unit("H of the parent", above.H, kg_m);
    in("add_bias", [&] { add_bias(link, above); });
    expect_unit("k", link.k, torque / along);
    expect_unit("n of the parent", above.n, torque);
    expect_unit("f of the parent", above.f, newton);
  }
}

TEST_CASE("11.4 an acceleration is one of an angle or of a length", "[11.4]") {
  for (TreeLink link : links) {
    const Quantity along = link.freedom == Freedom::slider ? m : pure;
    in("accelerate", [&] { accelerate(link, parent); });
    expect_unit("acceleration", link.acceleration, along / (s * s));
    expect_unit("alpha", link.alpha, pure / (s * s));
    expect_unit("a_A", link.a_A, m / (s * s));
    link.held = true;
    in("accelerate", [&] { accelerate(link, parent); });
    expect_unit("tau", link.tau, torque / along);
  }
}
