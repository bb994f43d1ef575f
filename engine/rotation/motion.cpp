// The motion of a body without joints.
#include "engine/rotation/free_rotation.h"

#include <algorithm>

namespace joints {

void integrate_forces(Body& body, const vec3& gravity, real h) {
  if (body.is_static()) return;
  body.v += h * (gravity + body.inverse_mass * body.force);
  if (body.torque != vec3(0)) body.w += h * angular_response(body, body.torque);
  if (!body.is_isotropic()) use_mean_rate(body, h);  // else it is w
}

[[gnu::always_inline]] inline static void clamp_speed(vec3& velocity) {
  const real top = std::max({std::abs(velocity.x), std::abs(velocity.y), std::abs(velocity.z)});
  if (top > max_speed) velocity *= max_speed / top;
}

void clamp_speed(Body& body) {
  clamp_speed(body.v);
  clamp_speed(body.w);
}

// Rotates a body by `phi` [rad] about its own axis i. L [body space] keeps its direction in the
// world, so in the body it rotates the other way.
static void rotate_about(int i, real phi, quat& q, vec3& L) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  const real c = std::cos(phi / 2), s = std::sin(phi / 2);
  const vec3 v(q.x, q.y, q.z);
  vec3 turned(0);
  turned[i] = c * v[i] + s * q.w;
  turned[j] = c * v[j] + s * v[k];
  turned[k] = c * v[k] - s * v[j];
  q = quat(c * q.w - s * v[i], turned);  // q (c, s e_i)
  const real cosine = c * c - s * s, sine = 2 * s * c, along_j = L[j];
  L[j] = cosine * L[j] + sine * L[k];
  L[k] = cosine * L[k] - sine * along_j;
}

// A rotation is done in so many equal parts that the size of each is at most this [rad]: the error
// of a part is that of exchanging two rotations. A body of two equal moments has none.
static constexpr real size_of_part = real(0.1);
static constexpr int most_parts = 64;

void rotate_freely(Body& body, real h) {
  const vec3& inverse = body.inverse_inertia_local;
  int a = 0, m = 1, b = 2;  // the axes of the largest, the middle and the smallest moment
  if (inverse[a] > inverse[m]) std::swap(a, m);
  if (inverse[m] > inverse[b]) std::swap(m, b);
  if (inverse[a] > inverse[m]) std::swap(a, m);
  const vec3 momentum = angular_momentum(body);
  vec3 L = inverse[m] * to_local(body, momentum);  // over I_m [rad/s]: no unit of mass counts
  const real of_a = inverse[a] / inverse[m] - 1, of_b = inverse[b] / inverse[m] - 1;
  const real size = std::abs(h) * length(L) * std::sqrt(-of_a * of_b);
  const int parts = int(glm::clamp(std::ceil(size / size_of_part), real(1), real(most_parts)));
  const quat common = rotation(h * inverse[m] * momentum);  // the terms of Eq. 2-11
  const real part = h / real(parts);
  for (int n = 0; n < parts; ++n) {
    if (of_a != 0) rotate_about(a, part / 2 * of_a * L[a], body.q, L);
    if (of_b != 0) rotate_about(b, part * of_b * L[b], body.q, L);
    if (of_a != 0) rotate_about(a, part / 2 * of_a * L[a], body.q, L);
  }
  body.q = normalize(common * body.q);
  set_angular_momentum(body, momentum);
}

// A free rotation by h w keeps L. In the axes of the body, where I is constant, L has become R^T L
// after the first half of it, R = rotation(h/2 w), and the mean rate is the w for which this is
// I w. Newton's method needs two to four iterations.
static constexpr int most_newton = 4;
static constexpr real near_enough = real(1e-6);  // the error after such a change is its square

void use_mean_rate(Body& body, real h) {
  if (body.is_isotropic() || body.w_is_mean) return;
  body.w_is_mean = true;
  const vec3& inverse = body.inverse_inertia_local;
  const real scale = glm::max(inverse.x, glm::max(inverse.y, inverse.z));
  const vec3 moments = scale * (real(1) / body.inverse_inertia_local);  // the smallest is 1
  const vec3 start = to_local(body, body.w), L = moments * start;
  body.precession = vec3(0);
  body.mean = body.w;
  if (cross(start, L) == vec3(0)) return;  // it rotates about one of its axes
  vec3 w = start;
  for (int newton = 0; newton < most_newton; ++newton) {
    const vec3 middle = conjugate(rotation(h / 2 * w)) * L;
    mat3 slope = (-h / 2) * skew(middle);
    for (int k = 0; k < 3; ++k) slope[k][k] = moments[k];
    const vec3 change = glm::inverse(slope) * (moments * w - middle);
    w -= change;
    if (dot(change, change) <= near_enough * near_enough * dot(w, w)) break;
  }
  body.precession = to_world(body, w - start);
  body.mean = body.w += body.precession;
}

// After an impulse that has changed the rate of a fast rotation: the mean rate for the new
// momentum. Returns true if w has changed.
static bool renew_mean_rate(Body& body, real h) {
  if (!body.w_is_mean) return false;
  const vec3 change = body.w - body.mean;
  const real fastest = std::max(dot(body.w, body.w), dot(body.mean, body.mean));
  constexpr real fraction = real(0.1), turn = real(0.3);  // of the rate; in a step [rad]
  if (dot(change, change) <= fraction * fraction * fastest || h * h * fastest <= turn * turn)
    return false;
  use_own_rate(body);
  use_mean_rate(body, h);
  return true;
}

bool renew_mean_rates(Bodies& bodies, real h) {
  bool any = false;
  for (Body& body : bodies) any = renew_mean_rate(body, h) || any;
  return any;
}

void use_own_rate(Body& body) {
  if (body.w_is_mean) body.w -= body.precession;
  body.w_is_mean = false;
}

// A body is thin if one moment is more than so many times as large as another one.
static constexpr real thin = 20;
// About its axis a thin body rotates by L/I with a tiny I: there an error of the direction of that
// axis, small as it may be, is an error of the energy.
static bool is_thin(const Body& body) {
  const vec3& inverse = body.inverse_inertia_local;
  return glm::max(inverse.x, glm::max(inverse.y, inverse.z)) >
         thin * glm::min(inverse.x, glm::min(inverse.y, inverse.z));
}

void integrate_pose(Body& body, real h) {
  if (body.is_static() && !body.kinematic) return;
  // Without an impulse the rotation is free. With one, the rows hold for a rotation by h w, w being
  // the mean rate; for a thin body rotate_freely() is nearer to the truth than these rows.
  if (body.w_is_mean && (body.w == body.mean || is_thin(body))) use_own_rate(body);
  clamp_speed(body.v);
  clamp_speed(body.w);
  body.x += h * body.v;
  if (body.w == vec3(0)) return use_own_rate(body);  // impulses have stopped it
  if (!body.is_isotropic() && !body.w_is_mean) return rotate_freely(body, h);
  const quat next = normalize(rotation(h * body.w) * body.q);
  if (body.w_is_mean) {
    use_own_rate(body);
    const vec3 L = angular_momentum(body);
    body.q = next;
    return set_angular_momentum(body, L);
  }
  body.q = next;  // its moments are equal: no rotation changes I w
}

}  // namespace joints
