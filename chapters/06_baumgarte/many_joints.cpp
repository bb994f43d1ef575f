// Chapter 6's program, many joints: beta and the warm start in a chain, rods that contradict each
// other, a chain between two walls, the methods side by side. Read it; there is nothing to edit.
#include <algorithm>
#include <cmath>

#include "chapters/01_distance/distance_joint.h"
#include "chapters/02_ball/ball_joint.h"
#include "chapters/06_baumgarte/baumgarte.h"
#include "chapters/06_baumgarte/program.h"

namespace joints::chapter6 {

namespace {

// ---- a chain -----------------------------------------------------------------------------------

// Cubes 1 m apart in a row, the first static, each on a ball joint at the centre of the one before.
struct CubeChain {
  Stage stage;
  std::vector<BodyId> ids;
  std::vector<BallJoint*> joints;

  CubeChain(const std::string& name, int links, real mass, const vec3& along, real beta)
      : stage{.name = name} {
    stage.energy_scale = 0;
    for (int k = 0; k <= links; ++k) {
      ids.push_back(stage.box(k == 0 ? 0 : mass, vec3(real(0.4)), real(k) * along));
      if (k > 0) add_joint(ids[std::size_t(k) - 1], ids.back(), beta);
      stage.energy_scale += double(mass) * 9.81 * k;
    }
  }
  void add_joint(BodyId a, BodyId b, real beta) {
    World& world = stage.world;
    const vec3 anchor = world.bodies[a].x;
    joints.push_back(&world.add<BallJoint>(a, b, point_at(world.bodies[a], world.bodies[b],
                                                          anchor)));
    joints.back()->beta = beta;
    stage.mark(a, b, anchor);
  }
  void step() { stage.solver.step(stage.world, h); }
  double gap(std::size_t k) const {
    const BallJoint& joint = *joints[k];
    const Bodies& bodies = stage.world.bodies;
    return double(length(joint.part.error(bodies[joint.body1], bodies[joint.body2])));
  }
  double gap() const {
    double sum = 0;
    for (std::size_t k = 0; k < joints.size(); ++k) sum += gap(k) * gap(k);
    return std::sqrt(sum);
  }
};

// How much a sweep leaves, in the long run, of what the joints still ask for: rho.
double contraction(CubeChain& chain, int sweeps) {
  Bodies& bodies = chain.stage.world.bodies;
  chain.stage.solver.begin(chain.stage.world, h);
  const auto change = [&] {
    const vec3 before = bodies[chain.ids.back()].v;
    chain.stage.solver.sweep(bodies, 0);
    return double(length(bodies[chain.ids.back()].v - before));
  };
  for (int n = 0; n < sweeps; ++n) change();
  const double first = change();
  for (int n = 0; n < sweeps / 2; ++n) change();
  return std::pow(change() / first, 1.0 / (sweeps / 2 + 1));
}

// The same by formula, for n equal masses in a row held at one end: what a sweep leaves of mode j.
double contraction_of_row(int n, int j) {
  return std::pow(std::cos((2 * j - 1) * std::acos(-1.0) / (2 * n)), 2);
}

// ---- beta, alone and in a chain ----------------------------------------------------------------

// What a step makes of a mode of which its sweeps leave `eta`: the larger root of
// z^2 - (1 + eta - (1 - eta) beta) z + eta, in size.
double step_factor(double eta, double beta) {
  const double half = (1 + eta - (1 - eta) * beta) / 2, root = half * half - eta;
  return root < 0 ? std::sqrt(eta) : std::abs(half) + std::sqrt(root);
}

// The slowest of all modes. A sweep over n equal masses in a row leaves cos^2((2j - 1) pi/2n) of
// the modes j = 1, 2, .., and nothing of as many others.
double predicted_factor(int links, int sweeps, double beta) {
  double slowest = std::abs(1 - beta);
  if (links > 1)
    for (int j = 1; 2 * j <= links; ++j)
      slowest = std::max(slowest, step_factor(std::pow(contraction_of_row(links, j), sweeps),
                                              beta));
  return slowest;
}

// A chain without gravity whose last joint starts open by 0.1 m, along the chain: what a step
// leaves of the gaps. They may swing, so the largest of some steps is compared with the largest of
// later ones.
double measured_factor(int links, int sweeps, double beta) {
  CubeChain chain("beta", links, 1, vec3(0, -1, 0), real(beta));
  chain.stage.world.gravity = vec3(0);
  chain.stage.solver.iterations = sweeps;
  chain.stage.world.bodies[chain.ids.back()].x.y -= real(0.1);
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
  for (const int sweeps : {0, 10, 30, 300})
    for (const double beta : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3,
                              1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.1, 2.2}) {
      const bool one = sweeps == 0;
      const int links = one ? 1 : 10, count = one ? 1 : sweeps;
      table.row({one ? "one joint" : "chain, " + std::to_string(sweeps) + " sweeps"},
                {beta, predicted_factor(links, count, beta), measured_factor(links, count, beta)});
    }
}

// ---- the warm start ----------------------------------------------------------------------------

// Sag of a cold chain that hangs plumb, Eq. 6-12: x = H (x + b) repeated until nothing changes, H
// being what is left of a right side after some sweeps over n equal masses in a row.
double predicted_sag(int n, int sweeps, double beta) {
  std::vector<double> x(std::size_t(n), 0.0);
  for (double change = 1; change > 1e-9;) {
    std::vector<double> r = x, lambda(std::size_t(n), 0.0);
    r[0] += 9.81;  // what gravity does to the first joint; the others fall together
    const auto left = [&](std::size_t k) {
      double sum = r[k] - (k == 0 ? 1 : 2) * lambda[k];
      if (k > 0) sum += lambda[k - 1];
      if (k + 1 < r.size()) sum += lambda[k + 1];
      return sum;
    };
    for (int sweep = 0; sweep < sweeps; ++sweep)
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

double sag(int links, int sweeps, double beta, bool warm) {
  CubeChain chain("hanging", links, 1, vec3(0, -1, 0), real(beta));
  chain.stage.solver.iterations = sweeps;
  chain.stage.solver.warm_start = warm;
  for (int n = 0; n < 900; ++n) chain.step();
  return -links - double(chain.stage.world.bodies[chain.ids.back()].x.y);
}

void warm(const Choice& choice) {
  CsvFile table(choice.out + "/warm.csv",
                {"links", "iterations", "beta", "rho", "kept", "safe", "warm_sag_m", "cold_sag_m",
                 "predicted_cold_sag_m"});
  for (const int links : {5, 10, 20}) {
    CubeChain chain("warm", links, 1, vec3(0, -1, 0), 0);
    const double rho = contraction(chain, 400);
    for (const double beta : {0.05, 0.15, 0.5})
      for (const int k : {1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 80}) {
        const double kept = std::pow(rho, k) * (1 + beta);
        table.row({double(links), double(k), beta, rho, kept,
                   warm_start_is_safe(real(rho), k, real(beta)) ? 1.0 : 0.0,
                   sag(links, k, beta, true), sag(links, k, beta, false),
                   predicted_sag(links, k, beta)});
      }
  }
}

// ---- rods that contradict each other -----------------------------------------------------------

// The bridge of chapter 1 with rods of 2.3 m in place of its ropes: ten cubes 2 m apart, the outer
// ones static, nine rods that are all too long for the straight line.
void rods(const Choice& choice) {
  CsvFile table(choice.out + "/rods.csv",
                {"method", "iterations", "peak_speed_m_s", "gap_max_m"});
  const struct {
    std::string name;
    real beta;
    int projections;
  } methods[] = {{"beta 0.05", real(0.05), 0}, {"beta 0.2", real(0.2), 0}, {"beta 1", 1, 0},
                 {"projection", 0, 1}, {"beta 0.2 + projection", real(0.2), 1}};
  for (const auto& method : methods)
    for (const int iterations : {3, 10, 30, 100, 300}) {
      Stage stage{.name = "bridge of rods"};
      stage.solver.iterations = iterations;
      stage.solver.projections = method.projections;
      BodyId before;
      for (int i = 0; i < 10; ++i) {
        const BodyId id = stage.box(i == 0 || i == 9 ? 0 : 100, vec3(1),
                                    vec3(real(2 * i - 9), 0, 0));
        if (i > 0) {
          stage.world.add<CentreDistanceJoint>(before, id, CentreDistance{real(2.3)}).beta =
              method.beta;
          stage.strokes.push_back({i - 1, i, {}, {}});
        }
        before = id;
      }
      double peak = 0, gap = 0;
      const bool seen = method.beta == real(0.2) && iterations == 100;
      play(stage, "", 5, seen ? choice.out + "/bridge_of_rods.motion.json" : "", [&](double time) {
        for (int slot = 0; slot < stage.world.bodies.slots(); ++slot)
          peak = std::max(peak, double(length(stage.world.bodies.at(slot).v)));
        if (time < 4) return;
        for (const auto& joint : stage.world.joints())
          gap = std::max(gap, std::abs(double(CentreDistance{real(2.3)}.error(
                                  stage.world.bodies[joint->body1],
                                  stage.world.bodies[joint->body2]))));
      });
      table.row({method.name}, {double(iterations), peak, gap});
    }
}

// ---- side by side ------------------------------------------------------------------------------

// Twenty cubes of 100 kg let go level: what each method leaves of the gaps and of the energy, and
// what it costs. Substeps: the step cut into 16, with a few sweeps in each; counted are all.
void side_by_side(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/side_by_side.csv", {"method", "iterations", "gap_rms_m", "gap_max_m",
                                                   "energy_drift", "us_per_step"});
  const struct {
    std::string name;
    real beta;
    int projections, substeps;
    std::vector<int> counts;  // sweeps a step
  } methods[] = {{"beta 0.2", real(0.2), 0, 1, {5, 10, 30, 100}},
                 {"beta 1", 1, 0, 1, {5, 10, 30, 100}},
                 {"projection", 0, 1, 1, {5, 10, 30, 100}},
                 {"beta 0.2 + projection", real(0.2), 1, 1, {5, 10, 30, 100}},
                 {"beta 1 + projection", 1, 1, 1, {5, 10, 30, 100}},
                 {"16 substeps", real(0.2), 0, 16, {16, 32, 96}}};
  for (const auto& method : methods)
    for (const int iterations : method.counts) {
      CubeChain chain("side by side", 20, 100, vec3(1, 0, 0), method.beta);
      chain.stage.h = h / real(method.substeps);
      chain.stage.solver.iterations = iterations / method.substeps;
      chain.stage.solver.projections = method.projections;
      if (&method == methods && iterations == 5) chain.stage.print_plan();
      Summary line = play(chain.stage, method.name + ", " + std::to_string(iterations), 5);
      line.us_per_step *= method.substeps;
      table.row({method.name}, {double(iterations), line.gap_rms, line.gap_max, line.energy_drift,
                                line.us_per_step});
      if (iterations == 30 || iterations == 32) lines.push_back(line);
    }
}

}  // namespace

void many_joints(const Choice& choice, std::vector<Summary>& lines) {
  betas(choice);
  warm(choice);
  rods(choice);
  side_by_side(choice, lines);
}

}  // namespace joints::chapter6
