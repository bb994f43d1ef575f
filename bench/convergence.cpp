// How many iterations the first step of a chain takes until its velocities are right to a
// millionth, by Gauss-Seidel and by the solvers of bench/next_door.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>

#include "bench/next_door/conjugate_gradients.h"
#include "bench/next_door/nonsmooth.h"
#include "bench/named.h"
#include "direct/direct_solver.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

constexpr real h = real(1) / 60;
constexpr double enough = 1e-6;

// A straight chain. Gravity pulls along it, or as in S7 partly along the axes of its hinges.
World chain(int hinges, bool sideways) {
  BenchScene scene = cubes_on_hinges(1, hinges + 1);
  scene.world.gravity = sideways ? vec3(3, real(-9.81), 0) : vec3(0, 0, real(9.81));
  return std::move(scene.world);
}

// The root of dV^T M dV for the difference of two worlds' velocities.
double distance(const World& one, const World& other) {
  double sum = 0;
  for (int slot = 0; slot < one.bodies.slots(); ++slot) {
    const Body &a = one.bodies.at(slot), &b = other.bodies.at(slot);
    if (a.is_static()) continue;
    const vec3 v = a.v - b.v, w = to_local(a, a.w - b.w);
    sum += double(dot(v, v) / a.inverse_mass) + double(dot(w, w / a.inverse_inertia_local));
  }
  return std::sqrt(sum);
}

struct Found {
  double iterations = std::numeric_limits<double>::infinity();  // that: more than were tried
  double us = std::numeric_limits<double>::quiet_NaN();  // of the processor, for one iteration
};

// Iterates in pieces of at most 2 % of the iterations done so far, up to `most` iterations.
template <class Kind>
Found by_pieces(Kind solver, int hinges, bool sideways, long most) {
  World exact = chain(hinges, sideways), world = chain(hinges, sideways);
  DirectSolver direct = DirectSolver::velocities_only();
  begin_step(exact, direct, h);
  direct.solve(exact.bodies);
  begin_step(world, solver, h);
  const double begin = distance(world, exact);
  long done = 0;
  std::clock_t time = 0;
  while (distance(world, exact) > enough * begin) {
    if (done > most) return {};
    solver.iterations = int(std::max(1L, done / 50));
    const std::clock_t start = std::clock();
    solver.solve(world.bodies);
    time += std::clock() - start;
    done += solver.iterations;
  }
  return {double(done), 1e6 * double(time) / CLOCKS_PER_SEC / double(done)};
}

// Begins anew with more iterations until there are enough: for solvers that remember directions.
template <class Kind>
Found from_the_beginning(Kind solver, int hinges, bool sideways, long most) {
  World exact = chain(hinges, sideways);
  DirectSolver direct = DirectSolver::velocities_only();
  begin_step(exact, direct, h);
  direct.solve(exact.bodies);
  for (long k = 1; k <= most; k += std::max(1L, k / 50)) {
    World world = chain(hinges, sideways);
    begin_step(world, solver, h);
    const double begin = distance(world, exact);
    solver.iterations = int(k);
    const std::clock_t start = std::clock();
    solver.solve(world.bodies);
    const double us = 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC;
    if (distance(world, exact) <= enough * begin) return {double(k), us / double(k)};
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Iterations until the velocities of a chain's first step are right to 1e-6",
                    {{"csv", "out/convergence.csv", "the table"},
                     {"most", "1000000", "no more iterations than this; of NNCG and CG a 200th"}});
    if (!options.read(argc, argv)) return;
    const long most = options.count("most", 1);
    FILE* file = open_table(options.text("csv"), false,
                            "gravity,hinges,method,rows,iterations,us_per_iteration");
    for (const bool sideways : {false, true})
      for (const int hinges : {10, 20, 50, 100}) {
        const auto print = [&](const char* method, const Found& found) {
          std::fprintf(file, "%s,%d,%s,%d,%g,%.4f\n", sideways ? "sideways" : "along", hinges,
                       method, 5 * hinges, found.iterations, found.us);
          std::fflush(file);
        };
        SequentialImpulses over_relaxed;
        over_relaxed.relaxation = real(1.9);
        print("gauss-seidel", by_pieces(SequentialImpulses(), hinges, sideways, most));
        print("over-relaxed", by_pieces(over_relaxed, hinges, sideways, most));
        print("nncg", from_the_beginning(NonsmoothGradients(), hinges, sideways, most / 200));
        print("cg", from_the_beginning(ConjugateGradients(), hinges, sideways, most / 200));
      }
    std::fclose(file);
  });
}
