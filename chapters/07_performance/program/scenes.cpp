// The scenes of chapter 7's program. Read it; there is nothing to edit here.
#include "chapters/07_performance/program/scenes.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "engine/instruments/plan.h"

namespace joints::chapter7 {

namespace {

std::vector<int> in_a_row(const Chains& chains) {
  std::vector<int> order(chains.links.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

}  // namespace

// ---- chains ------------------------------------------------------------------------------------

Chains bent_chains(int count, int cubes, int hanging, real beta) {
  Chains chains;
  chains.count = count;
  chains.length = cubes - 1;
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

Chains cube_chains(int count, int cubes, real beta) { return bent_chains(count, cubes, 0, beta); }

// ---- orders ------------------------------------------------------------------------------------

Groups chain_order(const Chains& chains) { return one_by_one(in_a_row(chains)); }

Groups from_the_end(const Chains& chains) {
  std::vector<int> order = in_a_row(chains);
  std::reverse(order.begin(), order.end());
  return one_by_one(order);
}

Groups colour_order(const Chains& chains, int width) {
  return by_colour(checked_colours(chains.links, chains.bodies), width);
}

std::vector<int> checked_colours(const std::vector<BodyPair>& links,
                                 const std::vector<Body>& bodies) {
  std::vector<bool> moves;
  for (const Body& body : bodies) moves.push_back(!body.is_static());
  std::vector<int> colours = colours_of(links, moves);
  require(colours.size() == links.size(), "colours_of: there must be one colour for each joint");
  return colours;
}

void print_plan(const std::string& name, const std::vector<Body>& bodies, std::size_t hinges) {
  Plan plan;
  plan.bodies = int(bodies.size());
  for (const Body& body : bodies) plan.static_bodies += body.is_static();
  plan.blocks = int(hinges);
  plan.rows = 5 * plan.blocks;
  std::printf("%s: %s\n", name.c_str(), plan.line().c_str());
  std::fflush(stdout);
}

}  // namespace joints::chapter7
