// What is true of the parts themselves: their rows, their K and their errors, at every kind of pose
// and for every part of chapters 1 and 2.
#include "tests/checker/catch.h"
#include "tests/checker/fixtures.h"
#include "tests/oracle/oracle.h"

using namespace joints;
using namespace joints::testing;

namespace {

struct CentreRopeFixture : CentreDistanceFixture {
  using Part = Rope<CentreDistance>;
  static constexpr Subject J{"", "the row J of a rope from centre to centre"};
  static Part make(const Pair& pair) { return {CentreDistanceFixture::make(pair)}; }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    CentreDistanceFixture::move_freely(part.rod, pair, random);
  }
};

template <class Fixture, class Look>
void at_every_pose(Look look) {
  INFO("part: " << Fixture::J.words);
  for_each_pose<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    INFO("pose: " << pose_names[std::size_t(pose)]);
    look(part, pair);
  });
}

// Calls look(part, pair) for every part at every pose.
template <class Look>
void for_every_part(Look look) {
  at_every_pose<CentreDistanceFixture>(look);
  at_every_pose<DistanceFixture>(look);
  at_every_pose<CentreRopeFixture>(look);
  at_every_pose<RopeFixture>(look);
  at_every_pose<PointFixture>(look);
}

// A part's numbers as matrices.
template <class Part>
struct Numeric {
  Dense J, K;
  Column C;
  Numeric(const Part& part, const Body& a, const Body& b) {
    constexpr int N = Part::rows;
    J = {N, 12, flat(to_jacobian(part.jacobian(a, b)))};
    K = {N, N, flat(to_matrix(part.K(a, b)))};
    const Vector<N> error = to_vector(part.error(a, b));
    C = Column(N);
    for (int i = 0; i < N; ++i) C[i] = double(error[std::size_t(i)]);
  }
};

bool all_finite(const Dense& numbers) { return numbers.finite(); }

}  // namespace

TEST_CASE("I1 J times V is the rate at which the error of a moving pair changes") {
  for_every_part([](const auto& part, const Pair& pair) {
    Random random(11);
    Pair moving = pair;
    for (Body* body : {&moving.body1, &moving.body2}) {
      body->v = random.vector(real(0.6));
      body->w = random.vector(real(0.6));
    }
    Pair before = moving, after = moving;
    for (Body* body : {&before.body1, &before.body2}) integrate_pose(*body, -difference_step);
    for (Body* body : {&after.body1, &after.body2}) integrate_pose(*body, difference_step);
    const Numeric now(part, moving.body1, moving.body2);
    const Column rate = (Numeric(part, after.body1, after.body2).C -
                         Numeric(part, before.body1, before.body2).C) /
                        (2 * double(difference_step));
    const Column JV = now.J * velocities({moving.body1, moving.body2});
    CHECK((rate - JV).largest() < difference_tolerance);
  });
}

TEST_CASE("I2 K is J M^-1 J^T and the same below and above its diagonal") {
  for_every_part([](const auto& part, const Pair& pair) {
    const Numeric at(part, pair.body1, pair.body2);
    const Dense K = at.J * inverse_masses({pair.body1, pair.body2}) * at.J.transpose();
    const double size = K.largest();
    CHECK((at.K - K).largest() / size < tolerance(1e-12, 1e-5));
    CHECK((at.K - at.K.transpose()).largest() / size < tolerance(1e-15, 1e-6));
  });
}

TEST_CASE("I2 in no direction does a ball joint feel less than the two masses in series") {
  at_every_pose<PointFixture>([](const Point& part, const Pair& pair) {
    const double mm = double(pair.body1.inverse_mass + pair.body2.inverse_mass);
    const double least = symmetric_eigenvalues(Numeric(part, pair.body1, pair.body2).K)[0];
    CHECK(least > mm * (1 - tolerance(1e-12, 1e-5)));
    // beside a wall the lever itself is that direction: a push along it turns nothing
    const Body wall = static_body(pair.body1.x, pair.body1.q);
    const Dense K = Numeric(part, wall, pair.body2).K;
    CHECK(symmetric_eigenvalues(K)[0] ==
          Approx(double(pair.body2.inverse_mass)).epsilon(tolerance(1e-12, 1e-5)));
  });
}

