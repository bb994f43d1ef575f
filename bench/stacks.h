// Stacks of boxes on the ground, with the setting that the guide gives for them.
#pragma once

#include "bench/settings.h"
#include "chapters/08_ground/ground_contact.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// Boxes on each other, each with a contact with the one below.
struct Stack {
  std::string kind;  ///< one of stack_kinds()
  int count = 0;     ///< boxes
};
/// equal: cubes of 1 m and 10 kg; shrinking: the edge falls to half of that from bottom to top;
/// heavy top: the uppermost has 1,000 kg; slope: the ground is tilted by 0.05 rad; overlapping: the
/// cubes begin 0.3 m inside each other.
std::vector<std::string> stack_kinds();

/// What became of a stack.
struct Standing {
  double drift = 0;    ///< displacement of a centre along the ground after the first 10 s [m]
  double sag = 0;      ///< by which the lowest centre is below its place at the end [m]
  double fastest = 0;  ///< largest speed of a centre in the run [m/s]
  double seconds = 0;  ///< of the processor
  bool stands = false;  ///< no centre is displaced by a fifth of an edge
};
/// Runs a stack for a minute, or as long as it is told. \param solver sequential, lanes or direct
/// \param setting guide: contacts of frequency 60 Hz and damping 10, 4 warm substeps of 4
/// iterations; finer: 240 Hz, 16 substeps; hard: 4 cold substeps of 8 iterations with beta = 1
Standing run_stack(const Stack& stack, const std::string& solver, const std::string& setting,
                   double seconds = 60);

}  // namespace joints::bench
/// @}
