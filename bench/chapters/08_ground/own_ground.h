// A loop by hand: one box on the ground, moved by the functions of chapter 8's exercises and the
// rows of chapters 1 and 6.
#pragma once

#include "chapters/02_ball/ball.h"
#include "chapters/06_baumgarte/baumgarte.h"
#include "chapters/08_ground/ground.h"

/// \addtogroup chapter8
/// @{
namespace joints {

/// A body on the ground, and a step of it written out. Cold: every step begins without impulses.
class OwnGround {
 public:
  Body ground, body;            ///< body 1, static, and body 2
  std::vector<Corner> corners;  ///< of the body, those that may touch
  real friction = real(0.5);    ///< coefficient mu [1]
  real beta = real(0.2);        ///< fraction of a penetration fed back per step [1]
  int iterations = 30;          ///< iterations per step
  bool normal_first = false;    ///< the normal row before the friction of its corner (question 2)
  vec3 gravity{0, real(-9.81), 0};  ///< [m/s^2]

  /// Forces, rows of the corners that touch, iterations, positions. \param h the step [s]
  void step(real h) {
    integrate_forces(body, gravity, h);
    prepare(h);
    for (int iteration = 0; iteration < iterations; ++iteration)
      for (Rows& rows : touching_) {
        if (normal_first) push(rows);
        rub(rows);
        if (!normal_first) push(rows);
      }
    body.x += h * body.v;
    body.q = turned(body.q, body.w, h);
  }

  /// Sum of the impulses of all normal rows in the last step [N s].
  real normal() const {
    real sum = 0;
    for (const Rows& rows : touching_) sum += rows.normal;
    return sum;
  }
  /// Sum of the impulses of all friction rows in the last step, a vector in the world [N s].
  vec3 sideways() const {
    vec3 sum(0);
    for (const Rows& rows : touching_)
      for (std::size_t i = 0; i < 2; ++i) sum += rows.sideways[i] * rows.along[i].v2;
    return sum;
  }

 private:
  // A corner that touches, prepared for the iterations of a step.
  struct Rows {
    std::array<Row, 2> along;
    Row up;
    std::array<real, 2> K_along;
    real K_up, bias;
    std::array<real, 2> sideways{};  // accumulated in the step [N s]
    real normal = 0;
  };
  real rate(const Row& J) const {
    return dot(J.v1, ground.v) + dot(J.w1, ground.w) + dot(J.v2, body.v) + dot(J.w2, body.w);
  }
  void rub(Rows& rows) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Row& J = rows.along[i];
      const real change = friction_impulse(rate(J), rows.K_along[i], friction, rows.normal,
                                           rows.sideways[i]);
      apply_impulse(J, change, ground, body);
    }
  }
  void push(Rows& rows) {
    const real wish = row_impulse(rows.up, rows.K_up, rows.bias, ground, body);
    apply_impulse(rows.up, clamp_sum(wish, rows.normal), ground, body);
  }
  void prepare(real h) {
    touching_.clear();
    const vec3 n = Corner::up(ground);
    for (const Corner& corner : corners) {
      const real C = corner.error(ground, body);  // Eq. 8-1
      const Row up = corner.jacobian(ground, body);
      if (C + h * rate(up) >= real(0.1) * h) continue;  // Eq. 8-4
      const vec3 p = corner.point(ground, body);
      const auto t = tangents(n, point_velocity(body, p - body.x) -
                                     point_velocity(ground, p - ground.x));  // Eq. 8-5
      Rows rows{{corner.along(t[0], ground, body), corner.along(t[1], ground, body)}, up, {},
                corner.K(ground, body), limit_bias(C, beta, h)};  // Eq. 8-3
      for (std::size_t i = 0; i < 2; ++i)
        rows.K_along[i] = coupling(rows.along[i], rows.along[i], ground, body);
      touching_.push_back(rows);
    }
  }

  std::vector<Rows> touching_;
};

}  // namespace joints
/// @}
