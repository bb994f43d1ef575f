// The forces that joints report, against statics: what hangs, what is held out, what a motor or a
// limit holds.
#include "engine/kept/reaction.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const double g = 9.81;
const double near = tolerance(1e-9, 2e-3);

enum class Kind { ball, hinge, weld, slider };

// Everything turned by one rotation: a frame in which a scene is built.
struct Frame {
  quat turn{1, 0, 0, 0};
  vec3 at(real x, real y, real z) const { return turn * vec3(x, y, z); }
};
const Frame frames[] = {{}, {rotation(vec3(real(0.7), real(-1.1), real(0.4)))}};

// Boxes of unlike masses in a row along `along` (of the frame), one metre each, the joints between
// them, the first joint at the wall. Gravity is -y of the frame.
struct Beam {
  World world;
  Frame frame;
  std::vector<BodyId> ids;
  std::vector<Joint*> joints;
  std::vector<double> masses;
  std::vector<vec3> anchors;

  Beam(const Frame& frame, const vec3& along, Kind kind, const std::vector<double>& masses)
      : frame(frame), masses(masses) {
    world.gravity = frame.turn * vec3(0, real(-g), 0);
    ids.push_back(world.add(static_body(vec3(0), frame.turn)));
    const vec3 way = frame.turn * along;
    for (std::size_t k = 0; k < masses.size(); ++k) {
      const vec3 anchor = real(k) * way;
      ids.push_back(world.add(box(real(masses[k]), vec3(real(0.9), real(0.8), real(0.7)),
                                  anchor + real(0.5) * way, frame.turn)));
      joints.push_back(add(kind, ids[k], ids[k + 1], anchor));
      anchors.push_back(anchor);
    }
  }
  Joint* add(Kind kind, BodyId a, BodyId b, const vec3& anchor) {
    const Bodies& bodies = world.bodies;
    const vec3 axis = frame.at(0, 0, 1);
    switch (kind) {
      case Kind::ball:
        return &world.add<BallJoint>(a, b, point_at(bodies[a], bodies[b], anchor));
      case Kind::hinge: return &world.add<HingeJoint>(a, b, anchor, axis);
      case Kind::slider: return &world.add<SliderJoint>(a, b, anchor, axis);
      case Kind::weld: return &world.add<FixedJoint>(a, b, anchor);
    }
    return nullptr;
  }
  double weight_from(std::size_t k) const {  // of all bodies from joint k on
    double sum = 0;
    for (; k < masses.size(); ++k) sum += masses[k] * g;
    return sum;
  }
};

double off(const vec3& a, const vec3& b, double size) { return double(length(a - b)) / size; }

}  // namespace

TEST_CASE("each joint of a hanging chain carries the weight of all that hangs below it") {
  for (const Frame& frame : frames)
    for (Kind kind : {Kind::ball, Kind::hinge, Kind::weld})
      for (bool warm : {false, true})
        for (real step_length : {h, h / 4}) {
          Beam chain(frame, vec3(0, -1, 0), kind, {3, 1, 2});
          SequentialImpulses solver;
          StepOptions stepping{.warm_start = warm};
          solver.iterations = 300;
          for (int n = 0; n < 40; ++n) step(chain.world, solver, step_length, stepping);
          for (std::size_t k = 0; k < 3; ++k) {
            CAPTURE(int(kind), warm, k);
            const Reaction load = reaction(*chain.joints[k], chain.world.bodies);
            const double weight = chain.weight_from(k);
            CHECK(off(load.force, frame.at(0, real(weight), 0), weight) < near);
            CHECK(double(length(load.torque)) / weight < near);
          }
        }
}

TEST_CASE("the wall of a cantilever bears n m g and n^2 m g L over 2") {
  for (const Frame& frame : frames)
    for (bool whole : {true, false})
      for (bool warm : {false, true}) {
        Beam beam(frame, vec3(1, 0, 0), Kind::weld, {2, 2, 2});
        for (Joint* joint : beam.joints) static_cast<FixedJoint*>(joint)->whole = whole;
        SequentialImpulses solver;
        StepOptions stepping{.warm_start = warm};
        solver.iterations = 3000;
        for (int n = 0; n < 5; ++n) step(beam.world, solver, h, stepping);
        for (std::size_t k = 0; k < 3; ++k) {
          CAPTURE(whole, warm, k);
          const Reaction load = static_cast<const FixedJoint*>(beam.joints[k])->load();
          const double n = double(3 - k), force = n * 2 * g, torque = n * n * 2 * g / 2;
          CHECK(off(load.force, frame.at(0, real(force), 0), force) < tolerance(1e-7, 2e-3));
          CHECK(off(load.torque, frame.at(0, 0, real(torque)), torque) < tolerance(1e-7, 2e-3));
        }
      }
}

