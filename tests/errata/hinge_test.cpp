// Formulas of the thesis about motors, hinges and limits that are wrong as printed, or right only
// where it does not say so: each worked out as it stands, and the right one beside it.
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const double near = tolerance(1e-9, 1e-4);

// The whole angle of a turn, 2 atan2(|v|, s), as reference [17] of the thesis takes it.
double total_angle(const quat& q) {
  const vec3 v(q.x, q.y, q.z);
  return 2 * std::atan2(double(length(v)), std::abs(double(q.w)));
}

// Any two vectors at right angles to a, found anew whenever they are wanted.
std::pair<vec3, vec3> fresh_basis(const vec3& a) {
  const vec3 other = std::abs(a.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 b = normalize(cross(a, other));
  return {b, cross(a, b)};
}

// Section 3.7.3 with b and c computed from a2 where they are needed.
struct FreshAxis {
  vec3 a1_local, a2_local;
  static constexpr int rows = 2;
  std::pair<vec3, vec3> basis(const Body& body2) const {
    return fresh_basis(to_world(body2, a2_local));
  }
  Vector<2> error(const Body& body1, const Body& body2) const {
    const vec3 a1 = to_world(body1, a1_local);
    const auto [b, c] = basis(body2);
    return {dot(a1, b), dot(a1, c)};
  }
  Jacobian<2> jacobian(const Body& body1, const Body& body2) const {
    const vec3 a1 = to_world(body1, a1_local);
    const auto [b, c] = basis(body2);
    Jacobian<2> J;
    J[0] = {vec3(0), -cross(b, a1), vec3(0), cross(b, a1)};
    J[1] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)};
    return J;
  }
};

// A rotor on its axis, solved 30 times in a step with the motor's row as it is asked for.
double rate_after_a_step(double bias) {
  Rotor rotor;
  Body wall = rotor.world.bodies[rotor.wall], body = rotor.rotor();
  const Row J = rotor.hinge->coordinate().jacobian(wall, body);
  const real K = rotor.hinge->coordinate().K(wall, body);
  for (int loop = 0; loop < 30; ++loop)
    apply_impulse(J, row_impulse(J, K, real(bias), wall, body), wall, body);
  return double(body.w.z);
}

}  // namespace

TEST_CASE("E14 a bias equal to the wanted speed gives minus that speed", "[E14]") {
  CHECK(rate_after_a_step(3) == Approx(-3).epsilon(near));   // J V + b = 0 with b = speed
  CHECK(rate_after_a_step(-3) == Approx(3).epsilon(near));   // b = -speed
}

TEST_CASE("E30 the printed motor of a hinge asks for minus its speed and ours turns right-handed",
          "[E30]") {
  // printed: dC/dt = a.(w2 - w1) + w_motor = 0
  CHECK(rate_after_a_step(+3) == Approx(-3).epsilon(near));
  Rotor rotor;
  rotor.hinge->set_motor(3, unbounded);
  rotor.run(1, h);
  CHECK(double(rotor.rotor().w.z) == Approx(3).epsilon(near));
  CHECK(double(rotor.hinge->speed(rotor.world.bodies)) == Approx(3).epsilon(near));
}

TEST_CASE("E16 without the gyroscopic term a free body bends its angular momentum by 1.8 %",
          "[E16]") {
  const dvec3 I(1, 2, 3);
  const auto drift = [&](bool as_printed, int rate) {  // in 2 s
    Body body = body_with(1, vec3(1, 2, 3), vec3(0));
    body.w = vec3(real(0.1), 8, real(0.1));
    const auto momentum = [&] {
      const dmat3 R = rotation_matrix(body);
      return R * (I * (transpose(R) * dvec3(body.w)));
    };
    const dvec3 before = momentum();
    double worst = 0;
    for (int step = 0; step < 2 * rate; ++step) {
      const real t = real(1) / real(rate);
      if (as_printed) body.q = normalize(rotation(t * body.w) * body.q);  // I dw/dt = 0
      else integrate_pose(body, t);
      worst = std::max(worst, length(momentum() - before) / length(before));
    }
    return worst;
  };
  for (int rate : {60, 960, 3840}) CHECK(drift(true, rate) == Approx(0.0177).epsilon(0.05));
  CHECK(drift(false, 60) < tolerance(1e-13, 1e-4));
}

