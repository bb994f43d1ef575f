// The thesis' chain between two static ends (T 5.1, E44 and E45): what makes it hard, what it does
// when it is shot at, and the effect of slack.
#include "engine/instruments/rate.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const double link = 1.5;  // [m]

// Four cubes on ball joints, each joint at the centre of the cube before; the first and the last
// one do not move. Bent by an angle, the ends are nearer to each other: that is slack.
struct Between {
  World world;
  std::vector<BodyId> ids;
  std::vector<BallJoint*> joints;
  SequentialImpulses solver;
  StepOptions stepping{};

  explicit Between(double bend, real end_mass = 0) {
    const real x = real(link * std::cos(bend)), y = real(link * std::sin(bend));
    for (const vec3& at : {vec3(0), vec3(x, y, 0), vec3(2 * x, 0, 0), vec3(3 * x, 0, 0)}) {
      const bool end = ids.empty() || ids.size() == 3;
      const real mass = end ? end_mass : real(100);
      ids.push_back(world.add(mass > 0 ? box(mass, vec3(1), at) : static_body(at)));
    }
    for (std::size_t k = 1; k < 4; ++k)
      joints.push_back(&world.add<BallJoint>(
          ids[k - 1], ids[k],
          point_at(world.bodies[ids[k - 1]], world.bodies[ids[k]], world.bodies[ids[k - 1]].x)));
  }
  double gap() const {
    double largest = 0;
    for (const BallJoint* joint : joints)
      largest = std::max(largest, double(length(joint->part.error(world.bodies[joint->body1],
                                                                  world.bodies[joint->body2]))));
    return largest;
  }
  double speed() const {
    double largest = 0;
    for (BodyId id : ids) largest = std::max(largest, double(length(world.bodies[id].v)));
    return largest;
  }
  double rate() { return iteration_rate(world, rows_of(world)); }
  // The rows, as far as bodies can move.
  Dense rows() { return rows_of(world).J * inverse_masses(snapshot(world.bodies)); }
};

// Shot at once a second for ten seconds, then left alone for five.
struct Shot {
  double gap = 0, speed = 0, impulse = 0;  // largest ever
  double late_gap = 0, late_speed = 0;     // in the last second
  Shot(Between chain, real beta, int projections, unsigned seed) {
    Random random(seed);
    for (BallJoint* joint : chain.joints) joint->beta = beta;
    chain.stepping.projections = projections;
    for (int n = 0; n < 900; ++n) {
      if (n % 60 == 0 && n <= 600)
        for (const std::size_t k : {1, 2})
          chain.world.bodies[chain.ids[k]].v = real(20) * normalize(random.vector(1));
      step(chain.world, chain.solver, h, chain.stepping);
      REQUIRE(all_finite(chain.world));
      gap = std::max(gap, chain.gap());
      speed = std::max(speed, chain.speed());
      impulse = std::max(impulse, largest_impulse(chain.world));
      if (n < 840) continue;
      late_gap = std::max(late_gap, chain.gap());
      late_speed = std::max(late_speed, chain.speed());
    }
  }
};

}  // namespace

TEST_CASE("E45 stretched straight between its ends the chain has 9 rows of rank 8", "[E45]") {
  Between straight(0), bent(0.05);
  for (const auto& [chain, rank] : {std::pair{&straight, 8}, std::pair{&bent, 9}}) {
    const Dense rows = chain->rows();
    CHECK(rows.rows() == 9);
    CHECK(rank_of(rows, tolerance(1e-12, 1e-6)) == rank);
  }
}

TEST_CASE("E45 an iteration leaves all of one error when straight and 0.996 when bent a little",
          "[E45]") {
  CHECK(Between(0).rate() == Approx(1).epsilon(tolerance(1e-9, 1e-5)));
  CHECK(Between(0.05).rate() == Approx(0.99566).margin(tolerance(1e-5, 1e-4)));
  CHECK(Between(0.1).rate() == Approx(0.98279).margin(tolerance(1e-5, 1e-4)));
  CHECK(Between(0.3).rate() == Approx(0.8595).margin(tolerance(1e-4, 1e-3)));
}

TEST_CASE("E44 ends of 1e8 kg are swept as fast as static ones", "[E44]") {
  for (const double bend : {0.05, 0.3})
    CHECK(Between(bend, real(1e8)).rate() ==
          Approx(Between(bend).rate()).epsilon(tolerance(1e-5, 1e-4)));
}

TEST_CASE("E44 measured iteration by iteration static and heavy ends leave the same share",
          "[E44]") {
  const auto measured = [](real end_mass) {
    Between chain(0.3, end_mass);
    chain.world.gravity = vec3(0);
    chain.world.bodies[chain.ids[1]].v = vec3(3, 5, -8);
    return contraction_rate(chain.world, 1000);
  };
  const double rate = Between(0.3).rate();
  CHECK(measured(0) == Approx(rate).epsilon(1e-3));
  CHECK(measured(real(1e8)) == Approx(rate).epsilon(1e-3));
}

TEST_CASE("E44 a heavy body carried by a light one is what iterations are slow at", "[E44]") {
  // below a ceiling, joints at the centres, no levers: m2/(m1 + m2) whatever is static
  const auto rate = [](real upper, real lower) {
    World world;
    const BodyId ceiling = world.add(static_body(vec3(0)));
    const BodyId a = world.add(ball(upper, real(0.1), vec3(0, -1, 0)));
    const BodyId b = world.add(ball(lower, real(0.1), vec3(0, -2, 0)));
    world.add<CentreDistanceJoint>(ceiling, a, CentreDistance{1});
    world.add<CentreDistanceJoint>(a, b, CentreDistance{1});
    return iteration_rate(world, rows_of(world));
  };
  CHECK(rate(1, 100) == Approx(100.0 / 101).epsilon(tolerance(1e-9, 1e-5)));
  CHECK(rate(100, 1) == Approx(1.0 / 101).epsilon(tolerance(1e-9, 1e-4)));
}

TEST_CASE("X14 and E45 shot at again and again the chain stays finite and near its place",
          "[E45]") {
  for (const double bend : {0.0, 0.05, 0.3})
    for (const auto& [beta, projections] : {std::pair{0.15, 0}, {0.05, 0}, {0.0, 4}, {0.2, 1}})
      for (const unsigned seed : {1u, 2u, 3u}) {
        CAPTURE(bend, beta, projections, seed);
        const Shot shot(Between(bend), real(beta), projections, seed);
        CHECK(shot.gap < (projections > 0 ? 0.06 : 0.3));
        CHECK(shot.speed < 20);           // never faster than it was shot
        CHECK(shot.impulse < 10 * 2000);  // a shot is 2000 N s
      }
}

TEST_CASE("E45 seconds later the straight chain still shakes with feedback and not with projection",
          "[E45]") {
  double fed_back = 0;
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    fed_back += Shot(Between(0), real(0.15), 0, seed).late_speed / 6;
    CHECK(Shot(Between(0), 0, 4, seed).late_speed < 0.4);
  }
  CHECK(fed_back > 1.5);  // of a body with one legal place only
}

TEST_CASE("E45 with slack the gap that projection leaves under gravity is a fifth", "[E45]") {
  const Shot straight(Between(0), 0, 4, 1), slack(Between(0.3), 0, 4, 1);
  CHECK(straight.late_gap == Approx(6.4e-3).epsilon(0.05));
  CHECK(slack.late_gap < straight.late_gap / 5);
}