TEST_CASE("I2 K between two static bodies is exactly zero") {
  for_every_part([](const auto& part, const Pair& pair) {
    const Body wall = static_body(pair.body1.x, pair.body1.q);
    const Body rock = static_body(pair.body2.x, pair.body2.q);
    CHECK(Numeric(part, wall, rock).K.largest() == 0);
  });
}

TEST_CASE("I2 and I8 a pair that is turned and moved as one keeps its errors and its K") {
  for_every_part([](const auto& part, const Pair& pair) {
    Random random(12);
    Pair other = pair;
    move_together(other, random);
    const Numeric here(part, pair.body1, pair.body2), there(part, other.body1, other.body2);
    const double near = tolerance(1e-12, 1e-5);
    const dmat3 R = rotation_matrix(other.body1) * transpose(rotation_matrix(pair.body1));
    Dense turn = Dense::identity(here.C.size());
    for (int i = 0; i < 9 && turn.size() == 9; ++i) turn(i / 3, i % 3) = R[i % 3][i / 3];
    CHECK((there.C - turn * here.C).largest() < near);
    CHECK((there.K - turn * here.K * turn.transpose()).largest() <
          near * here.K.largest());
    CHECK((symmetric_eigenvalues(there.K) - symmetric_eigenvalues(here.K)).largest() <
          near * here.K.largest());
  });
}

TEST_CASE("I7 a row pushes one body as hard as it pushes the other the opposite way") {
  for_every_part([](const auto& part, const Pair& pair) {
    const Dense J = Numeric(part, pair.body1, pair.body2).J;
    CHECK((J.columns_from(0, 3) + J.columns_from(6, 3)).largest() == 0);
  });
}

TEST_CASE("I7 the moment of a row about the origin is the gap times the direction of the push") {
  // rods push along the gap itself, so nothing is left; a ball joint has u x e, zero only at C = 0
  for_every_part([](const auto& part, const Pair& pair) {
    const Numeric at(part, pair.body1, pair.body2);
    const dvec3 x1 = dvec3(pair.body1.x), x2 = dvec3(pair.body2.x);
    for (long i = 0; i < at.J.rows(); ++i) {
      const Column row = at.J.rows_from(i, 1).transpose();
      const dvec3 v1 = three(row), w1 = three(row, 3), v2 = three(row, 6), w2 = three(row, 9);
      dvec3 expected(0);
      if (at.C.size() == 3) expected = cross(three(at.C), dmat3(1)[int(i)]);
      const dvec3 moment = cross(x1, v1) + w1 + cross(x2, v2) + w2;
      CHECK(length(moment - expected) < tolerance(1e-14, 1e-5));
    }
  });
}

TEST_CASE("I28 a quaternion and its negative are the same orientation to every part") {
  for_every_part([](const auto& part, const Pair& pair) {
    const Numeric plain(part, pair.body1, pair.body2);
    for (int which = 1; which <= 3; ++which) {
      Body a = pair.body1, b = pair.body2;
      if (which & 1) a.q = -a.q;
      if (which & 2) b.q = -b.q;
      const Numeric turned(part, a, b);
      const double near = tolerance(1e-14, 1e-6);
      CHECK((turned.C - plain.C).largest() < near);
      CHECK((turned.J - plain.J).largest() < near);
      CHECK((turned.K - plain.K).largest() < near * plain.K.largest());
    }
  });
}

TEST_CASE("I27 where two points coincide a rod has no row and all its numbers are finite") {
  for_every_part([](const auto& part, const Pair& pair) {
    Pair together = pair;  // the two ends of the part in the same place, to the last bit
    auto touching = part;
    if constexpr (requires { touching.rod.anchor1_local; })
      touching.rod.anchor1_local = touching.rod.anchor2_local = vec3(0);
    if constexpr (requires { touching.anchor1_local; })
      touching.anchor1_local = touching.anchor2_local = vec3(0);
    together.body2.x = together.body1.x;
    const Numeric at(touching, together.body1, together.body2);
    CHECK(all_finite(at.J));
    CHECK(all_finite(at.K));
    CHECK(all_finite(at.C));
    if (at.C.size() == 1) CHECK(at.J.largest() == 0);
  });
}
