// Chapter 10's program: a universal joint measured over a turn, a gear over ten thousand turns, a
// screw under load, a cone that is hit from its axis in every direction, and the reader's own part.
// Read it; there is nothing to edit here.
#include <algorithm>
#include <cstdio>
#include <numbers>

#include "chapters/10_own/program/machine.h"
#include "engine/instruments/options.h"
#include "joints/driven_joints.h"
#include "joints/rack_joint.h"

using namespace joints;
using namespace joints::chapter10;

namespace {

constexpr double degree = std::numbers::pi / 180;

// ---- a universal joint --------------------------------------------------------------------------

// Two shafts that meet at an angle: the ratio of their speeds at angles of the first one over a
// turn, measured in one solve at each pose, and by formula. The cross is placed by geometry.
void universal(const Settings& settings, CsvFile& table) {
  for (const int b : {15, 30, 45, 60})
    for (int a = 0; a <= 360; a += 5) {
      const real bend = real(b * degree), turn = real(a * degree);
      const vec3 along1(1, 0, 0), along2(std::cos(bend), 0, std::sin(bend));
      const vec3 pin1 = rotation(turn * along1) * vec3(0, 1, 0);
      World world;
      world.gravity = vec3(0);
      const BodyId wall = world.add(static_body(vec3(0)));
      const BodyId first = world.add(box(4, vec3(1, real(0.2), real(0.2)), -along1));
      const BodyId second = world.add(box(4, vec3(1, real(0.2), real(0.2)), along2,
                                          rotation(vec3(0, -bend, 0))));
      auto& drive = world.add<HingeJoint>(wall, first, -along1, along1);
      auto& driven = world.add<HingeJoint>(wall, second, along2, along2);
      world.add<UniversalJoint>(first, second, vec3(0), pin1, cross(along2, pin1));
      drive.set_motor(1, 1e6);
      SequentialImpulses solver;
      solver.iterations = 100 * settings.iterations;
      begin_step(world, solver, real(1) / 60);
      solver.solve(world.bodies);
      const double sine = std::sin(double(bend)) * std::sin(double(turn));
      table.row({double(b), double(a),
                 double(driven.speed(world.bodies) / drive.speed(world.bodies)),
                 std::cos(double(bend)) / (1 - sine * sine)});
    }
}

// The machine at work: the shafts' speeds, the wheel's angle, the nut's travel.
Summary machine(const Settings& settings) {
  Machine machine(settings, real(30 * degree), 4);
  machine.scene.print_plan();
  CsvFile table(settings.out + "/machine.csv",
                {"time_s", "first_rad_s", "second_rad_s", "wheel_rad", "nut_m"});
  const Bodies& bodies = machine.scene.world.bodies;
  double travel = 0;
  Summary line = play(machine.scene, "", settings.seconds, settings.out + "/machine.motion.json",
                      [&](double time) {
                        travel = double(machine.rail->position(bodies));
                        table.row({time, double(machine.drive->speed(bodies)),
                                   double(machine.driven->speed(bodies)),
                                   double(machine.axle->position(bodies)), travel});
                      });
  char setting[60];
  std::snprintf(setting, sizeof setting, "the nut has moved %.3f m", travel);
  line.setting = setting;
  return line;
}

// ---- a gear -------------------------------------------------------------------------------------

// A gear whose angles stay within half a turn, as atan2 gives them.
struct Folded : Gear {
  void count(const Body&, const Body&, real) { angle1.expected = angle2.expected = 0; }
};

// Two wheels on their axles, the first with a motor: how far the second is from where it should be,
// in degrees, after every turn. Without a count it jumps as soon as an angle passes half a turn.
template <class Kind>
double gear(const std::string& name, int turns, real ratio, CsvFile& table) {
  const real rate = 40, h = real(1) / 60;
  World world;
  world.gravity = vec3(0);
  const BodyId wall = world.add(static_body(vec3(0)));
  const vec3 axle1(0, 0, 1), axle2 = normalize(vec3(0, 1, 1));
  const BodyId one = world.add(box(2, vec3(1, 1, real(0.2)), vec3(0)));
  const BodyId two = world.add(box(1, vec3(real(0.6), real(0.6), real(0.2)), vec3(1, 0, 0)));
  auto& first = world.add<HingeJoint>(wall, one, vec3(0), axle1);
  auto& second = world.add<HingeJoint>(wall, two, vec3(1, 0, 0), axle2);
  Kind part;
  static_cast<Gear&>(part) = gear_on(world.bodies[one], axle1, world.bodies[two], axle2, ratio);
  world.add<CountingJoint<Kind>>(one, two, part);
  first.set_motor(rate, 1000);
  second.set_motor(0, real(1e-9));  // counts its turns
  SequentialImpulses solver;
  solver.iterations = 100;
  double worst = 0;
  const int steps = int(turns * 2 * std::numbers::pi / double(rate * h));
  for (int n = 0; n < steps; ++n) {
    step(world, solver, h);
    const double off = double(second.position(world.bodies) -
                              ratio * first.position(world.bodies)) / degree;
    worst = std::max(worst, std::abs(off));
    if (n < 60) table.row({name}, {double(first.position(world.bodies)) / 2 / std::numbers::pi,
                                   off});
  }
  return worst;
}

// ---- a cone -------------------------------------------------------------------------------------

// A cone without a direction at swing 0.
struct Blind : Cone {
  Row jacobian(const Body& body1, const Body& body2) const {
    const vec3 n = cross(to_world(body1, a1_local), to_world(body2, a2_local));
    return length(n) < real(1e-6) ? Row{} : Cone::jacobian(body1, body2);
  }
};

// An arm held by a ball joint starts along the axis of a cone of 45 degrees at 100 rad/s, in one of
// 36 directions: its greatest swing in half a second [degrees].
template <class Kind, class Made = PartJoint<Kind>>
double greatest_swing(double direction) {
  World world;
  world.gravity = vec3(0);
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId arm = world.add(box(3, vec3(real(0.8), real(0.2), real(0.15)),
                                   vec3(real(0.4), 0, 0)));
  Bodies& bodies = world.bodies;
  world.add<BallJoint>(wall, arm, vec3(0));
  Kind cone;
  static_cast<Cone&>(cone) = cone_about(bodies[wall], bodies[arm], vec3(1, 0, 0),
                                        real(45 * degree));
  world.add<Made>(wall, arm, cone);
  bodies[arm].w = real(100) * vec3(0, std::cos(direction), std::sin(direction));
  bodies[arm].v = cross(bodies[arm].w, bodies[arm].x);
  SequentialImpulses solver;
  solver.iterations = 100;
  double most = 0;
  for (int n = 0; n < 30; ++n) {
    step(world, solver, real(1) / 60);
    most = std::max(most, 45 - double(cone.error(bodies[wall], bodies[arm])) / degree);
  }
  return most;
}

// ---- a screw and a pulley at rest ---------------------------------------------------------------

// A nut of 2 kg on a vertical screw that a motor holds, and a body of 3 kg on a rope over two
// pulleys, balanced by one of 1.5 kg on the fast side: the torque of the motor and the force of the
// rope, beside statics.
void loads(const Settings& settings) {
  CsvFile table(settings.out + "/loads.csv", {"what", "measured", "statics"});
  const real lead = real(0.02);
  World screw;
  const BodyId wall = screw.add(static_body(vec3(0)));
  const vec3 up(0, 1, 0);
  const BodyId spindle = screw.add(box(5, vec3(real(0.1), 1, real(0.1)), vec3(0)));
  const BodyId nut = screw.add(box(2, vec3(real(0.2)), vec3(0)));
  auto& hinge = screw.add<HingeJoint>(wall, spindle, vec3(0), up);
  screw.add<SliderJoint>(wall, nut, vec3(0), up);
  screw.add<ScrewJoint>(spindle, nut, vec3(0), up, lead);
  hinge.set_motor(0, 100);
  World ropes;
  const BodyId heavy = ropes.add(box(3, vec3(real(0.2)), vec3(-1, -1, 0)));
  const BodyId light = ropes.add(box(real(1.5), vec3(real(0.2)), vec3(1, -1, 0)));
  auto& rope = ropes.add<PulleyJoint>(light, heavy, Pulley{vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0),
                                                           vec3(0), 3, 2});
  SequentialImpulses solver;
  solver.iterations = 300;
  for (int n = 0; n < 60; ++n) {
    step(screw, solver, real(1) / 60, {.warm_start = true});
    step(ropes, solver, real(1) / 60, {.warm_start = true});
  }
  table.row({"torque"}, {double(hinge.motor_force()), 2 * 9.81 * double(lead) / 2 /
                                                          std::numbers::pi});
  table.row({"rope"}, {double(rope.forces()[0]), 1.5 * 9.81});
}

