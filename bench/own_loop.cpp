// From the bodies and hinges of a world to chapter 7's loop and back.
#include "bench/own_loop.h"

#include "chapters/07_performance/hinge_loop.h"
#include "joints/hinge_joint.h"

namespace joints::bench {

namespace {

template <class Number>
class Adapted : public OwnLoop {
 public:
  Adapted(const World& world, int iterations, Visits visits, real relaxation) {
    loop_.relaxation = relaxation;
    for (int slot = 0; slot < world.bodies.slots(); ++slot)
      loop_.bodies.push_back(world.bodies.at(slot));
    for (const auto& joint : world.joints()) {
      const HingeJoint& hinge = static_cast<const HingeJoint&>(*joint);
      loop_.links.push_back({world.bodies.index(hinge.body1), world.bodies.index(hinge.body2)});
      loop_.hinges.push_back({hinge.first, hinge.second, hinge.beta});
    }
    loop_.gravity = world.gravity;
    loop_.iterations = iterations;
    if (visits == Visits::chain_order) {
      loop_.arrange(one_by_one(int(loop_.links.size())));
    } else if (visits == Visits::coloured_lanes) {
      loop_.arrange(by_colour(colours_of(loop_.links, moving(loop_.bodies)), loop_.width));
    } else {
      loop_.arrange(by_islands);
    }
  }
  void step(real h) override { loop_.step(h); }
  void show(World& world) const override {
    for (int slot = 0; slot < world.bodies.slots(); ++slot)
      world.bodies.at(slot) = loop_.bodies[std::size_t(slot)];
  }

 private:
  HingeLoop<Number> loop_;
};

}  // namespace

std::unique_ptr<OwnLoop> own_loop(const World& world, int iterations, Visits visits,
                                  real relaxation) {
  if (visits == Visits::chain_order || visits == Visits::interleaved)
    return std::make_unique<Adapted<real>>(world, iterations, visits, relaxation);
  return std::make_unique<Adapted<Lanes>>(world, iterations, visits, relaxation);
}

std::string own_instructions() {
#if defined(__AVX2__)
  const std::string processor = "AVX2";
#elif defined(__SSE2__)
  const std::string processor = "SSE2";
#else
  const std::string processor = "the compiler's choice of instructions";
#endif
  return processor + ", " + std::to_string(lane_count) + " lanes";
}

}  // namespace joints::bench
