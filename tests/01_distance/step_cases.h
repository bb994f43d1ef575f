// Exercise 1.4: scenes for the step, and the tables of the reader's step beside the right one.
#pragma once

#include "engine/instruments/todo.h"
#include "tests/01_distance/step_reference.h"
#include "tests/checker/thrown.h"

namespace joints::testing {

inline StepSettings settings_of(const vec3& gravity, real h, int iterations, real beta) {
  return {gravity, h, iterations, beta};
}

inline std::vector<Scene> free_scenes() {
  std::vector<Body> thrown{static_body(vec3(0)), ball(real(0.5), 1, vec3(0, 1, 0)),
                           ball(3, 1, vec3(2, 0, 1))};
  thrown[1].v = vec3(1, 2, -1);
  thrown[2].v = vec3(-2, 1, real(0.5));
  return {{"a ball of 2 kg falls, h = 1/60 s, 3 steps",
           {ball(2, 1, vec3(0)), static_body(vec3(1, 1, 1))}, {}, {}, 3},
          {"two balls are thrown, gravity (1, -2, 3) m/s^2, h = 1/25 s, 2 steps", thrown, {},
           settings_of(vec3(1, -2, 3), real(0.04), 7, real(0.2)), 2}};
}

/// A chain of balls that fly apart: a light one carries heavy ones, so that many iterations are
/// needed. The errors are 0.
inline std::vector<Body> chain(real mass) {
  std::vector<Body> bodies{ball(9 * mass, real(0.1), vec3(real(1.2), real(0.4), 0)),
                           static_body(vec3(0, 2, 0)),
                           ball(mass, real(0.1), vec3(real(0.6), real(1.2), 0)),
                           ball(4 * mass, real(0.1), vec3(2, 0, 1))};
  bodies[0].v = vec3(2, -1, real(0.5));
  bodies[2].v = vec3(-1, -1, 1);
  bodies[3].v = vec3(1, 0, 2);
  return bodies;
}
inline std::vector<Link> chain_links(bool first_rope, bool last_rope) {
  return {{2, 0, 1, first_rope}, {1, 2, 1}, {3, 0, std::sqrt(real(1.8)), last_rope}};
}

inline std::vector<Scene> rod_scenes() {
  const vec3 none(0);
  const real h = real(0.025);
  const auto on_a_rod = [](const vec3& place, const vec3& v) {
    std::vector<Body> bodies{static_body(vec3(0)), ball(2, 1, place)};
    bodies[1].v = v;
    return bodies;
  };
  const auto settings = [&](int iterations) {
    return settings_of(none, h, iterations, real(0.3));
  };
  std::vector<Scene> out{
      {"a rod of 1 m that is 0.1 m too long, beta = 0.3, h = 1/40 s, no gravity",
       on_a_rod(vec3(real(1.1), 0, 0), none), {{0, 1, 1}}, settings(9)},
      {"a rod of 1 m that is 0.1 m too short, beta = 0.3, h = 1/40 s, no gravity",
       on_a_rod(vec3(0, real(0.9), 0), none), {{0, 1, 1}}, settings(9)},
      {"a ball that flies past, held by a rod of the right length, no gravity",
       on_a_rod(vec3(0, -1, 0), vec3(1, -1, 0)), {{0, 1, 1}}, settings(9)}};
  for (int iterations : {1, 3, 10, 70})
    out.push_back({"three rods in a chain, " + std::to_string(iterations) +
                   (iterations == 1 ? " iteration" : " iterations"),
                   chain(1), chain_links(false, false), settings(iterations)});
  out.push_back({"the chain again, its balls of a microgram, 10 iterations", chain(real(1e-9)),
                 chain_links(false, false), settings(10)});
  return out;
}

inline std::vector<Scene> falling_rod_scenes() {
  std::vector<Body> pendulum{static_body(vec3(0)), ball(1, real(0.1), vec3(0, -1, 0))};
  pendulum[1].v = vec3(1, -1, 0);
  return {{"a pendulum at its lowest point, h = 1/60 s", pendulum, {{0, 1, 1}}, {}},
          {"the chain falls, gravity (1, -9, 2) m/s^2, h = 1/40 s, 10 iterations, 2 steps",
           chain(1), chain_links(false, false),
           settings_of(vec3(1, -9, 2), real(0.025), 10, real(0.3)), 2}};
}

inline std::vector<Scene> rope_scenes() {
  const Body wall = static_body(vec3(0));
  std::vector<Body> pulled{ball(1, real(0.1), vec3(0)), static_body(vec3(-1, 0, 0)),
                           static_body(vec3(real(-0.8), real(-0.6), 0))};
  pulled[0].v = vec3(1, 3, 0);
  std::vector<Body> askew{ball(1, real(0.1), vec3(0)), static_body(vec3(0, -1, 0)),
                          static_body(vec3(real(-0.6), real(-0.8), 0))};
  askew[0].v = vec3(3, 3, 0);
  std::vector<Body> mixed = chain(1);
  mixed[3].v = vec3(-1, 1, -1);
  const auto still = [](int iterations) {
    return settings_of(vec3(0), real(0.025), iterations, real(0.3));
  };
  return {{"a body falls, its rope is slack", {wall, ball(1, real(0.1), vec3(0, real(-0.5), 0))},
           {{0, 1, 1, true}}, {}},
          {"a body falls to the end of its rope within the step",
           {wall, ball(1, real(0.1), vec3(0, real(-0.999), 0))}, {{0, 1, 1, true}}, {}},
          {"two ropes share a body, so that the first has pulled too much, 200 iterations", pulled,
           {{1, 0, 1, true}, {2, 0, 1, true}}, still(200)},
          {"two ropes pull askew, so that the first gives back again and again, 4 iterations",
           askew, {{1, 0, 1, true}, {2, 0, 1, true}}, still(4)},
          {"a rope, a rod and a rope in a chain, 4 iterations", mixed, chain_links(true, true),
           still(4)},
          {"a body hangs from a rope, 60 steps", {wall, ball(1, real(0.1), vec3(0, -1, 0))},
           {{0, 1, 1, true}}, {}, 60}};
}

/// What a step makes of a scene, the reader's or one with a known mistake.
using Step = void(std::vector<Body>&, const std::vector<Link>&, const StepSettings&);
inline constexpr Step* your_step = step;
inline Numbers stepped(Step* step, const Scene& scene) {
  std::vector<Body> bodies = scene.bodies;
  for (int n = 0; n < scene.steps; ++n) {
    const auto todo = thrown_by<NotDone>([&] { step(bodies, scene.links, scene.settings); });
    if (!todo) continue;
    if (step != your_step) return Numbers(6 * most_bodies, -1e6);  // no one's numbers
    const auto rope = [](const Link& link) { return link.rope; };
    if (todo->id != "1.5" || std::any_of(scene.links.begin(), scene.links.end(), rope)) throw *todo;
    fail({"1.4", "the step"}, "Likely mistake: clamp_sum is called for a rod, which pushes, too. "
                              "Test link.rope first\n");
  }
  return numbers_of(bodies);
}

/// The order in which yours is right, or else from first to last.
inline Order order_of_yours() {
  const std::vector<Order> orders = right_orders();
  for (const Order& order : orders) {
    bool fits = true;
    for (const Scene& s : rod_scenes())
      fits = fits && close(stepped(your_step, s), walked(s, order), 10 * rounding);
    if (fits) return order;
  }
  return orders[0];
}

/// Some of the scenes beside the right step. \param all the scenes that a mistake should explain:
/// those which do come first, so that some scenes alone do not mislead
inline CaseTable<Scene> table_of(const Subject& subject, const std::vector<Scene>& scenes,
                                 const std::vector<Scene>& all) {
  const Order right = scenes.front().links.empty() ? right_orders()[0] : order_of_yours();
  CaseTable<Scene> table{subject, step_entries(), {}, {}, {}, scenes};
  judge(table, your_step, stepped);
  table.right = [=](const Scene& s) { return walked(s, right); };
  table.whole = true;
  table.tolerance = 10 * rounding;
  if (table.holds()) return table;
  for (const int n : {2, 5, 6, 8, 10, 12, 15, 16, 20, 25, 30, 32, 40, 50, 60, 64, 100, 200})
    table.mistakes.push_back({"a fixed number of iterations, " + std::to_string(n) +
                                  ": take settings.iterations",
                              [=](Scene s) {
                                s.settings.iterations = n;
                                return walked(s, right);
                              }});
  // the links from last to first
  const auto backward = [](Scene scene) {
    std::reverse(scene.links.begin(), scene.links.end());
    return scene;
  };
  for (std::size_t k = 0, count = table.mistakes.size(); k < count; ++k) {
    const AnyMistake mistake = table.mistakes[k];
    table.mistakes.push_back(
        {mistake.words, [=](const Scene& s) { return mistake.does(backward(s)); }});
  }
  std::stable_partition(table.mistakes.begin(), table.mistakes.end(), [&](const auto& mistake) {
    return std::all_of(all.begin(), all.end(), [&](const Scene& s) {
      return close(stepped(your_step, s), mistake.does(s), 10 * rounding);
    });
  });
  return table;
}

inline std::vector<Scene> scenes_without_ropes() {
  std::vector<Scene> all = free_scenes();
  for (const auto& more : {rod_scenes(), falling_rod_scenes()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}
/// Some of the scenes of exercise 1.4.
inline CaseTable<Scene> step_table(const std::vector<Scene>& scenes) {
  return table_of({"1.4", "the step"}, scenes, scenes_without_ropes());
}
/// The scenes with ropes: to be asked once clamp_sum is right by itself.
inline CaseTable<Scene> rope_table() {
  std::vector<Scene> all = scenes_without_ropes();
  for (const Scene& scene : rope_scenes()) all.push_back(scene);
  return table_of({"1.4", "the step, with ropes. Your clamp_sum (1.5) is right by itself"},
                  rope_scenes(), all);
}

}  // namespace joints::testing
