// Makes bodies, and moves them without joints.
#include "engine/body.h"

#include <algorithm>
#include <atomic>

namespace joints {

// ---- validation ---------------------------------------------------------------------------------

namespace {

// A moment is an integral over two squares of coordinates; each square is in two moments.
bool are_moments(const vec3& moments) {
  const real sum = moments.x + moments.y + moments.z;
  const real largest = glm::max(moments.x, glm::max(moments.y, moments.z));
  return 2 * largest <= real(1.001) * sum;  // flat bodies are at the limit
}

}  // namespace

void check(const Body& body) {
  require_finite("x", body.x);
  require_unit("q", body.q);
  require_finite("v", body.v);
  require_finite("w", body.w);
  require_finite("force", body.force);
  require_finite("torque", body.torque);
  const vec3& inertia = body.inverse_inertia_local;
  require(finite(body.inverse_mass) && body.inverse_mass >= 0, "inverse_mass", body.inverse_mass,
          "must be finite and not negative");
  require(finite(inertia) && inertia.x >= 0 && inertia.y >= 0 && inertia.z >= 0,
          "inverse_inertia_local", inertia, "must be finite and not negative");
  const bool turns = inertia.x > 0 && inertia.y > 0 && inertia.z > 0;
  require(body.inverse_mass > 0 ? turns : inertia == vec3(0), "inverse_inertia_local", inertia,
          "must be zero where inverse_mass is (static), and positive elsewhere");
  require(!body.kinematic || body.is_static(),
          "kinematic: only a static body can be; forces move this one");
}

// ---- construction -------------------------------------------------------------------------------

// M times a diagonal matrix.
static mat3 scaled(const mat3& M, const vec3& diagonal) {
  return mat3(M[0] * diagonal.x, M[1] * diagonal.y, M[2] * diagonal.z);
}

mat3 rotated_inverse_inertia(const Body& body) {
  const mat3 R = mat3_cast(body.q);
  return scaled(R, body.inverse_inertia_local) * transpose(R);
}

Body static_body(const vec3& x, const quat& q) {
  require(finite(x), "x: the place of a body must be finite");
  require(finite(q) && length(q) > 0, "q: an orientation must be finite and not zero");
  Body body;
  body.x = x;
  body.q = normalize(q);
  return body;
}

Body body_with(real mass, const vec3& inertia_local, const vec3& x, const quat& q) {
  require(finite(mass) && mass > 0, "mass: must be positive and finite [kg]");
  require(finite(inertia_local) && inertia_local.x > 0 && inertia_local.y > 0 &&
              inertia_local.z > 0,
          "inertia: the three moments must be positive and finite [kg m^2]");
  Body body = static_body(x, q);
  body.inverse_mass = 1 / mass;
  body.inverse_inertia_local = real(1) / inertia_local;
  return body;
}

void check_size(const vec3& size) {
  require(finite(size) && size.x > 0 && size.y > 0 && size.z > 0,
          "size: the edges of a box must be positive and finite [m]");
}

Body box(real mass, const vec3& size, const vec3& x, const quat& q) {
  check_size(size);
  const vec3 s = size * size;
  return body_with(mass, mass / 12 * vec3(s.y + s.z, s.z + s.x, s.x + s.y), x, q);
}

Body ball(real mass, real radius, const vec3& x) {
  require(finite(radius) && radius > 0, "radius: must be positive and finite [m]");
  return body_with(mass, vec3(real(0.4) * mass * radius * radius), x);
}

// ---- motion -------------------------------------------------------------------------------------

quat rotation(const vec3& phi) {
  const real angle = length(phi);
  const real half = angle / 2;
  // sin(angle/2)/angle; its series 1/2 - angle^2/48 is exact to the last bit below this angle
  const real scale = angle < real(1e-4) ? real(0.5) - angle * angle / 48 : std::sin(half) / angle;
  return quat(std::cos(half), scale * phi.x, scale * phi.y, scale * phi.z);
}

void integrate_forces(Body& body, const vec3& gravity, real h) {
  if (body.is_static()) return;
  body.v += h * (gravity + body.inverse_mass * body.force);
  if (body.torque != vec3(0)) body.w += h * angular_response(body, body.torque);
  use_mean_rate(body, h);
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
// A body is thin if one moment is more than so many times as large as another one.
static constexpr real thin = 20;

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

// The mean rate w of a free rotation is that of the middle: I w = R^T L after half of the rotation
// by h w, in the axes of the body. Newton's method needs two to four iterations.
static constexpr int most_newton = 4;
static constexpr real near_enough = real(1e-6);  // the error after such a change is its square

void use_mean_rate(Body& body, real h) {
  if (body.is_isotropic() || body.w_is_mean) return;
  body.w_is_mean = true;
  const vec3& inverse = body.inverse_inertia_local;
  const real scale = glm::max(inverse.x, glm::max(inverse.y, inverse.z));
  const vec3 moments = scale * (real(1) / body.inverse_inertia_local);
  const vec3 start = to_local(body, body.w), L = moments * start;
  body.precession = vec3(0);
  body.mean = body.w;
  if (cross(start, L) == vec3(0)) return;  // it rotates about one of its axes
  vec3 w = start;
  for (int newton = 0; newton < most_newton; ++newton) {
    const vec3 middle = conjugate(rotation(h / 2 * w)) * L;
    const mat3 slope = scaled(mat3(1), moments) - (h / 2) * skew(middle);
    const vec3 change = glm::inverse(slope) * (moments * w - middle);
    w -= change;
    if (dot(change, change) <= near_enough * near_enough * dot(w, w)) break;
  }
  body.precession = to_world(body, w - start);
  body.mean = body.w += body.precession;
}

bool renew_mean_rate(Body& body, real h) {
  if (!body.w_is_mean) return false;
  const vec3 change = body.w - body.mean;
  const real fastest = std::max(dot(body.w, body.w), dot(body.mean, body.mean));
  const real fraction = real(0.1), turn = real(0.3);  // of the rate; in a step [rad]
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
  if (body.w == vec3(0)) return use_own_rate(body);
  if (!body.is_isotropic() && !body.w_is_mean) return rotate_freely(body, h);
  const quat next = normalize(rotation(h * body.w) * body.q);
  if (body.w_is_mean) {  // w is changed such that the angular momentum is kept
    use_own_rate(body);
    const vec3 L = angular_momentum(body);
    body.q = next;
    set_angular_momentum(body, L);
  }
  body.q = next;
}

void move_to(Body& body, const vec3& x, const quat& q, real h) {
  require(body.kinematic, "body: only a kinematic body can be moved to a place");
  require(h > 0 && h < unbounded, "h", h, "must be positive and finite [s]");
  const Body there = static_body(x, q);  // validates both
  quat e = there.q * conjugate(body.q);
  if (e.w < 0) e = -e;
  const vec3 axis(e.x, e.y, e.z);
  const real sine = length(axis), angle = 2 * std::atan2(sine, e.w);
  body.v = (there.x - body.x) / h;
  body.w = (sine > 0 ? angle / sine : real(2)) / h * axis;
}

// ---- the array ----------------------------------------------------------------------------------

// Odd, and as far from those of all other arrays as golden sections make them.
std::uint32_t Bodies::new_generation() {
  static std::atomic<std::uint32_t> arrays{0};
  return ++arrays * 0x9E3779B9u | 1u;
}

BodyId Bodies::add(const Body& given) {
  Body body = given;
  const real square = dot(body.q, body.q);
  if (std::abs(square - 1) > 8 * epsilon && std::abs(square - 1) < real(1e-3))
    body.q = normalize(body.q);
  check(body);
  const vec3& inverse = body.inverse_inertia_local;
  require(body.is_static() || are_moments(real(1) / inverse), "inverse_inertia_local", inverse,
          "no moment may be larger than the sum of the other two");
  if (free_.empty()) {
    bodies_.push_back(body);
    generation_.push_back(first_generation_);
    return {std::uint32_t(slots() - 1), first_generation_};
  }
  const std::uint32_t slot = free_.back();
  free_.pop_back();
  bodies_[slot] = body;
  return {slot, ++generation_[slot]};
}

void Bodies::remove(BodyId id) {
  const int slot = index(id);
  bodies_[slot] = Body{};
  ++generation_[slot];
  free_.push_back(id.slot);
}

HeldMatrices::HeldMatrices(Bodies& bodies, const std::vector<bool>* of) : bodies_(bodies) {
  bodies.matrices_.resize(std::size_t(bodies.slots()));
  BodyMatrices* matrices = bodies.matrices_.data();
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body& body = bodies.at(slot);
    if (of && !(*of)[slot] && !body.is_static()) continue;
    matrices->R = mat3_cast(body.q);
    if (!body.is_isotropic()) matrices->inverse_inertia = rotated_inverse_inertia(body);
    body.matrices.now = matrices++;
  }
}

HeldMatrices::~HeldMatrices() {
  for (Body& body : bodies_) body.matrices.now = nullptr;
}

}  // namespace joints
