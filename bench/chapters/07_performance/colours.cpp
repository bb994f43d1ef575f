// The colours of a chain, a bridge and a net, and the fraction of eight lanes that these and a
// wheel use.
#include <algorithm>
#include <cmath>

#include "bench/chapters/07_performance/experiments.h"

namespace joints::chapter7 {

namespace {

// Bodies, and the pairs of them that are linked: the input of graph colouring.
struct Sketch {
  std::string name;
  std::vector<Body> bodies;
  std::vector<BodyPair> links;

  int add(real mass, const vec3& place) {
    bodies.push_back(mass > 0 ? box(mass, vec3(real(0.8)), place) : static_body(place));
    return int(bodies.size()) - 1;
  }
};

Sketch a_chain() {
  Sketch chain{"chain", {}, {}};
  for (int i = 0; i < 12; ++i) {
    chain.add(i == 0 ? 0 : 100, vec3(spacing * real(i), 0, 0));
    if (i > 0) chain.links.push_back({i - 1, i});
  }
  return chain;
}

// 42 boxes on an arc of 90 degrees that hangs down, chords of 1 m, both ends static.
Sketch a_bridge() {
  Sketch bridge{"bridge", {}, {}};
  const double pi = std::acos(-1.0), step = pi / 2 / 41, radius = 0.5 / std::sin(step / 2);
  for (int i = 0; i < 42; ++i) {
    const double angle = -pi / 4 + i * step;
    bridge.add(i == 0 || i == 41 ? 0 : 1,
               vec3(real(radius * std::sin(angle)),
                    real(radius * (std::cos(pi / 4) - std::cos(angle))), 0));
    if (i > 0) bridge.links.push_back({i - 1, i});
  }
  return bridge;
}

// Six by six cubes, the upper corners static. For each cube in turn: the joint to its right
// neighbour, and the joint to its lower neighbour.
Sketch a_net() {
  Sketch net{"net", {}, {}};
  const int side = 6;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const bool corner = row == 0 && (column == 0 || column == side - 1);
      net.add(corner ? 0 : 1, spacing * vec3(real(column), real(-row), 0));
    }
  for (int i = 0; i < side * side; ++i) {
    if (i % side < side - 1) net.links.push_back({i, i + 1});
    if (i / side < side - 1) net.links.push_back({i, i + side});
  }
  return net;
}

// A hub and twelve arms with this number of hinges each: arm by arm from the hub outwards, or the
// list backwards.
Sketch a_wheel(const std::string& name, int hinges, real hub_mass, bool backwards) {
  Sketch wheel{name, {}, {}};
  wheel.add(hub_mass, vec3(0));
  for (int arm = 0; arm < 12; ++arm)
    for (int i = 0; i < hinges; ++i) {
      const int cube = wheel.add(1, vec3(real(arm), real(i), 0));
      wheel.links.push_back({i == 0 ? 0 : cube - 1, cube});
    }
  if (backwards) std::reverse(wheel.links.begin(), wheel.links.end());
  return wheel;
}

// A row for each colour: the numbers of its joints and of their groups of eight.
void count(const Sketch& sketch, const std::vector<int>& found, CsvFile& table) {
  for (int colour = 0; colour <= *std::max_element(found.begin(), found.end()); ++colour) {
    const auto joints = double(std::count(found.begin(), found.end(), colour));
    table.row({sketch.name}, {double(colour), joints, std::ceil(joints / 8)});
  }
}

}  // namespace

void colours(const Choice& choice) {
  CsvFile groups(choice.out + "/groups.csv", {"scene", "colour", "joints", "groups_of_8"});
  for (const Sketch& wheel : {a_wheel("wheel", 10, 1, false), a_wheel("rim first", 10, 1, true),
                              a_wheel("short arms", 1, 1, false),
                              a_wheel("static hub", 10, 0, false)})
    count(wheel, checked_colours(wheel.links, wheel.bodies), groups);
  CsvFile table(choice.out + "/colours.csv", {"scene", "body1_x", "body1_y", "body1_z", "body2_x",
                                              "body2_y", "body2_z", "colour"});
  for (const Sketch& sketch : {a_chain(), a_bridge(), a_net()}) {
    print_plan(sketch.name, sketch.bodies, sketch.links.size());
    const std::vector<int> found = checked_colours(sketch.links, sketch.bodies);
    count(sketch, found, groups);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const vec3 &a = sketch.bodies[sketch.links[k].body1].x,
                 &b = sketch.bodies[sketch.links[k].body2].x;
      table.row({sketch.name}, {double(a.x), double(a.y), double(a.z), double(b.x), double(b.y),
                                double(b.z), double(found[k])});
    }
  }
}

}  // namespace joints::chapter7
