// Over-relaxation in the engine's solvers: a factor of every impulse that changes how fast the
// iterations settle, and neither where they settle nor what bounds allow.
#include "engine/simd/packed.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A chain of hinges, a slider, a soft row and a motor that all pull at each other.
struct Machine {
  World world;
  HingeJoint* motor = nullptr;
  SliderJoint* slider = nullptr;
  Machine() {
    Random random(61);
    BodyId before = world.add(static_body(vec3(0)));
    for (int k = 1; k <= 6; ++k) {
      const vec3 x(real(k), 0, 0), anchor = x - vec3(real(0.5), 0, 0);
      Body body = box(real(1 + k % 2), vec3(real(0.8), real(0.5), real(0.3)), x, random.turn());
      body.v = random.vector(1);
      body.w = random.vector(1);
      const BodyId id = world.add(body);
      if (k == 4) {
        slider = &world.add<SliderJoint>(before, id, anchor, vec3(1, 1, 0));
        slider->set_limits(real(0.01), 1);
      } else {
        HingeJoint& hinge =
            world.add<HingeJoint>(before, id, anchor, vec3(0, real(k % 2), 1));
        if (k == 1) motor = &hinge;
      }
      before = id;
    }
    motor->set_motor(3, 2);
    auto& soft = world.add<AnyJoint<1>>(motor->body1, before);
    soft.J[0] = {vec3(0, -1, 0), vec3(0), vec3(0, 1, 0), vec3(0)};
    soft.C[0] = real(0.02);
    soft.target = {.frequency = 3, .damping = real(0.5)};
  }
};

template <class Kind>
Column settled(real relaxation, int iterations, Kind solver) {
  Machine machine;
  solver.relaxation = relaxation;
  solver.iterations = iterations;
  step(machine.world, solver, h);
  return velocities(snapshot(machine.world.bodies));
}

}  // namespace

TEST_CASE("a relaxed solve of one block is omega times the exact one") {
  const auto impulse = [](real relaxation, const RowSettings& target) {
    World world = weightless();
    const Pair pair = uneven_pair();
    const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
    auto& joint = world.add<AnyJoint<3>>(a, b);
    Random random(62);
    for (Row& row : joint.J.row) row = random_row(random);
    for (real& error : joint.C) error = random.uniform(-1, 1);
    joint.target = target;
    SequentialImpulses scalar;
    scalar.iterations = 1;
    scalar.relaxation = relaxation;
    begin_step(world, scalar, h);
    scalar.solve(world.bodies);
    return joint.impulse;
  };
  for (const RowSettings& target : {RowSettings{.beta = real(0.2)}, RowSettings{.frequency = 4}}) {
    const Vector<3> exact = impulse(1, target), eighth = impulse(real(0.125), target);
    const Vector<3> half = impulse(real(0.5), target), more = impulse(real(1.7), target);
    for (int i = 0; i < 3; ++i) {
      CHECK(exact[i] != 0);
      CHECK(eighth[i] == exact[i] / 8);  // to the last bit: only the exponent changes
      CHECK(half[i] == exact[i] / 2);
      CHECK(double(more[i]) == Approx(1.7 * double(exact[i])).epsilon(tolerance(1e-12, 1e-5)));
    }
  }
}

