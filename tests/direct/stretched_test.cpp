// Chains without slack, drawn by a seed, as docs/which_method.md describes them: between two walls
// they can only be straight, or the joints have no pose that closes them all.
#include <stdexcept>

#include "bench/draw.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

struct Worst {
  double gap = 0;   // the widest in ten seconds [m]
  double late = 0;  // the largest speed in the tenth second [m/s]
};

// Rods of 1 m in a row that begins at a wall, of 1 kg to 10^4 kg each.
struct Rods {
  Scene scene{.name = "stretched"};
  std::vector<BodyId> ids{scene.world.add(static_body(vec3(0)))};
  double misfit = 0;  // length that is missing [m]
  bench::Draw draw;

  explicit Rods(unsigned seed, int most) : draw(seed) {
    const int rods = draw.whole(2, most);
    const double heaviest = draw.scale(1, 1e4);
    for (int k = 0; k < rods; ++k) {
      ids.push_back(scene.world.add(rod(heaviest, 1, real(k) + real(0.5))));
      join(k, k + 1, real(k == 0 ? 0 : 0.5), real(-0.5));
    }
  }
  Body rod(double heaviest, double length, real at) {
    return box(real(draw.scale(1, heaviest)), vec3(real(length), real(0.1), real(0.1)),
               vec3(at, 0, 0));
  }
  double reach() const { return double(ids.size()) - 1; }
  // A ball joint at places along two bodies [m from their centres], where these now are.
  void join(int a, int b, real at_a, real at_b) {
    const BodyId one = ids[std::size_t(a)], other = ids[std::size_t(b)];
    scene.world.add<BallJoint>(one, other, Point{vec3(at_a, 0, 0), vec3(at_b, 0, 0)});
    scene.mark(one, other, scene.world.bodies[one].x);
    scene.marks.back().anchor1_local = glm::dvec3(at_a, 0, 0);
    scene.marks.back().anchor2_local = glm::dvec3(at_b, 0, 0);
  }
  // Ten seconds with three blows.
  Worst run() {
    feed_back_all(scene.world);
    DirectSolver solver = with(8, 8);
    Worst out;
    for (int n = 0; n < 600; ++n) {
      if (n == 30 || n == 90 || n == 150)
        scene.world.bodies[ids[std::size_t(draw.whole(1, int(ids.size()) - 2))]].v +=
            real(draw.scale(1, 15)) * draw.direction();
      step(scene.world, solver, sixtieth, second_order);
      out.gap = std::max(out.gap, widest_gap(scene));
      if (n < 540) continue;
      for (const BodyId id : ids)
        out.late = std::max(out.late, double(length(scene.world.bodies[id].v)));
    }
    return out;
  }
};

Rods between_walls(unsigned seed, bool too_short) {
  Rods row(seed, 15);
  row.misfit = too_short ? row.draw.scale(1e-4, 1e-2) * row.reach() : 0;
  const int last = int(row.ids.size()) - 1;
  row.ids.push_back(
      row.scene.world.add(static_body(vec3(real(row.reach() + row.misfit), 0, 0))));
  row.join(last, last + 1, real(0.5), 0);
  return row;
}

// One more rod, longer than the others together, joins the two ends of the row.
Rods loop(unsigned seed) {
  Rods row(seed, 5);
  row.misfit = row.draw.scale(1e-3, 2e-2) * row.reach();
  const real half = real((row.reach() + row.misfit) / 2);
  const int last = int(row.ids.size()) - 1;
  row.ids.push_back(row.scene.world.add(row.rod(1e3, 2 * double(half), half)));
  row.join(last, last + 1, real(0.5), half);
  row.join(last + 1, 1, -half, real(-0.5));
  return row;
}

}  // namespace

TEST_CASE("chains pulled straight between two walls stay closed under blows and come to rest",
          "[slow]") {
  for (unsigned seed = 90001; seed <= 90050; ++seed) {
    CAPTURE(seed);
    const Worst worst = between_walls(seed, false).run();
    CHECK(worst.gap < tolerance(1e-4, 1e-2));
    CHECK(worst.late < tolerance(0.5, 1));
  }
}

TEST_CASE("chains of rods that are too short open by less than the missing length and rest",
          "[slow]") {
  int overflows = 0;
  for (unsigned seed = 90101; seed <= 90150; ++seed) {
    CAPTURE(seed);
    Rods row = between_walls(seed, true);
    try {
      const Worst worst = row.run();
      CHECK(worst.gap < row.misfit);
      CHECK(worst.late < tolerance(0.5, 1));
    } catch (const std::overflow_error&) {
      ++overflows;
    }
  }
  CHECK(overflows <= (is_float ? 3 : 0));
}

TEST_CASE("loops of rods that cannot close open by less than the missing length",
          "[slow]") {
  for (unsigned seed = 90201; seed <= 90250; ++seed) {
    CAPTURE(seed);
    Rods row = loop(seed);
    CHECK(row.run().gap < row.misfit);
  }
}
