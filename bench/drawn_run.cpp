// A run of a scene that a seed has drawn: its gaps and its energy.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/draw.h"
#include "bench/families.h"

namespace joints::bench {

namespace {

// Errors of all rows at the present poses.
void look(World& world, Blocks& blocks, Outcome& out) {
  blocks.clear();
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
  for (const Block& block : blocks.list) {
    if (!block.settings.holds_position || block.settings.follows != 0) continue;
    const int equalities = block.rows - block.settings.one_sided();
    for (int i = 0; i < block.rows; ++i) {
      const double C = double(blocks.C[std::size_t(block.first + i)]);
      if (i < equalities) out.gap = std::max(out.gap, std::abs(C));
      else out.past = std::max(out.past, -C);
    }
  }
}

// The energy at a pose, from the momentum half a step before and half a step behind: between kicks
// the momentum of a body stays, its angular velocity does not.
double energy_at(std::vector<Body> before, const Bodies& after, double share, const vec3& gravity) {
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Body& then = after.at(int(k));
    before[k].v += real(share) * (then.v - before[k].v);
    if (before[k].is_static()) continue;
    const vec3 L = angular_momentum(before[k]), later = angular_momentum(then);
    set_angular_momentum(before[k], L + real(share) * (later - L));
  }
  return energy(before, gravity);
}

}  // namespace

std::vector<Family> families() {
  std::vector<Family> out = joint_families();
  for (auto* more : {motion_families, contact_families})
    for (Family& family : more()) out.push_back(std::move(family));
  return out;
}

Outcome run_drawn(Drawn scene, const std::string& setting, double h) {
  const Setting how = setting_named(setting);
  how.prepare(scene.world);
  return run_drawn(std::move(scene), how.make(), how.leapfrog, h);
}

Outcome run_drawn(Drawn scene, const Step& step, bool leapfrog, double h) {
  World& world = scene.world;
  const auto angular = [&] { return momentum(all_of(world.bodies)).angular; };
  const glm::dvec3 L = angular();
  Outcome out{.most_gain = scene.most_gain};
  Blocks errors;
  errors.errors_only = true;
  Draw lengths(unsigned(world.bodies.slots()));
  const double start = energy(all_of(world.bodies), world.gravity);
  for (double time = 0; time < scene.seconds - h / 2 && out.finite;) {
    const double length = scene.any_step ? 1 / lengths.number(24, 240) : h;
    const std::span<const Body> all = all_of(world.bodies);
    const std::vector<Body> before(all.begin(), all.end());
    const double behind = double(world.last_h) / 2;  // the velocities are as far behind the poses
    if (scene.control) scene.control(world, real(length));
    try {
      step(world, real(length));
    } catch (const std::exception&) {  // it has flown apart
      out.finite = false;
      break;
    }
    const double share = leapfrog || scene.between_steps
                             ? behind / (behind + length - double(world.last_h) / 2) : 0;
    const double change = (energy_at(before, world.bodies, share, world.gravity) - start) /
                          scene.energy_scale;
    if (!scene.driven) out.gain = std::max(out.gain, change);
    out.loss = -change;
    look(world, errors, out);
    if (scene.miss) out.gap = std::max(out.gap, scene.miss(world));
    if (scene.momentum_scale > 0)
      out.momentum = std::max(out.momentum, glm::length(angular() - L) / scene.momentum_scale);
    time += length;
  }
  out.finite = out.finite && all_finite(all_of(world.bodies));
  return out;
}

}  // namespace joints::bench
