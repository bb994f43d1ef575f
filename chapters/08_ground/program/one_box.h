// One box on the ground, or on a slope. Read it; there is nothing to edit here.
#pragma once

#include <numbers>

#include "chapters/08_ground/program/program.h"

namespace joints::chapter8 {

constexpr real degree = std::numbers::pi_v<real> / 180;  ///< [rad]
constexpr double g = 9.81;                               ///< [m/s^2]

/// A box of 10 kg, mu = 0.5; a slope is the ground rotated about z.
struct OneBox {
  Scene scene;             ///< world and solver
  vec3 size;               ///< edges [m]
  BodyId ground, box;      ///< the bodies
  GroundContact* contact;  ///< between them

  /// Makes the scene. \param slope [rad]
  OneBox(const std::string& name, const Choice& choice, const vec3& size, real slope = 0)
      : scene{.name = name}, size(size) {
    scene.solver.iterations = choice.iterations;
    const quat turn = rotation(vec3(0, 0, slope));
    ground = scene.box(0, vec3(12, real(0.2), 12), turn * vec3(0, real(-0.1), 0), turn);
    box = scene.box(10, size, turn * vec3(0, size.y / 2, 0), turn);
    contact = &stand(scene, ground, box, size, real(0.5));
    contact->beta = choice.beta;
    scene.energy_scale = 10 * g;
  }
  /// The box.
  Body& body() { return scene.world.bodies[box]; }
  /// A corner of it [m, world].
  vec3 corner(int k) { return world_point(body(), contact->outline.corners[std::size_t(k)]); }
};

}  // namespace joints::chapter8
