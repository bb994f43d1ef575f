// Beta and the warm start in a chain.
#include <algorithm>
#include <cmath>

#include "bench/chapters/06_baumgarte/cube_chain.h"
#include "bench/chapters/06_baumgarte/experiments.h"
#include "chapters/06_baumgarte/baumgarte.h"
#include "engine/instruments/rate.h"

namespace joints::chapter6 {

namespace {

// ---- beta, alone and in a chain ----------------------------------------------------------------

// The factor by which an iteration multiplies mode j in the long run, for n equal masses in a row
// that is held at one end.
double contraction_of_row(int n, int j) {
  return std::pow(std::cos((2 * j - 1) * std::acos(-1.0) / (2 * n)), 2);
}

// The factor by which a step multiplies a mode that its iterations multiply by `eta`: the magnitude
// of the larger root of z^2 - (1 + eta - (1 - eta) beta) z + eta.
double step_factor(double eta, double beta) {
  const double half = (1 + eta - (1 - eta) * beta) / 2, root = half * half - eta;
  return root < 0 ? std::sqrt(eta) : std::abs(half) + std::sqrt(root);
}

// The slowest of all modes. An iteration over n equal masses in a row multiplies the modes j = 1,
// 2, .. by cos^2((2j - 1) pi/2n), and removes the same number of others entirely.
double predicted_factor(int links, int iterations, double beta) {
  double slowest = std::abs(1 - beta);
  if (links > 1)
    for (int j = 1; 2 * j <= links; ++j)
      slowest = std::max(slowest, step_factor(std::pow(contraction_of_row(links, j), iterations),
                                              beta));
  return slowest;
}

// A chain without gravity whose last joint starts open by 0.1 m, along the chain: the factor by
// which a step multiplies the gaps. They may oscillate, so the largest gap of some steps is
// compared with the largest of later steps.
double measured_factor(int links, int iterations, double beta) {
  CubeChain chain("beta", links, 1, vec3(0, -1, 0), real(beta));
  chain.scene.world.gravity = vec3(0);
  chain.scene.solver.iterations = iterations;
  chain.scene.world.bodies[chain.ids.back()].x.y -= real(0.1);
  std::vector<double> gaps{chain.gap()};
  while (gaps.size() < 300 && gaps.back() > 1e-13 && gaps.back() < 1e6) {
    chain.step();
    gaps.push_back(chain.gap());
  }
  const auto n = long(gaps.size()) - 1, window = std::min(20L, n / 4);
  if (n < 4) return gaps[1] / gaps[0] < 1e-12 ? 0 : gaps[1] / gaps[0];
  const auto largest = [&](long last) {
    return *std::max_element(gaps.begin() + last - window, gaps.begin() + last + 1);
  };
  const long early = n / 2;
  return std::pow(largest(n) / largest(early), 1.0 / double(n - early));
}

void betas(const Choice& choice) {
  CsvFile table(choice.out + "/beta.csv", {"scene", "beta", "predicted", "measured"});
  for (const int iterations : {0, 10, 30, 300})
    for (const double beta : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3,
                              1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.1, 2.2}) {
      const bool one = iterations == 0;
      const int links = one ? 1 : 10, count = one ? 1 : iterations;
      table.row({one ? "one joint" : "chain with " + std::to_string(iterations) + " iterations"},
                {beta, predicted_factor(links, count, beta), measured_factor(links, count, beta)});
    }
}

// ---- the warm start ----------------------------------------------------------------------------

// Sag of a cold chain that hangs plumb, Eq. 6-12: x = H (x + b) repeated until x is constant. H is
// the matrix by which some iterations multiply an error, over n equal masses in a row.
double predicted_sag(int n, int iterations, double beta) {
  std::vector<double> x(std::size_t(n), 0.0);
  for (double change = 1; change > 1e-9;) {
    std::vector<double> r = x, lambda(std::size_t(n), 0.0);
    r[0] += 9.81;  // gravity acts on the first joint; the bodies of the others fall together
    const auto left = [&](std::size_t k) {
      double sum = r[k] - (k == 0 ? 1 : 2) * lambda[k];
      if (k > 0) sum += lambda[k - 1];
      if (k + 1 < r.size()) sum += lambda[k + 1];
      return sum;
    };
    for (int iteration = 0; iteration < iterations; ++iteration)
      for (std::size_t k = 0; k < r.size(); ++k) lambda[k] += left(k) / (k == 0 ? 1 : 2);
    change = 0;
    for (std::size_t k = 0; k < r.size(); ++k) {
      change = std::max(change, std::abs(left(k) - x[k]));
      x[k] = left(k);
    }
  }
  double sum = 0;
  for (const double part : x) sum += part;
  return double(h) * double(h) / beta * sum;
}

// The displacement of the last cube: the largest in the third and in the last second.
struct Sag {
  double early = 0, late = 0;  // [m]
};

Sag sag(int links, int iterations, double beta, bool warm, int steps) {
  CubeChain chain("hanging", links, 1, vec3(0, -1, 0), real(beta));
  chain.scene.solver.iterations = iterations;
  chain.scene.stepping.warm_start = warm;
  Sag out;
  for (int n = 1; n <= steps; ++n) {
    chain.step();
    const double size = std::abs(links + double(chain.scene.world.bodies[chain.ids.back()].x.y));
    if (n > 120 && n <= 180) out.early = std::max(out.early, size);
    if (n > steps - 60) out.late = std::max(out.late, size);
  }
  return out;
}

void warm(const Choice& choice) {
  CsvFile table(choice.out + "/warm.csv",
                {"links", "iterations", "beta", "rho", "kept", "safe", "warm_sag_m", "cold_sag_m",
                 "predicted_cold_sag_m", "warm_early_m"});
  const int steps = steps_in(1.5 * choice.seconds, h);
  for (const int links : {5, 10, 20}) {
    CubeChain chain("warm", links, 1, vec3(0, -1, 0), 0);
    const double rho = contraction_rate(chain.scene.world, 600);
    for (const double beta : {0.05, 0.15, 0.5})
      for (const int k : {1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 80}) {
        const double kept = std::pow(rho, k) * (1 + beta);
        const Sag warm = sag(links, k, beta, true, steps), cold = sag(links, k, beta, false, steps);
        table.row({double(links), double(k), beta, rho, kept,
                   warm_start_is_safe(real(rho), k, real(beta)) ? 1.0 : 0.0,
                   warm.late, cold.late, predicted_sag(links, k, beta), warm.early});
      }
  }
}

}  // namespace

void in_a_chain(const Choice& choice) {
  betas(choice);
  warm(choice);
}

}  // namespace joints::chapter6
