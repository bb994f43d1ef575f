// The torn joints of exercise 6.3: points and ropes at every pose, and a chain.
#pragma once

#include "tests/06_baumgarte/projection_cases.h"

namespace joints::testing {

// ---- projections --------------------------------------------------------------------------------

/// A part at every pose, with its joint torn and its bodies flying; then with a static body each.
template <class Fixture>
std::vector<ProjectionCase<typename Fixture::Part>> torn_cases(
    const Call<void(typename Fixture::Part&, Pair&, Random&)>& tear) {
  std::vector<ProjectionCase<typename Fixture::Part>> out;
  Random random(63);
  for_each_pose<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    out.push_back({pose_names[pose], part, pair});
    auto& c = out.back();
    tear(c.part, c.pair, random);
    for (Body* body : {&c.pair.body1, &c.pair.body2}) {
      body->v = random.vector(2);
      body->w = random.vector(2);
    }
  });
  for (const bool second : {false, true}) {
    out.push_back(out[5]);
    out.back().words = second ? "2 static" : "1 static";
    Body& wall = second ? out.back().pair.body2 : out.back().pair.body1;
    wall = static_body(wall.x, wall.q);
  }
  return out;
}

inline constexpr Subject point_projection{"6.3", "position projection of a point"};
inline constexpr Subject rope_projection{"6.3", "position projection of a rope", 2};

inline CaseTable<ProjectionCase<Point>> point_table() {
  const auto tear = [](Point&, Pair& pair, Random& random) {
    pair.body2.x += random.vector(real(0.15));
  };
  return projection_table(point_projection, torn_cases<PointFixture>(tear));
}
// Half of the ropes are too long and half of them are slack, two of them hardly.
inline CaseTable<ProjectionCase<Rope<Distance>>> rope_table() {
  bool slack = true;
  auto cases = torn_cases<RopeFixture>([&](Rope<Distance>& rope, Pair& pair, Random& random) {
    slack = !slack;
    const real length = rope.rod.length - rope.error(pair.body1, pair.body2);
    rope.rod.length = length + (slack ? 1 : -1) * random.uniform(real(0.1), real(0.3));
  });
  for (const real C : {real(0.004), real(-0.004)}) {
    cases.push_back(cases[4]);
    auto& c = cases.back();
    c.words = C > 0 ? "hardly" : "hardly too long";
    c.part.rod.length += C - c.part.error(c.pair.body1, c.pair.body2);
  }
  for (auto& c : cases)
    if (c.part.error(c.pair.body1, c.pair.body2) > 0) c.words += ", slack";
  return projection_table(rope_projection, cases);
}

template <class Part>
Pair projected(const ProjectionCase<Part>& c) {
  Pair after = c.pair;
  project(c.part, after.body1, after.body2);
  return after;
}

// The velocities and the static body of a projection are the same afterwards, to the last bit.
template <class Part>
void expect_left_alone(const CaseTable<ProjectionCase<Part>>& table) {
  for (const ProjectionCase<Part>& c : table.cases) {
    const Pair after = projected(c);
    const auto same = [&](const char* entry, const vec3& a, const vec3& b) {
      expect(table.subject, entry + (" (" + c.words + ")"), a, b, 0, why(table, a));
    };
    const auto look = [&](const Body& before, const Body& body) {
      same(&before == &c.pair.body1 ? "v1" : "v2", body.v, before.v);
      same(&before == &c.pair.body1 ? "w1" : "w2", body.w, before.w);
      if (before.is_static()) same("x of the static body", body.x, before.x);
      if (before.is_static())
        expect(table.subject, "q of the static body", body.q, before.q, rounding);
      expect(table.subject, "length of q (" + c.words + ")", double(length(body.q)), 1, rounding,
             table.explain(double(length(body.q)),
                           {{double(length(body.q)), no_sum}}));
    };
    look(c.pair.body1, after.body1);
    look(c.pair.body2, after.body2);
  }
}

// ---- the iteration
// ----------------------------------------------------------------------------------

inline constexpr Subject iteration_subject{"6.3", "an iteration of position projection", 3};

