// Parts of any geometry as joints of their own: the fixtures have made them, nothing is refused.
#pragma once

#include "chapters/03_hinge/hinge_joint.h"
#include "chapters/05_fixed/fixed_joint.h"

namespace joints {

template <class First, class Second>
void check(const Composite<First, Second>&) {}

}  // namespace joints
