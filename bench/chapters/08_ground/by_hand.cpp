// A box slides, moved by the functions of the exercises alone, and beside it the same box in the
// engine.
#include <cmath>

#include "bench/chapters/08_ground/experiments.h"
#include "bench/chapters/08_ground/own_ground.h"

namespace joints::chapter8 {

// Four corners are enough for a box that does not tip over: those of its lower face.
void by_hand(const Choice& choice) {
  const vec3 size(1, real(0.4), real(0.8));
  Scene scene{.name = "by hand"};
  scene.solver.iterations = choice.iterations;
  const BodyId ground = add_ground(scene, 8);
  const BodyId id = scene.box(10, size, vec3(0, size.y / 2, 0));
  scene.world.bodies[id].v = vec3(3, 0, 1);
  Outline lower{.count = 4};
  for (std::size_t k = 0; k < 4; ++k)
    lower.corners[k] = real(0.5) * size * vec3(k & 1 ? 1 : -1, -1, k & 2 ? 1 : -1);
  auto& contact = scene.world.add<GroundContact>(ground, id, Top{.height = real(0.1)}, lower);
  contact.beta = choice.beta;
  scene.print_plan();

  const Body start = scene.world.bodies[id];
  OwnGround own;
  own.ground = scene.world.bodies[ground];
  own.body = start;
  own.friction = contact.friction;
  own.beta = choice.beta;
  own.iterations = choice.iterations;
  for (std::size_t k = 0; k < 4; ++k)
    own.corners.push_back({lower.corners[k], 0, contact.top.height});

  CsvFile table(choice.out + "/by_hand.csv",
                {"time_s", "way_m", "speed_m_s", "normal_ns", "friction_ns", "bound_ns",
                 "off_engine_m"});
  for (int n = 0; n <= 90; ++n) {
    if (n > 0) {
      own.step(h);
      step(scene.world, scene.solver, h, scene.stepping);
    }
    double off = 0;
    for (std::size_t k = 0; k < 4; ++k)
      off = std::max(off, double(length(world_point(own.body, lower.corners[k]) -
                                        world_point(scene.world.bodies[id], lower.corners[k]))));
    table.row({n * double(h), double(length(own.body.x - start.x)), double(length(own.body.v)),
               double(own.normal()), double(length(own.sideways())),
               double(own.friction * own.normal()), off});
  }
}

}  // namespace joints::chapter8
