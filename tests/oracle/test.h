// What a test of engine and joints begins with: Catch2, the finished joints, what reckons for it.
#pragma once

#include "joints/distance_joint.h"
#include "joints/fixed_joint.h"
#include "tests/checker/catch.h"
#include "tests/oracle/rigs.h"
#include "tests/oracle/shared.h"

// A test has no names that these could hide.
using namespace joints;
using namespace joints::testing;
