// The error of exercise 4.2 as a table of cases: a lock.
#pragma once

#include "tests/04_slider/slider_references.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct LockCase {
  std::string words;
  quat q1, q2, start;
};

inline vec3 vector_of(const quat& q) { return {q.x, q.y, q.z}; }

/// Locks of any start between bodies that are turned anyhow, that are held, that are nearly held.
inline std::vector<LockCase> lock_cases() {
  std::vector<LockCase> out;
  Random random(42);
  for (int draw = 0; draw < 8; ++draw) {
    const quat q1 = random.turn(), q2 = random.turn(), start = random.turn();
    out.push_back({"turned", q1, q2, start});
    out.push_back({"held", q1, q1 * start, start});
  }
  for (const real little : {real(0.05), real(5e-3), real(5e-5)}) {
    const quat q1 = random.turn(), start = random.turn();
    const vec3 turn = little * normalize(random.vector(1));
    out.push_back({"turned a little", q1, rotation(turn) * q1 * start, start});
  }
  return out;
}

inline CaseTable<LockCase> lock_table() {
  using Case = LockCase;
  CaseTable<Case> table{{"4.2", "the error C of a lock"}, {"C"}, {}, {}, {}, lock_cases()};
  const auto numbers = [](const vec3& a) { return Numbers{double(a.x), double(a.y), double(a.z)}; };
  judge(table, +[](const RotationLock& lock, const Body& body1, const Body& body2) {
    return lock.error(body1, body2);
  }, [=](auto error, const Case& c) {
    return numbers(error({c.start}, static_body(vec3(0), c.q1), static_body(vec3(0), c.q2)));
  });
  table.right = [=](const Case& c) {
    return numbers(real(2) * short_way(c.q2 * conjugate(c.q1 * c.start)));
  };
  table.tolerance = 10 * rounding;
  // a mistake together with those that come after it
  table.pairs = [=, mistakes = table.mistakes, yours = table.yours, close = table.tolerance] {
    CaseTable<Case>::Mistakes out;
    const auto add = [&](const AnyMistake& mistake, const char* more, double factor, bool signs) {
      out.push_back({mistake.words + "; " + more + " as well", [=](const Case& c) {
                       Numbers a = mistake.does(c);
                       for (double& x : a) x *= factor;
                       Numbers opposite = a;
                       for (double& x : opposite) x = -x;
                       return signs && same_numbers(yours(c), opposite, close) ? opposite : a;
                     }});
    };
    for (const AnyMistake& mistake : mistakes) {
      add(mistake, "the sign is wrong", -1, false);
      add(mistake, "the factor 2 is forgotten", 0.5, false);
      add(mistake, "the sign rule is forgotten", 1, true);
      add(mistake, "the factor 2 and the sign rule are forgotten", 0.5, true);
    }
    return out;
  };
  return table;
}

}  // namespace joints::testing