TEST_CASE("a weld's load about its anchor and its reaction about the centre are one load") {
  for (const Frame& frame : frames) {
    Beam beam(frame, vec3(1, 0, 0), Kind::weld, {2, 3});
    SequentialImpulses solver;
    for (int n = 0; n < 10; ++n) step(beam.world, solver, h);
    for (std::size_t k = 0; k < 2; ++k) {
      const FixedJoint& weld = static_cast<const FixedJoint&>(*beam.joints[k]);
      const Body& body2 = beam.world.bodies[beam.ids[k + 1]];
      const vec3 anchor = world_point(body2, weld.weld.first.anchor2_local);
      const Reaction mine = about(weld.load(), anchor, body2.x);
      const Reaction seen = reaction(weld, beam.world.bodies);
      CHECK(off(mine.force, seen.force, 50) < tolerance(1e-12, 1e-5));
      CHECK(off(mine.torque, seen.torque, 50) < tolerance(1e-12, 1e-5));
    }
  }
}

TEST_CASE("a stalled motor pushes with its strength and the limit holds against it") {
  for (real strength : {real(0.5), real(40)})
    for (bool whole : {true, false})
      for (bool warm : {false, true})
        for (real step_length : {h, h / 4}) {
          Rotor rotor(real(0.5));
          rotor.hinge->whole = whole;
          rotor.stepping.warm_start = warm;
          rotor.hinge->set_motor(-9, strength);
          rotor.hinge->set_limits(0, 1);  // it stands at the lower one
          rotor.run(200, step_length);
          CHECK(double(rotor.hinge->motor_force() / strength) ==
                Approx(-1).epsilon(tolerance(1e-9, 1e-3)));
          CHECK(double(rotor.hinge->limit_force() / strength) ==
                Approx(1).epsilon(tolerance(1e-9, 1e-3)));
          const Reaction sum = reaction(*rotor.hinge, rotor.world.bodies);
          CHECK(double(length(sum.torque)) < tolerance(1e-9, 1e-3) * double(strength));
        }
}

TEST_CASE("a limit that holds a weight out gives m g r cos of the angle") {
  for (const Frame& frame : frames)
    for (double angle : {-20.0, -60.0, -100.0})
      for (bool whole : {true, false})
        for (bool warm : {false, true}) {
          CAPTURE(angle, whole, warm);
          Beam arm(frame, vec3(1, 0, 0), Kind::hinge, {4});
          HingeJoint& hinge = static_cast<HingeJoint&>(*arm.joints[0]);
          hinge.whole = whole;
          const bool beyond = angle < -90;  // past the lowest point it is held from the other side
          Body& body = arm.world.bodies[arm.ids[1]];
          const real phi = real(angle) * degree;
          body.q = normalize(rotation(phi * frame.at(0, 0, 1)) * body.q);
          body.x = frame.at(real(0.5) * std::cos(phi), real(0.5) * std::sin(phi), 0);
          hinge.set_limits(beyond ? -unbounded : phi, beyond ? phi : unbounded);
          SequentialImpulses solver;
          StepOptions stepping{.warm_start = warm};
          solver.iterations = 200;
          for (int n = 0; n < 100; ++n) step(arm.world, solver, h, stepping);
          const double torque = 4 * g * 0.5 * std::cos(angle * double(degree));
          CHECK(double(hinge.limit_force()) == Approx(torque).epsilon(tolerance(1e-7, 2e-3)));
          const Reaction load = reaction(hinge, arm.world.bodies);
          CHECK(off(load.force, frame.at(0, real(4 * g), 0), 4 * g) < tolerance(1e-7, 2e-3));
          const vec3 to_anchor = -body.x;  // about the centre of the body nothing is left over
          CHECK(double(length(load.torque)) < tolerance(1e-6, 5e-2));
          CHECK(double(dot(cross(to_anchor, load.force), frame.at(0, 0, 1))) ==
                Approx(-torque).epsilon(tolerance(1e-6, 5e-3)));
        }
}

