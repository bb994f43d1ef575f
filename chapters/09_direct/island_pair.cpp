// A pair of islands: its rows, its factor, and corrections of its velocities.
#include "chapters/09_direct/island_pair.h"

#include <algorithm>

#include "engine/kernels.h"

namespace joints {

namespace {
// Bounded rows are softened by this fraction of K, since they may depend on others, as those of a
// motor and a limit do. Until one of them is at its bound, their impulses are inversely
// proportional to it. With float velocities 1e-9 would make them so large that the velocities are
// lost.
constexpr double bound_softness = sizeof(real) == 4 ? 1e-6 : 1e-9;
// In an open chain only the masses make a pivot small, so there its threshold is multiplied by
// this.
constexpr double of_open_chains = 1e-3;
// A row is dependent if its pivot is below this multiple of the softening.
constexpr double of_softening = sizeof(real) == 4 ? 100 : 1000;
constexpr int rounds = 12;  // largest number of corrections in reach()

// Sets one lane.
void put(Triple<TwoLanes>& to, int lane, const vec3& a) {
  to.x[lane] = double(a.x), to.y[lane] = double(a.y), to.z[lane] = double(a.z);
}
vec3 lane_of(const Triple<TwoLanes>& a, int lane) {
  return {real(a.x[lane]), real(a.y[lane]), real(a.z[lane])};
}

}  // namespace

// ---- from bodies and blocks to lanes, and back --------------------------------------------------

void IslandPair::prepare(const Blocks& given, const Correction* corrections, real h) {
  if (is_new) {
    for (std::vector<TwoLanes>* list : {&x, &wanted_, &impulse}) zeros(*list, A.original.size());
    zeros(velocities_, bodies.size());
    J_at_.clear();
  }
  softness_.resize(blocks.size());
  bounded.clear();
  factored = springs_ = false;
  passes = wrong = 0;
  const real acting = given.acts(h);
  for (int k = 0; k < int(blocks.size()); ++k)
    for (const int lane : {0, 1}) {
      softness_[k][lane] = 0;
      if (blocks[k].block[lane] < 0) continue;
      const Block& block = given.list[blocks[k].block[lane]];
      set_rows(k, lane, &given.J[block.first]);
      const StepTarget target = step_target(block.target, h, acting);
      if (target.softness > 0) softness_[k][lane] = double(target.softness), springs_ = true;
      const int last = block.rows - 1, row = row_of(blocks[k]);
      const real* const C = &given.C[block.first];
      static const Correction none[6]{};
      const Correction* const expected = corrections ? corrections + blocks[k].row[lane] : none;
      TwoLanes *const wanted = &wanted_[row], *const own = &impulse[row];
      with_size(block.rows, [&](auto n) {
        for (int i = 0; i < n; ++i) {
          const real by = i < last ? target.rate * C[i] : bias(block, i, C[i], target.rate, h);
          wanted[i][lane] = double(expected[i].next) - double(by);
          own[i][lane] = double(block.impulse[i]);
        }
      });
      if (block.target.lower > -unbounded || block.target.upper < unbounded) {
        BoundedRow bound{k, lane, double(acting * block.target.lower),
                         double(acting * block.target.upper),
                         -wanted[last][lane]};
        const double before = own[last][lane];  // of the last step
        bound.side = before <= bound.lower   ? Side::lower
                     : before >= bound.upper ? Side::upper
                                             : Side::free;
        bounded.push_back(bound);
      }
    }
}

void IslandPair::make_room() {
  IslandMatrix::make_room();
  for (std::vector<TwoLanes>* list : {&x, &wanted_, &impulse}) list->reserve(A.original.capacity());
  softness_.reserve(blocks.capacity());
  bounded.reserve(2 * blocks.capacity());  // one on each lane
}

void IslandPair::set_rows(int block, int lane, const Row* rows) {
  HalfRowOf<TwoLanes>*const one = half(blocks[block], 0), *const two = half(blocks[block], 1);
  const int n = blocks[block].own[lane];
  for (int i = 0; i < n; ++i) put(one[i].w, lane, rows[i].w1), put(two[i].w, lane, rows[i].w2);
  if (nodes[blocks[block].node].form != Form::any) return;  // lay_out() has set unit vectors
  for (int i = 0; i < n; ++i) put(one[i].v, lane, rows[i].v1), put(two[i].v, lane, rows[i].v2);
}

void IslandPair::set_mass(int column, int lane, const Body& body) {
  auto& [linear, angular] = masses[column];
  const mat3 in_world = inverse_inertia(body);
  const Symmetric<real> I = symmetric(in_world);
  linear[lane] = double(body.inverse_mass);
  angular.xx[lane] = double(I.xx), angular.yy[lane] = double(I.yy);
  angular.zz[lane] = double(I.zz), angular.xy[lane] = double(I.xy);
  angular.xz[lane] = double(I.xz), angular.yz[lane] = double(I.yz);
}

void IslandPair::load(const Bodies& all) {
  for (std::size_t k = 0; k < bodies.size(); ++k)
    for (const int lane : {0, 1})
      if (bodies[k][lane] >= 0) {
        put(velocities_[k].v, lane, all.at(bodies[k][lane]).v);
        put(velocities_[k].w, lane, all.at(bodies[k][lane]).w);
      }
}

void IslandPair::store(Bodies& all) const {
  for (std::size_t k = 0; k < bodies.size(); ++k)
    for (const int lane : {0, 1}) {
      if (!moves[k] || bodies[k][lane] < 0) continue;
      Body& body = all.at(bodies[k][lane]);
      body.v = lane_of(velocities_[k].v, lane);
      body.w = lane_of(velocities_[k].w, lane);
    }
}

void IslandPair::store_impulses(const Blocks& given) const {
  for (std::size_t k = 0; k < blocks.size(); ++k)
    for (const int lane : {0, 1}) {
      if (blocks[k].block[lane] < 0) continue;
      real* const to = given.list[blocks[k].block[lane]].impulse;
      const TwoLanes* const from = &impulse[row_of(blocks[k])];
      with_size(blocks[k].own[lane], [&](auto n) {
        for (int i = 0; i < n; ++i) to[i] = real(from[i][lane]);
      });
    }
}

void IslandPair::keep_impulses() { copy_with_room(impulse, kept_impulses_); }

void IslandPair::restore_impulses(int lane) {
  for (std::size_t r = 0; r < impulse.size(); ++r) impulse[r][lane] = kept_impulses_[r][lane];
}

void IslandPair::keep(const Bodies& all, int lane) {
  kept_velocities_.resize(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Body& body = all.at(bodies[k][lane]);
    put(kept_velocities_[k].v, lane, body.v), put(kept_velocities_[k].w, lane, body.w);
  }
  for (std::size_t r = 0; r < impulse.size(); ++r) kept_impulses_[r][lane] = impulse[r][lane];
}

void IslandPair::go_back(Bodies& all, int lane) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (!moves[k]) continue;
    Body& body = all.at(bodies[k][lane]);
    body.v = lane_of(kept_velocities_[k].v, lane), body.w = lane_of(kept_velocities_[k].w, lane);
  }
  restore_impulses(lane);
}

