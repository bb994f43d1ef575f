// A user-defined joint with two free coordinates: a piston that turns and slides in its cylinder. A
// motor turns the piston, and a spring carries it. Exit status 1 if the piston rests elsewhere.
// Prints:
//   the piston has turned by 15.0 rad and rests 20.0 mm lower
//   joint: this world has no such joint (removed, or of another one)
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <joints.h>

namespace mine {
using namespace joints;

/// Holds a line and an axis, four rows. The rotation about the axis and the displacement along it
/// are free.
class CylinderJoint : public WithCoordinates<Composite<Line, Axis>, HingeAngle, Slide> {
 public:
  /// Both coordinates are 0 in the present poses. \param anchor a point of the axis [m, world]
  /// \param axis its direction, world, of any length
  CylinderJoint(const Bodies& bodies, BodyId id1, BodyId id2, const vec3& anchor, const vec3& axis)
      : CylinderJoint(id1, id2, bodies[id1], bodies[id2], anchor, axis) {}
  auto& angle() { return coordinate<0>(); }
  auto& slide() { return coordinate<1>(); }

 private:
  CylinderJoint(BodyId id1, BodyId id2, const Body& body1, const Body& body2, const vec3& anchor,
                const vec3& axis)
      : WithCoordinates(id1, id2,
                        {line_along(body1, body2, anchor, axis), axis_along(body1, body2, axis)},
                        angle_about(body1, body2, axis),
                        slide_along(body1, body2, anchor, axis)) {}
};

}  // namespace mine

int main() {
  using namespace joints;
  World world;
  const BodyId cylinder = world.add(static_body(vec3(0)));
  const BodyId piston = world.add(box(2, vec3(real(0.2), real(0.5), real(0.2)), vec3(0)));
  const JointId joint = world.add<mine::CylinderJoint>(cylinder, piston, vec3(0), vec3(0, 1, 0));
  world[joint].angle().set_motor(3, 5);                                // rad/s, N m
  world[joint].slide().set_spring({.stiffness = 981, .damping = 60});  // N/m, N s/m
  world[joint].slide().set_limits(real(-0.1), real(0.1));              // m

  PackedImpulses solver;
  for (int n = 0; n < 300; ++n) step(world, solver, real(1) / 60, {.warm_start = true});
  const real turned = world[joint].angle().position(world.bodies);
  const real lowered = -1000 * world[joint].slide().position(world.bodies);
  std::printf("the piston has turned by %.1f rad and rests %.1f mm lower\n", double(turned),
              double(lowered));

  world.remove(joint);
  try {
    world[joint].angle().set_motor(0, 0);
  } catch (const std::invalid_argument& error) {
    std::printf("%s\n", error.what());
  }
  return std::abs(turned - 15) < real(0.1) && std::abs(lowered - 20) < real(0.1) ? 0 : 1;
}
