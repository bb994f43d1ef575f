// Chapter 8's program: a box slides and lies on a slope, balls bounce, and a chain falls on the
// ground, with joints and contacts in one loop or in two. Read it; there is nothing to edit here.
#include <algorithm>
#include <cmath>

#include "chapters/08_ground/program/one_box.h"
#include "chapters/08_ground/program/order.h"
#include "engine/instruments/options.h"

namespace joints::chapter8 {

namespace {

// The expected path of a box: straight with turned tangents; with fixed ones each direction
// separately, as for two boxes that slide along x and along z. `shorter`: the part by which steps
// of h shorten each path [s].
double way_of(bool turned, double angle, double speed, double mu, double shorter) {
  const auto along = [&](double v) { return std::max(0.0, v * v / (2 * mu * g) - v * shorter); };
  if (turned) return along(speed);  // Eq. 8-7
  return std::hypot(along(speed * std::cos(angle)), along(speed * std::sin(angle)));
}

void slide(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/slide.csv", {"tangents", "direction_deg", "speed_m_s", "way_m",
                                            "expected_m", "stepped_m", "arrives_deg"});
  for (int direction = 0; direction <= 90; direction += 15)
    for (const double speed : {1.0, 2.0, 4.0}) {
      const real angle = real(direction) * degree;
      const vec3 ahead(std::cos(angle), 0, std::sin(angle)), aside(-ahead.z, 0, ahead.x);
      OneBox both("slide", choice, vec3(1, real(0.2), 1));  // turned, and beside it fixed
      Scene& scene = both.scene;
      Bodies& bodies = scene.world.bodies;
      const BodyId other = scene.box(10, both.size, both.body().x + real(2) * aside);
      scene.shapes[both.box.slot].label = "turned";
      scene.shapes[other.slot].label = "fixed";
      auto& fixed = stand(scene, both.ground, other, both.size, both.contact->friction);
      fixed.beta = choice.beta;
      fixed.turned_tangents = false;
      const bool seen = direction == 45 && speed == 4;
      if (seen) scene.print_plan();
      const BodyId ids[] = {both.box, other};
      const vec3 from[] = {bodies[both.box].x, bodies[other].x};
      for (const BodyId id : ids) bodies[id].v = real(speed) * ahead;
      const Summary line = play(scene, "both tangents", 2,
                                seen ? choice.out + "/slide.motion.json" : "");
      const double mu = double(fixed.friction);
      for (const int k : {0, 1}) {
        const vec3 way = bodies[ids[k]].x - from[k];
        table.row({k == 0 ? "turned" : "fixed"},
                  {double(direction), speed, double(length(way)),
                   way_of(k == 0, double(angle), speed, mu, 0),
                   way_of(k == 0, double(angle), speed, mu, double(h) / 2),
                   double(std::atan2(way.z, way.x) / degree)});
      }
      if (seen) lines.push_back(line);
    }
}

// A box on slopes near arctan(mu), Eq. 8-8: its displacement after ten seconds.
void tilt(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/tilt.csv", {"mu", "angle_deg", "way_m"});
  for (const double mu : {0.2, 0.5, 1.0})
    for (const double beyond :
         {-5.0, -2.0, -1.0, -0.5, -0.2, -0.1, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0}) {
      const double angle = std::atan(mu) / double(degree) + beyond;  // Eq. 8-8
      OneBox one("slope", choice, vec3(1, real(0.2), 1), real(angle) * degree);
      one.scene.stepping.warm_start = true;
      one.contact->friction = real(mu);
      const vec3 start = one.body().x;
      const Summary line = play(one.scene, beyond < 0 ? "just holds" : "just slides", 10);
      table.row({mu, angle, double(length(one.body().x - start))});
      if (mu == 0.5 && std::abs(beyond) == 0.1) lines.push_back(line);
    }
}

