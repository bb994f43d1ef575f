// Validates bodies.
#include "engine/body.h"

namespace joints {

// A moment is an integral over two squares of coordinates; each square is in two moments.
static bool are_moments(const vec3& moments) {
  const real sum = moments.x + moments.y + moments.z;
  const real largest = glm::max(moments.x, glm::max(moments.y, moments.z));
  return 2 * largest <= real(1.001) * sum;  // flat bodies are at the limit
}

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

void check_moments(const Body& body) {
  const vec3& inverse = body.inverse_inertia_local;
  require(body.is_static() || are_moments(real(1) / inverse), "inverse_inertia_local", inverse,
          "no moment may be larger than the sum of the other two");
}

void check_size(const vec3& size) {
  require(finite(size) && size.x > 0 && size.y > 0 && size.z > 0,
          "size: the edges of a box must be positive and finite [m]");
}

}  // namespace joints
