// Two ways to correct positions whose velocities are taken back: relax iterations after the bodies
// have moved, and a split impulse.
#include "direct/direct_solver.h"
#include "engine/kept/reaction.h"
#include "tests/oracle/test.h"
#include "tests/oracle/track.h"

namespace {

const real h = real(1) / 60;

// The largest |J V| of a world's last step [unit of C per s].
double largest_rate(const World& world) {
  const System system = system_of(world.blocks, world.bodies.slots());
  return (system.J * velocities(snapshot(world.bodies))).largest();
}

double kinetic_energy(const Bodies& bodies) {
  double sum = 0;
  for (const Body& body : snapshot(bodies)) {
    if (body.is_static()) continue;
    const vec3 w = to_local(body, body.w), moments = real(1) / body.inverse_inertia_local;
    sum += double(dot(body.v, body.v) / body.inverse_mass + dot(w, moments * w)) / 2;
  }
  return sum;
}

// Two boxes that turn about a ball joint and have come apart.
struct Apart {
  World world;
  BodyId a, b;
  BallJoint* joint;
  explicit Apart(real speed) {
    world.gravity = vec3(0);
    a = world.add(box(2, vec3(1, real(0.2), real(0.5)), vec3(0)));
    b = world.add(box(3, vec3(real(0.3), 1, real(0.4)), vec3(1, real(0.2), 0)));
    joint = &world.add<BallJoint>(a, b, point_at(world.bodies[a], world.bodies[b],
                                                 vec3(real(0.5), real(0.3), real(0.1))));
    joint->beta = real(0.3);
    Random random(71);
    push_at_random(world.bodies, random, speed);
    world.bodies[b].x += vec3(real(0.05), real(-0.04), real(0.06));
  }
  double gap() const {
    return double(length(joint->part.error(world.bodies[a], world.bodies[b])));
  }
};

// A chain of cubes on ball joints that are torn, held by its first cube and pushed at random.
struct Torn {
  World world;
  std::vector<BallJoint*> joints;
  explicit Torn(int count, real beta = real(0.2), const vec3& gravity = vec3(0)) {
    world.gravity = gravity;
    Random random(72);
    BodyId before = world.add(static_body(vec3(0)));
    for (int k = 1; k <= count; ++k) {
      const BodyId next = world.add(box(real(1 + k % 3), vec3(real(0.4), real(0.6), real(0.5)),
                                        vec3(0, real(-k), 0), random.turn()));
      joints.push_back(&world.add<BallJoint>(
          before, next, point_at(world.bodies[before], world.bodies[next],
                                 vec3(0, real(0.5) - real(k), 0) + random.vector(real(0.1)))));
      joints.back()->beta = beta;
      before = next;
    }
    push_at_random(world.bodies, random, 1);
    for (int k = 1; k <= count; ++k) world.bodies.at(k).x += random.vector(real(0.02));
  }
  // Then w of a body does not depend on the pose to which it is moved.
  void make_isotropic() {
    for (Body& body : world.bodies) body.inverse_inertia_local = vec3(body.inverse_inertia_local.x);
  }
  double gap() const {
    double most = 0;
    for (const BallJoint* joint : joints)
      most = std::max(most, double(length(joint->part.error(world.bodies[joint->body1],
                                                            world.bodies[joint->body2]))));
    return most;
  }
};

}  // namespace

// ---- one joint ----------------------------------------------------------------------------------

TEST_CASE("a joint solved exactly closes by beta a step and leaves no velocity and no impulse") {
  for (TwoPassImpulses solver : {relaxing(), splitting(), relaxing(3), splitting(4)}) {
    const bool split = solver.split_iterations > 0;
    CAPTURE(split);
    Track track({0, real(1.1), real(2.4)}, {2, 5});  // the pair 1.3 m apart, 1 m wanted
    Along& joint = track.join(1, 2, 1);
    const double centre = 2 * track.x(1) + 5 * track.x(2);
    double C = track.x(2) - track.x(1) - 1;
    for (int n = 0; n < 20; ++n) {
      step(track.world, solver, h, {.warm_start = n % 2 == 1});
      C *= 0.8;
      CHECK(track.x(2) - track.x(1) - 1 == Approx(C).margin(tolerance(1e-14, 2e-6)));
      CHECK(std::abs(double(track.v(1))) <= (split ? 0 : tolerance(1e-14, 1e-5)));
      CHECK(std::abs(double(joint.impulse)) <= (split ? 0 : tolerance(1e-14, 1e-5)));
    }
    CHECK(std::abs(2 * track.x(1) + 5 * track.x(2) - centre) < tolerance(1e-13, 2e-5));
    CHECK(track.x(0) == 0);
  }
  Track track({0, real(1.1), real(2.4)}, {2, 5});  // fed back it parts with a velocity
  track.join(1, 2, 1);
  TwoPassImpulses solver = feeding_back();
  step(track.world, solver, h);
  CHECK(double(track.v(2) - track.v(1)) == Approx(-0.2 * 0.3 * 60));
}

