// The scenes of chapter 7: chains of cubes on hinges, their orders and their runs. Read it; there
// is nothing to edit here.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "chapters/07_performance/hinge_loop.h"
#include "engine/instruments/plan.h"
#include "engine/instruments/record.h"
#include "engine/instruments/run.h"

/// Chapter 7's program.
namespace joints::chapter7 {

constexpr real h = real(1) / 60;  ///< the step of its scenes [s]

/// The options of the command line.
struct Choice {
  int iterations = 30;    ///< iterations per step
  real beta = real(0.2);  ///< fraction of the error fed back per step [1]
  double seconds = 5;     ///< duration of the scenes [s]
  int chains = 10;        ///< of the performance scene
  std::string out;        ///< folder of tables and recordings
};

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
/// \param cubes of each chain \param beta of the hinges [1] \param hanging how many cubes at the
/// end of each chain already hang straight down
inline Chains cube_chains(int count, int cubes, real beta, int hanging = 0) {
  Chains chains;
  for (int c = 0; c < count; ++c)
    for (int i = 0; i < cubes; ++i) {
      const int level = std::min(i, cubes - 1 - hanging);
      const vec3 place = spacing * vec3(real(2 * c), real(level - i), real(level));
      chains.bodies.push_back(i == 0 ? static_body(place) : box(100, vec3(1), place));
      chains.energy_scale += 100 * 9.81 * double(spacing) * i;
      if (i == 0) continue;
      const int last = int(chains.bodies.size()) - 1;
      const Body &body1 = chains.bodies[last - 1], &body2 = chains.bodies[last];
      chains.links.push_back({last - 1, last});
      chains.hinges.push_back({point_at(body1, body2, body1.x),
                               axis_along(body1, body2, vec3(1, 0, 0)), beta});
    }
  return chains;
}

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

/// Chain after chain, from the static cube to the end: one lane.
inline Groups chain_order(const Chains& chains) { return one_by_one(int(chains.links.size())); }
/// The colours of these links, by exercise 7.3. \param bodies a static one blocks no colour
/// \throws std::invalid_argument unless there is one for each link
inline std::vector<int> checked_colours(const std::vector<BodyPair>& links,
                                 const std::vector<Body>& bodies) {
  std::vector<int> colours = colours_of(links, moving(bodies));
  require(colours.size() == links.size(), "colours_of: there must be one colour for each joint");
  for (const int colour : colours)
    require(colour >= 0 && colour < int(colours.size()),
            "colours_of: a colour must be at least 0 and less than there are joints");
  return colours;
}
/// Colour after colour. \param width number solved at a time
inline Groups colour_order(const Chains& chains, int width) {
  return by_colour(checked_colours(chains.links, chains.bodies), width);
}

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
inline void print_plan(const std::string& name, const std::vector<Body>& bodies,
                       std::size_t hinges) {
  Plan plan;
  plan.bodies = int(bodies.size());
  for (const Body& body : bodies) plan.static_bodies += body.is_static();
  plan.blocks = int(hinges);
  plan.rows = 5 * plan.blocks;
  std::printf("%s: %s\n", name.c_str(), plan.line().c_str());
  std::fflush(stdout);
}

}  // namespace joints::chapter7
