// One block at a time: lambda = K^-1 (-C), and the bodies are moved by M^-1 J^T lambda.
#include "engine/steps/projection.h"

#include <algorithm>

namespace joints {

namespace {

// Projects the first `rows` rows of a block.
void project(World& world, const Block& block, int rows) {
  if (rows == 0) return;
  Bodies& bodies = world.bodies;
  const Blocks& blocks = world.blocks;
  Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
  Row response[6];
  real K[36], lambda[6] = {};
  form_responses(&blocks.J[block.first], rows, body1, body2, response);
  form_K(&blocks.J[block.first], response, rows, K);
  invert_symmetric(K, rows);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) lambda[i] -= K[i * rows + j] * blocks.C[block.first + j];
  // lambda < 0: all rows together would need the limit to pull. Solve again without its row.
  const bool may_pull = rows < block.rows || !block.settings.one_sided();
  if (!may_pull && lambda[rows - 1] < 0) return project(world, block, rows - 1);

  Row move;  // M^-1 J^T lambda
  for (int i = 0; i < rows; ++i) {
    move.v1 += lambda[i] * response[i].v1;
    move.w1 += lambda[i] * response[i].w1;
    move.v2 += lambda[i] * response[i].v2;
    move.w2 += lambda[i] * response[i].w2;
  }
  // At most 1: keeps both displacements and both rotations below their bounds.
  const auto within = [](const vec3& a, real most) {
    const real size = length(a);
    return size > most ? most / size : real(1);
  };
  const real share =
      std::min({within(move.v1, world.max_displacement), within(move.w1, max_rotation),
                within(move.v2, world.max_displacement), within(move.w2, max_rotation)});
  const auto displace = [&](Body& body, const vec3& displacement, const vec3& phi) {
    if (body.is_static()) return;
    body.x += share * displacement;
    body.q = normalize(rotation(share * phi) * body.q);
  };
  displace(body1, move.v1, move.w1);
  displace(body2, move.v2, move.w2);
}

}  // namespace

void project_positions(World& world) {
  Blocks& blocks = world.blocks;
  const int known = int(blocks.list.size());  // the blocks of the step are kept
  for (const auto& joint : world.joints()) {
    joint->after_projection(world.bodies);
    if (!joint->projected) continue;
    joint->append(world.bodies, blocks);
    for (int k = known; k < int(blocks.list.size()); ++k) {
      const Block& block = blocks.list[k];
      if (!block.corrects) continue;
      const real C = blocks.C[block.first + block.rows - 1];
      const bool leave_out_last = block.settings.one_sided() && C > 0;
      project(world, block, leave_out_last ? block.rows - 1 : block.rows);
    }
    blocks.truncate(known);
  }
}

}  // namespace joints
