// Warm starting: what the joints remember of the last step, and what it is worth in the next.
#include "chapters/01_distance/distance_joint.h"
#include "chapters/02_ball/ball_joint.h"
#include "tests/catch.h"
#include "tests/own/oracle.h"

using namespace joints;
using namespace joints::testing;

namespace {

const real h = real(1) / 60;

// Masses that hang plumb from a ceiling, one below the other, on ball joints midway.
struct Hanging {
  World world;
  std::vector<BodyId> ids;
  std::vector<BallJoint*> joints;

  explicit Hanging(const std::vector<real>& masses) {
    ids.push_back(world.add(static_body(vec3(0))));
    for (real mass : masses) {
      const real y = -real(ids.size());
      ids.push_back(world.add(box(mass, vec3(real(0.4)), vec3(0, y, 0))));
      const BodyId above = ids[ids.size() - 2];
      joints.push_back(&world.add<BallJoint>(
          above, ids.back(),
          point_at(world.bodies[above], world.bodies[ids.back()], vec3(0, y + real(0.5), 0))));
    }
  }
  // How far the lowest body has sunk [m].
  double sag() const { return -double(ids.size() - 1) - double(world.bodies[ids.back()].x.y); }
};

}  // namespace

TEST_CASE("I23 a joint that carries 3 kg pulls with 29.43 N after ten warm steps") {
  Hanging hanging({3});
  SequentialImpulses solver;
  solver.warm_start = true;
  for (int step = 0; step < 10; ++step) solver.step(hanging.world, h);
  CHECK(double(hanging.joints[0]->impulse()[1] / h) ==
        Approx(29.43).epsilon(tolerance(1e-9, 1e-5)));
  CHECK(std::abs(hanging.sag()) < tolerance(1e-12, 1e-6));
}

TEST_CASE("I23 warm joints of a chain come to pull as much as hangs from them") {
  Hanging hanging({3, 2, 1});
  SequentialImpulses solver;
  solver.warm_start = true;
  solver.iterations = 2;
  for (int step = 0; step < 2000; ++step) solver.step(hanging.world, h);
  const double weight[] = {6 * 9.81, 3 * 9.81, 9.81};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(double(hanging.joints[k]->impulse()[1] / h) ==
          Approx(weight[k]).epsilon(tolerance(1e-9, 1e-4)));
    CHECK(std::abs(double(hanging.joints[k]->impulse()[0])) < tolerance(1e-9, 1e-4));
  }
  CHECK(std::abs(hanging.sag()) < tolerance(1e-9, 2e-5));
}

TEST_CASE("I26 a cold chain that is swept too little sags by what the formula says") {
  // C = h^2/beta (I - H)^-1 H J g, H = A G^k A^-1, G what a sweep leaves of an error in lambda
  const int sweeps = 10;
  const double m1 = 1, m2 = 9, t = double(h), beta = 0.2;
  Eigen::Matrix2d A, lower;
  A << 1 / m1, -1 / m1, -1 / m1, 1 / m1 + 1 / m2;
  lower << A(0, 0), 0, A(1, 0), A(1, 1);
  const Eigen::Matrix2d E = Eigen::Matrix2d::Identity(), G = E - lower.inverse() * A;
  Eigen::Matrix2d H = A;
  for (int k = 0; k < sweeps; ++k) H = H * G;
  H = (H * A.inverse()).eval();
  const Eigen::Vector2d Jg(9.81, 0);  // the upper joint sees its body fall, the lower one nothing
  const double expected = t * t / beta * ((E - H).inverse() * (H * Jg)).sum();

  Hanging hanging({real(m1), real(m2)});
  SequentialImpulses solver;
  solver.iterations = sweeps;
  const auto sag_after_a_minute = [&](bool warm) {
    solver.warm_start = warm;
    for (int step = 0; step < 3600; ++step) solver.step(hanging.world, h);
    return hanging.sag();
  };
  CHECK(expected == Approx(7.3e-3).epsilon(0.5));
  CHECK(sag_after_a_minute(false) == Approx(expected).epsilon(tolerance(1e-9, 1e-3)));
  CHECK(std::abs(sag_after_a_minute(true)) < tolerance(1e-9, 2e-5));  // warm: none at all
  CHECK(sag_after_a_minute(false) == Approx(expected).epsilon(tolerance(1e-9, 1e-3)));
}

TEST_CASE("when the step changes the remembered impulses change with it") {
  // at rest every force stays the same, so an impulse is force times step; taken over unchanged it
  // would kick the chain with g (h_old - h_new)
  Hanging hanging({3, 2, 1});
  SequentialImpulses solver;
  solver.warm_start = true;
  solver.iterations = 2;
  for (int step = 0; step < 2000; ++step) solver.step(hanging.world, h);
  solver.iterations = 1;  // no sweeps to mend it with
  for (real step : {h / 2, h * 2, h / 5, h}) {
    solver.step(hanging.world, step);
    const double kick = 9.81 * std::abs(double(h - step)) + 0.01;
    for (std::size_t k = 1; k <= 3; ++k)
      CHECK(std::abs(double(hanging.world.bodies[hanging.ids[k]].v.y)) <
            tolerance(1e-8, 1e-3) * kick);
    CHECK(double(hanging.joints[0]->impulse()[1]) ==
          Approx(6 * 9.81 * double(step)).epsilon(tolerance(1e-8, 1e-3)));
  }
}

TEST_CASE("I15 warm starting with feedback is stable where rho^k (1 + beta) is below 1 only") {
  // ten equal masses: rho = cos^2(pi/20) = 0.97553, so 10 sweeps of beta 0.15 give 0.898 and 4 give
  // 1.04: one chain hangs still, the other shakes itself to pieces
  const auto sag_after = [](int sweeps, int steps) {
    Hanging hanging(std::vector<real>(10, real(1)));
    for (BallJoint* joint : hanging.joints) joint->beta = real(0.15);
    SequentialImpulses solver;
    solver.warm_start = true;
    solver.iterations = sweeps;
    double largest = 0;
    for (int step = 0; step < steps; ++step) {
      solver.step(hanging.world, h);
      if (step > steps - 60) largest = std::max(largest, std::abs(hanging.sag()));
    }
    return largest;
  };
  CHECK(sag_after(10, 600) < tolerance(1e-8, 1e-4));
  const double early = sag_after(4, 200), late = sag_after(4, 300);
  CHECK(early > 0.05);
  CHECK(late / early > 2);
}
