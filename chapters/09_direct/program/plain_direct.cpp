// The direct solver without bounds. Read it; there is nothing to edit here.
#include "chapters/09_direct/program/plain_direct.h"

#include <algorithm>
#include <cmath>

namespace joints::chapter9 {

namespace {

Triple<double> triple_of(const vec3& a) { return {double(a.x), double(a.y), double(a.z)}; }
vec3 vec3_of(const Triple<double>& a) { return vec3(real(a.x), real(a.y), real(a.z)); }

}  // namespace

// The halves of a block's rows: of body 1, then of body 2.
void PlainDirect::place(const Bodies& bodies, const Block& block) {
  for (int i = 0; i < block.rows; ++i) {
    const Row& J = blocks_->J[block.first + i];
    const auto half = [&](int slot, const vec3& v, const vec3& w, int at) {
      const Body& body = bodies.at(slot);
      J_[at] = {triple_of(v), triple_of(w)};
      response_[at] = {triple_of(body.inverse_mass * v), triple_of(inverse_inertia(body) * w)};
    };
    half(block.body1, J.v1, J.w1, 2 * block.first + i);
    half(block.body2, J.v2, J.w2, 2 * block.first + block.rows + i);
  }
}

void PlainDirect::prepare(const Bodies& bodies, const Blocks& blocks, int, real h) {
  blocks_ = &blocks;
  pattern_.clear();
  for (std::vector<HalfRow>* halves : {&J_, &response_}) halves->resize(2 * blocks.C.size());
  for (std::vector<double>* rows : {&bias_, &x_}) rows->resize(blocks.C.size());
  const auto moving = [&](int slot) { return bodies.at(slot).is_static() ? -1 : slot; };
  for (const Block& block : blocks.list) {
    pattern_.push_back({block.rows, block.first, moving(block.body1), moving(block.body2)});
    place(bodies, block);
    for (int i = 0; i < block.rows; ++i)
      bias_[block.first + i] =
          double(bias(block, i, blocks.C[block.first + i], feedback(block.target, h).rate, h));
    std::fill_n(block.impulse, block.rows, real(0));
  }
  maker_.follow(pattern_, int(blocks.C.size()));
  maker_.assemble(J_, response_);
  for (std::size_t k = 0; k < pattern_.size(); ++k)
    for (int i = 0; i < pattern_[k].rows; ++i)
      maker_.A.original[pattern_[k].row + i] =
          maker_.A.numbers[maker_.diagonal(int(k)) + i * (pattern_[k].rows + 1)];
  factor(maker_.A, inverse);
}

// A lambda = rates, and V += M^-1 J^T lambda: with M^-1 J^T as it was when the step began, since
// Newton's method calls this while the bodies are at their new poses.
void PlainDirect::change_rates(Bodies& bodies, std::vector<double>& rates) const {
  joints::solve(maker_.A, rates.data());
  const auto push = [&](int slot, const HalfRow& response, double lambda) {
    bodies.at(slot).v += vec3_of(lambda * response.v);
    bodies.at(slot).w += vec3_of(lambda * response.w);
  };
  for (const Block& block : blocks_->list)
    for (int i = 0; i < block.rows; ++i) {
      const double lambda = rates[block.first + i];
      push(block.body1, response_[2 * block.first + i], lambda);
      push(block.body2, response_[2 * block.first + block.rows + i], lambda);
      block.impulse[i] += real(lambda);
    }
}

void PlainDirect::solve(Bodies& bodies) {
  for (const Block& block : blocks_->list)
    for (int i = 0; i < block.rows; ++i)
      x_[block.first + i] = -bias_[block.first + i] -
                            double(row_velocity(blocks_->J[block.first + i],
                                                bodies.at(block.body1), bodies.at(block.body2)));
  change_rates(bodies, x_);  // Eq. 9-1
}

class PlainDirect::Poses : public Corrector {
 public:
  Poses(PlainDirect& solver, Bodies& bodies, const Append& append)
      : solver_(solver), bodies_(bodies), append_(append) {}
  std::vector<double>& errors() override {
    Blocks now;
    now.errors_only = true;
    append_(now);
    double most = 0;
    for (std::size_t i = 0; i < now.C.size(); ++i) {
      solver_.x_[i] = double(now.C[i]);
      most = std::max(most, std::abs(solver_.x_[i]));
    }
    solver_.largest.push_back(most);
    return solver_.x_;
  }
  void change_rates(std::vector<double>& rates) override { solver_.change_rates(bodies_, rates); }

 private:
  PlainDirect& solver_;
  Bodies& bodies_;
  const Append& append_;
};

void PlainDirect::advance(Bodies& bodies, real h, const Append& append) {
  largest.clear();
  if (newton == 0) return integrate_poses(bodies, h);
  std::vector<Body> before(bodies.data(), bodies.data() + bodies.slots());
  Poses poses(*this, bodies, append);
  if (move_onto_constraints(bodies, double(h), newton, poses, start_)) return;
  std::copy(before.begin(), before.end(), bodies.data());
  integrate_poses(bodies, h);
}

}  // namespace joints::chapter9
