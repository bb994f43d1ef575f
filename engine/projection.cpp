// One visit: K^-1 (-C), M^-1 J^T times that, and the bodies are moved.
#include "engine/projection.h"

#include <algorithm>

namespace joints {

void Projection::iterate(World& world) {
  for (const auto& joint : world.joints()) {
    joint->moved(world.bodies);
    if (!joint->projected) continue;
    blocks_.clear();
    blocks_.reserve(joint->most_rows());
    joint->append(world.bodies, blocks_);
    for (const Block& block : blocks_.list) {
      if (!block.target.holds_position) continue;  // a motor asks for a speed, not for a place
      const real C = blocks_.C[block.first + block.rows - 1];
      const bool one_sided = block.target.lower == 0 && block.target.upper == unbounded;
      solve(world.bodies, block, one_sided && C > 0 ? block.rows - 1 : block.rows);
    }
  }
}

// The first `rows` rows of a block.
void Projection::solve(Bodies& bodies, const Block& block, int rows) {
  real inverse_K[36], lambda[6];
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j)
      inverse_K[i * rows + j] = blocks_.K[block.first_K + i * block.rows + j];
  invert_symmetric(inverse_K, rows);
  for (int i = 0; i < rows; ++i) {
    lambda[i] = 0;
    for (int j = 0; j < rows; ++j)
      lambda[i] -= inverse_K[i * rows + j] * blocks_.C[block.first + j];
  }
  // The rigid rows alone may bring a limit back further than to its end: then it may not pull.
  const bool one_sided = rows == block.rows && block.target.lower == 0;
  if (one_sided && lambda[rows - 1] < 0) return solve(bodies, block, rows - 1);

  vec3 move[2], turn[2];  // M^-1 J^T lambda of the two bodies
  real share = 1;         // of it, so that no body goes too far
  for (const int k : {0, 1}) {
    const Body& body = bodies.at(k == 1 ? block.body2 : block.body1);
    for (int i = 0; i < rows; ++i) {
      const Row& J = blocks_.J[block.first + i];
      move[k] += lambda[i] * body.inverse_mass * (k == 1 ? J.v2 : J.v1);
      turn[k] += lambda[i] * (inverse_inertia(body) * (k == 1 ? J.w2 : J.w1));
    }
    share = std::min({share, longest_move / std::max(length(move[k]), longest_move),
                      widest_turn / std::max(length(turn[k]), widest_turn)});
  }
  for (const int k : {0, 1}) {
    Body& body = bodies.at(k == 1 ? block.body2 : block.body1);
    if (body.is_static()) continue;
    body.x += share * move[k];
    body.q = normalize(rotation(share * turn[k]) * body.q);
  }
}

}  // namespace joints
