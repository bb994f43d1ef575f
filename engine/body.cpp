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

vec3 gyroscopic_midpoint(const vec3& moments, const vec3& w, real h) {
  // Only the ratios count; scaled to order 1, the determinant neither overflows nor vanishes.
  const vec3 inertia = moments / glm::max(moments.x, glm::max(moments.y, moments.z));
  const mat3 I = scaled(mat3(1), inertia);
  vec3 next = w;
  for (int newton = 0; newton < 3; ++newton) {
    const vec3 middle = (w + next) / real(2);
    const vec3 momentum = inertia * middle;
    const vec3 f = inertia * (next - w) + h * cross(middle, momentum);
    const mat3 slope = I + (h / 2) * (scaled(skew(middle), inertia) - skew(momentum));
    next -= inverse(slope) * f;
  }
  return next;
}

void kick(Body& body, const vec3& gravity, real h) {
  if (body.is_static()) return;
  body.v += h * (gravity + body.inverse_mass * body.force);
  if (body.torque != vec3(0)) body.w += h * angular_response(body, body.torque);
}

void turn(Body& body, real h) {
  if (body.is_static() || body.is_isotropic() || body.w == vec3(0)) return;
  const vec3 inertia = real(1) / body.inverse_inertia_local;
  body.w = to_world(body, gyroscopic_midpoint(inertia, to_local(body, body.w), h));
}

void integrate_forces(Body& body, const vec3& gravity, real h) {
  kick(body, gravity, h);
  turn(body, h);
}

static void clamp_speed(vec3& velocity) {
  const real top = std::max({std::abs(velocity.x), std::abs(velocity.y), std::abs(velocity.z)});
  if (top > max_speed) velocity *= max_speed / top;
}

void clamp_speed(Body& body) {
  clamp_speed(body.v);
  clamp_speed(body.w);
}

void integrate_pose(Body& body, real h) {
  if (body.is_static() && !body.kinematic) return;
  clamp_speed(body);
  body.x += h * body.v;
  if (body.w != vec3(0)) body.q = normalize(rotation(h * body.w) * body.q);
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
