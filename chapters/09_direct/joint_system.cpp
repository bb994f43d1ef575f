// A system of joints: the pattern of its matrix, its numbers and its factor, and corrections of the
// velocities.
#include "chapters/09_direct/joint_system.h"

#include <algorithm>

#include "chapters/09_direct/block_kernels.h"
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
}  // namespace

// ---- the pattern --------------------------------------------------------------------------------

// Puts the blocks of each link into nodes of up to six rows.
void JointSystem::make_nodes() {
  A.nodes.clear();
  columns_.clear();
  first_.clear();
  int row = 0;
  for (SystemBlock& block : blocks) {
    const bool is_first = block.place == int(first_.size());
    if (is_first) first_.push_back(int(columns_.size()));
    if (is_first || A.nodes.back().rows + block.rows > most_rows) {
      A.nodes.push_back({0, row, 0, 0});
      columns_.push_back(block.columns);
    }
    block.node = int(columns_.size()) - 1;
    block.first = A.nodes.back().rows;
    A.nodes.back().rows += block.rows;
    row += block.rows;
  }
  first_.push_back(int(columns_.size()));
}

bool JointSystem::coupled(int node, int other) const {
  for (const int one : columns_[node])
    for (const int two : columns_[other])
      if (one == two && moves[one]) return true;
  return false;
}

// Places nodes and edges, including the edges of fill-in.
void JointSystem::lay_out(const EliminationPlan& plan) {
  make_nodes();
  A.edges.clear();
  multiplications_ = fill_ = 0;
  int numbers = 0;
  for (int place = 0, k = 0; place + 1 < int(first_.size()); ++place)
    for (; k < first_[place + 1]; ++k) {
      Node& node = A.nodes[k];
      const int n = node.rows;
      node.diagonal = numbers, node.first_edge = int(A.edges.size());
      numbers += n * n;
      int below = 0;
      const auto add_edges = [&](int from, int end) {
        for (int to = from; to < end; ++to) {
          const int m = A.nodes[to].rows;
          A.edges.push_back({to, numbers});
          numbers += m * n;
          below += m;
          if (!coupled(k, to)) fill_ += m * n;
        }
      };
      add_edges(k + 1, first_[place + 1]);
      for (const int later : plan.later[place]) add_edges(first_[later], first_[later + 1]);
      multiplications_ += n * (n + below) * (n + below) / 2.0;
    }
  const int rows = A.nodes.back().row + A.nodes.back().rows;
  A.nodes.push_back({0, rows, numbers, int(A.edges.size())});
  zeros(A.numbers, std::size_t(numbers));
  for (std::vector<double>* list : {&A.original, &x, &wanted_, &impulse})
    zeros(*list, std::size_t(rows));
  zeros(J_, std::size_t(2 * rows));
  zeros(masses_, bodies.size());
  zeros(velocities_, bodies.size());
  zeros(softness_, blocks.size());
  A.targets.clear();
  for (std::size_t k = 0; k < columns_.size(); ++k)
    for (int j = A.nodes[k].first_edge; j < A.nodes[k + 1].first_edge; ++j)
      for (int i = j; i < A.nodes[k + 1].first_edge; ++i)
        A.targets.push_back(at(A.edges[i].to, A.edges[j].to));
}

// Where the block between two nodes begins. \param later, earlier places in the order
int JointSystem::at(int later, int earlier) const {
  if (later == earlier) return A.nodes[earlier].diagonal;
  const auto begin = A.edges.begin() + A.nodes[earlier].first_edge;
  const auto end = A.edges.begin() + A.nodes[earlier + 1].first_edge;
  return std::lower_bound(begin, end, later, [](const Edge& edge, int to) {
           return edge.to < to;
         })->at;
}

// ---- from bodies and blocks, and back -----------------------------------------------------------

