// The tests of chapter 2's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/checker/catch.h"
#include "tests/checker/fixtures.h"

using namespace joints;
using namespace joints::testing;

namespace {

const real half = std::sqrt(real(0.5));  // cos 45 degrees

// The pose for pencil and paper in the chapter's text.
const Body paper1 = static_body(vec3(0));
const Body paper2 = [] {
  Body body = body_with(2, vec3(5 / real(6), 1, 5 / real(21)), vec3(0, -1, 0),
                        quat(half, 0, 0, half));
  body.v = vec3(1, 0, 0);
  body.w = vec3(0, 0, 2);
  return body;
}();
const Point paper_part{vec3(0), vec3(1, 0, real(0.5))};

}  // namespace

TEST_CASE("2.1 the rows of a ball joint hold a unit matrix and the matrix of a lever", "[2.1]") {
  Jacobian<3> J;  // the lever of body 2 is (0, 1, 1/2)
  J[0] = {vec3(-1, 0, 0), vec3(0), vec3(1, 0, 0), vec3(0, real(0.5), -1)};
  J[1] = {vec3(0, -1, 0), vec3(0), vec3(0, 1, 0), vec3(real(-0.5), 0, 0)};
  J[2] = {vec3(0, 0, -1), vec3(0), vec3(0, 0, 1), vec3(1, 0, 0)};
  check_jacobian<PointFixture>(paper_part, {paper1, paper2}, J);
}

TEST_CASE("2.1 the rows of a ball joint are the slopes of its gap at every pose", "[2.1]") {
  check_jacobian<PointFixture>();
}

TEST_CASE("2.2 K of a ball joint says how far an impulse moves the anchor", "[2.2]") {
  // world inverse inertia diag(1, 1.2, 4.2), lever (0, 1, 1/2), mass 2 kg
  const mat3 K(5, 0, 0, 0, real(0.75), real(-0.5), 0, real(-0.5), real(1.5));
  check_K<PointFixture>(paper_part, {paper1, paper2}, to_matrix(K));
}

TEST_CASE("2.2 K of a ball joint is J M^-1 J^T at every pose", "[2.2]") {
  check_K<PointFixture>();
}

TEST_CASE("2.2 K between two static bodies is zero", "[2.2]") {
  expect(PointFixture::K, "K", paper_part.K(paper1, static_body(vec3(1, 2, 3))), mat3(0), 0);
}

// ---- 2.3 ----------------------------------------------------------------------------------------

namespace {

const Subject impulse{"2.3", "the impulse of a block"};
const Subject application{"2.3", "applying the impulse of a block", 2};

// J and K of a ball joint from the numeric twin, so that this exercise waits for no other.
struct Joint3 {
  Pair pair = uneven_pair();
  Jacobian<3> J;
  mat3 K;
  Joint3() {
    Random random(3);
    move_together(pair, random);
    for (Body* body : {&pair.body1, &pair.body2}) {
      body->v = random.vector(2);
      body->w = random.vector(2);
    }
    const Point part = point_at(pair.body1, pair.body2, pair.body1.x + random.vector(1));
    J = numeric_jacobian(part, pair.body1, pair.body2);
    const Matrix<3> dense = dense_K(J, pair.body1, pair.body2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) K[j][i] = dense[i][j];
  }
  vec3 rate() const {
    return {row_velocity(J[0], pair.body1, pair.body2), row_velocity(J[1], pair.body1, pair.body2),
            row_velocity(J[2], pair.body1, pair.body2)};
  }
};

}  // namespace

