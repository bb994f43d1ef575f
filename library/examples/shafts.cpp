// A shaft drives another one through a universal joint, at an angle of 30 degrees: the second is
// alternately faster and slower than the first. The solver is selected by its name. Exit status 1
// if the ratio of their speeds does not range from cos 30 degrees to its inverse.
// Prints:
//   rows      the second shaft turns 0.866 to 1.155 times as fast
//   packed    the second shaft turns 0.866 to 1.155 times as fast
//   direct    the second shaft turns 0.866 to 1.155 times as fast
//   symmetric the second shaft turns 0.866 to 1.155 times as fast
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>

#include "symmetric_impulses.h"
#include "universal_joint.h"

using namespace joints;

struct Choice {
  const char* name;
  std::unique_ptr<Solver> (*make)();
};
template <class Iterative>
std::unique_ptr<Solver> iterative() {
  auto solver = std::make_unique<Iterative>();
  solver->iterations = 300;
  return solver;
}
std::unique_ptr<Solver> direct() { return std::make_unique<DirectSolver>(); }
const Choice choices[] = {{"rows", iterative<SequentialImpulses>},
                          {"packed", iterative<PackedImpulses>},
                          {"direct", direct},
                          {"symmetric", iterative<SymmetricImpulses>}};  // the user's solver

// The least and the greatest ratio of the speeds during a revolution.
std::pair<real, real> ratios(Solver& solver) {
  const real angle = std::numbers::pi_v<real> / 6;
  const vec3 along1(1, 0, 0), along2(std::cos(angle), 0, std::sin(angle)), pin1(0, 1, 0);
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId first = world.add(box(4, vec3(1, real(0.2), real(0.2)), -along1));
  const BodyId second = world.add(box(4, vec3(1, real(0.2), real(0.2)), along2,
                                      rotation(vec3(0, -angle, 0))));
  auto& drive = world.add<HingeJoint>(wall, first, -along1, along1);
  auto& driven = world.add<HingeJoint>(wall, second, along2, along2);
  world.add<mine::UniversalJoint>(
      first, second, mine::cross_at(world.bodies[first], world.bodies[second], vec3(0), pin1,
                                    cross(along2, pin1)));
  drive.set_motor(5, 1000);  // rad/s, N m
  real least = 10, greatest = 0;
  for (int n = 0; n < 240; ++n) {
    step(world, solver, real(1) / 240);
    if (n < 60) continue;  // until the motion is periodic
    const real ratio = driven.speed(world.bodies) / drive.speed(world.bodies);
    least = std::min(least, ratio);
    greatest = std::max(greatest, ratio);
  }
  return {least, greatest};
}

int main(int arguments, char** words) {
  const std::string wanted = arguments > 1 ? words[1] : "";  // all solvers, if none is named
  for (const Choice& choice : choices) {
    if (!wanted.empty() && wanted != choice.name) continue;
    const std::unique_ptr<Solver> solver = choice.make();
    const auto [least, greatest] = ratios(*solver);
    std::printf("%-9s the second shaft turns %.3f to %.3f times as fast\n", choice.name,
                double(least), double(greatest));
    const double cosine = std::cos(std::numbers::pi / 6);
    if (std::abs(double(least) - cosine) > 0.01 || std::abs(double(greatest) - 1 / cosine) > 0.01)
      return 1;
  }
}
