// Added inertia: which forces pull at a body, and what the step has to add for them.
#include "direct/added_inertia.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

namespace joints {

void AddedInertia::begin(int slots, real kappa, real h) {
  kappa_ = kappa, h_ = h;
  if (used()) now_.assign(std::size_t(slots), Pulled{});
}

void AddedInertia::add(const Bodies& bodies, const Blocks& blocks, JointIslands& islands,
                       SolverMemory& memory) {
  memory.inertia.resize(now_.size());
  find(blocks.last_impulse_duration, bodies, blocks, islands, now_);
  for (int slot = 0; slot < bodies.slots(); ++slot)
    slow_down(bodies.at(slot), slot, memory);
}

void AddedInertia::find_next(const Bodies& bodies, const Blocks& blocks, JointIslands& islands) {
  next_.assign(now_.size(), Pulled{});
  find(blocks.impulse_duration, bodies, blocks, islands, next_);
}

bool AddedInertia::jumped(const Body& body, int slot) const {
  const real follows = kappa_ * h_ * h_;
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const vec3 next = follows * next_[slot].force_lever;
  return any(greaterThan(next, real(2) * max(follows * now_[slot].force_lever, moments)));
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
  if (body.is_static()) force_lever = vec3(0);
  if (force_lever != vec3(0)) slow = slowed(body, force_lever, memory.inertia[slot], kappa_, h_);
}

// |F||r| of each body, from impulses that acted for the time `acted`. The length of a lever follows
// from the rows of its block: the squares of the three rows of a point add up to 2 |r|^2.
void AddedInertia::find(real acted, const Bodies& bodies, const Blocks& blocks,
                        JointIslands& islands, std::vector<Pulled>& of) {
  if (acted == 0) return;  // there was no step yet
  vec3 F(0), square1(0), square2(0);
  const std::vector<int>& order = islands.order();
  for (std::size_t n = 0; n < order.size(); ++n) {
    const int k = order[n];
    const Block& block = blocks.list[k];
    const Island& island = islands.list[islands.at(k).island];
    if (island.left || is_lone(island)) continue;
    const int loop = island.system.blocks[islands.at(k).block].loop;
    if ((loop >= 0 && island.plan->list[loop].motions(island.dependent[loop]) <= 1))
      continue;
    for (int i = 0; i < block.rows; ++i) {
      const Row& J = blocks.J[block.first + i];
      if (J.v2 == vec3(0)) continue;
      F += block.impulse[i] / acted * J.v2;
      const vec3 w1 = to_local(bodies.at(block.body1), J.w1);
      const vec3 w2 = to_local(bodies.at(block.body2), J.w2);
      square1 += w1 * w1, square2 += w2 * w2;
    }
    if (n + 1 < order.size()) {
      const Block& next = blocks.list[order[n + 1]];
      if (next.body1 == block.body1 && next.body2 == block.body2) continue;
    }
    const real force = length(F);
    for (const auto& [slot, square] : {std::pair{block.body1, square1}, {block.body2, square2}}) {
      const real lever = std::sqrt((square.x + square.y + square.z) / 2);
      if (lever > 0) of[slot].force_lever += force / lever * square;
    }
    F = square1 = square2 = vec3(0);
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

namespace {

// The motion of an island as a whole.
struct Whole {
  double mass = 0;      // [kg]
  glm::dvec3 centre{0};      // times the mass
  glm::dvec3 p{0};           // momentum [N s]
  glm::dvec3 L{0};           // angular momentum about the origin [N m s]
  glm::dmat3 inertia{0};     // about the origin [kg m^2]

  void add(const Body& body) {
    const double m = 1 / double(body.inverse_mass);
    const glm::dvec3 x(body.x), w(body.w_is_mean ? body.w - body.precession : body.w);
    const glm::dmat3 R = mat3_cast(glm::dquat(body.q));
    const glm::dvec3 moments = 1.0 / glm::dvec3(body.inverse_inertia_local);
    mass += m, centre += m * x, p += m * glm::dvec3(body.v);
    L += cross(x, m * glm::dvec3(body.v)) + R * (moments * (transpose(R) * w));
    inertia += around(m, x);
    for (int i = 0; i < 3; ++i) inertia += moments[i] * outerProduct(R[i], R[i]);
  }
  static glm::dmat3 around(double m, const glm::dvec3& r) {
    return m * (dot(r, r) * glm::dmat3(1) - outerProduct(r, r));
  }
  glm::dvec3 about_centre() const { return L - cross(centre, p) / mass; }
};

}  // namespace

bool AddedInertia::is_free(const Island& island) {
  const std::vector<bool>& moves = island.system.moves;
  return !island.left && !island.alternates &&
         std::find(moves.begin(), moves.end(), false) == moves.end();
}

bool AddedInertia::is_lone(const Island& island) {
  const std::vector<bool>& moves = island.system.moves;
  const auto one = std::find(moves.begin(), moves.end(), true);
  return std::find(one == moves.end() ? one : one + 1, moves.end(), true) == moves.end();
}

void AddedInertia::keep_momentum(const Island& island, const std::vector<Body>& before,
                                 Bodies& bodies) const {
  if (!is_free(island)) return;
  Whole was, is;
  island.for_moving([&](int slot) { was.add(before[slot]), is.add(bodies.at(slot)); });
  const glm::dvec3 centre = is.centre / is.mass;
  const glm::dmat3 inertia = is.inertia - Whole::around(is.mass, centre);
  const glm::dvec3 w = inverse(inertia) * (was.about_centre() - is.about_centre());
  if (!(dot(w, w) < 1 / double(epsilon))) return;  // an overflow, or a body without any moment
  island.for_moving([&](int slot) {
    Body& body = bodies.at(slot);
    body.v += vec3(cross(w, glm::dvec3(body.x) - centre));
    body.w += vec3(w);
  });
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
