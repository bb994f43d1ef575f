// Exercise 1.4: the usual ways to do a step wrong, each as a step with another part.
#pragma once

#include "tests/01_distance/step_reference.h"

namespace joints::testing {

inline const char* const told_positions_every_iteration =
    "#positions-every-iteration positions move in every iteration: they belong after them";
inline const char* const told_impulses_computed_once =
    "#impulses-computed-once the impulses are computed once, before the iterations: compute them "
    "in each iteration";

using Ways = std::vector<std::pair<std::string, Way>>;

/// A way with one thing changed.
template <class Change>
Way way_with(Change change) {
  Way way;
  change(way);
  return way;
}

/// Forces, rows, impulses and positions in the wrong order.
inline Ways orders_of_pieces() {
  Ways out;
  std::string pieces = "FIPR";
  do {
    const auto before = [&](char a, char b) { return pieces.find(a) < pieces.find(b); };
    if (before('I', 'R') || (before('F', 'I') && before('I', 'P'))) continue;
    std::vector<std::string> words;
    if (before('P', 'F'))
      words.push_back("positions before the forces: the old velocity moves the body. Change v "
                      "first, then x");
    if (before('P', 'I'))
      words.push_back("#positions-before-impulses positions before the impulses: they move by "
                      "velocities that are not corrected yet");
    if (before('I', 'F'))
      words.push_back("#forces-after-rows forces after the impulses: the rods do not react to "
                      "gravity");
    std::string all;
    for (const std::string& part : words) all += (all.empty() ? "" : "; ") + part;
    out.push_back({all, way_with([&](Way& w) { w.pieces = pieces; })});
  } while (std::next_permutation(pieces.begin(), pieces.end()));
  return out;
}

/// Gravity.
inline Ways wrong_forces() {
  Ways out;
  const auto add = [&](const std::string& words, auto fall) {
    out.push_back({words, way_with([&](Way& w) { w.fall = fall; })});
  };
  using S = const StepSettings&;
  add("#whole-numbers-divided gravity does not act. Is it a copy that falls (write Body& body), "
      "or is h 1 / 60, which is 0 in whole numbers?", [](Body&, S) {});
  add("#gravity-without-h v grows by g, not by h g", [](Body& b, S s) { b.v += s.gravity; });
  add("v grows by h h g, not by h g", [](Body& b, S s) { b.v += s.h * s.h * s.gravity; });
  add("gravity is multiplied by the mass: all bodies fall alike",
      [](Body& b, S s) { b.v += s.h / b.inverse_mass * s.gravity; });
  add("#gravity-over-mass gravity is multiplied by the inverse mass: all bodies fall alike",
      [](Body& b, S s) { b.v += s.h * b.inverse_mass * s.gravity; });
  add("#sign-of-gravity the sign of gravity: the vector points to where bodies fall",
      [](Body& b, S s) { b.v -= s.h * s.gravity; });
  add("#velocity-set-gravity gravity sets v, which must grow: += and not =",
      [](Body& b, S s) { b.v = s.h * s.gravity; });
  add("#only-y-gravity only the y of gravity acts: settings.gravity is a vector",
      [](Body& b, S s) { b.v.y += s.h * s.gravity.y; });
  add("#fixed-gravity a fixed gravity of -9.81 m/s^2: take settings.gravity",
      [](Body& b, S s) { b.v.y += s.h * real(-9.81); });
  out.push_back({"#gravity-moves-static-bodies gravity moves a static body",
                 way_with([](Way& w) { w.static_falls = true; })});
  out.push_back({"#only-walls-fall gravity moves static bodies and no others: is the condition "
                 "the wrong way round?",
                 way_with([](Way& w) {
                   w.static_falls = true;
                   w.fall = [](Body& b, S s) {
                     if (b.is_static()) b.v += s.h * s.gravity;
                   };
                 })});
  out.push_back({"only the first body falls", way_with([](Way& w) {
                   w.falls = [](std::size_t i) { return i == 0; };
                 })});
  out.push_back({"the first body does not fall: places in a vector run from 0",
                 way_with([](Way& w) { w.falls = [](std::size_t i) { return i > 0; }; })});
  out.push_back({"#gravity-every-iteration gravity acts in every iteration: it belongs before them",
                 way_with([](Way& w) {
                   w.pieces = "RIP";
                   w.in_iteration = "F";
                 })});
  return out;
}

/// Places.
inline Ways wrong_places() {
  Ways out;
  const auto add = [&](const std::string& words, auto travel) {
    out.push_back({words, way_with([&](Way& w) { w.travel = travel; })});
  };
  using S = const StepSettings&;
  add("#positions-stay the position does not change. Is it a copy that moves (write Body& body)?",
      [](Body&, S) {});
  add("#positions-without-h x grows by v, not by h v", [](Body& b, S s) { b.x += b.v; (void)s; });
  add("#positions-set x is set, which must grow: += and not =",
      [](Body& b, S s) { b.x = s.h * b.v; });
  add("the sign of the position: x grows by h v", [](Body& b, S s) { b.x -= s.h * b.v; });
  for (const real half : {real(-0.5), real(0.5)})
    add("#parabola h h g / 2 does not belong here: x grows by h times the new v, Eq. 1-10",
        [half](Body& b, S s) {
          b.x += s.h * b.v;
          if (!b.is_static()) b.x += half * s.h * s.h * s.gravity;
        });
  add("#parabola-walls h h g / 2 does not belong here: x grows by h times the new v, and a wall "
      "does not move at all",
      [](Body& b, S s) { b.x += s.h * b.v + s.h * s.h / 2 * s.gravity; });
  out.push_back({"#nothing-without-links where there are no links the positions do not change: is "
                 "there a return before them?", way_with([](Way& w) { w.needs_links = true; })});
  out.push_back({told_positions_every_iteration, way_with([](Way& w) {
                   w.pieces = "FRI";
                   w.in_iteration = "P";
                 })});
  out.push_back({told_positions_every_iteration, way_with([](Way& w) {
                   w.pieces = "FRI";
                   w.gives = [](real lambda, const Turn& t) {
                     Way::push(lambda, t.row.J, t.body1, t.body2);
                     for (Body* body : {&t.body1, &t.body2}) body->x += t.settings.h * body->v;
                   };
                 })});
  out.push_back({"only the first body moves", way_with([](Way& w) {
                   w.travels = [](std::size_t i) { return i == 0; };
                 })});
  out.push_back({"the first body does not move: places in a vector run from 0",
                 way_with([](Way& w) { w.travels = [](std::size_t i) { return i > 0; }; })});
  return out;
}

/// A step that does not ask settings.h.
inline Ways fixed_steps() {
  Ways out;
  const std::pair<const char*, double> steps[] = {
      {"1/60", 1.0 / 60}, {"1/30", 1.0 / 30}, {"1/50", 0.02},    {"1/100", 0.01},
      {"1/120", 1.0 / 120}, {"1/10", 0.1},    {"0.016", 0.016}, {"0.0166", 0.0166},
      {"0.01666", 0.01666}, {"0.0167", 0.0167}, {"0.001", 0.001}};
  for (const auto& [number, seconds] : steps) {
    const std::string words = std::string("a fixed step of ") + number + " s";
    const real fixed = real(seconds);
    const auto fall = [=](Body& b, const StepSettings& s) { b.v += fixed * s.gravity; };
    const auto travel = [=](Body& b, const StepSettings&) { b.x += fixed * b.v; };
    out.push_back({words + ": take settings.h", way_with([&](Way& w) {
                     w.fall = fall;
                     w.travel = travel;
                   })});
    out.push_back({words + " for gravity: take settings.h",
                   way_with([&](Way& w) { w.fall = fall; })});
    out.push_back({words + " for the positions: take settings.h",
                   way_with([&](Way& w) { w.travel = travel; })});
  }
  return out;
}

/// How often, and in which order, the links are solved.
inline Ways wrong_iterations() {
  Ways out;
  const auto count = [&](const std::string& words, Call<int(const Scene&)> iterations) {
    out.push_back({words, way_with([&](Way& w) { w.iterations = iterations; })});
  };
  const auto order = [&](const char* words, auto which) {
    out.push_back({words, way_with([&](Way& w) { w.order = which; })});
  };
  count("#one-iteration-only as if there were only one iteration: the loop over the iterations is "
        "outside, the loop over the links inside", [](const Scene&) { return 1; });
  count("#one-iteration-too-few one iteration too few",
        [](const Scene& s) { return s.settings.iterations - 1; });
  count("#one-iteration-too-many one iteration too many",
        [](const Scene& s) { return s.settings.iterations + 1; });
  count("as many iterations as links: take settings.iterations",
        [](const Scene& s) { return int(s.links.size()); });
  count("as many iterations as bodies: take settings.iterations",
        [](const Scene& s) { return int(s.bodies.size()); });
  for (int fixed : {2, 3, 4, 5, 6, 8, 10, 12, 15, 16, 20, 25, 30, 32, 40, 50, 60, 64, 100, 200})
    count("a fixed number of iterations, " + std::to_string(fixed) + ": take settings.iterations",
          [=](const Scene&) { return fixed; });
  const auto from_to = [](int first, int cut) {
    return [=](int links, int) {
      std::vector<int> out;
      for (int k = first; k < links - cut; ++k) out.push_back(k);
      return out;
    };
  };
  order("#first-link-left-out the first link is left out: places in a vector run from 0",
        from_to(1, 0));
  order("#last-link-left-out the last link is left out: places run from 0 to size() - 1",
        from_to(0, 1));
  order("only the first link is solved",
         [](int links, int) { return std::vector<int>(links > 0 ? 1 : 0); });
  out.push_back({"#all-at-once all impulses of an iteration from the same velocities: apply each "
                 "one before the next is computed", way_with([](Way& w) { w.at_once = false; })});
  out.push_back({told_impulses_computed_once,
                 way_with([](Way& w) { w.asked_once = true; })});
  out.push_back({told_impulses_computed_once,
                 way_with([](Way& w) {
                   w.asked_once = true;
                   w.at_once = false;
                 })});
  return out;
}

}  // namespace joints::testing