TEST_CASE("E24 axes b and c that are made anew every time make J wrong off alignment", "[E24]") {
  double fresh_aligned = 0, fresh_bent = 0, ours_bent = 0;
  Random random(31);
  for (int draw = 0; draw < 200; ++draw) {
    const Pair pair = uneven_pair();
    const vec3 axis = normalize(random.vector(1) + vec3(0, 0, real(0.1)));
    const Axis ours = axis_along(pair.body1, pair.body2, axis);
    const FreshAxis fresh{ours.a1_local, normalize(to_local(pair.body2, axis))};
    if (std::abs(std::abs(axis.x) - real(0.6)) < real(0.05)) continue;  // where the basis jumps
    fresh_aligned = std::max(fresh_aligned, slope_error(fresh, pair.body1, pair.body2));
    Body bent = pair.body2;
    bent.q = normalize(rotation(random.vector(real(0.5))) * bent.q);
    const vec3 a2 = to_world(bent, fresh.a2_local);
    if (std::abs(std::abs(a2.x) - real(0.6)) < real(0.05)) continue;
    fresh_bent = std::max(fresh_bent, slope_error(fresh, pair.body1, bent));
    ours_bent = std::max(ours_bent, slope_error(ours, pair.body1, bent));
  }
  CHECK(fresh_aligned < 4 * difference_tolerance);
  CHECK(fresh_bent > 0.5);
  CHECK(ours_bent < difference_tolerance);
}

TEST_CASE("E24 two vectors that are only orthogonal to a2 may miss half of a misalignment",
          "[E24]") {
  const Body wall = static_body(vec3(0));
  const Body bent = static_body(vec3(0), rotation(vec3(real(0.3), 0, 0)));  // a2 tilts along y
  const Axis both_along_x{vec3(0, 0, 1), vec3(1, 0, 0), vec3(-1, 0, 0)};
  const Vector<2> C = both_along_x.error(wall, bent);
  CHECK(std::hypot(double(C[0]), double(C[1])) < tolerance(1e-15, 1e-7));
  const Axis ours = axis_along(wall, wall, vec3(0, 0, 1));
  const Vector<2> right = ours.error(wall, bent);
  CHECK(std::hypot(double(right[0]), double(right[1])) == Approx(std::sin(0.3)).epsilon(near));
}

TEST_CASE("E25 the printed error of the axis is zero upside down too and its K singular at 90",
          "[E25]") {
  const Body wall = static_body(vec3(0));
  const Axis part = axis_along(wall, wall, vec3(0, 0, 1));
  for (double angle : {90.0, 180.0}) {
    Body body = body_with(1, vec3(1, 2, 3), vec3(0));
    body.q = rotation(real(angle) * degree * vec3(real(0.6), real(0.8), 0));
    const vec3 a1(0, 0, 1), b = to_world(body, part.b_local), c = to_world(body, part.c_local);
    const mat3 I = inverse_inertia(body);
    const vec3 rows[2] = {cross(b, a1), cross(c, a1)};  // as printed
    const double det = double(dot(rows[0], I * rows[0]) * dot(rows[1], I * rows[1]) -
                              dot(rows[0], I * rows[1]) * dot(rows[0], I * rows[1]));
    const double C = std::hypot(double(dot(a1, b)), double(dot(a1, c)));
    CHECK(C == Approx(std::sin(angle * double(degree))).margin(tolerance(1e-14, 1e-6)));
    if (angle == 90) CHECK(std::abs(det) < tolerance(1e-14, 1e-6));
    const Vector<2> ours = part.error(wall, body);
    const Matrix<2> K = part.K(wall, body);
    CHECK(std::hypot(double(ours[0]), double(ours[1])) ==
          Approx(angle * double(degree)).epsilon(tolerance(1e-12, 1e-5)));
    CHECK(double(K[0][0] * K[1][1] - K[0][1] * K[1][0]) > 0.1);
  }
}

TEST_CASE("E26 the printed angle of a pair that is turned by 1 rad as one may read 2 rad",
          "[E26]") {
  Random random(32);
  double worst = 0, sum = 0, ours = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const quat q1 = random.turn(), q2 = random.turn();
    const quat turn = rotation(normalize(random.vector(1)));
    const quat start = q2 * conjugate(q1);                         // as printed
    const quat now = (turn * q2) * conjugate(turn * q1);
    const double angle = total_angle(now * conjugate(start));
    worst = std::max(worst, angle);
    sum += angle;
    Body body1 = static_body(vec3(0), q1), body2 = static_body(vec3(0), q2);
    const HingeAngle part = angle_about(body1, body2, normalize(random.vector(1)));
    body1.q = turn * q1;
    body2.q = turn * q2;
    ours = std::max(ours, std::abs(double(part.error(body1, body2))));
  }
  CHECK(worst > 1.9);
  CHECK(sum / 200 > 1.1);
  CHECK(sum / 200 < 1.4);
  CHECK(ours < tolerance(1e-14, 2e-6));
}

