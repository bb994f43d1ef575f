// A trolley on a shaft with welded bars, and a loop by hand that moves it with the functions of
// chapter 5's exercises. Read it; there is nothing to edit here.
#pragma once

#include <cmath>
#include <initializer_list>
#include <utility>

#include "chapters/01_distance/rods.h"
#include "engine/instruments/scene.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"
#include "joints/part_joint.h"

/// \addtogroup chapter5
/// @{
namespace joints::chapter5 {

/// Solves A x = b by elimination, for any matrix: a reader's K need not be symmetric.
template <int N>
Vector<N> solved(Matrix<N> A, Vector<N> b) {
  for (int k = 0; k < N; ++k) {
    int best = k;
    for (int i = k + 1; i < N; ++i)
      if (std::abs(A[i][k]) > std::abs(A[best][k])) best = i;
    std::swap(A[k], A[best]), std::swap(b[k], b[best]);
    for (int i = k + 1; i < N; ++i) {
      const real factor = A[i][k] / A[k][k];
      for (int j = k; j < N; ++j) A[i][j] -= factor * A[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (int k = N - 1; k >= 0; --k) {
    for (int j = k + 1; j < N; ++j) b[k] -= A[k][j] * b[j];
    b[k] /= A[k][k];
  }
  return b;
}

/// The rows of a joint in a step. They fall into two halves: those of the second hold the
/// orientation, and are gone once the joint is broken.
template <int N>
struct Held {
  Jacobian<N> J{};      ///< its rows
  Matrix<N> K{};        ///< by the exercises [1/kg, 1/(kg m) or 1/(kg m^2)]
  Vector<N> bias{};     ///< beta C / h [unit of each row per s]
  Vector<N> impulse{};  ///< accumulated in the step [N s or N m s]
  bool broken = false;  ///< only the first half is solved

  /// Solves the rows for the present velocities.
  void iterate(Body& body1, Body& body2) {
    const int rows = broken ? N / 2 : N;
    Vector<N> error{};
    for (int i = 0; i < rows; ++i) error[i] = -(row_velocity(J[i], body1, body2) + bias[i]);
    Matrix<N> A = K;
    for (int i = rows; i < N; ++i)
      for (int j = 0; j < N; ++j) A[i][j] = A[j][i] = i == j;
    const Vector<N> lambda = solved<N>(A, error);
    for (int i = 0; i < rows; ++i) {
      apply_impulse(J[i], lambda[i], body1, body2);
      impulse[i] += lambda[i];
    }
  }
};

/// A trolley runs to and fro on a slanted shaft, on a spring, and carries two bent arms of welded
/// bars. What breaks keeps its pin: a weld still is a ball, the sleeve a ring.
struct Trolley {
  /// A weld and what it bears.
  struct Seam {
    int body1, body2;   ///< slots
    Weld weld;          ///< its anchor is beside the seam
    vec3 middle_local;  ///< of the seam [m, in the space of body 2]
    Strength strength;  ///< what it bears, about the middle of the seam
    Held<6> rows{};     ///< of the present step
  };
  Scene scene{.name = "trolley"};  ///< world, solver, marks and shapes
  std::vector<Seam> seams;         ///< all welds
  Kit kit;                         ///< of the sleeve
  Held<4> sleeve_rows{};           ///< of the present step
  Strength sleeve_strength{.torque = 800};  ///< about a point of the shaft
  static constexpr real stiffness = 300;  ///< of the spring [N/m]

  /// Makes the scene.
  explicit Trolley(const Settings& settings) {
    scene.solver.iterations = 10;
    scene.h = real(0.016);
    scene.energy_scale = 400;
    const quat slant = rotation(vec3(real(0.25), real(-0.35), real(0.15)));
    const BodyId shaft = scene.box(0, vec3(real(4.6), real(0.1), real(0.1)), vec3(0), slant);
    const BodyId trolley = scene.box(20, vec3(real(0.7), real(0.4), real(0.5)),
                                     slant * vec3(0, real(-0.3), 0), slant);
    Bodies& bodies = scene.world.bodies;
    const vec3 axis = to_world(bodies[shaft], vec3(1, 0, 0));
    kit = {point_at(bodies[shaft], bodies[trolley], vec3(0)),
           line_along(bodies[shaft], bodies[trolley], vec3(0), axis),
           axis_along(bodies[shaft], bodies[trolley], axis),
           lock_of(bodies[shaft], bodies[trolley])};
    const auto arm = [&](BodyId before, const vec3& from, std::initializer_list<vec3> turns,
                         std::initializer_list<Strength> bear) {
      vec3 seam = slant * from;
      for (std::size_t k = 0; k < turns.size(); ++k) {
        const quat q = rotation(turns.begin()[k]);
        const vec3 half = q * vec3(real(0.45), 0, 0);
        const BodyId bar = scene.box(8, vec3(real(0.9), real(0.3), real(0.2)), seam + half, q);
        const vec3 anchor = seam + (k == 0 ? real(0.4) : real(0.05)) * half;
        auto& weld = scene.world.add<FixedJoint>(before, bar, anchor);
        weld.beta = settings.beta;
        scene.mark(before, bar, anchor);
        seams.push_back({int(before.slot), int(bar.slot), weld.weld,
                         to_local(bodies[bar], seam - bodies[bar].x), bear.begin()[k]});
        seam += real(2) * half;
        before = bar;
      }
    };
    arm(trolley, vec3(real(0.35), real(-0.3), real(0.1)),
        {vec3(real(0.5), real(0.6), real(0.5)), vec3(real(-0.4), real(-0.7), real(1.4))},
        {{.torque = 185}, {.force = 130}});
    arm(trolley, vec3(real(-0.35), real(-0.3), real(-0.1)),
        {vec3(real(0.3), real(2.4), real(-0.3)), vec3(real(0.6), real(0.4), real(-1.2))},
        {{.force = 330, .torque = 300}, {.torque = 60}});
    arm(shaft, vec3(real(1.4), 0, 0), {vec3(real(0.3), real(0.4), real(-1.1))}, {{}});
    using Sleeve = Composite<Line, Axis>;
    auto& sleeve = scene.world.add<PartJoint<Sleeve>>(shaft, trolley, Sleeve{kit.line, kit.axis});
    sleeve.beta = settings.beta;
  }

  /// The spring along the shaft. Called before each step.
  void pull() {
    Bodies& bodies = scene.world.bodies;
    const vec3 axis = to_world(bodies.at(0), vec3(1, 0, 0));
    bodies.at(1).force = -stiffness * (dot(axis, bodies.at(1).x) + real(0.9)) * axis;
  }

  /// Forces, rows, iterations, positions; then, what breaks. \param h the step [s]
  void step(Bodies& bodies, const vec3& gravity, int iterations, real beta, real h) {
    integrate_forces(bodies, gravity, h);
    for (Seam& one : seams) {
      const Body &a = bodies.at(one.body1), &b = bodies.at(one.body2);
      const Vector<6> C = one.weld.error(a, b);
      one.rows.J = one.weld.jacobian(a, b);
      one.rows.K = weld_K(one.weld, a, b);
      for (int i = 0; i < 6; ++i) one.rows.bias[i] = beta / h * C[i], one.rows.impulse[i] = 0;
    }
    Body &shaft = bodies.at(0), &trolley = bodies.at(1);
    const FourRows four = sleeve(kit, shaft, trolley);
    sleeve_rows.J = four.J, sleeve_rows.K = four.K;
    for (int i = 0; i < 4; ++i)
      sleeve_rows.bias[i] = beta / h * four.C[i], sleeve_rows.impulse[i] = 0;
    for (int iteration = 0; iteration < iterations; ++iteration) {
      sleeve_rows.iterate(shaft, trolley);
      for (Seam& one : seams) one.rows.iterate(bodies.at(one.body1), bodies.at(one.body2));
    }
    for (Seam& one : seams) {
      const Body& bar = bodies.at(one.body2);
      const Reaction load = about(carried(one.rows.impulse, h),
                                  world_point(bar, one.weld.first.anchor2_local),
                                  world_point(bar, one.middle_local));
      one.rows.broken = one.rows.broken || breaks(load, one.strength);
    }
    const Reaction load = transmitted(sleeve_rows.J, sleeve_rows.impulse, h, trolley,
                                      world_point(shaft, vec3(real(0.8), 0, 0)));
    sleeve_rows.broken = sleeve_rows.broken || breaks(load, sleeve_strength);
    integrate_poses(bodies, h);
  }
};

}  // namespace joints::chapter5
/// @}
