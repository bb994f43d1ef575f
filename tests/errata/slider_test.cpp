// Formulas of the thesis about the slider that are wrong as printed: each worked out as it stands,
// and the right one beside it.
#include "engine/instruments/measure.h"
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const double near = tolerance(1e-9, 1e-4);

// The row of section 3.7.4 without u: the lever of body 1 ends at its own anchor.
struct ShortLine : Line {
  Jacobian<2> jacobian(const Body& body1, const Body& body2) const {
    const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
    const vec3 n[2] = {to_world(body1, n1_local), to_world(body1, n2_local)};
    Jacobian<2> J;
    for (int i = 0; i < 2; ++i) J[i] = {-n[i], -cross(r1, n[i]), n[i], cross(r2, n[i])};
    return J;
  }
};

// The same line with its directions carried by body 2, the printed levers kept.
struct LineOfBody2 {
  vec3 anchor1_local, anchor2_local, n_local[2];  // n in body space of body 2
  static constexpr int rows = 2;
  vec3 u(const Body& body1, const Body& body2) const {
    return world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  }
  Vector<2> error(const Body& body1, const Body& body2) const {
    const vec3 gap = u(body1, body2);
    return {dot(gap, to_world(body2, n_local[0])), dot(gap, to_world(body2, n_local[1]))};
  }
  Jacobian<2> jacobian(const Body& body1, const Body& body2) const {
    const vec3 lever1 = to_world(body1, anchor1_local) + u(body1, body2);
    const vec3 r2 = to_world(body2, anchor2_local);
    Jacobian<2> J;
    for (int i = 0; i < 2; ++i) {
      const vec3 n = to_world(body2, n_local[i]);
      J[i] = {-n, -cross(lever1, n), n, cross(r2, n)};
    }
    return J;
  }
};

// The rotation of section 3.7.4: differences of the angles about x, y and z, as they are read off
// a rotation matrix; the rate of the difference is taken for w2 - w1.
struct AngleDifferences {
  static constexpr int rows = 3;
  static vec3 angles(const Body& body) {
    const mat3 R = mat3_cast(body.q);  // R[column][row]
    return {std::atan2(R[1][2], R[2][2]), std::asin(-R[0][2]), std::atan2(R[0][1], R[0][0])};
  }
  vec3 error(const Body& body1, const Body& body2) const { return angles(body2) - angles(body1); }
  Jacobian<3> jacobian(const Body&, const Body&) const {
    return jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1));
  }
};

// The row of the printed motor: no levers.
Row printed_motor(const vec3& a) { return {-a, vec3(0), a, vec3(0)}; }

// Two free bodies on a slider along `a`, slid by `displacement`.
struct Slid {
  Pair pair = uneven_pair();
  vec3 a = normalize(vec3(2, -1, real(0.5)));
  Line line;
  Slide slide;
  explicit Slid(real displacement) {
    const vec3 anchor(real(0.8), real(0.4), real(-0.6));
    line = line_along(pair, anchor, a);
    slide = {line.anchor1_local, line.anchor2_local, cross(line.n1_local, line.n2_local)};
    pair.body2.x += displacement * a;
  }
};

dvec3 angular_momentum(const Pair& pair) {  // about the origin
  dvec3 sum(0);
  for (const Body* body : {&pair.body1, &pair.body2}) {
    sum += cross(dvec3(body->x), dvec3(body->v)) / double(body->inverse_mass);
    sum += inertia_of(*body) * dvec3(body->w);
  }
  return sum;
}

}  // namespace

