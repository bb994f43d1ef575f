// Experiments that the text of chapter 6 and its answers quote, beyond the chapter's program. They
// run on the solution.
#pragma once

#include <vector>

#include "chapters/06_baumgarte/program/program.h"
#include "engine/instruments/scene.h"

namespace joints::chapter6 {

/// One joint and an error: drift, decay, energy, remaining angular velocity, a rope.
void one_joint(const Choice& choice, std::vector<Summary>& lines);
/// Beta and the warm start in a chain.
void in_a_chain(const Choice& choice);
/// Many joints: rods that contradict each other, the methods side by side.
void many_joints(const Choice& choice, std::vector<Summary>& lines);
/// Arms about a hub, for which the criterion of chains does not hold.
void hubs(const Choice& choice);
/// The numbers of the answers to the questions.
void questions(const Choice& choice);
/// Every method with the same number of iterations, in one step or in many.
void budget(const Choice& choice);
/// The thesis' chain of four links between static ends, with impacts.
void between_walls(const Choice& choice, std::vector<Summary>& lines);

}  // namespace joints::chapter6
