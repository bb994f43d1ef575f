// Added inertia: which forces pull at a body, and what the step has to add for them.
#include "direct/added_inertia.h"

#include <algorithm>
#include <cmath>

namespace joints {

void AddedInertia::begin(int slots, real kappa, real h) {
  kappa_ = kappa, h_ = h;
  if (used()) now_.assign(std::size_t(slots), Pulled{});
}

void AddedInertia::add(const Bodies& bodies, const Blocks& blocks, JointIslands& islands,
                       SolverMemory& memory) {
  memory.inertia.resize(now_.size());
  find(blocks.last_impulse_duration, blocks, islands, now_);
  for (int slot = 0; slot < bodies.slots(); ++slot)
    slow_down(bodies.at(slot), slot, memory);
}

void AddedInertia::find_next(const Blocks& blocks, JointIslands& islands) {
  next_.assign(now_.size(), Pulled{});
  find(blocks.impulse_duration, blocks, islands, next_);
}

bool AddedInertia::jumped(const Body& body, int slot) const {
  const real follows = kappa_ * h_ * h_;
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const real least = std::min({moments.x, moments.y, moments.z});
  return follows * next_[slot].force_lever > 2 * std::max(follows * now_[slot].force_lever, least);
}

void AddedInertia::add_next(const Body& body, int slot, const SolverMemory& memory) {
  now_[slot] = next_[slot];
  slow_down(body, slot, memory);
}

void AddedInertia::remember(SolverMemory& memory) const {
  for (std::size_t slot = 0; slot < now_.size(); ++slot)
    memory.inertia[slot] = kappa_ * h_ * h_ * now_[slot].force_lever;
}

void AddedInertia::slow_down(const Body& body, int slot, const SolverMemory& memory) {
  auto& [force_lever, slow] = now_[slot];
  if (body.is_static()) force_lever = 0;
  if (force_lever > 0) slow = slowed(body, force_lever, memory.inertia[slot], kappa_, h_);
}

// |F||r| of each body, from impulses that acted for the time `acted`. The length of a lever follows
// from the rows of its block: the squares of the three rows of a point add up to 2 |r|^2.
void AddedInertia::find(real acted, const Blocks& blocks, JointIslands& islands,
                        std::vector<Pulled>& of) {
  if (acted == 0) return;  // there was no step yet
  for (const int k : islands.order()) {
    const Island& island = islands.list[islands.at(k).island];
    if (island.left) continue;
    const int loop = island.system.blocks[islands.at(k).block].loop;
    if (loop >= 0 && island.plan->list[loop].motions(island.dependent[loop]) <= 1) continue;
    const Block& block = blocks.list[k];
    vec3 F(0);
    real square1 = 0, square2 = 0;
    for (int i = 0; i < block.rows; ++i) {
      const Row& J = blocks.J[block.first + i];
      if (J.v2 == vec3(0)) continue;
      F += block.impulse[i] / acted * J.v2;
      square1 += dot(J.w1, J.w1) / 2;
      square2 += dot(J.w2, J.w2) / 2;
    }
    const real force = length(F);
    for (const auto& [slot, square] : {std::pair{block.body1, square1}, {block.body2, square2}})
      of[slot].force_lever += force * std::sqrt(square);
  }
}

// Only if the number of rows does not decide this, a factor of A is computed to find the dependent
// rows.
void AddedInertia::find_tight_loops(Island& island) const {
  JointSystem& system = island.system;
  const std::vector<ClosedLoop>& loops = island.plan->list;
  island.dependent.assign(loops.size(), 0);
  if (std::none_of(loops.begin(), loops.end(),
                   [](const ClosedLoop& loop) { return loop.motions(0) <= 1; }))
    return;
  system.assemble();
  for (const BoundedRow& row : system.bounded)
    system.diagonal_of(row) = JointSystem::infinite;
  system.note_diagonal();
  factor(system.A, inverse_pivot);
  system.factored = false;
  for (const SystemBlock& block : system.blocks)
    if (block.loop >= 0) island.dependent[block.loop] += system.rows_below(0, block);
  for (const BoundedRow& row : system.bounded)
    if (const int loop = system.blocks[row.block].loop; loop >= 0) --island.dependent[loop];
}

void AddedInertia::set_masses(Island& island, const Bodies& bodies) const {
  for (std::size_t column = 0; column < island.system.bodies.size(); ++column) {
    if (!island.system.moves[column]) continue;
    const int slot = island.system.bodies[column];
    Body body = bodies.at(slot);
    if (adds(slot)) body.inverse_inertia_local = now_[slot].slowed.inverse_inertia_local;
    island.system.set_mass(int(column), body);
  }
}

void AddedInertia::set_inertia(Bodies& bodies) const {
  for (int slot = 0; slot < bodies.slots(); ++slot)
    if (adds(slot))
      bodies.at(slot).inverse_inertia_local = now_[slot].slowed.inverse_inertia_local;
}

}  // namespace joints
