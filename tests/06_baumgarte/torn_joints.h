// The torn joints of exercise 6.3: points and ropes at every pose, and a chain.
#pragma once

#include "tests/06_baumgarte/projection_reference.h"
#include "tests/checker/arguments.h"

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

template <class Part>
CaseTable<ProjectionCase<Part>> projection_table(const Subject& subject,
                                                 std::vector<ProjectionCase<Part>> cases) {
  using Case = ProjectionCase<Part>;
  CaseTable<Case> table{subject,
                        {"move of 1", "rotation of 1", "move of 2", "rotation of 2", "change of v1",
                         "change of w1", "change of v2", "change of w2", "lengths of q1 and q2"},
                        {}, {}, {}, std::move(cases)};
  const auto numbers = [](auto project_one, const Case& c) {
    Pair after = c.pair;
    const auto& [one, two] = c.pair;
    project_one(c.part, after.body1, after.body2);
    const Moves a = between(c.pair, after);
    return flat({a.way1, a.turn1, a.way2, a.turn2, after.body1.v - one.v, after.body1.w - one.w,
                 after.body2.v - two.v, after.body2.w - two.w,
                 vec3(length(after.body1.q), length(after.body2.q), 0)});
  };
  judge<void(const Part&, Body&, Body&)>(table, project, numbers);
  table.right = [=](const Case& c) {
    const auto move = [](const Part& part, Body& one, Body& two) {
      move_by(reference_moves(part, {one, two}), one, two);
    };
    return numbers(move, c);
  };
  table.tolerance = difference_tolerance;
  return table;
}

/// From which error on a rope moves, where that is the only thing that is wrong; "" elsewhere.
inline std::string threshold_of(const CaseTable<ProjectionCase<Rope<Distance>>>& table) {
  real moves = -unbounded, rests = unbounded;  // the greatest C that moves, the least that rests
  for (const auto& c : table.cases) {
    const real C = c.part.error(c.pair.body1, c.pair.body2);
    const Numbers yours = table.yours(c), right = table.right(c);
    const bool at_rest = std::all_of(yours.begin(), yours.begin() + 12,
                                     [&](double a) { return std::abs(a) < table.tolerance; });
    if (at_rest) rests = std::min(rests, C);
    else moves = std::max(moves, C);
    if (C < 0 && !at_rest && !close(yours, right, table.tolerance)) return "";
  }
  if (moves > rests || (moves < 0 && rests > 0) || std::isinf(moves) || std::isinf(rests))
    return "";
  return moves < 0 ? "a rope that is hardly too long is left alone: there is no threshold, C < 0 "
                     "is too long"
                   : "a rope that is hardly slack is pushed to its length: there is no threshold, "
                     "C >= 0 is left alone";
}

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
  auto table = projection_table(rope_projection, cases);
  read_off(table, [=] { return threshold_of(table); });
  return table;
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
             table.explain(double(length(body.q))));
    };
    look(c.pair.body1, after.body1);
    look(c.pair.body2, after.body2);
  }
}

// ---- the iteration ------------------------------------------------------------------------------

inline constexpr Subject iteration_subject{"6.3", "an iteration of position projection", 3};

struct ChainCase {
  std::string words;
  Chain chain;
};

/// Five uneven bodies, turned or not. \param gaps by how much each joint is torn
inline Chain torn_chain(const std::array<double, 4>& gaps, bool turned) {
  Random random(64);
  const auto turn = [&] { return turned ? random.turn() : quat(1, 0, 0, 0); };
  Chain chain{{static_body(vec3(0), turn())}, {}};
  for (int k = 1; k < 5; ++k) {
    Pair pair = uneven_pair();
    Body body = k % 2 == 0 ? pair.body1 : pair.body2;
    body.x = vec3(real(k), 0, 0);
    body.q = turn();
    body.v = random.vector(1);
    chain.joints.push_back(point_at(chain.bodies.back(), body, vec3(real(k) - real(0.5), 0, 0)));
    body.x += random.vector(real(gaps[std::size_t(k - 1)]));
    chain.bodies.push_back(body);
  }
  return chain;
}

inline void project_in_order(Chain& chain, void (*project_one)(const Point&, Body&, Body&)) {
  Body* body = chain.bodies.data();
  for (const Point& joint : chain.joints) project_one(joint, body[0], body[1]), ++body;
}

/// What the known mistakes do is done with your projection.
inline CaseTable<ChainCase> iteration_table() {
  using Case = ChainCase;
  CaseTable<Case> table{iteration_subject, {}, {}, {}, {}, {}};
  for (int k = 0; k < 5; ++k)
    for (const char* of : {"x", "rotation", "v"})
      for (const char* part : {".x", ".y", ".z"})
        table.entries.push_back(of + (" of body " + std::to_string(k)) + part);
  table.whole = true;
  table.cases = {{"every joint torn", torn_chain({0.1, 0.1, 0.1, 0.1}, true)},
                 {"two closed", torn_chain({0, 0.1, 0, 0.1}, false)},
                 {"two hardly open", torn_chain({1e-7, 1e-7, 0.1, 0.1}, true)},
                 {"two slightly open", torn_chain({2e-5, 2e-5, 0.1, 0.1}, true)}};
  const auto numbers = [](auto iterate, const Case& c) {
    Chain chain = c.chain;
    iterate(chain);
    std::vector<vec3> all;
    for (std::size_t k = 0; k < chain.bodies.size(); ++k) {
      const Body &body = chain.bodies[k], &before = c.chain.bodies[k];
      all.insert(all.end(), {body.x, turn_between(before.q, body.q), body.v});
    }
    return flat(all);
  };
  judge(table, projection_iteration, numbers);
  table.right = [=](const Case& c) {
    const auto move = [](const Point& point, Body& one, Body& two) {
      move_by(reference_moves(point, {one, two}), one, two);
    };
    return numbers([=](Chain& chain) { project_in_order(chain, move); }, c);
  };
  const auto yours_often = [=](int times) {
    return [=](const Case& c) {
      return numbers([=](Chain& chain) {
        for (int n = 0; n < times; ++n) project_in_order(chain, project);
      }, c);
    };
  };
  table.mistakes.put_first({"the iteration is right and its projections are not: look at "
                            "`project` of a point, the first part of the exercise",
                            yours_often(1)});
  table.tolerance = difference_tolerance;
  read_off(table, [=, yours = table.yours, tolerance = table.tolerance, c = table.cases[0]] {
    for (int n = 3; n < 200; ++n)
      if (same_numbers(yours(c), yours_often(n)(c), tolerance))
        return "this is " + std::to_string(n) + " iterations: every joint is projected once";
    return std::string();
  });
  return table;
}

}  // namespace joints::testing
