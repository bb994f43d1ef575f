// Makes bodies, and keeps them in an array. Their motion is in engine/rotation, their validation in
// engine/kept.
#include "engine/body.h"

#include <atomic>

namespace joints {

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

Body box(real mass, const vec3& size, const vec3& x, const quat& q) {
  check_size(size);
  const vec3 s = size * size;
  return body_with(mass, mass / 12 * vec3(s.y + s.z, s.z + s.x, s.x + s.y), x, q);
}

Body ball(real mass, real radius, const vec3& x) {
  require(finite(radius) && radius > 0, "radius: must be positive and finite [m]");
  return body_with(mass, vec3(real(0.4) * mass * radius * radius), x);
}

quat rotation(const vec3& phi) {
  const real angle = length(phi);
  const real half = angle / 2;
  // sin(angle/2)/angle; its series 1/2 - angle^2/48 is exact to the last bit below this angle
  const real scale = angle < real(1e-4) ? real(0.5) - angle * angle / 48 : std::sin(half) / angle;
  return quat(std::cos(half), scale * phi.x, scale * phi.y, scale * phi.z);
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
  check_moments(body);
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
