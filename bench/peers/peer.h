// Common code of all adapters: a world of ours as plain numbers, from which another engine's world
// is built, and that world as a setting of the runner. All errors are measured with our marks.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/runner.h"

/// \defgroup peers Peers
/// \brief Published engines on the scenes of the benchmark; compiled only where they are installed.
/// @{
namespace joints::bench {

/// A joint of ours at the poses of the start.
struct PeerJoint {
  enum class Kind { ball, hinge, slider, fixed };
  Kind kind = Kind::ball;
  int body1 = 0, body2 = 0;  ///< slots
  glm::dvec3 anchor{0};      ///< [m, world]
  glm::dvec3 axis{0};        ///< of a hinge or a slider: unit, world
  Range limits{};            ///< [rad or m]
  Motor motor{};             ///< [rad/s and N m, or m/s and N]
  bool limited() const { return limits.lower > -unbounded || limits.upper < unbounded; }
};

/// What of a body can be touched.
struct PeerShape {
  enum class Kind { none, plane, box, ball, capsule };
  Kind kind = Kind::none;
  /// Half the edges of a box; the radius of a ball or a capsule in x, and in y half the length of
  /// the capsule's cylinder, which is parallel to the body's y axis [m].
  glm::dvec3 half{0};
  double height = 0;    ///< of a plane above the body's centre, across the body's y axis [m]
  double friction = 1;  ///< of a body that stands; of a ground 1, so that the product is ours
  bool is_ground = false;  ///< grounds touch bodies that stand, and nothing else touches
};

/// A world of ours as other engines need it.
struct PeerScene {
  std::vector<Body> bodies{};       ///< by slots
  std::vector<PeerShape> shapes{};  ///< one a body
  std::vector<PeerJoint> joints{};
  glm::dvec3 gravity{0};            ///< [m/s^2]
  bool heap = false;                ///< all shapes touch each other, but no joined ones
  bool touches() const;             ///< some body can be touched
  bool is_driven() const;           ///< some joint has limits or a motor
};
/// \throws std::invalid_argument for a kind of joint that is none of these
PeerScene peer_scene(const World& world);

/// The joints as trees, for engines with reduced coordinates: each body hangs on one before it.
struct Trees {
  std::vector<int> order{};   ///< slots, every parent before its children
  std::vector<int> joint{};   ///< of each slot: the joint on which it hangs, -1 for a root
  std::vector<int> parent{};  ///< of each slot: the slot, -1 for a root
  std::vector<int> root{};    ///< of each slot: the slot
  std::vector<int> loops{};   ///< joints that are in no tree: they close loops
};
/// Static bodies are roots and nothing else.
Trees trees_of(const PeerScene& scene);

/// The rate of a body's joint in its tree at the start: of a hinge or a slider in x, of a ball in
/// the body's axes [rad/s or m/s].
glm::dvec3 start_rate(const PeerScene& scene, const Trees& trees, int slot);

/// A world of another engine.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual void step(double h) = 0;           ///< [s]
  virtual void show(Bodies& bodies) = 0;     ///< poses and velocities into ours
};

/// An engine and its settings.
struct PeerSetting {
  std::string engine, version;
  std::string number;           ///< double or float: its type of numbers
  std::string name;             ///< the settings, without a comma
  bool quick = false;           ///< also in the short form
  int most_joints = 0;          ///< on larger scenes a step takes too long; 0: on none
  bool basic = false;           ///< measured on large scenes, too
  bool contacts = true;         ///< measured where bodies can touch, too
  bool slow = false;            ///< a step takes a tenth of a second on S1
  bool exact = false;           ///< it does not iterate: its first step has the true acceleration
  int substeps = 1;             ///< each begins with its forces; 0: of order 4 by itself
  bool reduced = false;         ///< reduced coordinates: it starts with rates of its joints
  bool swept = false;           ///< measured over the length of the step alone (sweeps.cpp)
  bool trees_only = false;      ///< no loops, no limits or motors, no contacts
  std::function<std::unique_ptr<Peer>(const PeerScene&)> make{};

  bool takes(const PeerScene& scene) const {
    return (most_joints == 0 || int(scene.joints.size()) <= most_joints) &&
           (contacts || !scene.touches()) &&
           (!trees_only || (!scene.touches() && !scene.is_driven() &&
                            trees_of(scene).loops.empty()));
  }
  Setting setting() const;      ///< for the runner
};

std::vector<PeerSetting> bullet_settings(bool search);  ///< of the same kind of number as `real`
std::vector<PeerSetting> ode_settings(bool search);     ///< double
std::vector<PeerSetting> mujoco_settings(bool search);  ///< double
std::vector<PeerSetting> simbody_settings(bool search);  ///< double
std::vector<PeerSetting> bullet_heap_settings();  ///< those of heaps.h
std::vector<PeerSetting> ode_heap_settings();     ///< those of heaps.h
/// Of all engines that are compiled in. \param search those of the search for the best instead
std::vector<PeerSetting> peer_settings(bool search = false);

}  // namespace joints::bench
/// @}
