// The scenes of chapter 7's program and what is measured of them. There is nothing to edit here.
#pragma once

#include <string>
#include <vector>

#include "chapters/07_performance/program/hinge_loop.h"
#include "engine/instruments/measure.h"

/// \addtogroup chapter7
/// @{
namespace joints::chapter7 {

constexpr real spacing = real(1.5);  ///< from a cube to the next of its chain [m]

/// Chains of cubes on hinges: what a HingeLoop needs, apart from the order of the solves.
struct Chains {
  std::vector<Body> bodies;    ///< chain after chain, each from its static cube on
  std::vector<BodyPair> links;     ///< in the same order
  std::vector<Hinge> hinges;   ///< one a link
  double energy_scale = 0;     ///< m g times the way along the chain, over all cubes [J]
};

/// The thesis' performance scene: cubes of 1 m and 100 kg in rows along z, spacing apart, the first
/// of each chain static; each hinge at the centre of the cube before, its axis x; chains 3 m apart.
/// \param cubes of each chain \param beta of the hinges [1]
Chains cube_chains(int count, int cubes, real beta);

/// The same with the last `hanging` cubes of each chain already straight down.
Chains bent_chains(int count, int cubes, int hanging, real beta);

/// A loop over them. \param groups who comes with whom, and when
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

/// Chain after chain, from the static cube to the end: one lane.
Groups chain_order(const Chains& chains);
/// The same list from its end.
Groups from_the_end(const Chains& chains);
/// Colour after colour. \param width how many at a time
Groups colour_order(const Chains& chains, int width);

/// The colours of these links, by exercise 7.3. \param bodies a static one takes part in nothing
/// \throws std::invalid_argument unless there is one for each link
std::vector<int> checked_colours(const std::vector<BodyPair>& links,
                                 const std::vector<Body>& bodies);

/// Watches a loop while it runs: gaps over the last two thirds of the steps, and the energy.
class Watch {
 public:
  /// \param steps how many there will be
  Watch(const Chains& chains, int steps);
  /// After step n, 1 for the first. \return false where a body's place is no ordinary number
  bool look(int n, const std::vector<Body>& bodies);
  double gap_rms() const;        ///< [m], NaN where a place is no ordinary number
  double gap_max() const;        ///< [m], NaN likewise
  double energy_change() const;  ///< now, over the scene's energy scale [1]
  /// ok (no gap above 1 % of a link), soft (below half a link), torn (above), energy+ (over 2 % of
  /// the scale gained at any time), exploded (over 100 %), nan.
  std::string status() const;

 private:
  int steps_;
  double scale_, start_, change_ = 0, peak_ = 0;
  bool finite_ = true;
  std::vector<Mark> marks_;
  GapMeter gaps_;
};

/// Prints what a scene has, as every program does.
void print_plan(const std::string& name, const std::vector<Body>& bodies, std::size_t hinges);

/// So many steps of length h as make up a time, at least one. \param seconds [s]
int steps_in(double seconds);

}  // namespace joints::chapter7
/// @}
