// Declarations common to the files of chapter 8's program. Read it; there is nothing to edit here.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "contacts/ground_contact.h"
#include "engine/instruments/scene.h"

namespace joints::chapter8 {

/// The options of the command line.
struct Choice {
  int iterations = 30;      ///< iterations per step
  real beta = real(0.2);    ///< fraction of the error fed back per step [1]
  double seconds = 10;      ///< duration of the machines' runs [s]
  std::string machine;      ///< one of them by name, or "all"
  std::string out;          ///< folder of tables and recordings
};

const real h = real(1) / 60;  ///< the step [s]

/// A static slab whose top is the plane y = 0. \param width of the drawn part [m]
inline BodyId add_ground(Scene& scene, real width) {
  return scene.box(0, vec3(width, real(0.2), width), vec3(0, real(-0.1), 0));
}
/// Adds the contact of a box of this size with that ground.
inline GroundContact& stand(Scene& scene, BodyId ground, BodyId body, const vec3& size,
                            real friction) {
  auto& contact = scene.world.add<GroundContact>(ground, body, Top{.height = real(0.1)},
                                                 box_outline(size));
  contact.friction = friction;
  return contact;
}
/// Penetration depth of the deepest corner of all contacts [m], 0 if there is none.
inline double penetration(const World& world) {
  double deepest = 0;
  for (const auto& joint : world.joints())
    if (const auto* contact = dynamic_cast<const GroundContact*>(joint.get()))
      deepest = std::max(deepest, -double(contact->gap(world.bodies)));
  return deepest;
}

/// The largest present gap of the scene's joints [m].
inline double widest(const Scene& scene) {
  GapMeter meter;
  meter.look(scene.marks, poses(scene.world.bodies));
  return meter.maximum();
}
/// Writes a row of machines.csv, which contains the rows of all machines that ran: the gaps of the
/// machine's joints with this number of iterations per step, and the largest penetration [m].
void machine_row(const Choice& choice, const std::string& machine, int iterations,
                 const Summary& line, double penetration);

/// The numbers of iterations of each machine for that table: 10, 30, and the chosen one.
inline std::vector<int> iterations_to_compare(const Choice& choice) {
  std::vector<int> out{10, 30};
  if (std::find(out.begin(), out.end(), choice.iterations) == out.end())
    out.push_back(choice.iterations);
  return out;
}

/// A box at rest, one that slides, one on a slope, balls that bounce.
void basics(const Choice& choice, std::vector<Summary>& lines);
/// A box that slides, by the functions of the exercises alone.
void by_hand(const Choice& choice);
/// Joints and contacts in one loop, or in two.
void order(const Choice& choice, std::vector<Summary>& lines);
/// Thesis fig. 3.2: a hinge without correction, with impacts.
void drift(const Choice& choice, std::vector<Summary>& lines);
/// The numbers of the chapter's questions and answers.
void questions(const Choice& choice);
/// The machines, one function each.
void ragdoll(const Choice& choice, std::vector<Summary>& lines);
void wheels(const Choice& choice, std::vector<Summary>& lines);
void cannon(const Choice& choice, std::vector<Summary>& lines);
void bridge(const Choice& choice, std::vector<Summary>& lines);
void curl(const Choice& choice, std::vector<Summary>& lines);

}  // namespace joints::chapter8
