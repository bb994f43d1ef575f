// Experiments that the text of chapter 7 and its answers quote, beyond the chapter's program. They
// run on the solution, with one chain unless they say otherwise.
#pragma once

#include "chapters/07_performance/program/scenes.h"

namespace joints::chapter7 {

/// An order of the solves and its name.
struct Order {
  std::string name;  ///< as in the tables
  Groups groups;     ///< the hinges solved together, in order
};
/// The list of the solves from its end.
inline Groups from_the_end(const Chains& chains) {
  Groups groups = chain_order(chains);
  std::reverse(groups.begin(), groups.end());
  return groups;
}

/// Convergence: the order of the joints, over-relaxation and its divergence, the rows inside one
/// step: order.csv, relaxation.csv, inside_a_step.csv.
void relaxation(const Choice& choice);
/// The colours of a chain, a bridge and a net: colours.csv; the fraction of eight lanes in use, for
/// these and a wheel: groups.csv.
void colours(const Choice& choice);
/// The numbers of the questions and folds: iterations to an error, factors per iteration, half a
/// kick: needed.csv, rate.csv, kick.csv.
void needed(const Choice& choice);
/// Joints that are all solved from the same velocities: at_once.csv, left.csv.
void at_once(const Choice& choice);

}  // namespace joints::chapter7
