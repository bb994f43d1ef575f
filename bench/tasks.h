// Scenes of typical applications, each with its result: a hanging load, an arm that follows its
// drives, a bridge under a crate, ragdolls on the ground.
#pragma once

#include "bench/scenes.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// Cubes of 100 kg and 0.4 m that hang below each other, 1 m apart, and one of `load` kg at the
/// end. Nothing should move. Finding: the sag of the load.
BenchScene hung_chain(int cubes, double load);
/// The same with 100 kg throughout, on soft joints. Finding: the sag of the load; expected is the
/// elongation of the springs. \param frequency of each joint and its bodies [Hz]
BenchScene sprung_chain(int cubes, double frequency);
/// 20 balls of 1 kg, 1 m apart on ball joints, the last of 10 kg, released from a level line.
/// \param inertia m r^2 / I of each with r = 0.5 m: the larger, the smaller the balls
BenchScene beads(double inertia);
/// S3b. Finding: the total elongation of its links at the end.
BenchScene rope_bridge();
/// Chapter 9's beam of welded cubes. Finding: the sag of its tip.
BenchScene welded_beam(int cubes);
/// Six links of 8 to 1 kg on hinges, a tool of 5 kg welded to the last, and in each hinge a drive
/// that runs at a constant speed. Finding: the distance of the tool after 1 s from the position
/// given by the drives' angles.
BenchScene arm();
/// S4m. Finding: its speed after 1 s.
BenchScene driven_crane();
/// S4l. Finding: its angle at rest.
BenchScene stopped_crane();
/// Chapter 8's bridge of planks, and the crate that falls on it. Finding: the speed of the crate at
/// the end.
BenchScene loaded_planks();
/// Chapter 8's ragdolls, 4 m apart on one ground, released just above it. Finding: the penetration
/// depth of the deepest corner at the end.
BenchScene ragdolls(int count);
/// The same in poses that a seed draws. \param lowest height of a torso's centre; the highest is
/// 1.2 m above it [m]. Below 1.6 some limbs start inside the ground.
BenchScene random_ragdolls(int count, unsigned seed, double lowest = 1.3);

}  // namespace joints::bench
/// @}
