// Scenes drawn by seeds: what a seed draws, and how a run judges it.
#include "bench/families.h"
#include "tests/checker/catch.h"

using namespace joints;
using namespace joints::bench;

namespace {

double first_gap(World& world) {
  Blocks errors;
  errors.errors_only = true;
  for (const auto& joint : world.joints()) joint->append(world.bodies, errors);
  double out = 0;
  for (const Block& block : errors.list) {
    if (!block.target.holds_position || block.target.follows != 0) continue;
    for (int i = 0; i < block.rows - block.target.one_sided(); ++i)
      out = std::max(out, std::abs(double(errors.C[std::size_t(block.first + i)])));
  }
  return out;
}

}  // namespace

TEST_CASE("a seed draws one scene, and its joints are closed") {
  for (const Family& family : families())
    for (unsigned seed = 1; seed <= 4; ++seed) {
      INFO(family.name << ", seed " << seed);
      Drawn one = family.draw(seed), again = family.draw(seed), other = family.draw(seed + 100);
      REQUIRE(one.energy_scale > 0);
      REQUIRE(one.world.bodies.slots() == again.world.bodies.slots());
      REQUIRE(first_gap(one.world) < (sizeof(real) == 8 ? 1e-9 : 1e-4));
      bool differs = one.world.bodies.slots() != other.world.bodies.slots();
      for (int slot = 0; slot < one.world.bodies.slots(); ++slot) {
        const Body &a = one.world.bodies.at(slot), &b = again.world.bodies.at(slot);
        REQUIRE((a.x == b.x && a.v == b.v && a.inverse_mass == b.inverse_mass));
        if (differs) continue;
        const Body& c = other.world.bodies.at(slot);
        differs = one.world.gravity != other.world.gravity || a.x != c.x || a.v != c.v ||
                  a.inverse_mass != c.inverse_mass ||
                  a.inverse_inertia_local != c.inverse_inertia_local;
      }
      CHECK(differs);
    }
}

TEST_CASE("a run tells an open joint from a closed one: thirty iterations do not hold heavy ends") {
  int seen = 0;
  for (const Family& family : families()) {
    const bool loops = family.name == "equal four-bars";
    if (!loops && family.name != "heavy ends") continue;
    ++seen;
    Drawn scene = family.draw(1);
    scene.seconds = 1;
    CHECK(run_drawn(std::move(scene), loops ? "shake" : "si30").held() == loops);
  }
  CHECK(seen == 2);
}

TEST_CASE("the careful direct solver holds the first draws of every family but piles") {
  int of = 0;
  for (const Family& family : families()) {
    if (family.name == "piles") continue;  // their contacts are iterated
    if (family.name == "heavy ends" && sizeof(real) == 4) continue;  // beyond float's digits
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Outcome out = run_drawn(family.draw(seed), "careful");
      INFO(family.name << ", seed " << seed << ": gap " << out.gap << " m, gain " << out.gain);
      CHECK(out.held());
      ++of;
    }
  }
  CHECK(of == 4 * (sizeof(real) == 8 ? 18 : 17));
}

TEST_CASE("closed loops keep their energy with the careful solver and no added inertia") {
  for (const Family& family : families()) {
    if (family.name != "Bricard" && family.name != "equal four-bars") continue;
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Outcome out = run_drawn(family.draw(seed), "loops");
      INFO(family.name << ", seed " << seed << ": gap " << out.gap << " m, loss " << out.loss);
      CHECK(out.gap < (sizeof(real) == 8 ? 1e-6 : 5e-3));
      CHECK(std::abs(out.loss) < 0.1);
    }
  }
}
