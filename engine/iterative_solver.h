// What iterative solvers share: the preparation of the blocks, once per step, and the warm start.
#pragma once

#include "engine/solver.h"

/// \addtogroup rows
/// @{
namespace joints {

/// What the inner loop reads of a row in addition to J.
struct PreparedRow {
  real bias;  ///< minus the wanted J V [unit of C per s]
  /// Kinv[i][last] / Kinv[last][last]: the change of this row's impulse per unit by which the
  /// bounds change the impulse of the block's last row.
  real clamp_response;
  vec3 response_w1, response_w2;  ///< I1^-1 J_w1^T, I2^-1 J_w2^T: angular half of M^-1 J^T
};

/// What the inner loop reads of a block.
struct PreparedBlock {
  int body1, body2;        ///< slots
  int rows;                ///< 1 to 6
  int first, first_K;      ///< its first row in Blocks::J and Prepared::rows; first number of K^-1
  Touches touches;         ///< which velocities it reads and changes
  signed char follows;     ///< RowTarget::follows: if not 0, `upper` is a factor, `lower` not read
  real mass_scale, impulse_scale;  ///< for soft rows; without relaxation 1 and 0 for hard ones
  real lower, upper;       ///< bounds of the last row's accumulated impulse [N s or N m s]
  real* impulse;           ///< the accumulated impulses, owned by the joint
  int followed = -1;       ///< if `follows` is not 0, the row whose impulse bounds this one
};

/// The prepared blocks of a step: bias, scales, bounds and the inverse of K, all for this h.
struct Prepared {
  std::vector<PreparedBlock> blocks;  ///< in the order of Blocks::list
  std::vector<PreparedRow> rows;      ///< one for each of Blocks::J
  std::vector<real> inverse_K;        ///< rows x rows numbers per block
};

/// @}
/// \addtogroup world
/// @{

/// A solver that solves one block after the other, in several iterations. solve() of the derived
/// class chooses the order of the blocks and the form in which their numbers are stored. For every
/// block it adds dlambda = -mass_scale K^-1 (J V + bias) - impulse_scale lambda to the accumulated
/// impulses, clamps the last one to its bounds (-+upper times impulse[follows], if follows is not
/// 0), changes the other rows by clamp_response for each unit that was cut, and changes the
/// velocities: SequentialImpulses::solve_block is the reference. Both scales hold the relaxation.
class IterativeSolver : public Solver {
 public:
  int iterations = 30;  ///< over all blocks, per solve()
  real relaxation = 1;  ///< over-relaxation: a factor of every impulse change [1]; stable below 2

  void check() const override;
  /// \throws std::invalid_argument if a bound follows an impulse that no row has
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  /// Zeroes the impulse of a row whose Jacobian is zero or that depends on others of its block.
  void warm_start(Bodies& bodies, real ratio) override;

 protected:
  Prepared prepared_;  ///< all blocks of the step so far
  /// The blocks of the last prepare(). \throws std::logic_error if it was called with other bodies,
  /// or if rows were appended or removed since
  const Blocks& blocks_of(const Bodies& bodies) const;

 private:
  virtual bool rows_apart() const { return false; }  // true: each row is a block of its own
  void add(const Bodies& bodies, const Block& block, int from, int to, real h);
  int followed_row(std::size_t k) const;

  const Bodies* bodies_ = nullptr;
  const Blocks* blocks_ = nullptr;
};

}  // namespace joints
/// @}
