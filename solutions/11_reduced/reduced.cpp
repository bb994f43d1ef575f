// Chapter 11: reduced coordinates. Replace each todo(...) by your own code; the text is in
// README.md. Vectors are in world axes unless their names end in _local.
#include "chapters/11_reduced/reduced.h"

#include "engine/instruments/todo.h"

namespace joints {

// ---- outward: poses and velocities --------------------------------------------------------------

void place(TreeLink& link, const TreeLink& parent) {
  link.d = parent.R * link.from_parent_local;
  link.a = parent.R * link.axis_local;
  // begin [exercise 11.1]
  // Set link.q of a hinge, a slider and a weld, and add to link.d what a slider moves by. Other
  // links (ball, free, fixed) have a q of their own, which stays.
  if (link.freedom == Freedom::hinge) {
    const real half = link.x / 2;
    const quat turned = std::cos(half) * link.start + std::sin(half) * link.start_axis;
    link.q = parent.q * turned;  // Eq. 11-1
  } else if (link.freedom == Freedom::slider) {
    link.q = parent.q * link.start;
    link.d += link.x * link.a;  // Eq. 11-2
  } else if (link.freedom == Freedom::weld) {
    link.q = parent.q * link.start;
  }
  // end [exercise 11.1]
  link.R = mat3_cast(link.q);
  link.c = link.R * link.centre_local;
  if (link.rotates_inertia) {
    const vec3& I = link.inertia_local;
    link.inertia = mat3(I.x * link.R[0], I.y * link.R[1], I.z * link.R[2]) * transpose(link.R);
  }
}

void move(TreeLink& link, const TreeLink& parent) {
  const vec3& w = parent.w;
  // begin [exercise 11.1]
  // Set link.w (but not that of a ball), link.zeta of a hinge, and link.gamma, of every kind.
  link.gamma = cross(w, cross(w, link.d));  // Eq. 11-5
  if (link.freedom == Freedom::hinge) {
    const vec3 relative = link.rate * link.a;
    link.w = w + relative;           // Eq. 11-3
    link.zeta = cross(w, relative);  // Eq. 11-4
  } else if (link.freedom != Freedom::ball) {
    link.w = w;
    if (link.freedom == Freedom::slider)
      link.gamma += 2 * link.rate * cross(w, link.a);  // Eq. 11-5
  }
  // end [exercise 11.1]
}

void locate(TreeLink& link, const TreeLink& parent) {
  link.centre = parent.centre - parent.c + link.d + link.c;
  link.v = parent.v + cross(parent.w, link.d - parent.c) + cross(link.w, link.c);
  if (link.freedom == Freedom::slider) link.v += link.rate * link.a;
}

// ---- inward: inertia and bias -------------------------------------------------------------------

void begin_inertia(TreeLink& link) {
  const vec3& c = link.c;
  const real m = link.mass;
  // begin [exercise 11.2]
  // Set link.M, link.H and link.J of the body alone, about A.
  link.M = mat3(m);
  link.H = m * skew(c);
  link.J = link.inertia;
  for (int k = 0; k < 3; ++k) {
    link.J[k] -= (m * c[k]) * c;
    link.J[k][k] += m * dot(c, c);  // Eq. 11-6
  }
  // end [exercise 11.2]
}

void begin_bias(TreeLink& link) {
  const vec3 &w = link.w, &c = link.c;
  // begin [exercise 11.2]
  // Set link.f and link.n: what holds the body if A does not accelerate and it rotates evenly.
  link.f = link.mass * cross(w, cross(w, c)) - link.force;  // Eq. 11-7
  link.n = cross(c, link.f) - link.torque;                  // Eq. 11-7
  if (link.rotates_inertia) link.n += cross(w, link.inertia * w);
  // end [exercise 11.2]
}

void eliminate_ball(TreeLink& link) {
  const mat3 over_J = inverse_of(link.J), B = over_J * link.H;
  link.M -= transpose(link.H) * B;  // Eq. 11-10
  link.J = over_J;
  link.H = B;
}

void eliminate(TreeLink& link) {
  const bool hinge = link.freedom == Freedom::hinge, slider = link.freedom == Freedom::slider;
  if (link.freedom == Freedom::ball) eliminate_ball(link);
  if (!hinge && !slider) return;  // a weld passes on all
  // begin [exercise 11.3]
  // Set link.Uw, link.Uv and link.D, then link.over_D = 1 / (D + added), or 0 if that is 0. If the
  // link is not held, leave of J, H and M what the parent feels.
  if (hinge) {
    link.Uw = link.J * link.a;  // Eq. 11-8
    link.Uv = link.a * link.H;  // H^T a
    link.D = dot(link.a, link.Uw);
  } else {
    link.Uw = link.H * link.a;  // Eq. 11-8
    link.Uv = link.M * link.a;
    link.D = dot(link.a, link.Uv);
  }
  const real D = link.D + link.added;
  link.over_D = D > 0 ? 1 / D : real(0);
  if (!link.held) {
    const vec3 w = link.over_D * link.Uw, v = link.over_D * link.Uv;
    link.J -= outerProduct(link.Uw, w);  // Eq. 11-9
    link.H -= outerProduct(link.Uw, v);
    link.M -= outerProduct(link.Uv, v);
  }
  // end [exercise 11.3]
}

void add_inertia(const TreeLink& link, TreeLink& parent) {
  const vec3& d = link.d;
  const mat3 XM = crossed(d, link.M);
  if (link.freedom == Freedom::ball) {  // it passes on M alone
    parent.M += link.M;
    parent.H += XM;
    parent.J += crossed(d, transpose(XM));
    return;
  }
  // begin [exercise 11.3]
  // Add J, H and M of the link to those of the parent, with the lever d. XM is skew(d) M.
  const mat3 moved = link.H + XM;
  parent.M += link.M;
  parent.H += moved;
  parent.J += link.J + transpose(crossed(d, transpose(link.H))) +
              crossed(d, transpose(moved));  // Eq. 11-11
  // end [exercise 11.3]
}

void add_bias(TreeLink& link, TreeLink& parent) {
  vec3 n = link.n, f = link.f;
  if (link.freedom == Freedom::ball) {
    f += link.M * link.gamma - n * link.H;  // Eq. 11-12 with n^T J^-1 H
    n = vec3(0);
  } else {
    const bool hinge = link.freedom == Freedom::hinge, slider = link.freedom == Freedom::slider;
    // begin [exercise 11.3]
    // Set link.k of a hinge or slider, and make of n and f what the parent feels. The acceleration
    // along the free motion is link.acceleration if the link is held; if not, this much of it
    // belongs to the bias: over_D k.
    n += link.H * link.gamma;  // Eq. 11-12
    f += link.M * link.gamma;
    if (hinge) {
      link.k = link.tau - dot(link.a, link.n);
      n += link.J * link.zeta;
      f += link.zeta * link.H;
    } else if (slider) {
      link.k = link.tau - dot(link.a, link.f);
    }
    if (hinge || slider) {
      const real along = link.held ? link.acceleration : link.over_D * link.k;
      n += along * link.Uw;  // Eq. 11-12
      f += along * link.Uv;
    }
    // end [exercise 11.3]
  }
  parent.f += f;
  parent.n += n + cross(link.d, f);
}

// ---- outward: accelerations ---------------------------------------------------------------------

void accelerate(TreeLink& link, const TreeLink& parent) {
  link.a_A = parent.a_A + cross(parent.alpha, link.d) + link.gamma;  // Eq. 11-13
  if (link.freedom == Freedom::ball) {
    link.alpha = -(link.J * link.n + link.H * link.a_A);  // Eq. 11-14 for three numbers
    return;
  }
  link.alpha = parent.alpha;
  if (link.freedom == Freedom::hinge) link.alpha += link.zeta;
  if (link.freedom != Freedom::hinge && link.freedom != Freedom::slider) return;
  // begin [exercise 11.4]
  // Here alpha and a_A are those of the child before its own acceleration along S. If the link is
  // held, set link.tau (link.tau - link.k is S^T (n, f) of the old bias); if not, set
  // link.acceleration by Eq. 11-14. Then add the acceleration along S to alpha or a_A.
  const real felt = dot(link.Uw, link.alpha) + dot(link.Uv, link.a_A);
  if (link.held) {
    link.tau += felt + link.D * link.acceleration - link.k;  // Eq. 11-16
  } else {
    link.acceleration = link.over_D * (link.k - felt);  // Eq. 11-14
  }
  (link.freedom == Freedom::hinge ? link.alpha : link.a_A) += link.acceleration * link.a;
  // end [exercise 11.4]
}

void accelerate_root(TreeLink& root) {
  const mat3 B = root.H * inverse_of(root.M);
  const mat3 J = root.J - B * transpose(root.H);
  root.alpha = -(inverse_of(J) * (root.n - B * root.f));              // Eq. 11-15
  root.a_A = -(inverse_of(root.M) * (root.f + root.alpha * root.H));  // Eq. 11-15
}

mat3 inverse_of(const mat3& A) {
  const real size = A[0][0] + A[1][1] + A[2][2];
  if (!(size > 0)) return mat3(0);
  return inverse(A / size) / size;  // the determinant neither overflows nor vanishes
}

}  // namespace joints