TEST_CASE("relaxation 1 finds what a solver without relaxation finds") {
  const auto chain = [] {
    World world;
    Random random(63);
    BodyId before = world.add(static_body(vec3(0)));
    for (int k = 1; k <= 5; ++k) {
      const vec3 x(real(k), 0, 0), uneven(real(0.8), real(0.5), real(0.3));
      const BodyId id = world.add(box(real(1 + k % 2), uneven, x, random.turn()));
      auto& tie = world.add<AnyJoint<3>>(before, id);
      tie.J = to_jacobian(point_at(world.bodies[before], world.bodies[id], x - vec3(real(0.5)))
                              .jacobian(world.bodies[before], world.bodies[id]));
      if (k % 2 == 0) tie.target = {.frequency = 5, .damping = real(0.4)};
      before = id;
    }
    return world;
  };
  World by_engine = chain(), by_hand = chain();
  SequentialImpulses solver;
  solver.relaxation = 1;
  begin_step(by_engine, solver, h);
  SequentialImpulses unused;
  begin_step(by_hand, unused, h);
  const Blocks& blocks = by_hand.blocks;
  for (int iteration = 0; iteration < 30; ++iteration) {
    solver.iterate(by_engine.bodies);
    for (const Block& block : blocks.list) {  // the same sums, no factor
      Body &body1 = by_hand.bodies.at(block.body1), &body2 = by_hand.bodies.at(block.body2);
      const Row* const J = &blocks.J[std::size_t(block.first)];
      real K[9], e[3];
      Row response[3];
      form_responses(J, 3, body1, body2, response);
      form_K(J, response, 3, K);
      invert_symmetric(K, 3);
      real share = 1, kept = 0;
      if (block.settings.frequency > 0) {
        const real omega = 2 * std::numbers::pi_v<real> * block.settings.frequency;
        const real a2 = h * omega * (2 * block.settings.damping + h * omega);
        share = 1 / (1 + 1 / a2);
        kept = 1 / a2 / (1 + 1 / a2);
      }
      for (int i = 0; i < 3; ++i) {  // C and so the bias is zero
        e[i] = dot(J[i].v1, body1.v) + dot(J[i].v2, body2.v);
        e[i] += dot(J[i].w1, body1.w) + dot(J[i].w2, body2.w);
      }
      vec3 push1(0), push2(0), turn1(0), turn2(0);
      for (int i = 0; i < 3; ++i) {
        const real sum = K[3 * i] * e[0] + K[3 * i + 1] * e[1] + K[3 * i + 2] * e[2];
        const real dlambda = -share * sum - kept * block.impulse[i];
        block.impulse[i] += dlambda;
        push1 += dlambda * J[i].v1, push2 += dlambda * J[i].v2;
        turn1 += dlambda * (inverse_inertia(body1) * J[i].w1);
        turn2 += dlambda * (inverse_inertia(body2) * J[i].w2);
      }
      body1.v += body1.inverse_mass * push1, body2.v += body2.inverse_mass * push2;
      body1.w += turn1, body2.w += turn2;
    }
  }
  for (int slot = 0; slot < by_hand.bodies.slots(); ++slot) {
    const Body &one = by_engine.bodies.at(slot), &other = by_hand.bodies.at(slot);
    CHECK(double(length(one.v - other.v)) < tolerance(1e-13, 1e-5));
    CHECK(double(length(one.w - other.w)) < tolerance(1e-13, 1e-5));
  }
  CHECK(length(by_hand.bodies.at(5).w) > 0);
}

TEST_CASE("relaxed impulses stay within the strength of a motor and a limit only pushes") {
  const auto check = [](auto solver, double slack, real speed) {
    for (const real relaxation : {real(0.5), real(1.5), real(1.9)}) {
      Machine machine;
      const SliderJoint* const slider = machine.slider;
      machine.motor->set_motor(speed, 2);
      solver.relaxation = relaxation;
      double most = 0, most_pushed = 0;
      for (int n = 0; n < 30; ++n) {
        step(machine.world, solver, h);
        most = std::max(most, std::abs(double(machine.motor->motor_force())));
        CHECK(double(slider->limit_force()) > -slack);
        most_pushed = std::max(most_pushed, double(slider->limit_force()));
      }
      CHECK(most == Approx(2).epsilon(slack));  // it wants more, and gets all it may have
      CHECK(most_pushed > 1);
    }
  };
  const double last_digit = 4 * double(epsilon);
  for (const real speed : {real(3), real(1e6)}) {
    check(SequentialImpulses(), last_digit, speed);
    for (const Packing packing : {Packing::automatic, Packing::colours, Packing::interleaved}) {
      PackedImpulses wide;
      wide.packing = packing;
      check(wide, last_digit, speed);
    }
  }
}

TEST_CASE("relaxed iterations settle where plain iterations do") {
  const Column plain = settled(1, 1000, SequentialImpulses());
  for (const real relaxation : {real(0.5), real(1.3), real(1.8)}) {
    const int iterations = relaxation < 1 ? 3000 : 1000;  // below 1 a third of the way each time
    CHECK(difference(settled(relaxation, iterations, SequentialImpulses()), plain) <
          tolerance(1e-9, 1e-3));
    for (const Packing packing : {Packing::automatic, Packing::colours, Packing::list}) {
      PackedImpulses wide;
      wide.packing = packing;
      CHECK(difference(settled(relaxation, iterations, wide), plain) < tolerance(1e-9, 1e-3));
    }
  }
  // and after a few iterations they have not settled: the test can tell
  CHECK(difference(settled(1, 3, SequentialImpulses()), plain) > 1e-3);
}