void JointSystem::prepare(const Blocks& given, const real* expected, real h) {
  bounded.clear();
  bounded.reserve(blocks.capacity());
  factored = springs_ = loops_ = false;
  passes = wrong = 0;
  const real acting = given.duration_or(h);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Block& block = given.list[blocks[k].block];
    set_rows(blocks[k], &given.J[block.first]);
    const SoftCoefficients target = soft_coefficients(block.settings, h, acting);
    softness_[k] = double(target.softness);
    springs_ = springs_ || softness_[k] > 0;
    loops_ = loops_ || blocks[k].loop >= 0;
    const int row = row_of(blocks[k]);
    for (int i = 0; i < block.rows; ++i) {
      wanted_[row + i] = (expected ? double(expected[blocks[k].row + i]) : 0) -
                         double(bias(block, i, given.C[block.first + i], target.bias_rate, h));
      impulse[row + i] = double(block.impulse[i]);
    }
    if (!blocks[k].bounded) continue;
    const int last = row + block.rows - 1;
    BoundedRow bound{int(k), double(acting * block.settings.lower),
                     double(acting * block.settings.upper), -wanted_[last]};
    const double before = impulse[last];  // of the last step
    bound.side = before <= bound.lower   ? Side::lower
                 : before >= bound.upper ? Side::upper
                                         : Side::free;
    bounded.push_back(bound);
  }
}

void JointSystem::set_rows(const SystemBlock& block, const Row* rows) {
  HalfRow* const one = half(block.node, 0) + block.first;
  HalfRow* const two = half(block.node, 1) + block.first;
  for (int i = 0; i < block.rows; ++i) {
    one[i] = {glm::dvec3(rows[i].v1), glm::dvec3(rows[i].w1)};
    two[i] = {glm::dvec3(rows[i].v2), glm::dvec3(rows[i].w2)};
  }
}

void JointSystem::set_mass(int column, const Body& body) {
  glm::dmat3 I(inverse_inertia(body));  // not quite symmetric where real is float, but A has to be
  I[0][1] = I[1][0], I[0][2] = I[2][0], I[1][2] = I[2][1];
  masses_[column] = {double(body.inverse_mass), I};
}

void JointSystem::load(const Bodies& all) {
  for (std::size_t k = 0; k < bodies.size(); ++k)
    velocities_[k] = {glm::dvec3(all.at(bodies[k]).v), glm::dvec3(all.at(bodies[k]).w)};
}

void JointSystem::store(Bodies& all) const {
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (moves[k]) {
      all.at(bodies[k]).v = vec3(velocities_[k].v);
      all.at(bodies[k]).w = vec3(velocities_[k].w);
    }
}

void JointSystem::store_impulses(const Blocks& given) const {
  for (const SystemBlock& block : blocks)
    for (int i = 0; i < block.rows; ++i)
      given.list[block.block].impulse[i] = real(impulse[row_of(block) + i]);
}

void JointSystem::start(double ratio) {
  for (double& one : impulse) one *= ratio;
  for (std::size_t k = 0; k < columns_.size() && ratio != 0; ++k)
    push(int(k), &impulse[A.nodes[k].row]);
}

// ---- the factor ---------------------------------------------------------------------------------

// Every two halves at the same moving body couple their nodes.
void JointSystem::assemble() {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const Node &node = A.nodes[k], &next = A.nodes[k + 1];
    std::fill(&A.numbers[node.diagonal], A.numbers.data() + next.diagonal, 0.0);
    for (const int of : {0, 1}) {
      const int column = columns_[k][of], n = node.rows;
      if (!moves[column]) continue;
      const HalfRow* const own = half(int(k), of);
      add_coupling(own, n, own, n, masses_[column], &A.numbers[node.diagonal]);
      for (int j = node.first_edge; j < next.first_edge; ++j)
        for (const int other : {0, 1}) {
          const auto& [to, at] = A.edges[j];
          if (columns_[to][other] == column)
            add_coupling(half(to, other), A.nodes[to].rows, own, n, masses_[column],
                         &A.numbers[at]);
        }
    }
  }
}

// A row at its bound gets no impulse from the factor, since its diagonal entry is infinite.
void JointSystem::factor_now() {
  assemble();
  for (BoundedRow& row : bounded) {
    const bool free = row.side == Side::free;
    row.softness = free ? bound_softness * diagonal_of(row) : 0;
    diagonal_of(row) += free ? row.softness : infinite;
  }
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const SystemBlock& block = blocks[k];
    for (int i = 0; softness_[k] > 0 && i < block.rows; ++i)
      for (int j = 0; j <= i; ++j) *(&diagonal(block, i) - j) *= 1 + softness_[k];
    for (int i = 0; block.loop >= 0 && i < block.rows - block.bounded; ++i)
      diagonal(block, i) *= 1 + softening;
  }
  note_diagonal();
  factor(A, inverse);
  factored = true;
}

