// The velocities during the iterations: a record for each body, or columns of them.
#pragma once

#include "engine/body.h"
#include "engine/simd/lane_order.h"
#include "engine/simd/records.h"

/// \addtogroup world
/// @{
namespace joints {

/// The velocities that the iterations change, at the places that an order of the blocks defines.
class BodyRecords {
 public:
  /// Copies the bodies' velocities into the records. \param bodies by slot
  void gather(const LaneOrder& order, const Body* bodies) {
    records_.resize(order.bodies.size());
    each(order, [&](int slot, auto& all, int lane) {
      if (slot < 0) return joints::scatter(Velocities<real>{}, all, lane);
      const Body& from = bodies[slot];
      joints::scatter(Velocities<real>{triple(from.v), from.inverse_mass, triple(from.w), 0}, all,
                      lane);
    });
  }
  /// Copies the velocities back to the bodies that are not static.
  void scatter(const LaneOrder& order, Body* bodies) {
    each(order, [&](int slot, const auto& all, int lane) {
      if (slot < 0) return;
      Body& to = bodies[slot];
      if (to.is_static()) return;
      const auto one = joints::gather<Velocities<real>>(all, lane);
      to.v = vec3(one.v.x, one.v.y, one.v.z);
      to.w = vec3(one.w.x, one.w.y, one.w.z);
    });
  }
  /// For an iteration over the groups from number `first` on.
  BodyView view(const LaneOrder& order, int first = 0) {
    return {records_.data(), order.ends.data() + first * order.ends_of_a_group(), order.columns};
  }

 private:
  // Calls f(slot, record or column, lane) for all records.
  template <class F>
  void each(const LaneOrder& order, const F& f) {
    const int count = int(order.bodies.size());
    const int* const slots = order.bodies.data();
    Velocities<real>* const records = records_.data();
    auto* const columns = reinterpret_cast<Velocities<LaneNumber>*>(records);
    if (order.columns && order.width > 1)
      for (int k = 0; k < count; ++k) f(slots[k], columns[k / lane_count], k % lane_count);
    else
      for (int k = 0; k < count; ++k) f(slots[k], records[k], 0);
  }

  std::vector<Velocities<real>> records_;
};

}  // namespace joints
/// @}
