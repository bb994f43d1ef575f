// The finished joints and the solver in one include, for programs outside the workbook.
// How to install and use it: docs/library.md.
#pragma once

#include "chapters/01_distance/distance_joint.h"
#include "chapters/02_ball/ball_joint.h"
#include "chapters/03_hinge/hinge_joint.h"
#include "chapters/04_slider/slider_joint.h"
#include "chapters/05_fixed/fixed_joint.h"
#include "chapters/08_ground/contacts.h"
#include "chapters/08_ground/ground_contact.h"
#include "chapters/10_own/driven_joints.h"
#include "chapters/10_own/rack_joint.h"
#include "direct/direct_solver.h"
#include "engine/instruments/measure.h"
#include "engine/instruments/rate.h"
#include "engine/reaction.h"
#include "engine/sequential_impulses.h"
#include "engine/simd/packed.h"
#include "engine/state.h"
#include "engine/step.h"
