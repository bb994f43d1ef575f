// One joint at a time: its drift, the decay of an error, the energy that this costs, and the motion
// that remains.
#include <cmath>

#include "bench/chapters/06_baumgarte/experiments.h"
#include "chapters/06_baumgarte/baumgarte.h"
#include "joints/ball_joint.h"
#include "joints/hinge_joint.h"
#include "joints/slider_joint.h"

namespace joints::chapter6 {

namespace {

// ---- the thesis' test scene --------------------------------------------------------------------

// A static cube at the origin, a cube of 100 kg two metres beside it, and a joint at the centre of
// the static one. `Make` adds the joint to the scene and returns it.
struct Pair {
  Scene scene;
  BodyId wall, cube;

  explicit Pair(const std::string& name, int iterations) : scene{.name = name} {
    scene.solver.iterations = iterations;
    wall = scene.box(0, vec3(1), vec3(0));
    cube = scene.box(100, vec3(1), vec3(2, 0, 0));
    scene.mark(wall, cube, vec3(0));
    scene.energy_scale = 100 * 9.81 * 2;
  }
  BallJoint& ball(real beta) {
    World& world = scene.world;
    auto& joint = world.add<BallJoint>(
        wall, cube, vec3(0));
    joint.beta = beta;
    return joint;
  }
  HingeJoint& hinge(const vec3& axis, real beta) {
    auto& joint = scene.world.add<HingeJoint>(wall, cube, vec3(0), axis);
    joint.beta = beta;
    return joint;
  }
  Body& body() { return scene.world.bodies[cube]; }
  const Body& fixed() { return scene.world.bodies[wall]; }
  void step() { scene.step(); }
};

// ---- drift and decay ---------------------------------------------------------------------------

// Thesis fig. 3.1: a hinge without correction. Each step moves the cube's end of the hinge
// outwards, along the vector from there to the centre, by Eq. 6-1; the gap is the sum of these
// vectors.
Summary drift(const Choice& choice) {
  Pair pair("drift", choice.iterations);
  const HingeJoint& joint = pair.hinge(vec3(0, 0, 1), 0);
  pair.scene.print_plan();
  CsvFile table(choice.out + "/drift.csv", {"time_s", "gap_m", "predicted_m"});
  vec3 sum(0);
  return play(pair.scene, "beta 0", choice.seconds, "", [&](double time) {
    const Body& cube = pair.body();
    const vec3 r = -to_world(cube, joint.first.anchor2_local);
    sum += dot(cube.w, cube.w) * h * h / real(2) * r;  // Eq. 6-1
    table.row({time, double(length(joint.first.error(pair.fixed(), cube))), double(length(sum))});
  });
}

// Thesis fig. 3.3: a ball joint that starts with a gap, without gravity.
void decay(const Choice& choice) {
  CsvFile table(choice.out + "/decay.csv", {"start_m", "step", "gap_m", "expected_m"});
  for (const double start : {0.001, std::sqrt(2.0)}) {
    Pair pair("decay", choice.iterations);
    pair.scene.world.gravity = vec3(0);
    const BallJoint& joint = pair.ball(choice.beta);
    pair.body().x += real(start / std::sqrt(2.0)) * vec3(1, 0, -1);
    for (int n = 0; n <= 60; ++n) {
      if (n > 0) pair.step();
      table.row({start, double(n), double(length(joint.part.error(pair.fixed(), pair.body()))),
                 start * std::pow(1 - double(choice.beta), n)});  // Eq. 6-3
    }
  }
}

// Thesis figs. 5.1 and 5.2: a slider and a hinge that start displaced and rotated.
template <class AnyJoint>
void correction(Pair& pair, const AnyJoint& joint, const std::string& path) {
  pair.scene.world.gravity = vec3(0);
  pair.body().x += vec3(0, real(0.4), real(-0.3));
  pair.body().q = rotation(vec3(real(0.3), 0, real(0.2))) * pair.body().q;
  CsvFile table(path, {"time_s", "translation_m", "rotation_rad"});
  const auto size = [](const auto& C) {
    double sum = 0;
    for (const real part : to_vector(C)) sum += double(part * part);
    return std::sqrt(sum);
  };
  for (int n = 0; n <= 60; ++n) {
    if (n > 0) pair.step();
    table.row({n * double(h), size(joint.first.error(pair.fixed(), pair.body())),
               size(joint.second.error(pair.fixed(), pair.body()))});
  }
}

// ---- energy, and the angular velocity that remains ---------------------------------------------

void energies(const Choice& choice) {
  CsvFile table(choice.out + "/energy.csv",
                {"beta", "gap_m", "predicted_j", "measured_j", "left_j"});
  for (const double beta : {0.05, 0.15, 0.5, 1.0})
    for (const double gap : {0.001, 0.01, 0.1, std::sqrt(2.0)}) {
      Pair pair("energy", choice.iterations);
      pair.scene.world.gravity = vec3(0);
      const BallJoint& joint = pair.ball(real(beta));
      pair.body().x += real(gap / std::sqrt(2.0)) * vec3(1, 0, -1);
      const vec3 C = joint.part.error(pair.fixed(), pair.body());
      const vec3 pressed = inverse(joint.part.K(pair.fixed(), pair.body())) * C;
      const double predicted = 0.5 * std::pow(beta / double(h), 2) * double(dot(C, pressed));
      pair.step();
      const double measured = kinetic_energy(pair.body());
      for (int n = 0; n < 900; ++n) pair.step();
      table.row({beta, gap, predicted, measured, kinetic_energy(pair.body())});  // Eq. 6-6
    }
}

// Eq. 6-7 for the thesis' scene: m = 100 kg, i = 100/6 kg m^2, r = (-2, 0, 0), a = y.
double predicted_spin(const vec3& gap, double beta) {
  const vec3 r(-2, 0, 0);
  const double G = 100 / (100 / 6.0 + 100 * 4.0);
  return G * G * beta / double(h) / (2 - beta) * double(cross(r, gap).y) * double(dot(r, gap));
}

// The angular velocity that remains when a gap has been corrected.
vec3 spin_left(const vec3& gap, real beta, int iterations) {
  Pair pair("spin", iterations);
  pair.scene.world.gravity = vec3(0);
  pair.hinge(vec3(0, 1, 0), beta);
  pair.body().x += gap;
  for (int n = 0; n < 900; ++n) pair.step();
  return pair.body().w;
}

void spins(const Choice& choice) {
  CsvFile table(choice.out + "/spin.csv",
                {"beta", "gap_m", "predicted_rad_s", "measured_rad_s"});
  for (const double beta : {0.05, 0.15, 0.5, 1.0})
    for (const double gap : {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 2.0}) {
      const vec3 offset = real(gap / std::sqrt(2.0)) * vec3(1, 0, -1);
      table.row({beta, gap, predicted_spin(offset, beta),
                 double(spin_left(offset, real(beta), choice.iterations).y)});
    }
}

// T 5.1 reports 1.8155 rad/s for beta 0.15. Finds the offset along (1, 0, -1) that gives it, by
// bisection.
void thesis_spin(const Choice& choice) {
  CsvFile table(choice.out + "/thesis_spin.csv",
                {"offset_m", "wx_rad_s", "wy_rad_s", "wz_rad_s", "predicted_rad_s"});
  const real beta = real(0.15), wanted = real(1.8155);
  real low = real(0.5), high = 2;
  for (int n = 0; n < 40; ++n) {
    const real middle = (low + high) / 2;
    (spin_left(middle * vec3(1, 0, -1), beta, choice.iterations).y < wanted ? low : high) = middle;
  }
  for (const real side : {real(-1), real(1)}) {
    const vec3 gap = low * vec3(1, 0, side), w = spin_left(gap, beta, choice.iterations);
    table.row({double(low), double(w.x), double(w.y), double(w.z),
               predicted_spin(gap, double(beta))});
  }
}

// ---- a rope that is too long -------------------------------------------------------------------

// A ball of 1 kg at rest, without gravity, on a rope of 1 m that is stretched by 0.1 m. The rope
// can accelerate the ball, but cannot brake it.
void rope(const Choice& choice) {
  CsvFile table(choice.out + "/rope.csv", {"method", "time_s", "length_m", "speed_m_s"});
  for (const bool projected : {false, true}) {
    Body wall = static_body(vec3(0)), body = ball(1, real(0.1), vec3(real(1.1), 0, 0));
    const Rope<Distance> part{{vec3(0), vec3(0), 1}};
    for (int n = 0; n <= 60; ++n) {
      if (n > 0) {
        const real C = part.error(wall, body), beta = projected ? real(0) : choice.beta;
        const Row J = part.jacobian(wall, body);
        real sum = 0;
        const real wish = row_impulse(J, part.K(wall, body), limit_bias(C, beta, h), wall, body);
        apply_impulse(J, clamp_sum(wish, sum), wall, body);
        body.x += h * body.v;
        if (projected) project(part, wall, body);
      }
      table.row({projected ? "projection" : "beta"},
                {n * double(h), double(length(body.x)), double(length(body.v))});
    }
  }
}

}  // namespace

void one_joint(const Choice& choice, std::vector<Summary>& lines) {
  lines.push_back(drift(choice));
  decay(choice);
  Pair slider("slider", choice.iterations), hinge("hinge", choice.iterations);
  auto& along = slider.scene.world.add<SliderJoint>(slider.wall,
                                                    slider.cube, vec3(0), vec3(1, 0, 0));
  along.beta = choice.beta;
  correction(slider, along, choice.out + "/slider.csv");
  correction(hinge, hinge.hinge(vec3(0, 1, 0), choice.beta), choice.out + "/hinge.csv");
  energies(choice);
  spins(choice);
  thesis_spin(choice);
  rope(choice);
}

}  // namespace joints::chapter6
