// A joint with one free coordinate: the common base of hinge and slider. Given: there is nothing to
// edit here.
#pragma once

#include "engine/parts/part.h"
#include "joints/free_coordinate.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// Two rigid parts, and a free coordinate with everything that acts on it. Its blocks are in the
/// order drives, limit, rigid rows, because the block that is solved last is satisfied best. With
/// `whole` the rigid rows are one block, and the limit is its last row.
template <class First, class Second, class Coordinate>
class DrivenJoint : public Joint,
                    public FreeCoordinate<Coordinate>,
                    private Composite<First, Second> {
  using Free = FreeCoordinate<Coordinate>;
  using Rigid = Composite<First, Second>;

 public:
  using Rigid::first;   ///< a rigid part
  using Rigid::second;  ///< the other rigid part
  bool whole = true;  ///< one block for all rigid rows and the limit; false: one for each part

  /// The forces of the rigid rows in the last step [N or N m], first part, then second.
  Vector<Rigid::rows> forces() const {
    Vector<Rigid::rows> out;
    for (int i = 0; i < Rigid::rows; ++i) out[i] = mean_force(impulse_[i]);
    return out;
  }

  /// Validates the bodies, beta, and the two rigid parts by their check().
  void check_input(const Bodies& bodies) const override {
    Joint::check_input(bodies);
    check(first);
    check(second);
  }
  /// Measures the coordinate again after position projection.
  void after_projection(const Bodies& bodies) override { Free::after_projection(bodies); }
  /// Appends the blocks of drives, limit and rigid rows that are live.
  void append(const Bodies& bodies, Blocks& blocks) const override {
    const auto add = [&](const auto& part, const RowSettings& target, int place) {
      blocks.append(bodies, body1, body2, part, target, &impulse_[place]);
    };
    Free::append_drives(bodies, blocks);
    if (!whole) {
      Free::append_limit(bodies, blocks);
      add(first, hold(), 0);
      add(second, hold(), First::rows);
    } else if (Free::limited_now()) {
      add(Composite<Rigid, Limit<Coordinate>>{*this, Free::limit()}, Free::limit_target(), 0);
    } else {
      add(static_cast<const Rigid&>(*this), hold(), 0);
    }
    Free::append_late(bodies, blocks);
  }
  /// Appends a limit that the new velocities would pass within this step.
  void activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) override {
    Free::late(bodies, h, blocks);
  }
  /// Reports a limit if one is set, and a motor if anything drives or brakes the coordinate.
  Stats stats() const override {
    Stats out;
    Free::report(out);
    return out;
  }

 protected:
  /// Chooses the rows of a step. \param h step [s]
  void update_active_rows(const Bodies& bodies, real h) override {
    Free::choose(bodies, h);
  }
  /// Between two static bodies: no row is live.
  void deactivate() override {
    impulse_ = {};
    Free::drop();
  }
  /// Saves or restores the coordinate and the impulses.
  void serialize(StateStream& stream) override {
    Free::serialize(stream);
    stream(impulse_);
  }
  /// Makes the joint from its parts.
  DrivenJoint(BodyId body1, BodyId body2, const First& first, const Second& second,
              const Coordinate& coordinate)
      : Joint(body1, body2), Free(*this, coordinate), Rigid{first, second} {
    Free::keep_limit_impulse(impulse_[Rigid::rows]);
  }

 private:
  // Of the rigid rows, then of the limit; written by the solver through the blocks.
  mutable Vector<Rigid::rows + 1> impulse_{};
};

}  // namespace joints
/// @}
