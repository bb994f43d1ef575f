// Trees of equal shape side by side. Given, there is nothing to edit here.
#pragma once

#include <array>
#include <span>

#include "engine/simd/triple.h"
#include "reduced/tree.h"

/// \addtogroup reduced
/// @{
namespace joints {

/// Up to lane_count trees of equal shape, whose Runge-Kutta steps are done together: one in each
/// lane. Each tree gets the digits that it has alone.
class Pack {
 public:
  /// Of equal trees. \param trees all \param members which of them
  Pack(std::span<const Tree> trees, std::span<const std::size_t> members);
  /// Moves the members by one step: together if all are Tree::plain(). \param h [s]
  void runge_kutta(std::span<Tree> trees, real h);

 private:
  struct alignas(32) Numbers {  // of all lanes
    std::array<real, lane_count> all;
  };
  std::array<std::size_t, lane_count> members_{};
  int count_ = 0;                       // of the members
  std::vector<Numbers> links_, states_;  // lanes.inl knows what they are
};

/// Sorts trees into packs; one that no other tree resembles is alone in its pack.
std::vector<Pack> packs_of(std::span<const Tree> trees);

}  // namespace joints
/// @}