TEST_CASE("2.3 a ball joint stops the point of a body that flies and spins", "[2.3]") {
  const Jacobian<3> J = jacobian_from_blocks(mat3(-1), mat3(0), mat3(1),
                                             -skew(vec3(0, 1, real(0.5))));
  const mat3 K(5, 0, 0, 0, real(0.75), real(-0.5), 0, real(-0.5), real(1.5));
  Body wall = paper1, body = paper2;
  expect(impulse, "lambda", block_impulse(J, K, vec3(0), wall, body), vec3(real(0.2), 0, 0),
         10 * rounding,
         {{vec3(real(-0.2), 0, 0), "the sign: the impulse works against J V + b"},
          {vec3(5, 0, 0), "times K where its inverse belongs"},
          {vec3(0), "J V is missing, or nothing is done where the bias is 0"}});
  apply_impulse(J, vec3(real(0.2), 0, 0), wall, body);
  expect(application, "v2", body.v, vec3(real(1.1), 0, 0), 10 * rounding,
         {{vec3(real(0.9), 0, 0), "the sign: velocities grow by +M^-1 J^T lambda"},
          {vec3(real(1.2), 0, 0), "the inverse mass is missing"},
          {vec3(real(1.4), 0, 0), "mass where inverse mass belongs"}});
  expect(application, "w2", body.w, vec3(0, real(0.12), real(1.16)), 10 * rounding,
         {{vec3(0, real(-0.12), real(2.84)), "the sign: velocities grow by +M^-1 J^T lambda"},
          {vec3(0, real(0.1), real(1.8)), "the inverse inertia is missing"},
          {vec3(0, real(0.1), real(1.16)), "body-space inertia: take inverse_inertia(body)"}});
  expect(application, "v1 of a static body", wall.v, vec3(0), 0);
  expect(application, "w1 of a static body", wall.w, vec3(0), 0);
}

TEST_CASE("2.3 the impulse of a block takes all three rates away at once", "[2.3]") {
  const Joint3 joint;
  const vec3 bias(real(0.3), real(-0.2), real(0.5)), e = joint.rate() + bias;
  const vec3 right = -inverse(joint.K) * e;
  const vec3 rows(-e.x / joint.K[0][0], -e.y / joint.K[1][1], -e.z / joint.K[2][2]);
  expect(impulse, "lambda",
         block_impulse(joint.J, joint.K, bias, joint.pair.body1, joint.pair.body2), right,
         100 * rounding,
         {{-right, "the sign: the impulse works against J V + b"},
          {-inverse(joint.K) * joint.rate(), "the bias is missing"},
          {-inverse(joint.K) * bias, "J V is missing"},
          {-joint.K * e, "times K where its inverse belongs"},
          {-inverse(joint.K) * (joint.rate() - bias), "the sign of the bias"},
          {rows, "each row divided by its own K: the rows of a block are solved together"}});
}

TEST_CASE("2.3 a joint without a gap still stops what would open it", "[2.3]") {
  const Joint3 joint;
  expect(impulse, "lambda where the bias is 0",
         block_impulse(joint.J, joint.K, vec3(0), joint.pair.body1, joint.pair.body2),
         -inverse(joint.K) * joint.rate(), 100 * rounding,
         {{vec3(0), "nothing is done where the bias is 0. C = 0 does not mean that there is "
                    "nothing to solve: the velocity J V would change C"}});
}

TEST_CASE("2.3 the impulse of a block changes velocities by M^-1 J^T lambda", "[2.3]") {
  const Joint3 joint;
  const vec3 lambda(real(0.4), real(-0.7), real(0.2));
  Pair after = joint.pair;
  apply_impulse(joint.J, lambda, after.body1, after.body2);
  const auto compare = [&](const Body& before, const Body& changed, bool second) {
    vec3 push(0), turn(0), first_push(0), first_turn(0), across(0);
    for (int i = 2; i >= 0; --i) {
      const Row& J = joint.J[i];
      first_push = lambda[i] * (second ? J.v2 : J.v1);
      first_turn = lambda[i] * (second ? J.w2 : J.w1);
      push += first_push;
      turn += first_turn;
      across[i] = dot(second ? J.w2 : J.w1, lambda);
    }
    const std::string number = second ? "2" : "1";
    const mat3 I = inverse_inertia(before);
    const char* const sign = "the sign: velocities grow by +M^-1 J^T lambda";
    const char* const set = "the velocity is set where it must grow: += and not =";
    const char* const first = "only the first row pushes: all three do, each with its lambda[i]";
    const vec3 v = before.v + before.inverse_mass * push, w = before.w + I * turn;
    expect(application, "v" + number, changed.v, v, 10 * rounding,
           {{real(2) * before.v - v, sign},
            {before.v, "this velocity is not changed at all"},
            {v - before.v, set},
            {before.v + before.inverse_mass * first_push, first},
            {before.v + push, "the inverse mass is missing"},
            {before.v + push / before.inverse_mass, "mass where inverse mass belongs"}});
    expect(application, "w" + number, changed.w, w, 10 * rounding,
           {{before.w + I * across, "J where J^T belongs: the sign of the turn (row i pushes along "
                                    "J[i] with lambda[i])"},
            {real(2) * before.w - w, sign},
            {before.w, "this velocity is not changed at all"},
            {w - before.w, set},
            {before.w + I * first_turn, first},
            {before.w + turn, "the inverse inertia is missing"},
            {before.w + inverse(I) * turn, "inertia where inverse inertia belongs"},
            {before.w + before.inverse_inertia_local * turn,
             "body-space inertia: take inverse_inertia(body)"}});
  };
  compare(joint.pair.body1, after.body1, false);
  compare(joint.pair.body2, after.body2, true);
}