// ---- the reader's own part ----------------------------------------------------------------------

// Two boxes that are thrown about weightlessly for a second, with the reader's part between them:
// its largest error by the number of iterations. The first box also hangs on a hinge.
void own_part_at_work(CsvFile& table) {
  for (const int iterations : {1, 2, 5, 10, 30, 100}) {
    World world;
    world.gravity = vec3(0);
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId one = world.add(box(2, vec3(1, real(0.4), real(0.3)), vec3(real(0.5), 0, 0)));
    const BodyId two = world.add(box(1, vec3(real(0.5), real(0.3), real(0.7)),
                                     vec3(real(1.1), real(0.6), real(0.2))));
    Bodies& bodies = world.bodies;
    world.add<HingeJoint>(wall, one, vec3(0), vec3(0, 1, 1));
    const OwnPart part = own_part(bodies[one], bodies[two]);
    world.add<OwnJoint>(one, two, part);
    bodies[one].w = vec3(0, 2, 2);
    bodies[two].v = vec3(1, real(0.5), -1);
    bodies[two].w = vec3(3, -1, 2);
    SequentialImpulses solver;
    solver.iterations = iterations;
    double worst = 0;
    for (int n = 0; n < 60; ++n) {
      step(world, solver, real(1) / 60);
      const std::array<real, 6> C = part.error(bodies[one], bodies[two]);
      for (int i = 0; i < part.rows; ++i)
        worst = std::max(worst, std::abs(double(C[std::size_t(i)])));
    }
    table.row({double(part.rows), double(iterations), worst});
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Settings settings;
    if (!read(settings, "Chapter 10: a machine, a gear, a cone, and a part of your own", "10",
              "how long the machine runs", argc, argv))
      return;
    std::vector<Summary> lines{machine(settings)};

    CsvFile ratios(settings.out + "/universal.csv",
                   {"bend_deg", "angle_deg", "measured", "formula"});
    universal(settings, ratios);
    CsvFile gears(settings.out + "/gear.csv", {"count", "turns", "off_deg"});
    std::printf("gear of 1 to -0.7: %.2g degrees off at most in 10000 turns",
                gear<Gear>("counted", 10000, real(-0.7), gears));
    std::printf(", %.0f in 10 turns without a count\n",
                gear<Folded>("folded", 10, real(-0.7), gears));
    CsvFile cones(settings.out + "/cone.csv",
                  {"direction_deg", "late_deg", "swing_deg", "blind_deg"});
    for (int k = 0; k < 360; k += 10)
      cones.row({double(k), greatest_swing<Cone, ConeJoint>(k * degree),
                 greatest_swing<Cone>(k * degree), greatest_swing<Blind>(k * degree)});
    loads(settings);
    CsvFile own(settings.out + "/own.csv", {"rows", "iterations", "worst"});
    own_part_at_work(own);
    report(lines, settings.out);
  });
}