void IslandPair::start(double ratio) {
  for (TwoLanes& one : impulse) one *= ratio;
  for (int k = 0; k < int(nodes.size()) && ratio != 0; ++k) push(k, &impulse[A.nodes[k].row]);
}

// ---- the factor ---------------------------------------------------------------------------------

// The diagonal entries of a bounded row, and of that beside it on the other lane.
TwoLanes& IslandPair::diagonal_of(const BoundedRow& row) {
  return A.numbers[diagonal(blocks[row.block], blocks[row.block].rows - 1)];
}

// A row at its bound gets no impulse from the factor, since its diagonal entry is infinite.
void IslandPair::factor_now() {
  assemble();
  for (BoundedRow& row : bounded) {
    const bool free = row.side == Side::free;
    row.softness = free ? bound_softness * diagonal_of(row)[row.lane] : 0;
    diagonal_of(row)[row.lane] += free ? row.softness : infinite;
  }
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const LaneBlock& block = blocks[k];
    for (int i = 0; springs_ && i < block.rows; ++i)
      for (int j = 0; j <= i; ++j) A.numbers[diagonal(block, i) - j] *= 1 + softness_[k];
    for (int i = 0; block.loop >= 0 && i < block.rows - block.bounded; ++i)
      A.numbers[diagonal(block, i)] *= 1 + softening;
  }
  note_diagonal();
  factor(A, inverse);
  factored = true;
}

// Stores the diagonal before any elimination.
void IslandPair::note_diagonal() {
  for (const LaneBlock& block : blocks) {
    const double fraction = block.loop < 0 ? of_open_chains : 1;
    for (int i = 0; i < block.rows; ++i)
      A.original[row_of(block) + i] = fraction * A.numbers[diagonal(block, i)];
  }
}

bool IslandPair::is_below(double fraction, const LaneBlock& block, int i, int lane) const {
  const double pivot = A.numbers[diagonal(block, i)][lane];  // its inverse
  return pivot == 0 || pivot * A.original[row_of(block) + i][lane] * fraction > 1;
}

int IslandPair::rows_below(double fraction, int block, int lane) const {
  int count = 0;
  for (int i = 0; i < blocks[block].own[lane]; ++i)
    count += is_below(fraction, blocks[block], i, lane);
  return count;
}

int IslandPair::dependent() const {
  int count = 0;
  for (int k = 0; k < int(blocks.size()); ++k)
    for (const int lane : {0, 1})
      if (blocks[k].own[lane] > 0)
        count += rows_below(blocks[k].loop < 0 ? 0 : of_softening * softening, k, lane);
  for (const BoundedRow& row : bounded) count -= row.side != Side::free;
  return count;
}