// Balls that are released side by side: the height of the first rebound, and the paths of those
// that fall one metre.
void bounce(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/bounce.csv",
                {"restitution", "drop_m", "rebound_m", "expected_m"});
  CsvFile path(choice.out + "/bounce_path.csv", {"restitution", "time_s", "height_m"});
  const real radius = real(0.2);
  const double restitutions[] = {0.0, 0.25, 0.5, 0.75, 1.0};
  for (const double drop : {0.5, 1.0, 2.0}) {
    struct Ball {
      BodyId id;
      bool landed = false, left = false;
      double highest = 0;
    };
    Scene scene{.name = "bounce"};
    scene.solver.iterations = choice.iterations;
    const BodyId ground = add_ground(scene, 6);
    std::vector<Ball> balls;
    for (const double restitution : restitutions) {
      const vec3 x(real(balls.size()) - 2, real(drop) + radius, 0);
      scene.shapes.push_back({"ball", {2 * double(radius), 2 * double(radius),
                                       2 * double(radius)},
                              "e = " + std::to_string(restitution).substr(0, 4)});
      balls.push_back({scene.world.add(ball(1, radius, x))});
      auto& contact = scene.world.add<GroundContact>(
          ground, balls.back().id, Top{.height = real(0.1)}, ball_outline(radius));
      contact.restitution = real(restitution);
      contact.beta = choice.beta;
      scene.energy_scale += g * drop;
    }
    const bool seen = drop == 1.0;
    if (seen) scene.print_plan();
    const Summary line = play(
        scene, "five restitutions", 5, seen ? choice.out + "/bounce.motion.json" : "",
        [&](double time) {
          for (std::size_t k = 0; k < balls.size(); ++k) {
            const Body& body = scene.world.bodies[balls[k].id];
            const double height = double(body.x.y - radius);
            if (seen) path.row({restitutions[k], time, height});
            if (balls[k].landed && balls[k].highest > 0 && body.v.y <= 0) balls[k].left = true;
            balls[k].landed = balls[k].landed || height < 1e-3;
            if (balls[k].landed && !balls[k].left)
              balls[k].highest = std::max(balls[k].highest, height);
          }
        });
    for (std::size_t k = 0; k < balls.size(); ++k)
      table.row({restitutions[k], drop, balls[k].highest,
                 restitutions[k] * restitutions[k] * drop});  // Eq. 8-10
    if (seen) lines.push_back(line);
  }
}

// The falling chain with the blocks of joints and contacts in each order.
void order(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/order.csv",
                {"order", "iterations", "time_s", "gap_m", "penetration_m"});
  CsvFile ends(choice.out + "/order_summary.csv",
               {"order", "iterations", "gap_rms_m", "gap_max_m", "penetration_max_m"});
  const struct {
    std::string name;
    Turns turns;
  } orders[] = {{"interleaved", Turns::interleaved}, {"joints first", Turns::joints_first},
                {"contacts first", Turns::contacts_first}, {"no ground", Turns::no_ground}};
  for (const auto& order : orders)
    for (const int iterations : {5, 10, 30, 100}) {
      const std::string& name = order.name;
      const Turns turns = order.turns;
      LandingChain chain(turns, 8, iterations, choice.beta);
      Scene& scene = chain.scene;
      const bool seen = turns == Turns::interleaved && iterations == 30;
      if (seen) scene.print_plan();
      double deepest = 0;
      const Summary line = play(
          scene, name, choice.seconds, seen ? choice.out + "/order.motion.json" : "",
          [&](double time) {
            const double deep = penetration(scene.world);
            deepest = std::max(deepest, deep);
            table.row({name}, {double(iterations), time, widest(scene), deep});
          },
          [&] { chain.step(turns); });
      ends.row({name}, {double(iterations), line.gap_rms, line.gap_max, deepest});
      if (iterations == 30) lines.push_back(line);
    }
}

}  // namespace
}  // namespace joints::chapter8

using namespace joints;
using namespace joints::chapter8;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 8: the ground",
                    {{"iterations", "30", "iterations per step"},
                     {"beta", "0.2", "fraction of the error fed back per step [1]"},
                     {"seconds", "6", "how long the chain is watched [s]"}});
    if (!options.read(argc, argv)) return;
    const Choice choice{options.count("iterations", 1), real(options.number("beta", 0)),
                        options.number("seconds", 0.1), options.text("out")};
    std::vector<Summary> lines;
    slide(choice, lines);
    tilt(choice, lines);
    bounce(choice, lines);
    order(choice, lines);
    report(lines, choice.out);
  });
}
