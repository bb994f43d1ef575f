// The scenes of chapter 7's program. Read it; there is nothing to edit here.
#include "chapters/07_performance/program/scenes.h"

#include <algorithm>
#include <cstdio>

#include "engine/instruments/plan.h"

namespace joints::chapter7 {

// ---- chains ------------------------------------------------------------------------------------

Chains bent_chains(int count, int cubes, int hanging, real beta) {
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

Chains cube_chains(int count, int cubes, real beta) { return bent_chains(count, cubes, 0, beta); }

// ---- orders ------------------------------------------------------------------------------------

Groups chain_order(const Chains& chains) { return one_by_one(int(chains.links.size())); }

Groups from_the_end(const Chains& chains) {
  Groups groups = chain_order(chains);
  std::reverse(groups.begin(), groups.end());
  return groups;
}

Groups colour_order(const Chains& chains, int width) {
  return by_colour(checked_colours(chains.links, chains.bodies), width);
}

std::vector<int> checked_colours(const std::vector<BodyPair>& links,
                                 const std::vector<Body>& bodies) {
  std::vector<int> colours = colours_of(links, moving(bodies));
  require(colours.size() == links.size(), "colours_of: there must be one colour for each joint");
  for (const int colour : colours)
    require(colour >= 0 && colour < int(colours.size()),
            "colours_of: a colour must be at least 0 and less than there are joints");
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
