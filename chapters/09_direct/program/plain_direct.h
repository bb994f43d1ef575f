// A direct solver without bounds, on one screen: the functions of the exercises and what lies
// between them. Read it; there is nothing to edit here.
#pragma once

#include "chapters/09_direct/joint_matrix.h"

/// \addtogroup chapter9
/// @{
namespace joints::chapter9 {

/// Solves all rows as equations.
class PlainDirect : public Solver {
 public:
  PivotInverse inverse = inverse_pivot;  ///< what 1 / pivot is
  int newton = 0;                        ///< iterations on the positions at most
  std::vector<double> largest;  ///< |C| before each of them in the last step, and after the last

  void check() const override {}
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  void warm_start(Bodies&, real) override {}
  void solve(Bodies& bodies) override;
  void advance(Bodies& bodies, real h, const Append& append) override;

 private:
  class Poses;
  void place(const Bodies& bodies, const Block& block);
  void change_rates(Bodies& bodies, std::vector<double>& rates) const;

  const Blocks* blocks_ = nullptr;
  JointMatrixMaker maker_;
  std::vector<BlockPattern> pattern_;
  std::vector<HalfRow> J_, response_;
  std::vector<double> bias_, x_;
  std::vector<Body> start_;
};

}  // namespace joints::chapter9
/// @}
