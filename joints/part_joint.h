// A joint of a single part and a single block: balls, rods and ropes.
#pragma once

#include <type_traits>

#include "engine/joint.h"
#include "engine/kept/state_stream.h"
#include "engine/parts/part.h"

/// \addtogroup joint
/// @{
namespace joints {

/// A joint of a single part: a type that satisfies the concept joints::Part and has a free function
/// check() that rejects impossible geometry. A free function `P make(std::type_identity<P>, const
/// Body&, const Body&, ...)` in the part's namespace makes the part in the present poses; with it,
/// World::add takes the same arguments after the two bodies.
template <class Part>
class PartJoint : public Joint {
  static_assert(require_part<Part>());
  static_assert(Checked<Part>,
                "this part, and each part of a composite, needs a free function `void check(const "
                "P& part)`, P its type: it throws std::invalid_argument for impossible geometry");

 public:
  Part part;  ///< the geometry; may be changed between steps

  /// Makes it of a part. \throws std::invalid_argument for one body twice, or from check(part)
  PartJoint(BodyId body1, BodyId body2, const Part& part) : Joint(body1, body2), part(part) {
    check(part);
  }
  /// The joint in the present poses: make() makes its part from these arguments, in world space.
  template <class... Arguments>
    requires requires(const Body& body, const Arguments&... arguments) {
      make(std::type_identity<Part>{}, body, body, arguments...);
    }
  PartJoint(const Bodies& bodies, BodyId body1, BodyId body2, const Arguments&... arguments)
      : PartJoint(body1, body2, make(std::type_identity<Part>{}, bodies[body1], bodies[body2],
                                     arguments...)) {}
  /// Validates what every joint has, and the part by its check().
  void check_input(const Bodies& bodies) const override {
    Joint::check_input(bodies);
    check(part);
  }
  /// Appends the block of the part.
  void append(const Bodies& bodies, Blocks& blocks) const override {
    const real lower = Part::one_sided ? real(0) : -unbounded;
    blocks.append(bodies, body1, body2, part, hold(lower), impulse_.data());
  }
  Stats stats() const override { return {.bounded = Part::one_sided}; }  ///< ropes have bounds
  /// The accumulated impulse of each row in the last step [N s, or N m s for an angular row].
  const Vector<Part::rows>& impulse() const { return impulse_; }
  /// The mean force of each row in the last step, impulse / impulse_duration() [N or N m].
  Vector<Part::rows> forces() const {
    Vector<Part::rows> out;
    for (int i = 0; i < Part::rows; ++i) out[i] = mean_force(impulse_[i]);
    return out;
  }

 protected:
  /// Saves or restores the impulses.
  void serialize(StateStream& stream) override { stream(impulse_); }

 private:
  mutable Vector<Part::rows> impulse_{};  // written by the solver through the block
};

}  // namespace joints
/// @}
