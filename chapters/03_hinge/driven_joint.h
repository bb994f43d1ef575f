// A joint with one free coordinate: the common base of hinge and slider. Given: there is nothing to
// edit here.
#pragma once

#include "chapters/03_hinge/free_coordinate.h"
#include "engine/composite.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// Two rigid parts, and a free coordinate with everything that acts on it. Its blocks are in the
/// order drives, limit, rigid rows, because the block that is solved last is satisfied best. With
/// `whole` the rigid rows are one block, and the limit is its last row.
template <class First, class Second, class Coordinate>
class DrivenJoint : public Joint, public FreeCoordinate<Coordinate> {
 public:
  First first;        ///< a rigid part
  Second second;      ///< the other rigid part
  bool whole = true;  ///< one block for all rigid rows and the limit; false: one for each part

  /// The forces of the rigid rows in the last step [N or N m], first part, then second.
  Vector<First::rows + Second::rows> forces() const {
    Vector<First::rows + Second::rows> out;
    for (int i = 0; i < limit_place; ++i) out[i] = mean_force(impulse_[i]);
    return out;
  }

  /// Validates the bodies, beta, and the two rigid parts by their check().
  void check_input(const Bodies& bodies) const override {
    Joint::check_input(bodies);
    check(first);
    check(second);
  }
  /// Measures the coordinate again after position projection.
  void moved(const Bodies& bodies) override { Free::moved(bodies); }
  /// Appends the blocks of drives, limit and rigid rows that are live.
  void append(const Bodies& bodies, Blocks& blocks) const override {
    const auto add = [&](const auto& part, const RowTarget& target, int place) {
      blocks.append(bodies, body1, body2, part, target, &impulse_[place]);
    };
    const bool used = Free::in_use();
    if (used) Free::append_drives(bodies, blocks);
    const bool limited = used && Free::limited_now();
    if (!whole) {
      Free::append_limit(bodies, blocks);
      add(first, hold(), 0);
      add(second, hold(), First::rows);
    } else if (limited) {
      add(Composite<Composite<First, Second>, Limit<Coordinate>>{{first, second}, Free::limit()},
          Free::limit_target(), 0);
    } else {
      add(Composite<First, Second>{first, second}, hold(), 0);
    }
    if (used) Free::append_late(bodies, blocks);
  }
  /// Appends a limit that the new velocities would pass within this step.
  void late_limits(const Bodies& bodies, real h, Blocks& blocks) override {
    if (Free::in_use()) Free::late(bodies, h, blocks);
  }
  /// Reports a limit if one is set, and a motor if anything drives or brakes the coordinate.
  Extras extras() const override {
    Extras out;
    Free::report(out);
    return out;
  }

 protected:
  /// Chooses the rows of a step. \param h step [s]
  void choose_rows(const Bodies& bodies, real h) override {
    if (Free::in_use()) Free::choose(bodies, h);
  }
  /// Between two static bodies: no row is live.
  void drop_rows() override {
    impulse_ = {};
    Free::drop();
  }
  /// Saves or restores the coordinate and the impulses.
  void exchange_own(StateStream& stream) override {
    Free::exchange(stream);
    stream(impulse_);
  }
  /// Makes the joint from its parts.
  DrivenJoint(BodyId body1, BodyId body2, const First& first, const Second& second,
              const Coordinate& coordinate)
      : Joint(body1, body2), Free(*this, coordinate), first(first), second(second) {
    Free::keep_limit_impulse(impulse_[limit_place]);
  }

 private:
  using Free = FreeCoordinate<Coordinate>;
  static constexpr int limit_place = First::rows + Second::rows;  // after the rigid rows
  mutable Vector<limit_place + 1> impulse_{};  // written by the solver through the blocks
};

}  // namespace joints
/// @}