TEST_CASE("E27 the whole angle reads a misalignment of 0.05 as an angle and has no sign", "[E27]") {
  const Body wall = static_body(vec3(0));
  const HingeAngle part = angle_about(wall, wall, vec3(0, 0, 1));
  const auto read = [&](const quat& q) {
    const Body body = static_body(vec3(0), q);
    return std::pair{total_angle(q), double(part.error(wall, body))};
  };
  const auto [bent, ours_bent] = read(rotation(vec3(real(0.05), 0, 0)));
  CHECK(bent == Approx(0.05).epsilon(near));
  CHECK(std::abs(ours_bent) < tolerance(1e-15, 1e-7));
  const auto [back, ours_back] = read(rotation(vec3(0, 0, real(-0.3))));
  CHECK(back == Approx(0.3).epsilon(near));
  CHECK(ours_back == Approx(-0.3).epsilon(near));
}

TEST_CASE("E28 a limit of 4.712 is never seen by an angle that is read modulo 2 pi", "[E28]") {
  const double limit = 1.5 * std::numbers::pi;
  Rotor rotor;
  rotor.rotor().q = rotation(vec3(0, 0, real(4.8)));
  CHECK(double(rotor.hinge->coordinate().twist(rotor.world.bodies[rotor.wall], rotor.rotor())) ==
        Approx(4.8 - 2 * std::numbers::pi).epsilon(near));  // -1.483, below the limit
  CHECK(4.8 - 2 * std::numbers::pi == Approx(-1.483).epsilon(1e-3));
  Rotor free(0, 5), held(0, 5);  // as printed the limit would have to be seen, here it is
  held.hinge->set_limits(-unbounded, real(limit));
  double highest = -10;
  for (int step = 0; step < 120; ++step) {
    free.run(1, h);
    held.run(1, h);
    highest = std::max(highest, double(free.hinge->coordinate().twist(
                                    free.world.bodies[free.wall], free.rotor())));
  }
  CHECK(highest < std::numbers::pi + 1e-6);  // so "twist > 4.712" is never true in any turn
  CHECK(held.angle() == Approx(limit).epsilon(tolerance(1e-9, 1e-5)));
}

TEST_CASE("E29 a1 alone as the row of the angle is wrong by tan of half the misalignment",
          "[E29]") {
  for (const auto& [phi, expected] : {std::pair{0.1, 0.0500}, {0.5, 0.2553}, {1.0, 0.5463}}) {
    const Body wall = static_body(vec3(0), rotation(vec3(real(0.3), real(-0.2), 1)));
    Body body = static_body(vec3(0), rotation(vec3(1, real(0.5), 0)));
    const vec3 a1 = normalize(vec3(1, 2, -1));
    const HingeAngle part = angle_about(wall, body, a1);
    body.q = rotation(real(phi) * normalize(cross(a1, vec3(0, 0, 1)))) * body.q;
    const vec3 slope = numeric_jacobian(part, wall, body)[0].w2;
    const double wrong = double(length(slope - a1));
    CHECK(wrong == Approx(std::tan(phi / 2)).epsilon(tolerance(1e-6, 5e-3)));
    CHECK(wrong == Approx(expected).epsilon(tolerance(1e-3, 5e-3)));
    CHECK(double(length(slope - part.jacobian(wall, body).w2)) < difference_tolerance);
  }
}

TEST_CASE("E31 a bound on every impulse gives thirty times the strength for thirty loops",
          "[E31]") {
  const Motor motor{1e6, 1};  // 1 N m
  double printed = 0;
  real sum = 0;
  for (int loop = 0; loop < 30; ++loop) {
    const double wanted = 1e6;  // far away: every loop would like more
    printed += std::clamp(wanted, -1.0, 1.0);
    motor_impulse(0, 1, motor, h, sum);
  }
  CHECK(printed == 30);
  CHECK(double(sum) == Approx(1.0 / 60).epsilon(near));
}

TEST_CASE("E31 a motor of 30 N m reaches 10 rad per s at once as printed and 0.5 in truth",
          "[E31]") {
  Body wall = static_body(vec3(0)), body = body_with(1, vec3(1), vec3(0));
  const Row J{vec3(0), vec3(0, 0, -1), vec3(0), vec3(0, 0, 1)};
  for (int loop = 0; loop < 30; ++loop)
    apply_impulse(J, std::clamp(row_impulse(J, 1, -10, wall, body), real(-30), real(30)), wall,
                  body);
  CHECK(double(body.w.z) == Approx(10).epsilon(near));
  for (int iterations : {1, 30, 100}) {
    Rotor rotor;
    rotor.hinge->set_motor(10, 30);
    rotor.solver.iterations = iterations;
    rotor.run(1, h);
    CHECK(double(rotor.rotor().w.z) == Approx(0.5).epsilon(near));
  }
}