TEST_CASE("the rigid rows of a slider carry what it is loaded with and its motor the rest") {
  // a box of 3 kg on a slider along z; gravity across, a weight along it that the motor holds
  for (const Frame& frame : frames)
    for (bool whole : {true, false}) {
      Beam one(frame, vec3(1, 0, 0), Kind::slider, {3});
      SliderJoint& slider = static_cast<SliderJoint&>(*one.joints[0]);
      slider.whole = whole;
      slider.set_motor(0, 100);
      one.world.bodies[one.ids[1]].force = frame.at(0, 0, -7);
      SequentialImpulses solver;
      solver.iterations = 200;
      for (int n = 0; n < 60; ++n) step(one.world, solver, h);
      CHECK(double(slider.motor_force()) == Approx(7).epsilon(tolerance(1e-7, 1e-3)));
      const Vector<5> rows = slider.forces();  // two of the line [N], three of the lock [N m]
      CHECK(std::hypot(double(rows[0]), double(rows[1])) ==
            Approx(3 * g).epsilon(tolerance(1e-7, 1e-3)));
      const vec3 moment(rows[2], rows[3], rows[4]);  // of the gravity, 0.5 m out
      const vec3 expected = frame.at(0, real(-7 * 0.5), real(3 * g * 0.5));
      CHECK(off(moment, expected, 3 * g) < tolerance(1e-7, 1e-3));
      const Reaction load = reaction(slider, one.world.bodies);
      CHECK(off(load.force, frame.at(0, real(3 * g), 7), 3 * g) < tolerance(1e-7, 1e-3));
    }
}

TEST_CASE("a frame that is turned as a whole turns all the forces with it") {
  const auto run = [](const Frame& frame, Kind kind) {
    Beam chain(frame, normalize(vec3(1, real(-0.5), real(0.3))), kind, {3, 1, 2});
    SequentialImpulses solver;
    for (int n = 0; n < 30; ++n) step(chain.world, solver, h);  // swinging
    std::vector<vec3> out;
    for (const Joint* joint : chain.joints) {
      const Reaction load = reaction(*joint, chain.world.bodies);
      out.push_back(conjugate(frame.turn) * load.force);
      out.push_back(conjugate(frame.turn) * load.torque);
    }
    return out;
  };
  for (Kind kind : {Kind::ball, Kind::hinge, Kind::weld, Kind::slider}) {
    const auto upright = run(frames[0], kind), turned = run(frames[1], kind);
    for (std::size_t k = 0; k < upright.size(); ++k)
      CHECK(off(turned[k], upright[k], 60) < tolerance(1e-10, 2e-3));
  }
}

TEST_CASE("before the first step every force is zero") {
  Beam welds({}, vec3(1, 0, 0), Kind::weld, {3}), hinges({}, vec3(1, 0, 0), Kind::hinge, {3});
  HingeJoint& hinge = static_cast<HingeJoint&>(*hinges.joints[0]);
  hinge.set_limits(0, 0);
  hinge.set_motor(3, 4);
  CHECK(double(hinge.motor_force()) == 0);
  CHECK(double(hinge.limit_force()) == 0);
  for (real force : hinge.forces()) CHECK(double(force) == 0);
  const Reaction load = static_cast<FixedJoint*>(welds.joints[0])->load();
  for (const Reaction& none : {load, reaction(hinge, hinges.world.bodies),
                               reaction(*welds.joints[0], welds.world.bodies)}) {
    CHECK(none.force == vec3(0));
    CHECK(none.torque == vec3(0));
  }
}

TEST_CASE("what a joint bears does not depend on the length of the step") {
  for (bool warm : {false, true}) {
    std::vector<double> torques;
    for (real step_length : {h, h / 2, h / 10}) {
      Beam beam({}, vec3(1, 0, 0), Kind::weld, {5});
      SequentialImpulses solver;
      StepOptions stepping{.warm_start = warm};
      for (int n = 0; n < 20; ++n) step(beam.world, solver, step_length, stepping);
      torques.push_back(double(static_cast<FixedJoint*>(beam.joints[0])->load().torque.z));
    }
    for (double torque : torques) CHECK(torque == Approx(5 * g * 0.5).epsilon(near));
  }
}
