// Chapter 4's program: a piston between two limits, a cannon, and the angular momentum with a motor
// row that has no levers. Read it; there is nothing to edit here.
#include "chapters/04_slider/program/piston.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::chapter4;

namespace {

// ---- the piston ---------------------------------------------------------------------------------

// The piston runs; its motor reverses every 1.5 s.
Summary piston(const Settings& settings, bool whole, CsvFile& table) {
  const std::string words = whole ? "whole joint" : "blocks apart";
  Piston piston(settings, whole);
  SliderJoint& joint = *piston.joint;
  if (whole) piston.scene.print_plan();
  const Bodies& bodies = piston.scene.world.bodies;
  const std::string motion = whole == settings.whole ? settings.out + "/piston.motion.json" : "";
  return play(piston.scene, words, settings.seconds, motion, [&](double time) {
    table.row({words}, {time, double(joint.position(bodies)), double(joint.speed(bodies)),
                        double(joint.motor_force()), double(joint.limit_force())});
    piston.turn_round(time);
  });
}

// ---- the cannon ---------------------------------------------------------------------------------

// A carriage of 50 kg on a slider at 45 degrees, limits -1 and 10 m, driven by a motor. It pushes a
// shot of 10 kg: a second slider whose lower limit is the carriage. At the muzzle the carriage
// stops and the shot moves on; half a metre further its slider is removed.
Summary cannon(const Settings& settings, bool whole, CsvFile& table) {
  const std::string words = whole ? "whole joint" : "blocks apart";
  const real diagonal = std::sqrt(real(0.5));
  const vec3 along(diagonal, diagonal, 0);
  const quat turn = rotation(vec3(0, 0, std::atan2(diagonal, diagonal)));
  Scene scene{.name = "cannon"};
  scene.solver.iterations = settings.iterations;
  scene.energy_scale = 60 * 9.81 * 11 * double(diagonal);
  const BodyId barrel = scene.box(0, vec3(11, real(0.1), real(0.6)),
                                  real(4.5) * along + real(0.6) * vec3(diagonal, -diagonal, 0),
                                  turn);
  const BodyId carriage = scene.box(50, vec3(1, 1, 1), vec3(0), turn);
  const BodyId shot = scene.box(10, vec3(real(0.5)), along, turn);
  SliderJoint& rail = slider(scene, barrel, carriage, vec3(0), along, settings, whole);
  SliderJoint& push = slider(scene, carriage, shot, along, along, settings, whole);
  for (const BodyId id : {carriage, shot}) scene.world.bodies[id].x -= along;  // loaded: at -1 m
  rail.set_limits(-1, 10);
  rail.set_motor(60, 5000);
  push.set_limits(0, unbounded);
  if (whole) scene.print_plan();
  bool flying = false;
  scene.gaps = [&](GapMeter& meter) {
    meter.add(gap(rail, scene.world.bodies));
    if (!flying) meter.add(gap(push, scene.world.bodies));
  };
  const std::string motion = whole == settings.whole ? settings.out + "/cannon.motion.json" : "";
  const double seconds = std::min(settings.seconds, 2.0);
  return play(scene, words, seconds, motion, [&](double time) {
    const Bodies& bodies = scene.world.bodies;
    const vec3 x = bodies[shot].x;
    table.row({words}, {time, double(rail.position(bodies)), double(rail.speed(bodies)),
                        double(x.x), double(x.y), double(length(bodies[shot].v)),
                        flying ? 1.0 : 0.0});
    if (flying) return;
    flying = push.position(bodies) > real(0.5);
    if (flying) scene.world.remove(push);
  });
}

// ---- a motor without levers ---------------------------------------------------------------------

// The motor's row as the thesis prints it, without levers, but with the right sign. It drives the
// centres apart, and not the anchors along the line.
class CentreMotor : public Joint {
 public:
  vec3 a1_local;
  real speed, strength;
  CentreMotor(BodyId id1, BodyId id2, const vec3& a1_local, real speed, real strength)
      : Joint(id1, id2), a1_local(a1_local), speed(speed), strength(strength) {}
  void append(const Bodies& bodies, Blocks& blocks) const override {
    const vec3 a = to_world(bodies[body1], a1_local);
    blocks.append(bodies, body1, body2, to_jacobian(Row{-a, vec3(0), a, vec3(0)}), {0},
                  {.rate = speed,
                   .holds_position = false,
                   .lower = -strength,
                   .upper = strength},
                  &impulse_);
  }

 private:
  mutable real impulse_ = 0;
};

// Two free bodies that rotate together while a motor pushes one along the other. No external force
// acts on them, so their angular momentum must not change.
void momentum(const Settings& settings, bool levers, CsvFile& table) {
  Scene scene{.name = "momentum"};
  scene.solver.iterations = settings.iterations;
  scene.world.gravity = vec3(0);
  const BodyId id1 = scene.box(3, vec3(2, real(0.4), real(0.4)), vec3(0));
  const BodyId id2 = scene.box(1, vec3(real(0.5)), vec3(0, 1, 0));
  SliderJoint& joint =
      slider(scene, id1, id2, vec3(0, real(0.5), 0), vec3(1, 0, 0), settings, settings.whole);
  if (levers)
    joint.set_motor(100, 5);  // a speed that it does not reach: 5 N all the time
  else
    scene.world.add<CentreMotor>(id1, id2, joint.coordinate().a1_local, real(100), real(5));
  play(scene, "", 1, "", [&](double time) {
    double L = 0;
    for (const BodyId id : {id1, id2}) {
      const Body& body = scene.world.bodies[id];
      const vec3 w = to_local(body, body.w);
      const glm::dvec3 spin = glm::dvec3(w) / glm::dvec3(body.inverse_inertia_local);
      L += double(cross(body.x, body.v).z) / double(body.inverse_mass) +
           double(to_world(body, vec3(spin)).z);
    }
    table.row({levers ? "levers" : "centres"},
              {time, L, double(joint.speed(scene.world.bodies)),
               double(scene.world.bodies[id1].w.z)});
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Settings settings;
    if (!read(settings, "Chapter 4: a piston, a cannon, a motor without levers", "6",
              "how long the piston runs", argc, argv))
      return;

    std::vector<Summary> lines;
    CsvFile piston_table(settings.out + "/piston.csv",
                         {"blocks", "time_s", "displacement_m", "speed_m_s", "motor_n",
                          "limit_n"});
    CsvFile cannon_table(settings.out + "/cannon.csv",
                         {"blocks", "time_s", "displacement_m", "speed_m_s", "shot_x_m", "shot_y_m",
                          "shot_m_s", "flying"});
    for (bool whole : {false, true}) lines.push_back(piston(settings, whole, piston_table));
    for (bool whole : {false, true}) lines.push_back(cannon(settings, whole, cannon_table));
    CsvFile momentum_table(settings.out + "/momentum.csv",
                           {"row", "time_s", "angular_momentum", "speed_m_s", "turn_rad_s"});
    for (bool levers : {true, false}) momentum(settings, levers, momentum_table);
    report(lines, settings.out);
  });
}