TEST_CASE("2.3 after its impulse a ball joint holds and a second impulse is zero", "[2.3]") {
  Joint3 joint;
  const vec3 bias(real(0.3), real(-0.2), real(0.5));
  const auto solve = [&] {
    const vec3 lambda =
        block_impulse(joint.J, joint.K, bias, joint.pair.body1, joint.pair.body2);
    apply_impulse(joint.J, lambda, joint.pair.body1, joint.pair.body2);
    return lambda;
  };
  solve();
  expect(impulse, "J V + b after the impulse", joint.rate() + bias, vec3(0), 100 * rounding);
  expect(impulse, "a second impulse", solve(), vec3(0), 100 * rounding);
}

// ---- 2.4 ----------------------------------------------------------------------------------------

namespace {

const Subject turning{"2.4", "turning a body"};

const char* const half_angle = "the half of the angle is forgotten";
const char* const sign_of_turn = "the sign of the turn";
const char* const unit_axis = "the axis must be a unit vector";
const char* const first_term = "q + h/2 (0, w) q is only the first term of the exponential";
}  // namespace

TEST_CASE("2.4 half a turn a second for half a second is a quarter turn", "[2.4]") {
  const vec3 w(0, 0, real(3.14159265358979323846));
  expect(turning, "q", turned(quat(1, 0, 0, 0), w, real(0.5)), quat(half, 0, 0, half), rounding,
         {{quat(0, 0, 0, 1), half_angle},
          {quat(half, 0, 0, -half), sign_of_turn},
          {quat(1, 0, 0, 0), "nothing turns"},
          {rotation(w), "h is missing: the angle is h |w|"},
          {normalize(quat(1, 0, 0, w.z / 4)), first_term},
          {quat(1, 0, 0, w.z / 4), first_term},
          {quat(half, 0, 0, half * w.z), unit_axis},
          {normalize(quat(half, 0, 0, half * w.z)), unit_axis}});
}

TEST_CASE("2.4 a steady spin turns a body by the exponential of h w in the world", "[2.4]") {
  Random random(4);
  for (int draw = 0; draw < 10; ++draw) {
    const quat q = random.turn();
    const vec3 w = random.vector(4);
    const real h = real(0.1), angle = h * length(w), scale = std::sin(angle / 2);
    const vec3 phi = h * w;
    const quat turn = rotation(phi);
    const quat first_order = q + quat(0, phi.x / 2, phi.y / 2, phi.z / 2) * q;
    const quat long_axis(std::cos(angle / 2), scale * w.x, scale * w.y, scale * w.z);
    expect(turning, "q", turned(q, w, h), turn * q, 10 * rounding,
           {{q * turn, "the turn is multiplied from the right: w is in world axes, not body axes"},
            {rotation(real(2) * phi) * q, half_angle},
            {rotation(-phi) * q, sign_of_turn},
            {rotation(w) * q, "h is missing: the angle is h |w|"},
            {turn, "the old orientation is lost: exp(h w) q"},
            {long_axis * q, unit_axis},
            {normalize(long_axis * q), unit_axis},
            {normalize(first_order), first_term},
            {first_order, first_term}});
  }
}

TEST_CASE("2.4 a body at rest keeps its orientation", "[2.4]") {
  const quat q = rotation(vec3(real(0.3), real(0.2), real(-0.9)));
  expect(turning, "q of a body at rest", turned(q, vec3(0), real(0.1)), q, rounding,
         {{quat(1, 0, 0, 0), "a body at rest keeps q: it does not go back to (1, 0, 0, 0)"}});
}

TEST_CASE("2.4 a thousand turns leave a unit quaternion", "[2.4]") {
  quat q(1, 0, 0, 0);
  Random random(6);
  for (int n = 0; n < 1000; ++n) q = turned(q, random.vector(10), real(1) / 60);
  expect(turning, "length of q after 1000 steps", double(length(q)), 1, rounding);
}
