// The scenes of chapter 7's program. Read it; there is nothing to edit here.
#include "chapters/07_performance/program/scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "chapters/07_performance/program/program.h"
#include "engine/instruments/plan.h"

namespace joints::chapter7 {

namespace {

std::vector<Pose> poses_of(const std::vector<Body>& bodies) {
  std::vector<Pose> all;
  for (const Body& body : bodies) all.push_back({glm::dvec3(body.x), glm::dquat(body.q)});
  return all;
}

// Of motion and of position.
double energy_of(const std::vector<Body>& bodies) {
  double sum = 0;
  for (const Body& body : bodies)
    if (!body.is_static())
      sum += kinetic_energy(body) + 9.81 * double(body.x.y) / double(body.inverse_mass);
  return sum;
}

}  // namespace

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

// ---- watching ----------------------------------------------------------------------------------

Watch::Watch(const Chains& chains, int steps)
    : steps_(steps), scale_(chains.energy_scale), start_(energy_of(chains.bodies)) {
  for (std::size_t k = 0; k < chains.links.size(); ++k) {
    const Point& point = chains.hinges[k].point;
    marks_.push_back({chains.links[k].body1, chains.links[k].body2,
                      glm::dvec3(point.anchor1_local), glm::dvec3(point.anchor2_local)});
  }
}

bool Watch::look(int n, const std::vector<Body>& bodies) {
  for (const Body& body : bodies) finite_ = finite_ && finite(body.x) && finite(body.v);
  change_ = (energy_of(bodies) - start_) / scale_;
  peak_ = std::max(peak_, change_);
  if (n > steps_ - 2 * steps_ / 3) gaps_.look(marks_, poses_of(bodies));
  return finite_;
}

double Watch::gap_rms() const {
  return finite_ ? gaps_.rms() : std::numeric_limits<double>::quiet_NaN();
}
double Watch::gap_max() const {
  return finite_ ? gaps_.maximum() : std::numeric_limits<double>::quiet_NaN();
}
double Watch::energy_change() const { return change_; }

std::string Watch::status() const {
  if (!finite_ || !std::isfinite(change_)) return "nan";
  if (peak_ > 1) return "exploded";
  if (peak_ > 0.02) return "energy+";
  const double link = double(spacing);
  return gap_max() < 0.01 * link ? "ok" : gap_max() < 0.5 * link ? "soft" : "torn";
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

int steps_in(double seconds) { return std::max(1, int(std::lround(seconds / double(h)))); }

}  // namespace joints::chapter7
