// A tree of Simbody in plain numbers. Its headers are not C++20, so this pair of files is C++17 and
// includes nothing of ours.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>

namespace joints::bench {

/// A body and the joint on which it hangs, with all that belongs to the start, in the world's axes.
struct SimbodyLink {
  enum class Joint { free, ball, hinge, slider, weld };
  Joint joint = Joint::free;
  int parent = -1;          ///< index of a link; -1: the ground
  double mass = 1;          ///< [kg]
  glm::dvec3 inertia{1};    ///< principal moments [kg m^2]
  glm::dvec3 x{0};          ///< [m]
  glm::dquat q{1, 0, 0, 0};
  glm::dvec3 v{0}, w{0};    ///< [m/s, rad/s]
  glm::dvec3 torque{0};     ///< from outside [N m]
  glm::dvec3 anchor{0};     ///< [m]
  glm::dvec3 axis{0};       ///< of a hinge or a slider, unit
};

enum class SimbodyMethod { euler, verlet, runge_kutta };

/// Links, each after its parent, with steps of equal length.
class SimbodyTree {
 public:
  SimbodyTree(const std::vector<SimbodyLink>& links, const glm::dvec3& gravity,
              SimbodyMethod method);
  ~SimbodyTree();
  void step(double h);                 ///< [s]
  std::vector<SimbodyLink> now() const;  ///< x, q, v and w alone
  static std::string version();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace joints::bench