TEST_CASE("E33 without u in its lever the row of a line is wrong by the displacement it has slid",
          "[E33]") {
  for (const auto& [displacement, at_least] : {std::pair{0.0, 0.0}, {0.5, 0.25}, {2.7, 1.4}}) {
    const Slid slid{real(displacement)};
    const Body &one = slid.pair.body1, &two = slid.pair.body2;
    const Vector<2> C = slid.line.error(one, two);
    CHECK(std::hypot(double(C[0]), double(C[1])) < tolerance(1e-15, 1e-6));  // on the line
    const Jacobian<2> slope = numeric_jacobian(slid.line, one, two);
    const Jacobian<2> printed = ShortLine{slid.line}.jacobian(one, two);
    for (int i = 0; i < 2; ++i)  // u x n is as long as u
      CHECK(double(length(slope[i].w1 - printed[i].w1)) ==
            Approx(displacement).margin(tolerance(1e-8, 1e-3)));
    CHECK(slope_error(ShortLine{slid.line}, one, two) >= at_least);
    CHECK(slope_error(slid.line, one, two) < difference_tolerance);
  }
}

TEST_CASE("E33 with directions that body 2 carries the printed levers are wrong by it too",
          "[E33]") {
  const Slid slid{real(2.7)};
  const Body &one = slid.pair.body1, &two = slid.pair.body2;
  const LineOfBody2 other{slid.line.anchor1_local, slid.line.anchor2_local,
                          {to_local(two, to_world(one, slid.line.n1_local)),
                           to_local(two, to_world(one, slid.line.n2_local))}};
  const Jacobian<2> slope = numeric_jacobian(other, one, two), J = other.jacobian(one, two);
  for (int i = 0; i < 2; ++i) {
    CHECK(double(length(slope[i].w1 - J[i].w1)) == Approx(2.7).epsilon(tolerance(1e-8, 1e-3)));
    CHECK(double(length(slope[i].w2 - J[i].w2)) == Approx(2.7).epsilon(tolerance(1e-8, 1e-3)));
  }
}

TEST_CASE("E34 differences of angles do not change at the rate w2 - w1", "[E34]") {
  // turned about the middle axis by phi the rate is wrong by tan phi
  for (const auto& [phi, expected] :
       {std::pair{0.01, 0.0100}, {0.1, 0.1003}, {0.5, 0.5463}, {1.0, 1.5574}}) {
    const Body wall = static_body(vec3(0));
    Body body = static_body(vec3(0), rotation(vec3(0, real(phi), 0)));
    CHECK(slope_error(AngleDifferences{}, wall, body) ==
          Approx(expected).margin(tolerance(1e-4, 1e-3)));
    const Body both = body;  // even where both are turned alike and the error is zero
    CHECK(slope_error(AngleDifferences{}, both, body) ==
          Approx(expected).margin(tolerance(1e-4, 1e-3)));
    CHECK(slope_error(lock_of(both, body), both, body) < difference_tolerance);
  }
}

TEST_CASE("E34 a slider held by differences of angles turns back wrongly from a large turn",
          "[E34]") {
  // the body is 170 degrees off about z, then a little more: the difference jumps by a full turn
  const Body wall = static_body(vec3(0));
  const auto read = [&](double degrees) {
    const Body body = static_body(vec3(0), rotation(vec3(0, 0, real(degrees) * degree)));
    return double(AngleDifferences{}.error(wall, body).z);
  };
  CHECK(read(179) - read(181) == Approx(2 * std::numbers::pi).epsilon(0.01));
  const Body turned = static_body(vec3(0), rotation(vec3(0, 0, real(181) * degree)));
  const Body little = static_body(vec3(0), rotation(vec3(0, 0, real(179) * degree)));
  CHECK(double(lock_of(little, turned).error(little, turned).z) ==
        Approx(0).margin(tolerance(1e-14, 1e-6)));
}

TEST_CASE("E35 a slider between bodies that are turned unlike starts with an error as printed",
          "[E35]") {
  const quat q1 = rotation(vec3(real(0.3), 0, 0)), q2 = rotation(vec3(0, real(0.4), real(0.5)));
  const Body one = static_body(vec3(0), q1), two = box(2, vec3(1, 2, 3), vec3(0, 1, 0), q2);
  CHECK(double(length(AngleDifferences{}.error(one, two))) > 0.5);
  CHECK(double(length(lock_of(one, two).error(one, two))) < tolerance(1e-15, 1e-6));
  World world;  // and so a slider does not move them
  world.gravity = vec3(0);
  const BodyId a = world.add(one), b = world.add(two);
  world.add<SliderJoint>(a, b, vec3(0), vec3(1, 1, 0));
  for (int n = 0; n < 60; ++n) step_once(world, h);
  CHECK(double(length(world.bodies[b].w)) < tolerance(1e-13, 1e-5));
}