TEST_CASE("a weld that is off by an angle turns back by beta and does not go on turning") {
  for (TwoPassImpulses solver : {relaxing(), splitting()}) {
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId id = world.add(body_with(2, vec3(real(0.5)), vec3(0)));
    world.add<FixedJoint>(wall, id, vec3(0)).beta = real(0.25);
    Body& body = world.bodies[id];
    body.q = rotation(vec3(0, real(0.01), 0));
    step(world, solver, h);
    CHECK(2 * double(body.q.y) == Approx(0.0075).epsilon(tolerance(1e-5, 1e-3)));
    CHECK(double(length(body.w)) < tolerance(1e-14, 1e-6));
    CHECK(double(length(body.v)) < tolerance(1e-14, 1e-6));
  }
}

TEST_CASE("a split impulse never raises the energy of a pair that it pulls together") {
  for (const real speed : {real(0), real(2)}) {
    Apart split(speed), fed(speed);
    TwoPassImpulses solver = splitting(), other = feeding_back();
    double before = kinetic_energy(split.world.bodies), first = 0, most = 0;
    const double gap = split.gap();
    for (int n = 0; n < 60; ++n) {
      step(split.world, solver, h);
      step(fed.world, other, h);
      const double now = kinetic_energy(split.world.bodies);
      CHECK(now <= before * (1 + tolerance(1e-12, 1e-5)));
      before = now;
      if (n == 0) first = now;
      most = std::max(most, kinetic_energy(fed.world.bodies));
    }
    CHECK(split.gap() < 0.2 * gap);
    CHECK(most > first + 0.1);  // fed back, it has been raised
    if (speed == 0) CHECK(before == 0);
  }
}

TEST_CASE("a joint that pulled off its lever is left without the spin that feedback leaves") {
  // chapter 6, Eq. 6-7: a gap at a slant to the lever leaves a spin about the free axis
  const auto spin = [](TwoPassImpulses solver) {
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId cube = world.add(box(100, vec3(1), vec3(2, 0, 0)));
    world.add<HingeJoint>(wall, cube, vec3(0), vec3(0, 0, 1));
    world.bodies[cube].x += vec3(real(0.2), real(0.2), 0);
    for (int n = 0; n < 120; ++n) step(world, solver, h);
    return std::abs(double(world.bodies[cube].w.z));
  };
  CHECK(spin(feeding_back()) > 5e-3);
  CHECK(spin(splitting()) == 0);
  CHECK(spin(relaxing()) < tolerance(1e-12, 1e-5));
}

// ---- many joints --------------------------------------------------------------------------------

TEST_CASE("after the relax iterations J V is zero as well as their number can make it") {
  // with the same J, an iteration of block Gauss-Seidel leaves rho of the error in the long run
  const auto left = [](int relax_iterations) {
    Torn torn(6);
    torn.make_isotropic();
    TwoPassImpulses solver = relaxing(relax_iterations, 200);
    step(torn.world, solver, h);
    return largest_rate(torn.world);
  };
  const double none = left(0);
  CHECK(none > 0.1);  // the bias is all in there
  double before = none;
  for (const int iterations : {10, 40, 160}) {
    const double now = left(iterations);
    CHECK(now < before);
    before = now;
  }
  CHECK(left(2000) < tolerance(1e-12, 1e-5));
}