// A chain of five uneven bodies, each turned, each joint torn.
inline Chain torn_chain() {
  Random random(64);
  Chain chain{{static_body(vec3(0), random.turn())}, {}};
  for (int k = 1; k < 5; ++k) {
    Pair pair = uneven_pair();
    Body body = k % 2 == 0 ? pair.body1 : pair.body2;
    body.x = vec3(real(k), 0, 0) + random.vector(real(0.1));
    body.q = random.turn();
    body.v = random.vector(1);
    chain.joints.push_back(point_at(chain.bodies.back(), body, vec3(real(k) - real(0.5), 0, 0)));
    body.x += random.vector(real(0.1));
    chain.bodies.push_back(body);
  }
  return chain;
}

using Project = Call<void(const Point&, Body&, Body&)>;
inline void project_all(Chain& chain, const std::vector<std::size_t>& order,
                        const Project& project_one) {
  for (const std::size_t k : order)
    project_one(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]);
}
inline void reference_projection(const Point& point, Body& body1, Body& body2) {
  move_by(reference_moves(point, {body1, body2}), body1, body2);
}
inline void your_projection(const Point& point, Body& body1, Body& body2) {
  project(point, body1, body2);
}

// Every joint looks at the poses before the iteration.
inline void stale_poses(Chain& chain, const Project&) {
  const Chain before = chain;
  for (std::size_t k = 0; k < chain.joints.size(); ++k)
    move_by(reference_moves(before.joints[k], {before.bodies[k], before.bodies[k + 1]}),
            chain.bodies[k], chain.bodies[k + 1]);
}

// All errors are taken before the iteration, K and J are fresh.
inline void stale_errors(Chain& chain, const Project&) {
  const Chain before = chain;
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body &a = chain.bodies[k], &b = chain.bodies[k + 1];
    ProjectionReference<Point> reference(chain.joints[k], {a, b});
    reference.C = to_vector(chain.joints[k].error(before.bodies[k], before.bodies[k + 1]));
    move_by(reference.moves(), a, b);
  }
}
// One of the two bodies of each joint is a copy.
inline auto project_copy(int copied) {
  return [=](Chain& chain, const Project& project_one) {
    for (std::size_t k = 0; k < chain.joints.size(); ++k) {
      Body copy = chain.bodies[k + copied];
      project_one(chain.joints[k], copied == 0 ? copy : chain.bodies[k],
            copied == 1 ? copy : chain.bodies[k + 1]);
    }
  };
}
// Joint k is given the bodies that stand `by` too far along the chain, where there are such.
inline auto project_shifted(int by) {
  return [=](Chain& chain, const Project& project_one) {
    for (int k = 0; k < int(chain.joints.size()); ++k)
      if (k + by >= 0 && k + by + 1 < int(chain.bodies.size()))
        project_one(chain.joints[k], chain.bodies[k + by], chain.bodies[k + by + 1]);
  };
}

inline bool same_chains(const Chain& a, const Chain& b) {
  for (std::size_t k = 0; k < a.bodies.size(); ++k)
    if (!(length(a.bodies[k].x - b.bodies[k].x) <= difference_tolerance) ||
        !(length(turn_between(a.bodies[k].q, b.bodies[k].q)) <= 3 * difference_tolerance) ||
        a.bodies[k].v != b.bodies[k].v)
      return false;
  return true;
}

