// Chapter 6's hinge without correction, and beside it the same hinge whose cube hits the ground in
// its swing.
#include "bench/chapters/08_ground/experiments.h"
#include "chapters/08_ground/program/order.h"
#include "joints/hinge_joint.h"

namespace joints::chapter8 {

// Thesis fig. 3.2: a cube of 100 kg, two metres beside the hinge, is released. The ground, if there
// is one, stops the swing half way down, and the cube bounces. There is no friction, so that only
// the impacts have an effect. The third run solves the contact after the joint and not together
// with it.
void drift(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/drift.csv",
                {"scene", "time_s", "gap_m", "predicted_m", "touching"});
  const struct {
    std::string name;
    Turns turns;
  } scenes[] = {{"gravity", Turns::no_ground}, {"collision", Turns::interleaved},
                {"contact last", Turns::joints_first}};
  for (const auto& each : scenes) {
    const std::string& name = each.name;
    const Turns turns = each.turns;
    Scene scene{.name = "drift"};
    scene.solver.iterations = choice.iterations;
    scene.energy_scale = 100 * 9.81 * 2;
    World& world = scene.world;
    const BodyId wall = scene.box(0, vec3(real(0.4)), vec3(0));
    const BodyId id = scene.box(100, vec3(1), vec3(2, 0, 0));
    scene.mark(wall, id, vec3(0));
    auto& joint = world.add<HingeJoint>(wall, id, vec3(0), vec3(0, 0, 1));
    joint.beta = 0;
    GroundContact* contact = nullptr;
    if (turns != Turns::no_ground) {
      const BodyId ground = scene.box(0, vec3(8, real(0.2), 8), vec3(0, real(-2.1), 0));
      contact = &stand(scene, ground, id, vec3(1), 0);
      contact->restitution = real(0.9);
    }
    scene.print_plan();
    const auto next = [&] {
      if (turns == Turns::joints_first) step_in_turns(scene, 1, turns);  // the hinge is one block
      else scene.step();
    };
    vec3 sum(0);
    lines.push_back(play(
        scene, name, choice.seconds, "",
        [&](double time) {
          const Body& cube = world.bodies[id];
          const vec3 r = -to_world(cube, joint.first.anchor2_local);
          sum += dot(cube.w, cube.w) * h * h / real(2) * r;  // Eq. 6-1
          table.row({name},
                    {time, double(length(joint.first.error(world.bodies[wall], cube))),
                     double(length(sum)), contact ? double(contact->touching()) : 0.0});
        },
        next));
  }
}

}  // namespace joints::chapter8
