// The articulated-body recursion (Featherstone 1983, 2008) in world axes at the joints' anchors.
#include "reduced/link.h"

namespace joints {

namespace {

mat3 outer(const vec3& a, const vec3& b) { return mat3(a * b.x, a * b.y, a * b.z); }

// skew(d) A, column by column
mat3 crossed(const vec3& d, const mat3& A) {
  return mat3(cross(d, A[0]), cross(d, A[1]), cross(d, A[2]));
}

}  // namespace

mat3 inverse_of(const mat3& A) {
  const real size = A[0][0] + A[1][1] + A[2][2];
  if (!(size > 0)) return mat3(0);
  return inverse(A / size) / size;  // the determinant neither overflows nor vanishes
}

void place(TreeLink& link, const TreeLink& parent) {
  link.d = parent.R * link.from_parent_local;
  if (link.freedom == Freedom::hinge) {
    const real half = link.x / 2;
    const quat turned = std::cos(half) * link.start + std::sin(half) * link.start_axis;
    link.q = parent.q * turned;  // (11-1)
    link.a = parent.R * link.axis_local;
  } else if (link.freedom == Freedom::slider) {
    link.q = parent.q * link.start;
    link.a = parent.R * link.axis_local;
    link.d += link.x * link.a;  // (11-2)
  } else if (link.freedom == Freedom::weld) {
    link.q = parent.q * link.start;
  }
  link.R = mat3_cast(link.q);
  link.c = link.R * link.centre_local;
  if (link.rotates_inertia) {
    const vec3& I = link.inertia_local;
    link.inertia = mat3(I.x * link.R[0], I.y * link.R[1], I.z * link.R[2]) * transpose(link.R);
  }
}

void move(TreeLink& link, const TreeLink& parent) {
  const vec3& w = parent.w;
  link.gamma = cross(w, cross(w, link.d));  // (11-5)
  if (link.freedom == Freedom::hinge) {
    const vec3 relative = link.rate * link.a;
    link.w = w + relative;             // (11-3)
    link.zeta = cross(w, relative);    // (11-4)
  } else if (link.freedom != Freedom::ball) {
    link.w = w;
    if (link.freedom == Freedom::slider) link.gamma += 2 * link.rate * cross(w, link.a);  // (11-5)
  }
}

void locate(TreeLink& link, const TreeLink& parent) {
  link.centre = parent.centre - parent.c + link.d + link.c;
  link.v = parent.v + cross(parent.w, link.d - parent.c) + cross(link.w, link.c);
  if (link.freedom == Freedom::slider) link.v += link.rate * link.a;
}

void begin_inertia(TreeLink& link) {
  const vec3& c = link.c;
  const real m = link.mass;
  link.M = mat3(m);
  link.H = m * skew(c);
  link.J = link.inertia;  // (11-6): I + m (c.c E - c c^T)
  for (int k = 0; k < 3; ++k) {
    link.J[k] -= (m * c[k]) * c;
    link.J[k][k] += m * dot(c, c);
  }
}

void begin_bias(TreeLink& link) {
  const vec3& w = link.w;
  link.f = link.mass * cross(w, cross(w, link.c)) - link.force;  // (11-7)
  link.n = cross(link.c, link.f) - link.torque;                  // (11-7)
  if (link.rotates_inertia) link.n += cross(w, link.inertia * w);
}

void eliminate(TreeLink& link) {
  if (link.freedom == Freedom::ball) {
    const mat3 over_J = inverse_of(link.J), B = over_J * link.H;
    link.M -= transpose(link.H) * B;  // (11-10)
    link.J = over_J;
    link.H = B;
    return;
  }
  if (link.freedom == Freedom::hinge) {
    link.Uw = link.J * link.a;  // (11-8)
    link.Uv = link.a * link.H;  // H^T a
    link.D = dot(link.a, link.Uw);
  } else if (link.freedom == Freedom::slider) {
    link.Uw = link.H * link.a;  // (11-8)
    link.Uv = link.M * link.a;
    link.D = dot(link.a, link.Uv);
  } else {
    return;
  }
  const real D = link.D + link.added;
  link.over_D = D > 0 ? 1 / D : real(0);
  if (link.held) return;
  const vec3 w = link.over_D * link.Uw, v = link.over_D * link.Uv;
  link.J -= outer(link.Uw, w);  // (11-9)
  link.H -= outer(link.Uw, v);
  link.M -= outer(link.Uv, v);
}

void add_inertia(const TreeLink& link, TreeLink& parent) {
  const vec3& d = link.d;
  const mat3 XM = crossed(d, link.M);
  parent.M += link.M;
  if (link.freedom == Freedom::ball) {  // its J and H are zero
    parent.H += XM;
    parent.J += crossed(d, transpose(XM));
    return;
  }
  const mat3 moved = link.H + XM;
  parent.H += moved;                                                   // (11-11)
  parent.J += link.J + transpose(crossed(d, transpose(link.H))) +
              crossed(d, transpose(moved));                            // (11-11)
}

void add_bias(TreeLink& link, TreeLink& parent) {
  vec3 n = link.n, f = link.f;
  if (link.freedom == Freedom::ball) {
    f += link.M * link.gamma - n * link.H;  // (11-12); n^T J^-1 H
    n = vec3(0);
  } else {
    n += link.H * link.gamma;  // (11-12)
    f += link.M * link.gamma;
    if (link.freedom == Freedom::hinge) {
      link.k = link.tau - dot(link.a, link.n);
      n += link.J * link.zeta;
      f += link.zeta * link.H;
    } else if (link.freedom == Freedom::slider) {
      link.k = link.tau - dot(link.a, link.f);
    }
    if (link.freedom != Freedom::weld) {
      const real along = link.held ? link.acceleration : link.over_D * link.k;
      n += along * link.Uw;  // (11-12)
      f += along * link.Uv;
    }
  }
  parent.f += f;
  parent.n += n + cross(link.d, f);
}

void accelerate(TreeLink& link, const TreeLink& parent) {
  link.a_A = parent.a_A + cross(parent.alpha, link.d) + link.gamma;  // (11-13)
  if (link.freedom == Freedom::ball) {
    link.alpha = -(link.J * link.n + link.H * link.a_A);  // (11-14)
    return;
  }
  link.alpha = parent.alpha;
  if (link.freedom == Freedom::hinge) link.alpha += link.zeta;
  if (link.freedom != Freedom::hinge && link.freedom != Freedom::slider) return;
  const real felt = dot(link.Uw, link.alpha) + dot(link.Uv, link.a_A);
  if (link.held) {
    link.tau += felt + link.D * link.acceleration - link.k;  // (11-15)
  } else {
    link.acceleration = link.over_D * (link.k - felt);  // (11-14)
  }
  (link.freedom == Freedom::hinge ? link.alpha : link.a_A) += link.acceleration * link.a;
}

void accelerate_root(TreeLink& root) {
  const mat3 B = root.H * inverse_of(root.M);
  const mat3 J = root.J - B * transpose(root.H);
  root.alpha = -(inverse_of(J) * (root.n - B * root.f));                 // (11-16)
  root.a_A = -(inverse_of(root.M) * (root.f + root.alpha * root.H));     // (11-16)
}

}  // namespace joints
