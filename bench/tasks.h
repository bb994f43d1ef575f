// Scenes as readers have them, each with what it is for: a load that hangs, an arm that follows its
// drives, a bridge under a crate, ragdolls on the ground.
#pragma once

#include "bench/scenes.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// Cubes of 100 kg and 0.4 m that hang below each other, 1 m apart, and one of `load` kg at the
/// end. Nothing should move. Finding: how far the load has gone down.
BenchScene hung_chain(int cubes, double load);
/// The same of 100 kg throughout, on soft joints. Finding: how far the load has gone down; what the
/// springs' own lengths are is expected. \param frequency of each joint and its bodies [Hz]
BenchScene sprung_chain(int cubes, double frequency);
/// S3b. Finding: by how much all of its links together are too long at the end.
BenchScene rope_bridge();
/// Chapter 9's beam of welded cubes. Finding: how far its tip has gone down.
BenchScene welded_beam(int cubes);
/// Six links of 8 to 1 kg on hinges, a tool of 5 kg welded to the last, and in each hinge a drive
/// that runs at a constant speed. Finding: how far the tool is from where the drives' angles put it
/// after 1 s.
BenchScene arm();
/// S4m. Finding: its speed after 1 s.
BenchScene driven_crane();
/// S4l. Finding: its angle at rest.
BenchScene stopped_crane();
/// Chapter 8's bridge of planks, and the crate that falls on it. Finding: how fast the crate still
/// is at the end.
BenchScene loaded_planks();
/// Chapter 8's ragdolls, 4 m apart on one ground, let go just above it. Finding: how deep the
/// deepest corner is in the ground at the end.
BenchScene ragdolls(int count);

}  // namespace joints::bench
/// @}
