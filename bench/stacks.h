// Stacks of boxes on the ground, with the setting that the guide gives for them.
#pragma once

#include <numbers>

#include "bench/draw.h"
#include "bench/settings.h"
#include "contacts/ground_contact.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// Boxes on each other, each with a contact with the one below.
struct Stack {
  std::string kind;   ///< one of stack_kinds(), or drawn
  int count = 0;      ///< boxes
  unsigned seed = 0;  ///< of a drawn stack
};
/// equal: cubes of 1 m and 10 kg; shrinking: the edge falls to half of that from bottom to top;
/// heavy top: the uppermost has 1,000 kg; slope: the ground is tilted by 0.05 rad; overlapping: the
/// cubes begin 0.3 m inside each other, and `push` is 0.8 m/s divided by the number of overlaps,
/// but at least 0.1 m/s.
std::vector<std::string> stack_kinds();
/// A stack of 2 to 20 boxes, 0.2 to 2 m wide and half to 1.25 times as high: equal, or narrower
/// from bottom to top; with equal masses, or masses that differ by a factor of up to 10; with any
/// friction from 0.2 to 1.
inline Stack drawn_stack(unsigned seed) { return {"drawn", Draw(seed).whole(2, 20), seed}; }
/// The frequency [Hz] below which a tower of equal cubes buckles on soft contacts, as a column
/// does under its own weight: with the stiffness k of a corner's row, k = (2 pi f)^2 m/8, and the
/// bending stiffness k edge^2 of a contact, Greenhill's m g count^3 = 7.84 k edge.
/// \param edge [m] Source: Greenhill 1881
inline double buckling_frequency(int count, double edge) {
  return std::sqrt(8 / 7.84 * 9.81 * std::pow(count, 3) / edge) / (2 * std::numbers::pi);
}

/// What became of a stack.
struct Standing {
  double drift = 0;    ///< displacement of a centre along the ground after the first 10 s [m]
  double sag = 0;      ///< by which a centre is below its place at the end, at most [m]
  double fastest = 0;  ///< largest speed of a centre in the run [m/s]
  double seconds = 0;  ///< of the processor
  bool stands = false;  ///< no centre is displaced by a fifth of an edge
};
/// Runs a stack for a minute, or as long as it is told. \param solver sequential, lanes or direct
/// \param setting guide: contacts of frequency 60 Hz and damping 10, 4 warm substeps of 4
/// iterations; taller: 120 Hz, 8 substeps; finer: 240 Hz, 16 substeps; hard: 4 cold substeps of 8
/// iterations with beta = 1
Standing run_stack(const Stack& stack, const std::string& solver, const std::string& setting,
                   double seconds = 60);

}  // namespace joints::bench
/// @}