void JointSystem::note_diagonal() {
  for (const SystemBlock& block : blocks)
    for (int i = 0; i < block.rows; ++i)
      A.original[row_of(block) + i] = (block.loop < 0 ? of_open_chains : 1) * diagonal(block, i);
}

bool JointSystem::is_below(double fraction, const SystemBlock& block, int i) const {
  const Node& node = A.nodes[block.node];
  const double pivot = A.numbers[node.diagonal + (block.first + i) * (node.rows + 1)];  // inverse
  return pivot == 0 || pivot * A.original[row_of(block) + i] * fraction > 1;
}

int JointSystem::rows_below(double fraction, const SystemBlock& block) const {
  int count = 0;
  for (int i = 0; i < block.rows; ++i) count += is_below(fraction, block, i);
  return count;
}

int JointSystem::dependent() const {
  int count = 0;
  for (const SystemBlock& block : blocks)
    count += rows_below(block.loop < 0 ? 0 : of_softening * softening, block);
  for (const BoundedRow& row : bounded) count -= row.side != Side::free;
  return count;
}

// ---- corrections --------------------------------------------------------------------------------

// Changes the velocities by impulses of a node.
void JointSystem::push(int node, const double* by) {
  with_size(A.nodes[node].rows, [&](auto n) {
    const HalfRow* rows = half(node, 0);
    for (const int column : columns_[node]) {
      HalfRow sum{};  // J^T times the impulses
      for (int i = 0; i < n; ++i, ++rows) sum.v += by[i] * rows->v, sum.w += by[i] * rows->w;
      velocities_[column].v += masses_[column].linear * sum.v;
      velocities_[column].w += masses_[column].angular * sum.w;
    }
  });
}

// J V of a node.
void JointSystem::rates_of(int node, double* out) const {
  const HalfRow& one = velocities_[columns_[node][0]];
  const HalfRow& two = velocities_[columns_[node][1]];
  with_size(A.nodes[node].rows, [&](auto n) {
    const HalfRow* a = &J_[2 * A.nodes[node].row];
    const HalfRow* b = a + n;
    for (int i = 0; i < n; ++i, ++a, ++b)
      out[i] = (dot(a->v, one.v) + dot(a->w, one.w)) + (dot(b->v, two.v) + dot(b->w, two.w));
  });
}

double JointSystem::rate(const SystemBlock& block, const Row& row) const {
  const HalfRow& one = velocities_[block.columns[0]];
  const HalfRow& two = velocities_[block.columns[1]];
  return dot(glm::dvec3(row.v1), one.v) + dot(glm::dvec3(row.w1), one.w) +
         dot(glm::dvec3(row.v2), two.v) + dot(glm::dvec3(row.w2), two.w);
}

void JointSystem::change() {
  joints::solve(A, x.data());
  if (inside_) stay_inside();
  for (std::size_t row = 0; row < x.size(); ++row) impulse[row] += x[row];
  for (std::size_t k = 0; k < columns_.size(); ++k) push(int(k), &x[A.nodes[k].row]);
}

// Makes the remaining errors of all free rows zero.
void JointSystem::correct() {
  for (std::size_t k = 0; k < columns_.size(); ++k) rates_of(int(k), &x[A.nodes[k].row]);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = wanted_[i] - x[i];
  for (std::size_t k = 0; springs_ && k < blocks.size(); ++k) {
    if (softness_[k] == 0) continue;
    const SystemBlock& block = blocks[k];
    const int n = block.rows, row = row_of(block);
    double K[36] = {};
    for (const int of : {0, 1}) {
      const HalfRow* const rows = half(block.node, of) + block.first;
      add_coupling(rows, n, rows, n, masses_[block.columns[of]], K);
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) x[row + i] -= softness_[k] * K[i * n + j] * impulse[row + j];
  }
  for (const BoundedRow& bound : bounded) {
    const int last = last_row(bound);
    x[last] = bound.side == Side::free ? x[last] - bound.softness * impulse[last] : 0;
  }
  change();
}

}  // namespace joints
