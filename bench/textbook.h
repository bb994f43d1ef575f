// The textbook's loop: a class per joint, set up once per step, one virtual call per joint and
// iteration, small matrices by GLM. The faster loops are compared with it. Beside it the same
// hinges in one array, without the virtual call.
#pragma once

#include "engine/world.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A joint that solves itself.
class TextbookJoint {
 public:
  virtual ~TextbookJoint() = default;
  /// Computes everything that does not depend on the velocities. \param h step [s]
  virtual void set_up(real h) = 0;
  /// One solve of all its rows.
  virtual void solve() = 0;
};

/// The hinge of the thesis: three rows of a point, then two rows of an axis.
class TextbookHinge : public TextbookJoint {
 public:
  /// Between two bodies at their present poses. \param anchor [m] \param axis unit \param beta [1]
  TextbookHinge(Body& body1, Body& body2, const vec3& anchor, const vec3& axis, real beta);
  void set_up(real h) override;
  void solve() override;
  /// The same without a call: always inlined.
  [[gnu::always_inline]] void solve_here();

 private:
  Body &body1_, &body2_;
  vec3 anchor1_, anchor2_, axis1_, b_, c_;  // [body space]
  real beta_;
  vec3 r1_, r2_, ba_, ca_, point_bias_;  // r1, r2; b x a1, c x a1; beta C/h
  mat3 I1_, I2_, inverse_K_;
  real axis_inverse_K_[3] = {}, axis_bias_[2] = {};  // of the two axis rows: xx, xy, yy
};

/// Sequential Impulses over textbook joints.
class TextbookSolver {
 public:
  int iterations = 30;       ///< iterations per step
  bool recompute = false;    ///< set up in every iteration: the cost of not hoisting
  std::vector<std::unique_ptr<TextbookJoint>> joints;  ///< in the order in which they are solved
  void step(World& world, real h);  ///< \param h step [s]
};

/// The same hinges by value in one array, solved without any call.
class FlatSolver {
 public:
  int iterations = 30;                ///< iterations per step
  std::vector<TextbookHinge> hinges;  ///< in the order in which they are solved
  void step(World& world, real h);    ///< \param h step [s]
};

}  // namespace joints::bench
/// @}