TEST_CASE("an iteration leaves the first of two joints in a row m2 / (m1 + m2) of its rate") {
  for (const int iterations : {1, 2, 3, 7}) {
    Track track({0, real(1.2), real(2.2)}, {1, 3});  // the first one is 0.2 m too long
    track.join(0, 1, 1);
    track.join(1, 2, 1);
    TwoPassImpulses solver = relaxing(iterations, 500);
    step(track.world, solver, h);
    CHECK(double(track.v(1)) == Approx(-0.2 * 0.2 * 60 * std::pow(0.75, iterations)));
    CHECK(std::abs(double(track.v(2) - track.v(1))) < tolerance(1e-12, 1e-5));
    Track split({0, real(1.2), real(2.2)}, {1, 3});
    split.join(0, 1, 1);
    split.join(1, 2, 1);
    solver = splitting(iterations, 500);
    step(split.world, solver, h);
    CHECK(double(split.x(1)) == Approx(1.2 - 0.2 * 0.2 * (1 - std::pow(0.75, iterations))));
  }
}

TEST_CASE("relax iterations come after the bodies have moved and go on with the same impulses") {
  Torn relaxed(6), fed(6);
  TwoPassImpulses solver = relaxing(2000, 300), other = feeding_back(300);
  step(relaxed.world, solver, h);
  step(fed.world, other, h);
  for (int slot = 0; slot < fed.world.bodies.slots(); ++slot) {  // moved alike, and so further
    CHECK(relaxed.world.bodies.at(slot).x == fed.world.bodies.at(slot).x);
    CHECK(relaxed.world.bodies.at(slot).q == fed.world.bodies.at(slot).q);
  }
  // the sums are those of a step without any feedback: the pushes of the bias are taken back
  Torn plain(6, 0);
  TwoPassImpulses without = feeding_back(2000);
  step(plain.world, without, h);
  for (std::size_t k = 0; k < plain.joints.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(double(relaxed.joints[k]->impulse()[i]) ==
            Approx(double(plain.joints[k]->impulse()[i])).margin(tolerance(1e-11, 1e-4)));
  // and so are the momenta; the bodies have been rotated further, so their w is another one
  for (int slot = 1; slot < plain.world.bodies.slots(); ++slot) {
    const Body &one = relaxed.world.bodies.at(slot), &other = plain.world.bodies.at(slot);
    CHECK(double(length(one.v - other.v)) < tolerance(1e-11, 1e-4));
    CHECK(double(length(angular_momentum(one) - angular_momentum(other))) <
          tolerance(1e-11, 1e-4));
  }
}

TEST_CASE("a split impulse changes no velocity and no impulse of a step without feedback") {
  Torn split(6, real(0.2), vec3(0, real(-9.81), 0)), plain(6, 0, vec3(0, real(-9.81), 0));
  TwoPassImpulses solver = splitting(7, 4), other = feeding_back(4);
  step(split.world, solver, h, {.warm_start = true});
  step(plain.world, other, h, {.warm_start = true});
  CHECK(velocities(snapshot(split.world.bodies)) == velocities(snapshot(plain.world.bodies)));
  for (std::size_t k = 0; k < plain.joints.size(); ++k)
    CHECK(split.joints[k]->impulse() == plain.joints[k]->impulse());
  CHECK(split.gap() < plain.gap());
  Torn fewer(6, real(0.2), vec3(0, real(-9.81), 0));  // the count is that of the split impulse
  TwoPassImpulses one = splitting(1, 4);
  step(fewer.world, one, h, {.warm_start = true});
  CHECK(split.gap() < fewer.gap());
}

TEST_CASE("row by row both come to the same places and velocities as block by block") {
  for (const TwoPassImpulses& kind : {relaxing(3000, 3000), splitting(3000, 3000)}) {
    Torn blocks(4), rows(4);
    for (Torn* torn : {&blocks, &rows}) torn->make_isotropic();
    TwoPassImpulses solver = kind, by_rows = kind;
    for (StepOptions how : {StepOptions{}, StepOptions{.frequency = 5}}) {
      step(blocks.world, solver, h, how);
      how.row_by_row = true;
      step(rows.world, by_rows, h, how);
      CHECK(difference(velocities(snapshot(rows.world.bodies)),
                       velocities(snapshot(blocks.world.bodies))) < tolerance(1e-9, 2e-3));
      if (how.frequency > 0) continue;  // a block is as soft in every direction, its rows are not
      for (int slot = 0; slot < rows.world.bodies.slots(); ++slot)
        CHECK(double(length(rows.world.bodies.at(slot).x - blocks.world.bodies.at(slot).x)) <
              tolerance(1e-10, 1e-4));
    }
  }
}

TEST_CASE("over-relaxed iterations settle both where plain ones do") {
  for (const TwoPassImpulses& kind : {relaxing(2000, 2000), splitting(2000, 2000)}) {
    Torn plain(4), over(4);
    TwoPassImpulses solver = kind, other = kind;
    other.relaxation = real(1.4);
    for (const StepOptions& how : {StepOptions{}, StepOptions{.frequency = 5}}) {
      step(plain.world, solver, h, how);
      step(over.world, other, h, how);
      CHECK(difference(velocities(snapshot(over.world.bodies)),
                       velocities(snapshot(plain.world.bodies))) < tolerance(1e-9, 2e-3));
      for (int slot = 0; slot < over.world.bodies.slots(); ++slot)
        CHECK(double(length(over.world.bodies.at(slot).x - plain.world.bodies.at(slot).x)) <
              tolerance(1e-10, 1e-4));
    }
  }
}

TEST_CASE("where a direct solver has to iterate, a split impulse or relax iterations correct") {
  for (const TwoPassImpulses& kind : {relaxing(), splitting()}) {
    Track track({0, real(1.1)}, {1});
    track.join(0, 1, 1);
    DirectSolver solver = DirectSolver::velocities_only();
    solver.fallback = kind;
    for (const bool iterated : {false, true}) {
      solver.most_work = iterated ? 0 : 3000;
      track.world.bodies[track.ids[1]].x.x = real(1.1);
      track.v(1) = 0;
      step(track.world, solver, h);
      CHECK(solver.report().iterated == iterated);
      CHECK(track.x(1) == Approx(1.08).epsilon(tolerance(1e-12, 1e-6)));
      CHECK(double(track.v(1)) == Approx(iterated ? 0 : -1.2).margin(tolerance(1e-12, 1e-5)));
    }
  }
}

// ---- the warm start -----------------------------------------------------------------------------

namespace {

// Ten cubes that hang plumb, the first joint torn by 2 cm: what the warm chain is like after 10 s.
struct Hung {
  World world;
  std::vector<BallJoint*> joints;
  Hung() {
    BodyId above = world.add(static_body(vec3(0)));
    for (int k = 1; k <= 10; ++k) {
      const BodyId next = world.add(box(1, vec3(real(0.4)), vec3(0, real(-k), 0)));
      joints.push_back(&world.add<BallJoint>(
          above, next, point_at(world.bodies[above], world.bodies[next],
                                vec3(0, real(0.5) - real(k), 0))));
      joints.back()->beta = real(0.15);
      above = next;
    }
    for (int k = 1; k <= 10; ++k) world.bodies.at(k).x.y -= real(0.02);
  }
};

}  // namespace

TEST_CASE("a warm start begins with the weights and not with the correction") {
  for (TwoPassImpulses solver : {splitting(4, 4), relaxing(4, 4)}) {
    CAPTURE(solver.split_iterations);
    Hung hung;
    for (int n = 0; n < 900; ++n) step(hung.world, solver, h, {.warm_start = true});
    // fed back, four iterations would shake this chain to pieces: rho^4 1.15 = 1.04 (Eq. 6-9)
    for (int k = 0; k < 10; ++k) {
      CHECK(double(hung.joints[std::size_t(k)]->impulse()[1]) ==
            Approx((10 - k) * 9.81 / 60).epsilon(tolerance(1e-5, 1e-2)));
      CHECK(double(hung.world.bodies.at(k + 1).x.y) == Approx(-(k + 1)).margin(1e-4));
    }
  }
}

TEST_CASE("what a weld bears is its load, however far it has been pulled off") {
  for (const bool split : {true, false}) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId id = world.add(box(3, vec3(1), vec3(0, -1, 0)));
    auto& weld = world.add<FixedJoint>(wall, id, vec3(0));
    world.bodies[id].x.y -= real(0.05);
    TwoPassImpulses solver = split ? splitting() : relaxing();
    step(world, solver, h);
    const Reaction load = reaction(weld, world.bodies);
    CHECK(double(load.force.y) == Approx(3 * 9.81).epsilon(tolerance(1e-12, 1e-5)));
    CHECK(double(world.bodies[id].x.y) == Approx(-1.04).epsilon(tolerance(1e-12, 1e-6)));
    CHECK(!breaks(load, {.force = 30}));
  }
}
