// Blows to the chain of T 5.1, four links of which the outer two are static.
#include <algorithm>
#include <array>
#include <cmath>

#include "bench/chapters/06_baumgarte/between_walls.h"
#include "bench/chapters/06_baumgarte/experiments.h"
#include "engine/instruments/rate.h"

namespace joints::chapter6 {

namespace {

// ---- the rank of the rows ----------------------------------------------------------------------

// The number of independent rows among the nine, by elimination in J M^-1 J^T. Its columns are the
// changes of all rates by an impulse of 1 in one row.
int rank_of(Chain chain) {
  std::array<std::array<double, 9>, 9> A{};
  for (std::size_t column = 0; column < 9; ++column) {
    std::vector<Body> pushed = chain.bodies;
    vec3 unit(0);
    unit[int(column % 3)] = 1;
    const std::size_t j = column / 3;
    apply_impulse(chain.joints[j].jacobian(pushed[j], pushed[j + 1]), unit, pushed[j],
                  pushed[j + 1]);
    for (std::size_t row = 0; row < 9; ++row) {
      const std::size_t k = row / 3;
      const Jacobian<3> J = chain.joints[k].jacobian(pushed[k], pushed[k + 1]);
      A[row][column] = double(row_velocity(J[int(row % 3)], pushed[k], pushed[k + 1]));
    }
  }
  double scale = 0;
  for (std::size_t k = 0; k < 9; ++k) scale = std::max(scale, A[k][k]);
  int rank = 0;
  for (std::size_t k = 0; k < 9; ++k) {  // A is symmetric: the largest pivot is on its diagonal
    std::size_t best = 0;
    for (std::size_t i = 1; i < 9; ++i)
      if (A[i][i] > A[best][best]) best = i;
    if (A[best][best] < 1e-9 * scale) break;
    ++rank;
    const std::array<double, 9> pivot = A[best];
    for (auto& row : A) {
      const double share = row[best] / pivot[best];
      for (std::size_t j = 0; j < 9; ++j) row[j] -= share * pivot[j];
    }
  }
  return rank;
}

// The factor by which an iteration multiplies wrong impulses in the long run. Arbitrary impulses
// are given to bodies at rest; the iterations have to remove them.
double contraction(Chain chain) {
  std::vector<vec3> impulses{vec3(3, 1, 2), vec3(1, 4, 1), vec3(5, 9, 2)};
  std::vector<Jacobian<3>> J;
  std::vector<mat3> K;
  for (std::size_t k = 0; k < 3; ++k) {
    Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
    J.push_back(chain.joints[k].jacobian(body1, body2));
    K.push_back(chain.joints[k].K(body1, body2));
  }
  for (std::size_t k = 0; k < 3; ++k)
    apply_impulse(J[k], impulses[k], chain.bodies[k], chain.bodies[k + 1]);
  double first = 0;
  const auto iteration = [&] {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
      const vec3 lambda = block_impulse(J[k], K[k], vec3(0), body1, body2);
      apply_impulse(J[k], lambda, body1, body2);
      impulses[k] += lambda;
      sum += double(dot(impulses[k], impulses[k]));
    }
    const double left = std::sqrt(sum);
    first = std::max(first, left);
    return left > 1e-10 * first ? left : 0;  // below that: rounding errors
  };
  return contraction_rate(iteration, 501);
}

// ---- three blows -------------------------------------------------------------------------------

Summary kicked(const Choice& choice, const std::string& method, real beta, int projections,
               real bend, CsvFile& table) {
  BetweenWalls between(bend, beta);
  Scene& scene = between.scene;
  scene.solver.iterations = choice.iterations;
  scene.stepping.projections = projections;
  if (method == "beta 0.05") scene.print_plan();  // the others have the same
  Bodies& bodies = scene.world.bodies;
  const std::string motion = method == "beta 0.2" ? choice.out + "/between.motion.json" : "";
  return play(scene, method, choice.seconds, motion, [&](double time) {
    double gap = 0, speed = 0;
    for (const Mark& mark : scene.marks) gap = std::max(gap, joints::gap(mark, poses(bodies)));
    for (const BodyId id : between.ids) speed = std::max(speed, double(length(bodies[id].v)));
    table.row({method}, {time, gap, speed});
    between.kick(time);
  });
}

}  // namespace

void between_walls(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile rates(choice.out + "/between_rate.csv", {"bend_rad", "rho", "rank"});
  for (const double bend : {0.0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
    const Chain chain = bent_chain(real(bend));
    rates.row({bend, contraction(chain), double(rank_of(chain))});
  }
  CsvFile table(choice.out + "/between.csv", {"method", "time_s", "gap_max_m", "speed_m_s"});
  lines.push_back(kicked(choice, "beta 0.05", real(0.05), 0, 0, table));
  lines.push_back(kicked(choice, "beta 0.2", real(0.2), 0, 0, table));
  lines.push_back(kicked(choice, "beta 1", 1, 0, 0, table));
  lines.push_back(kicked(choice, "projection", 0, 1, 0, table));
  lines.push_back(kicked(choice, "beta 0.2 + projection", real(0.2), 1, 0, table));
  lines.push_back(kicked(choice, "beta 0.2 + bent 0.2 rad", real(0.2), 0, real(0.2), table));
}

}  // namespace joints::chapter6
