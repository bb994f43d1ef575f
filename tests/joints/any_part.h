// Parts of any geometry as joints of their own: the fixtures have made them, nothing is refused.
#pragma once

#include "chapters/03_hinge/driven_joint.h"
#include "chapters/05_fixed/fixed.h"
#include "engine/part_joint.h"

namespace joints {

template <class First, class Second>
void check(const Composite<First, Second>&) {}
inline void check(const RotationLock&) {}
inline void check(const Axis&) {}
inline void check(const Line&) {}

}  // namespace joints
