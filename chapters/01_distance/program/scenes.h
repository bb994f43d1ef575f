// The scenes of chapter 1's program: a pendulum and the thesis' bridge. Read it; there is nothing
// to edit here.
#pragma once

#include <algorithm>
#include <string>

#include "chapters/01_distance/distance.h"
#include "engine/instruments/record.h"

/// \addtogroup chapter1
/// @{
namespace joints::chapter1 {

/// Bodies, the links between them, and how they look.
struct LinkScene {
  std::string name;           ///< for the plan, the summary and the recording
  std::vector<Body> bodies;   ///< all of them
  std::vector<Link> links;    ///< between their centres
  Shape shape;                ///< of every body
  double energy_scale = 1;    ///< divisor of the change of the energy [J]
};

/// A ball of 1 kg on a rod of 2 m, let go where the rod is level.
inline LinkScene pendulum() {
  return {"pendulum", {static_body(vec3(0)), ball(1, real(0.2), vec3(2, 0, 0))},
          {Link{0, 1, 2}}, {"ball", {0.4, 0.4, 0.4}}, 9.81 * 2};
}

/// The thesis' bridge (fig. 5.6): ten cubes of 100 kg, 2 m apart, the outer two static, hung from
/// ropes of 2.3 m. Every cube first falls freely until its ropes are taut.
inline LinkScene bridge() {
  LinkScene scene{"bridge", {}, {}, {"box", {1, 1, 1}}, 0};
  for (int i = 0; i < 10; ++i) {
    const vec3 place(real(2 * i - 9), 0, 0);
    const bool end = i == 0 || i == 9;
    scene.bodies.push_back(end ? static_body(place) : box(100, vec3(1), place));
    if (i > 0) scene.links.push_back({i - 1, i, real(2.3), true});
    if (!end) scene.energy_scale += 100 * 9.81 * 2.3 * std::min(i, 9 - i);
  }
  return scene;
}

/// A lamp of 10 kg falls 1 m into three ropes of 2 m, which are taut at the same time, 20 degrees
/// off the vertical. Each of them must release a part of its pull when the others have acted.
inline LinkScene lamp() {
  LinkScene scene{"lamp", {ball(10, real(0.1), vec3(0, 1, 0))}, {}, {"ball", {0.2, 0.2, 0.2}}, 98};
  for (int k = 1; k <= 3; ++k) {
    const vec3 hook = rotation(vec3(0, real(2.0944 * k), 0)) * vec3(real(0.684), real(1.879), 0);
    scene.bodies.push_back(static_body(hook));
    scene.links.push_back({0, k, length(hook), true});
  }
  return scene;
}

/// The error of a link [m]: 0 for a slack rope.
inline double gap(const Link& link, const Body& body1, const Body& body2) {
  const double stretch = CentreDistance{link.length}.error(body1, body2);
  return link.rope ? std::max(stretch, 0.0) : std::abs(stretch);
}

}  // namespace joints::chapter1
/// @}
