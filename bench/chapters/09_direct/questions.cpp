// The tables of the answers to the chapter's questions.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/chapters/09_direct/experiments.h"
#include "engine/instruments/rate.h"

namespace joints::chapter9 {

namespace {

// Question 1: the least power of 2 as the number of iterations with which no cube of a chain that
// is pulled sideways moves further than 0.1 m in five seconds; and the factor per iteration of the
// error.
int enough(int hinges) {
  for (int iterations = 1;; iterations *= 2) {
    Scene scene = sideways_chains(1, hinges + 1);
    scene.solver.iterations = iterations;
    double furthest = 0;
    for (int n = 0; n < steps_in(5, scene.h) && furthest <= 0.1; ++n) {
      scene.step();
      for (const Body& body : all_of(scene.world.bodies))
        furthest = std::max(furthest, std::abs(double(body.x.x)));
    }
    if (furthest <= 0.1) return iterations;
  }
}

void iterations_needed(const Choice& choice) {
  CsvFile table(choice.out + "/needed.csv", {"hinges", "iterations", "left_less"});
  for (const int hinges : {5, 7, 10, 14}) {
    Scene scene = sideways_chains(1, hinges + 1);
    const double rate = contraction_rate(scene.world, 100000);
    table.row({double(hinges), double(enough(hinges)), 1 - rate});
  }
}

// Question 2: a ring of moving bodies on hinges with arbitrary axes.
Scene ring_of(int bodies) {
  Scene scene{.name = "ring"};
  const auto corner = [&](int k) {
    const real angle = real(6.283185307179586) * real(k) / real(bodies);
    return vec3(std::cos(angle), std::sin(angle), 0);
  };
  std::vector<BodyId> ids;
  for (int k = 0; k < bodies; ++k) ids.push_back(rod(scene, corner(k), corner(k + 1)));
  for (int k = 0; k < bodies; ++k) {
    const vec3 axis(std::sin(real(3 * k + 1)), std::cos(real(5 * k)), std::sin(real(7 * k + 2)));
    on_hinge(scene, ids[std::size_t((k + bodies - 1) % bodies)], ids[std::size_t(k)], corner(k),
             axis);
  }
  return scene;
}

void rings(const Choice& choice) {
  CsvFile table(choice.out + "/rings.csv", {"bodies", "ways", "rows", "dependent", "fill"});
  for (const int bodies : {4, 5, 6, 7, 8}) {
    Scene scene = ring_of(bodies);
    DirectSolver direct = DirectSolver::velocities_only();
    leaps(scene, direct)();
    table.row({double(bodies), 6.0 * bodies, 5.0 * bodies, double(direct.dependent()),
               double(direct.report().fill)});
  }
}

// Question 3: added inertia with an unchanged angular velocity.
class KeepsRates : public DirectSolver {
 public:
  void warm_start(Bodies& bodies, real ratio) override {
    const std::vector<Body> before(bodies.data(), bodies.data() + bodies.slots());
    DirectSolver::warm_start(bodies, ratio);
    for (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot).w = before[slot].w;
  }
};

void kept_rates(const Choice& choice) {
  CsvFile table(choice.out + "/kept.csv", {"kept", "end_kg", "after_2s", "most_won"});
  for (const bool rates : {true, false})
    for (const double ratio : {1.0, 100.0, 1e4, 1e6}) {
      Scene scene = heavy_chain(10, real(ratio));
      DirectSolver more = DirectSolver::velocities_only();
      KeepsRates keeps;
      DirectSolver& direct = rates ? keeps : more;
      direct.newton = 8;
      direct.added_inertia = 8;
      const double start = energy_of(scene);
      double after = 0, most = 0;
      play(
          scene, "", 10, "",
          [&](double time) {
            const double change = (energy_of(scene) - start) / scene.energy_scale;
            if (time < 2 + double(scene.h) / 2) after = change;
            most = std::max(most, change);
          },
          leaps(scene, direct));
      table.row({rates ? "rate" : "energy"}, {ratio, after, most});
    }
}

}  // namespace

void questions(const Choice& choice) {
  iterations_needed(choice);
  rings(choice);
  kept_rates(choice);
}

}  // namespace joints::chapter9
