// The two bodies of a joint, as indices. A separate header, so that exercise 7.3 does not include
// the engine's graph colouring.
#pragma once

/// \addtogroup world
/// @{
namespace joints {

/// The indices of the two bodies of a joint or block.
struct BodyPair {
  int body1 = 0;  ///< index of body 1
  int body2 = 0;  ///< index of body 2
  bool operator==(const BodyPair&) const = default;  ///< the same bodies in the same roles
};

}  // namespace joints
/// @}