// Only if the number of rows does not decide this, a factor of A is computed to find the dependent
// rows.
void IslandPair::find_tight_loops() {
  dependent_.assign(plan->loops.size(), {});
  if (std::none_of(plan->loops.begin(), plan->loops.end(),
                   [](const ClosedLoop& loop) { return loop.motions(0) <= 1; }))
    return;
  assemble();
  for (const BoundedRow& row : bounded) diagonal_of(row)[row.lane] = infinite;
  note_diagonal();
  factor(A, inverse_pivot);
  factored = false;
  for (int k = 0; k < int(blocks.size()); ++k)
    for (const int lane : {0, 1})
      if (blocks[k].loop >= 0) dependent_[blocks[k].loop][lane] += rows_below(0, k, lane);
  for (const BoundedRow& row : bounded)
    if (const int loop = blocks[row.block].loop; loop >= 0) --dependent_[loop][row.lane];
}

// ---- corrections --------------------------------------------------------------------------------

// Changes the velocities by impulses of a node.
void IslandPair::push(int node, const TwoLanes* by) {
  const HalfRowOf<TwoLanes>* rows = &J[2 * A.nodes[node].row];
  with_size(A.nodes[node].rows, [&](auto n) {
    for (const int column : nodes[node].columns) {
      HalfRowOf<TwoLanes> sum{};  // J^T times the impulses
      for (int i = 0; i < n; ++i) sum.w += by[i] * rows[i].w;
      for (int i = 0, end = linear_rows(node); i < end; ++i) sum.v += by[i] * rows[i].v;
      rows += n;
      velocities_[column].v += masses[column].linear * sum.v;
      velocities_[column].w += masses[column].angular * sum.w;
    }
  });
}

// J V of a node. \param of J, or that of other poses
void IslandPair::rates_of(int node, const std::vector<HalfRowOf<TwoLanes>>& of,
                          TwoLanes* out) const {
  const HalfRowOf<TwoLanes>* const rows = &of[2 * A.nodes[node].row];
  const HalfRowOf<TwoLanes>& one = velocities_[nodes[node].columns[0]];
  const HalfRowOf<TwoLanes>& two = velocities_[nodes[node].columns[1]];
  with_size(A.nodes[node].rows, [&](auto n) {
    for (int i = 0; i < n; ++i)
      out[i] = joints::dot(rows[i].w, one.w) + joints::dot(rows[n + i].w, two.w);
    for (int i = 0, end = linear_rows(node); i < end; ++i)
      out[i] += joints::dot(rows[i].v, one.v) + joints::dot(rows[n + i].v, two.v);
  });
}

void IslandPair::change() {
  joints::solve(A, x.data());
  if (inside_[0] || inside_[1]) stay_inside();
  for (std::size_t row = 0; row < x.size(); ++row) impulse[row] += x[row];
  for (int k = 0; k < int(nodes.size()); ++k) push(k, &x[A.nodes[k].row]);
}

void IslandPair::reach(const Blocks& at, const std::vector<real>& wanted, double enough) {
  if (J_at_.empty()) J_at_ = J;  // with the unit vectors of points
  J.swap(J_at_);
  for (int k = 0; k < int(blocks.size()); ++k)
    for (const int lane : {0, 1}) {
      if (blocks[k].block[lane] < 0) continue;
      const Block& block = at.list[blocks[k].block[lane]];
      set_rows(k, lane, &at.J[block.first]);
      for (int i = 0; i < block.rows; ++i)
        wanted_[row_of(blocks[k]) + i][lane] = double(wanted[block.first + i]);
    }
  J.swap(J_at_);
  double before = 0;
  for (int n = 0; n < rounds; ++n) {
    for (int k = 0; k < int(nodes.size()); ++k) rates_of(k, J_at_, &x[A.nodes[k].row]);
    TwoLanes most{}, least{};
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = wanted_[i] - x[i];
      most = x[i] > most ? x[i] : most, least = x[i] < least ? x[i] : least;
    }
    const double largest = std::max({most[0], most[1], -least[0], -least[1]});
    if (largest <= enough || (n >= 2 && !(largest < before / 2))) return;
    before = largest;
    change();
  }
}

// Makes the remaining errors of all free rows zero.
void IslandPair::correct() {
  for (int k = 0; k < int(nodes.size()); ++k) rates_of(k, J, &x[A.nodes[k].row]);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = wanted_[i] - x[i];
  for (int k = 0; springs_ && k < int(blocks.size()); ++k) {
    if (softness_[k][0] == 0 && softness_[k][1] == 0) continue;
    const int n = blocks[k].rows, row = row_of(blocks[k]);
    for (int j = 0; j < n; ++j)  // K lambda of a spring
      for (const int of : {0, 1}) {
        const auto& [linear, angular] = masses[blocks[k].columns[of]];
        const HalfRowOf<TwoLanes>* const rows = half(blocks[k], of);
        const HalfRowOf<TwoLanes> response{linear * rows[j].v, angular * rows[j].w};
        for (int i = 0; i < n; ++i)
          x[row + i] -= softness_[k] * impulse[row + j] * dot(rows[i], response);
      }
  }
  for (const BoundedRow& bound : bounded) {
    const int last = last_row(bound);
    const double soft = bound.softness * impulse[last][bound.lane];
    x[last][bound.lane] = bound.side == Side::free ? x[last][bound.lane] - soft : 0;
  }
  change();
}

}  // namespace joints
