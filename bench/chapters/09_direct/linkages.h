// More scenes of chapter 9: a chain with a heavy end, a net, a star, and linkages that close in
// loops.
#pragma once

#include <cmath>

#include "chapters/09_direct/program/scenes.h"
#include "joints/ball_joint.h"

namespace joints::chapter9 {

// ---- joints between bodies in their poses -------------------------------------------------------

/// A ball joint at a point of the world, with its mark. Its beta is 1.
inline void on_ball(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor) {
  scene.world.add<BallJoint>(id1, id2, anchor).beta = 1;
  scene.mark(id1, id2, anchor);
}
/// A rod of 1 kg and 5 cm square from one point to another. \param mass [kg]; 0 for a static one
inline BodyId rod(Scene& scene, const vec3& from, const vec3& to, real mass = 1) {
  const real size = length(to - from), thick = real(0.05);
  const vec3 along = (to - from) / size, x(1, 0, 0);
  const vec3 edges(size, thick, thick);
  const real cosine = dot(x, along);
  const quat q = cosine < real(-0.999999)
                     ? quat(0, 0, 0, 1)
                     : normalize(quat(1 + cosine, cross(x, along).x, cross(x, along).y,
                                      cross(x, along).z));
  return scene.box(mass, edges, (from + to) / real(2), q);
}

// ---- chains -------------------------------------------------------------------------------------

/// A level chain of cubes of 1 kg and 0.4 m on ball joints, 0.5 m apart. The first cube is static,
/// and the last body is a ball of `ratio` kg.
inline Scene heavy_chain(int links, real ratio) {
  Scene scene{.name = "heavy end"};
  BodyId before = scene.box(0, vec3(real(0.4)), vec3(0));
  for (int k = 1; k <= links + 1; ++k) {
    const vec3 x(real(0.5) * real(k), 0, 0);
    BodyId id;
    if (k <= links) {
      id = scene.box(1, vec3(real(0.4)), x);
    } else {
      id = scene.world.add(ball(ratio, real(0.25), x));
      scene.shapes.push_back({.kind = "ball", .size = {0.5, 0.5, 0.5}});
    }
    on_ball(scene, before, id, x - vec3(real(0.25), 0, 0));
    scene.energy_scale += (k <= links ? 1 : double(ratio)) * 9.81 * 0.5 * k;
    before = id;
  }
  return scene;
}

// ---- loops --------------------------------------------------------------------------------------

/// A net: rows x rows cubes of 1 kg and 0.4 m, 1 m apart, on ball joints midway between neighbours;
/// one corner is static.
inline Scene net(int rows) {
  Scene scene{.name = "net"};
  std::vector<BodyId> ids;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) {
      const bool fixed = i == 0 && j == 0;
      const vec3 x(real(j), 0, real(i));
      ids.push_back(scene.box(fixed ? real(0) : real(1), vec3(real(0.4)), x));
      if (j > 0) on_ball(scene, ids[ids.size() - 2], ids.back(), x - vec3(real(0.5), 0, 0));
      if (i > 0)
        on_ball(scene, ids[ids.size() - 1 - std::size_t(rows)], ids.back(),
                x - vec3(0, 0, real(0.5)));
      scene.energy_scale += 9.81 * (i + j);
    }
  return scene;
}

/// A hub: a ball of 10 kg that hangs from a static cube, with arms of 1 kg on ball joints around
/// it.
inline Scene star(int arms, real mass = 10) {
  Scene scene{.name = "star"};
  const BodyId top = scene.box(0, vec3(real(0.2)), vec3(0, 1, 0));
  const BodyId hub = scene.world.add(ball(mass, real(0.5), vec3(0)));
  scene.shapes.push_back({.kind = "ball", .size = {1, 1, 1}});
  on_ball(scene, top, hub, vec3(0, real(0.5), 0));
  for (int k = 0; k < arms; ++k) {
    const real angle = real(6.283185307179586) * real(k) / real(arms);
    const vec3 out(std::cos(angle), 0, std::sin(angle));
    on_ball(scene, hub, rod(scene, real(0.5) * out, real(1.5) * out), real(0.5) * out);
    scene.energy_scale += 9.81;
  }
  return scene;
}

/// Bricard's linkage: six rods of 1 m along the edges of a cube; the axis of each hinge is
/// perpendicular to its two rods. By their number the rows of six hinges allow no motion, but the
/// linkage moves, because one row depends on the others.
inline Scene bricard() {
  Scene scene{.name = "Bricard", .energy_scale = 5 * 9.81};
  const vec3 corner[] = {vec3(0), vec3(1, 0, 0), vec3(1, 1, 0),
                         vec3(1, 1, 1), vec3(0, 1, 1), vec3(0, 0, 1)};
  std::vector<BodyId> rods;
  for (int k = 0; k < 6; ++k)
    rods.push_back(rod(scene, corner[k], corner[(k + 1) % 6], k == 0 ? real(0) : real(1)));
  for (int k = 0; k < 6; ++k) {
    const vec3 &before = corner[(k + 5) % 6], &here = corner[k], &next = corner[(k + 1) % 6];
    on_hinge(scene, rods[std::size_t((k + 5) % 6)], rods[std::size_t(k)], here,
             cross(here - before, next - here));
  }
  return scene;
}

/// A parallel linkage of `loops` four-bars: upright rods of 1 m side by side on the ground, with a
/// rod between the upper ends of neighbours. All upper rods begin with 1 m/s along x. In the pose
/// in which all rods are level, the linkage could leave the parallel motion.
inline Scene four_bars(int loops) {
  Scene scene{.name = "four-bars", .energy_scale = 9.81 * (1.5 * loops + 0.5)};
  const vec3 z(0, 0, 1);
  const BodyId ground = scene.box(0, vec3(real(loops), real(0.05), real(0.05)),
                                  vec3(real(loops) / 2, 0, 0));
  BodyId coupler{};
  for (int k = 0; k <= loops; ++k) {
    const vec3 low(real(k), 0, 0), high(real(k), 1, 0);
    const BodyId upright = rod(scene, low, high);
    Body& body = scene.world.bodies[upright];
    body.v = vec3(real(0.5), 0, 0), body.w = vec3(0, 0, -1);
    on_hinge(scene, ground, upright, low, z);
    if (k > 0) on_hinge(scene, coupler, upright, high, z);
    if (k == loops) break;
    coupler = rod(scene, high, high + vec3(1, 0, 0));
    scene.world.bodies[coupler].v = vec3(1, 0, 0);
    on_hinge(scene, upright, coupler, high, z);
  }
  return scene;
}

}  // namespace joints::chapter9
