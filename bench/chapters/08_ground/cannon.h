// The cannon of the thesis, fig. 5.3, with a ground for its shot.
#pragma once

#include "chapters/08_ground/program/program.h"
#include "joints/fixed_joint.h"
#include "joints/slider_joint.h"

namespace joints::chapter8 {

/// A carriage of 50 kg on a slider at 45 degrees, limits -1 and 10 m, driven by a motor. A
/// shot of 10 kg is fixed to it and released before the step in which the limit would stop the two.
/// The empty carriage slides back; the shot flies, lands, tumbles and comes to rest. The motor has
/// 3500 N, not 5000 as in chapter 4, so that this takes ten seconds.
struct Cannon {
  Scene scene{.name = "cannon"};  ///< world, solver, measurements, appearance
  BodyId ground{};    ///< where the shot lands
  BodyId barrel{};    ///< static, at 45 degrees
  BodyId carriage{};  ///< slides in it
  BodyId shot{};      ///< fixed in front of it, then flies
  SliderJoint* rail;         ///< of the carriage in the barrel
  FixedJoint* hold;          ///< of the shot in front of the carriage; null once it flies
  GroundContact* landing;    ///< shot and ground
  real shot_edge = real(0.5);  ///< [m]

  /// Makes the scene. \param iterations iterations per step \param beta of the joints [1]
  explicit Cannon(int iterations, real beta = real(0.2)) {
    const real diagonal = std::sqrt(real(0.5));
    const vec3 along(diagonal, diagonal, 0), across(diagonal, -diagonal, 0);
    const quat turn = rotation(vec3(0, 0, std::atan2(diagonal, diagonal)));
    const vec3 zero(0, 2, 0);  // where the displacement of the carriage is zero: above the ground
    scene.solver.iterations = iterations;
    scene.stepping.warm_start = true;
    scene.energy_scale = 3500 * 11;  // greatest work of the motor
    ground = scene.box(0, vec3(160, real(0.2), 8), vec3(72, real(-0.1), 0));
    barrel = scene.box(0, vec3(11, real(0.1), real(0.6)),
                       zero + real(4.5) * along + real(0.6) * across, turn);
    scene.box(0, vec3(real(0.3), 1, real(0.6)), vec3(0, real(0.5), 0));  // the legs, for show
    scene.box(0, vec3(real(0.3), 6, real(0.6)), vec3(5, 3, 0));
    carriage = scene.box(50, vec3(1), zero, turn);
    shot = scene.box(10, vec3(shot_edge), zero + along, turn);
    scene.shapes.back().label = "shot";
    rail = &scene.world.add<SliderJoint>(barrel, carriage, zero, along);
    for (const BodyId id : {carriage, shot}) scene.world.bodies[id].x -= along;  // loaded: at -1 m
    hold = &scene.world.add<FixedJoint>(carriage, shot,
                                        zero - real(0.5) * along);
    rail->set_limits(-1, 10);
    rail->set_motor(60, 3500);
    rail->beta = hold->beta = beta;
    landing = &stand(scene, ground, shot, vec3(shot_edge), real(0.5));
    landing->restitution = real(0.3);
  }
  /// After each step: releases the shot if the limit is reached within the next one.
  void look() {
    const Bodies& bodies = scene.world.bodies;
    if (!hold || rail->position(bodies) + h * rail->speed(bodies) < rail->limits().upper) return;
    scene.world.remove(*hold);
    hold = nullptr;
    rail->set_motor(0, 0);
  }
  /// The errors of the carriage's line and limits, and of the joint to the shot [m].
  double gap() const {
    const Bodies& bodies = scene.world.bodies;
    const Vector<2> C = rail->first.error(bodies[barrel], bodies[carriage]);
    const double x = double(rail->position(bodies));
    const double beyond = std::max({double(rail->limits().lower) - x,
                                    x - double(rail->limits().upper), 0.0});
    const double off = std::hypot(double(C[0]), double(C[1]), beyond);
    if (!hold) return off;
    return std::max(off, double(length(hold->weld.first.error(bodies[carriage], bodies[shot]))));
  }
};

}  // namespace joints::chapter8
