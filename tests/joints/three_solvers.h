// The solvers with which joints are tested: row by row, packed, and all rows at once.
#pragma once

#include <memory>
#include <vector>

#include "direct/direct_solver.h"
#include "checker/numeric.h"
#include "engine/simd/packed.h"

namespace joints::testing {

inline std::vector<std::unique_ptr<Solver>> three_solvers(int iterations) {
  std::vector<std::unique_ptr<Solver>> out;
  const auto iterated = [&](auto solver) {
    solver->iterations = iterations;
    out.push_back(std::move(solver));
  };
  iterated(std::make_unique<SequentialImpulses>());
  iterated(std::make_unique<PackedImpulses>());
  out.push_back(std::make_unique<DirectSolver>(DirectSolver::velocities_only()));
  return out;
}

inline vec3 drawn_direction(Random& random) {
  return normalize(random.vector(1) + vec3(0, 0, 2));
}

}  // namespace joints::testing
