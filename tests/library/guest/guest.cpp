// A plug-in of another project: ordinary GLM, as it compiles without the library, and a door.
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <joints.h>

#include <type_traits>

namespace {

static_assert(std::is_trivially_copyable_v<glm::vec3> && std::is_trivial_v<glm::dmat4>);

// Conversions without a word, from one kind of number to the other.
glm::dvec3 converted(const glm::vec3& v) {
  const glm::dvec3 d = v;
  glm::vec2 flat = glm::ivec2(1, 2);
  flat = d;
  const glm::mat4 moved = glm::translate(glm::dmat4(1), d);
  const glm::quat q = glm::dquat(1, 0, 0, 0);
  return 2.0 * d + glm::dvec3(q * glm::vec3(moved[3])) + glm::dvec3(flat, 0);
}

}  // namespace

// The angle [rad] at which a door stands after half a second of a motor with 1 rad/s.
extern "C" double angle_of_door() {
  using namespace joints;
  World world;
  const BodyId frame = world.add(static_body(vec3(0)));
  const BodyId door = world.add(box(20, vec3(1, 2, real(0.1)), vec3(real(0.5), 0, 0)));
  auto& hinge = world.add<HingeJoint>(frame, door, vec3(0), vec3(0, 1, 0));
  hinge.set_motor(1, 1000);
  DirectSolver solver;
  for (int n = 0; n < 50; ++n) step(world, solver, real(0.01));
  return double(hinge.position(world.bodies)) + 0 * converted(glm::vec3(1)).x;
}
