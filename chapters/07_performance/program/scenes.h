// The scenes of chapter 7's program and their runs. There is nothing to edit here.
#pragma once

#include <string>
#include <vector>

#include "chapters/07_performance/program/hinge_loop.h"
#include "chapters/07_performance/program/program.h"

/// \addtogroup chapter7
/// @{
namespace joints::chapter7 {

constexpr real spacing = real(1.5);  ///< from a cube to the next of its chain [m]

/// Chains of cubes on hinges: everything that a HingeLoop needs except the order of the solves.
struct Chains {
  std::vector<Body> bodies;    ///< chain after chain, each from its static cube on
  std::vector<BodyPair> links;     ///< in the same order
  std::vector<Hinge> hinges;   ///< one per link
  double energy_scale = 0;     ///< m g times the distance along the chain, over all cubes [J]
};

/// The thesis' performance scene: cubes of 1 m and 100 kg in rows along z, spacing apart, the first
/// of each chain static; each hinge at the centre of the previous cube, its axis x; chains 3 m
/// apart.
/// \param cubes of each chain \param beta of the hinges [1]
Chains cube_chains(int count, int cubes, real beta);

/// The same with the last `hanging` cubes of each chain already straight down.
Chains bent_chains(int count, int cubes, int hanging, real beta);

/// A loop over them. \param groups the hinges solved together, in order
template <class Number>
HingeLoop<Number> loop_over(const Chains& chains, const Groups& groups, int iterations) {
  HingeLoop<Number> loop;
  loop.bodies = chains.bodies;
  loop.links = chains.links;
  loop.hinges = chains.hinges;
  loop.arrange(groups);
  loop.iterations = iterations;
  return loop;
}

/// An order of the solves and its name.
struct Order {
  std::string name;  ///< as in the tables
  Groups groups;     ///< the hinges solved together, in order
};
/// Chain after chain, from the static cube to the end: one lane.
Groups chain_order(const Chains& chains);
/// The same list from its end.
Groups from_the_end(const Chains& chains);
/// Colour after colour. \param width number solved at a time
Groups colour_order(const Chains& chains, int width);

/// The colours of these links, by exercise 7.3. \param bodies a static one blocks no colour
/// \throws std::invalid_argument unless there is one for each link
std::vector<int> checked_colours(const std::vector<BodyPair>& links,
                                 const std::vector<Body>& bodies);

/// A loop over chains as an experiment. The gaps are measured in the last two thirds of the steps.
template <class Number>
Experiment experiment_of(HingeLoop<Number>& loop, const Chains& chains, int steps) {
  return {.step = [&loop] { loop.step(h); },
          .bodies = [&loop] { return std::span<const Body>(loop.bodies); },
          .gaps =
              [&loop](GapMeter& meter) {
                for (std::size_t k = 0; k < loop.links.size(); ++k) meter.add(double(loop.gap(k)));
              },
          .steps = steps,
          .gravity = loop.gravity,
          .energy_scale = chains.energy_scale,
          .settling = last_two_thirds(steps)};
}

/// Prints the plan of a scene, as every program does.
void print_plan(const std::string& name, const std::vector<Body>& bodies, std::size_t hinges);

}  // namespace joints::chapter7
/// @}
