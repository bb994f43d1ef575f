// The tables of the answers to the chapter's questions.
#include <cmath>
#include <cstdio>

#include "bench/chapters/08_ground/experiments.h"
#include "bench/chapters/08_ground/own_ground.h"
#include "chapters/08_ground/program/one_box.h"

namespace joints::chapter8 {

namespace {

const vec3 size(1, real(0.6), real(0.8));  // [m]

// Question 1: the loads of the four corners of a box at rest, after it was dropped in several ways.
void shares(const Choice& choice) {
  CsvFile table(choice.out + "/shares.csv", {"dropped", "start", "impulse1_ns", "impulse2_ns",
                                             "impulse3_ns", "impulse4_ns"});
  const struct {
    const char* name;
    real height;
    vec3 tilt;
  } drops[] = {{"put down", 0, vec3(0)},
               {"flat", real(0.3), vec3(0)},
               {"about x", real(0.3), vec3(real(0.1), 0, 0)},
               {"about z", real(0.3), vec3(0, 0, real(0.05))},
               {"back about z", real(0.3), vec3(0, 0, real(-0.05))}};
  for (const auto& drop : drops)
    for (const auto& [start, friction] :
         {std::pair{"no friction", real(0)}, {"cold", real(0.5)}, {"warm", real(0.5)}}) {
      OneBox one("shares", choice, size);
      one.contact->friction = friction;
      one.scene.stepping.warm_start = start[0] == 'w';
      one.body().x.y += drop.height;
      one.body().q = rotation(drop.tilt);
      for (int n = 0; n < steps_in(30, h); ++n) one.scene.step();
      std::vector<double> normal;
      const Blocks& blocks = one.scene.world.blocks;
      const std::size_t rows = friction > 0 ? 3 : 1;  // of a corner, a block each
      for (std::size_t k = rows - 1; k < blocks.list.size(); k += rows)
        normal.push_back(double(*blocks.list[k].impulse));
      normal.resize(4);  // it rests on four
      table.row({drop.name, start}, {normal[0], normal[1], normal[2], normal[3]});
    }
}

// Question 2: the body of "Numbers" with the velocity (-3, -2.49, 0), one step of 1/20 s.
double gap_left(bool normal_first, int iterations) {
  OwnGround own;
  own.body = box(12, vec3(1, 2, 1), vec3(real(1.5), real(1.1), 0),
                 rotation(vec3(0, 0, 90 * degree)));
  own.body.v = vec3(-3, real(-2.49), 0);
  own.corners = {{vec3(real(-0.5), 1, real(0.5)), 0, real(0.5)}};
  own.gravity = vec3(0);
  own.iterations = iterations;
  own.normal_first = normal_first;
  own.step(real(1) / 20);
  return double(own.corners[0].error(own.ground, own.body));
}

// The displacement of a box in ten seconds [m].
double way(const Choice& choice, int iterations, bool warm, real speed, real slope) {
  OneBox one("way", choice, size, slope);
  one.scene.solver.iterations = iterations;
  one.scene.stepping.warm_start = warm;
  one.body().v = vec3(speed, 0, 0);
  const vec3 start = one.body().x;
  for (int n = 0; n < steps_in(10, h); ++n) one.scene.step();
  return double(length(one.body().x - start));
}

void few_iterations(const Choice& choice) {
  CsvFile order(choice.out + "/rows_order.csv", {"last", "iterations", "gap_m"});
  for (const bool normal_first : {false, true})
    for (const int iterations : {1, 2, 4, 10})
      order.row({normal_first ? "friction" : "normal"},
                {double(iterations), gap_left(normal_first, iterations)});
  CsvFile ways(choice.out + "/few.csv", {"start", "iterations", "level_m", "slope_m"});
  for (const bool warm : {false, true})
    for (const int iterations : {1, 2, 3, 4, 10})
      ways.row({warm ? "warm" : "cold"}, {double(iterations), way(choice, iterations, warm, 4, 0),
                                          way(choice, iterations, warm, 0, 20 * degree)});
}

// Question 4: a ball falls and rebounds by ground_contact.h, with the half kick of Eq. 8-9 and that
// of Eq. 8-10, or without.
struct Rebound {
  real leaves = 0, highest = 0;  // [m/s], [m]
};
Rebound rebound(real drop, real restitution, bool half_in, bool half_out) {
  const real kick = real(-g) * h;
  real y = drop, v = 0, bounce = 0;
  while (bounce == 0) {
    v += kick;
    if (y + h * v < 0) {
      bounce = restitution * (half_in ? impact_speed(y, v, kick, h) : -v);
      v = -y / h;
    }
    y += h * v;
  }
  Rebound out{.leaves = bounce + (half_out ? kick / 2 : 0)};
  for (v = out.leaves; v > 0; v += kick) out.highest = y += h * v;
  return out;
}

void half_kicks(const Choice& choice) {
  CsvFile table(choice.out + "/half_kicks.csv", {"eq9", "eq10", "restitution", "drop_m",
                                                 "leaves_m_s", "highest_m", "too_high"});
  for (const real restitution : {real(0.5), real(1)})
    for (const real drop :
         {real(1), real(1.25), real(1.27), real(1.3), real(1.35), real(1.4)})
      for (const bool in : {true, false})
        for (const bool out : {true, false}) {
          const Rebound found = rebound(drop, restitution, in, out);
          const double right = double(restitution * restitution * drop);  // Eq. 8-10
          table.row({in ? "with" : "without", out ? "with" : "without"},
                    {double(restitution), double(drop), double(found.leaves),
                     double(found.highest), double(found.highest) / right - 1});
        }
}

}  // namespace

void questions(const Choice& choice) {
  shares(choice);
  few_iterations(choice);
  half_kicks(choice);
}

}  // namespace joints::chapter8