// The mistake that gives all the bodies of a chain; "" where there is none. The subject is another
// one where the iteration is right and its projections are not.
struct IterationMistake {
  Subject subject;
  std::string words;
};
inline IterationMistake explain_iteration(const Chain& start, const Chain& yours) {
  using Iteration = Call<void(Chain&, const Project&)>;
  const auto order = [](std::vector<std::size_t> joints) {
    return [=](Chain& chain, const Project& one) { project_all(chain, joints, one); };
  };
  const std::pair<Iteration, const char*> iterations[] = {
      {order({0, 1, 2, 3}),
       "the iteration is right and its projections are not: look at `project` of a "
                            "point, the first part of the exercise"},
      {stale_poses, "#stale-poses the poses are stale: each joint needs the poses after the one "
                    "before it, else both move their body for the same gap"},
      {order({3, 2, 1, 0}), "#backwards the iteration runs backwards: from the first joint to "
                            "the last"},
      {order({1, 2, 3}), "the first joint is left out: it holds body 0 to body 1"},
      {order({0, 1, 2}), "the last joint is left out: there is one joint less than bodies"},
      {order({0}), "only the first joint is projected"},
      {order({0, 1, 2, 3, 0, 1, 2, 3}), "this is two iterations: every joint is projected once"},
      {order({0, 1, 2, 3, 3, 2, 1, 0}), "there and back: every joint is projected once"},
      {order({0, 2}), "#every-second-joint every second joint is left out"},
      {order({0, 2, 1, 3}),
       "every second joint, then the others: from the first joint to the last"},
      {order({}), "#of-copies nothing moves: nothing is done yet, or copies move: take the "
                  "bodies of the chain by reference, auto& and not auto"},
      {stale_errors, "#errors-first the errors are computed before the iteration: each joint needs "
                     "its error at the poses after the one before it"},
      {project_copy(1), "#copy-one-body body k + 1 is a copy: take it by reference, auto& and "
                        "not auto"},
      {project_copy(0), "body k is a copy: take it by reference, auto& and not auto"},
      {project_shifted(-1), "bodies k - 1 and k: joint k holds body k to body k + 1"},
      {project_shifted(1), "bodies k + 1 and k + 2: joint k holds body k to body k + 1"},
      {[](Chain& chain, const Project& project_one) {
         for (std::size_t k = 0; k < chain.joints.size(); ++k)
           project_one(chain.joints[k], chain.bodies[k + 1], chain.bodies[k]);
       }, "#bodies-exchanged the bodies are exchanged: joint k holds body k to body k + 1"},
      {[](Chain& chain, const Project& project_one) {
         for (std::size_t k = 0; k < chain.joints.size(); ++k)
           project_one(chain.joints[k], chain.bodies[0], chain.bodies[k + 1]);
       }, "every joint holds its body to body 0: joint k holds body k to body k + 1"},
      {[](Chain& chain, const Project& project_one) {
         for (const Point& joint : chain.joints)
           project_one(joint, chain.bodies[0], chain.bodies[1]);
       }, "every joint is given bodies 0 and 1: joint k holds body k to body k + 1"},
      {[](Chain& chain, const Project& project_one) {
         for (std::size_t k = 0; k < chain.joints.size(); ++k)
           project_one(chain.joints[0], chain.bodies[k], chain.bodies[k + 1]);
       }, "joint 0 is taken for all of them: joint k holds body k to body k + 1"}};
  for (const Body& body : yours.bodies)
    if (!std::isfinite(double(dot(body.x, body.x) + dot(body.q, body.q))))
      fail(iteration_subject, "The position of a body is not a number.\n\n" +
                              likely("#body-itself a joint between a body and itself has no K: "
                                     "joint k holds body k to body k + 1"));
  for (const bool reference : {true, false})
    for (const auto& [iteration, words] : iterations) {
      Chain chain = start;
      iteration(chain, reference ? reference_projection : your_projection);
      if (!same_chains(chain, yours)) continue;
      const bool in_order = &words == &iterations[0].second;
      return {in_order && !reference ? point_projection : iteration_subject,
              in_order && reference ? "" : words};
    }
  Chain often = start, resting = yours;
  for (int n = 2; n < 200; ++n) {
    project_all(often, {0, 1, 2, 3}, your_projection);
    if (same_chains(often, yours) && n > 2)
      return {iteration_subject, "this is " + std::to_string(n - 1) +
                                     " iterations: every joint is projected once"};
  }
  for (std::size_t k = 0; k < resting.bodies.size(); ++k) resting.bodies[k].v = start.bodies[k].v;
  if (!same_chains(resting, yours))
    return {iteration_subject,
            "#velocities-to-rest the velocities of the bodies change: an iteration moves and "
            "turns them"};
  return {iteration_subject, ""};
}

}  // namespace joints::testing
