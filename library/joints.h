// The finished joints and the solver in one include, for programs outside the workbook.
// How to install and use it: docs/library.md.
#pragma once
#if defined(__GNUC__)  // a project's own warnings are not for what it includes, with -I, too
#pragma GCC system_header
#endif

#include "comparison/compare.h"
#include "contacts/contacts.h"
#include "contacts/ground_contact.h"
#include "direct/direct_solver.h"
#include "joints/ball_joint.h"
#include "joints/distance_joint.h"
#include "joints/driven_joints.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"
#include "joints/rack_joint.h"
#include "joints/slider_joint.h"
#include "reduced/reduced.h"
#include "engine/instruments/measure.h"
#include "engine/instruments/rate.h"
#include "engine/kept/joint_id.h"
#include "engine/kept/kinematic.h"
#include "engine/kept/reaction.h"
#include "engine/kept/state.h"
#include "engine/sequential_impulses.h"
#include "engine/simd/packed.h"
#include "engine/steps/leapfrog.h"
#include "engine/steps/projection.h"
#include "engine/steps/step.h"
#include "engine/steps/two_pass_impulses.h"
