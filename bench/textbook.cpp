// The textbook's hinge and step.
#include "bench/textbook.h"

namespace joints::bench {

TextbookHinge::TextbookHinge(Body& body1, Body& body2, const vec3& anchor, const vec3& axis,
                             real beta)
    : body1_(body1), body2_(body2), anchor1_(to_local(body1, anchor - body1.x)),
      anchor2_(to_local(body2, anchor - body2.x)), axis1_(to_local(body1, axis)), beta_(beta) {
  const vec3 any = std::abs(axis.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 b = normalize(cross(axis, any));
  b_ = to_local(body2, b);
  c_ = to_local(body2, cross(axis, b));
}

void TextbookHinge::set_up(real h) {
  r1_ = to_world(body1_, anchor1_);
  r2_ = to_world(body2_, anchor2_);
  I1_ = inverse_inertia(body1_);
  I2_ = inverse_inertia(body2_);
  const mat3 s1 = skew(r1_), s2 = skew(r2_);
  const mat3 K = mat3(body1_.inverse_mass + body2_.inverse_mass) - s1 * I1_ * s1 - s2 * I2_ * s2;
  inverse_K_ = inverse(K);
  point_bias_ = beta_ / h * (body2_.x + r2_ - body1_.x - r1_);

  const vec3 a1 = to_world(body1_, axis1_), b = to_world(body2_, b_), c = to_world(body2_, c_);
  ba_ = cross(b, a1);
  ca_ = cross(c, a1);
  const mat3 I = I1_ + I2_;
  const real xx = dot(ba_, I * ba_), xy = dot(ba_, I * ca_), yy = dot(ca_, I * ca_);
  const real determinant = xx * yy - xy * xy;
  axis_inverse_K_[0] = yy / determinant;
  axis_inverse_K_[1] = -xy / determinant;
  axis_inverse_K_[2] = xx / determinant;
  axis_bias_[0] = beta_ / h * dot(a1, b);
  axis_bias_[1] = beta_ / h * dot(a1, c);
}

inline void TextbookHinge::solve_here() {
  const vec3 turning = body2_.w - body1_.w;
  const real e0 = dot(ba_, turning) + axis_bias_[0], e1 = dot(ca_, turning) + axis_bias_[1];
  const vec3 turn = -(axis_inverse_K_[0] * e0 + axis_inverse_K_[1] * e1) * ba_ -
                    (axis_inverse_K_[1] * e0 + axis_inverse_K_[2] * e1) * ca_;
  body1_.w -= I1_ * turn;
  body2_.w += I2_ * turn;

  const vec3 rate = body2_.v + cross(body2_.w, r2_) - body1_.v - cross(body1_.w, r1_);
  const vec3 push = -(inverse_K_ * (rate + point_bias_));
  body1_.v -= body1_.inverse_mass * push;
  body1_.w -= I1_ * cross(r1_, push);
  body2_.v += body2_.inverse_mass * push;
  body2_.w += I2_ * cross(r2_, push);
}

void TextbookHinge::solve() { solve_here(); }

void TextbookSolver::step(World& world, real h) {
  integrate_forces(world.bodies, world.gravity, h);
  for (const auto& joint : joints) joint->set_up(h);
  for (int i = 0; i < iterations; ++i)
    for (const auto& joint : joints) {
      if (recompute) joint->set_up(h);
      joint->solve();
    }
  integrate_poses(world.bodies, h);
}

void FlatSolver::step(World& world, real h) {
  integrate_forces(world.bodies, world.gravity, h);
  for (TextbookHinge& hinge : hinges) hinge.TextbookHinge::set_up(h);
  for (int i = 0; i < iterations; ++i)
    for (TextbookHinge& hinge : hinges) hinge.solve_here();
  integrate_poses(world.bodies, h);
}

}  // namespace joints::bench