TEST_CASE("E36 the printed row of the motor is the negative of the printed rate", "[E36]") {
  Body one = static_body(vec3(0)), two = box(2, vec3(1), vec3(1, 0, 0));
  one.v = vec3(1, 0, 0);
  two.v = vec3(3, 0, 0);
  const vec3 a(1, 0, 0);
  const Row printed{a, vec3(0), -a, vec3(0)};
  const Slide slide{vec3(0), vec3(0), a};
  CHECK(double(row_velocity(printed, one, two)) == Approx(-2));  // the displacement grows by 2 m/s
  CHECK(double(row_velocity(slide.jacobian(one, two), one, two)) == Approx(2));
  // with the printed rate's bias the printed row pushes towards + v_motor, its formula says minus
  one.v = two.v = vec3(0);
  apply_impulse(printed, row_impulse(printed, two.inverse_mass, 3, one, two), one, two);
  CHECK(double(two.v.x) == Approx(3).epsilon(near));
}

TEST_CASE("E37 the printed motor reads a turning pair as sliding and ours does not", "[E37]") {
  // the pair turns as one at 0.7 rad/s, body 2's centre 1 m beside the line through body 1's
  Body one = box(2, vec3(1), vec3(0)), two = box(3, vec3(1), vec3(2, 1, 0));
  one.w = two.w = vec3(0, 0, real(0.7));
  two.v = cross(two.w, two.x);
  const vec3 a(1, 0, 0);
  CHECK(double(row_velocity(printed_motor(a), one, two)) == Approx(-0.7).epsilon(near));
  const Slide slide{vec3(0), vec3(0), a};
  CHECK(std::abs(double(row_velocity(slide.jacobian(one, two), one, two))) <
        tolerance(1e-15, 1e-6));
}

TEST_CASE("E37 the printed motor turns a free pair by the offset times its impulse", "[E37]") {
  for (real offset : {real(0), real(1), real(2.5)}) {
    const Pair start{box(2, vec3(1), vec3(0)), box(3, vec3(1), vec3(2, offset, 0))};
    const vec3 a(1, 0, 0);
    const Slide slide{vec3(0), vec3(0), a};
    Pair printed = start, ours = start;
    apply_impulse(printed_motor(a), 1, printed.body1, printed.body2);
    apply_impulse(slide.jacobian(ours.body1, ours.body2), 1, ours.body1, ours.body2);
    const dvec3 expected = dvec3(cross(start.body2.x - start.body1.x, a));
    CHECK(length(angular_momentum(printed) - expected) < tolerance(1e-14, 1e-6));
    CHECK(length(angular_momentum(printed)) == Approx(double(offset)).epsilon(near));
    CHECK(length(angular_momentum(ours)) < tolerance(1e-14, 1e-6));
  }
}

TEST_CASE("E38 the printed bound gives a slider's motor thirty times its force for thirty loops",
          "[E38]") {
  Body wall = static_body(vec3(0)), body = box(1, vec3(1), vec3(1, 0, 0));
  const Row J = printed_motor(vec3(1, 0, 0));
  for (int loop = 0; loop < 30; ++loop)  // 1 N, far too weak to reach 1000 m/s
    apply_impulse(J, std::clamp(row_impulse(J, 1, -1000, wall, body), real(-1), real(1)), wall,
                  body);
  CHECK(double(body.v.x) == Approx(30).epsilon(near));
  World world = weightless();
  const BodyId a = world.add(static_body(vec3(0))), b = world.add(box(1, vec3(1), vec3(1, 0, 0)));
  auto& slider = world.add<SliderJoint>(a, b, vec3(0), vec3(1, 0, 0));
  slider.set_motor(1000, 1);
  step_once(world, h);
  CHECK(double(world.bodies[b].v.x) == Approx(1.0 / 60).epsilon(tolerance(1e-9, 5e-3)));
}
