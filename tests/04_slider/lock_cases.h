// The error of exercise 4.2 as a table of cases with its usual mistakes: a lock.
#pragma once

#include <algorithm>

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
  const auto numbers = [](const vec3& a) { return Numbers{double(a.x), double(a.y), double(a.z)}; };
  const auto back = [](const quat& q) { return conjugate(q); };
  const auto turn = [=](const Case& c) { return c.q2 * back(c.start) * back(c.q1); };
  // something else made of the right rotation, with its sign as the rule wants it, or as it comes
  const auto of = [=](auto f) {
    return [=](const Case& c) {
      const quat e = turn(c);
      return numbers(f(e.w < 0 ? -e : e));
    };
  };
  const auto as_it_comes = [=](auto f) {
    return [=](const Case& c) { return numbers(f(turn(c))); };
  };
  const auto C = [](const quat& e) { return real(2) * vector_of(e); };
  const auto in_axes_of = [=](auto q) {
    return [=](const Case& c) { return numbers(q(c) * (real(2) * short_way(turn(c)))); };
  };
  const auto angles = [=](auto three) {
    return [=](const Case& c) { return numbers(three(c)); };
  };
  const char* const three = "#differences-of-angles differences of angles about three axes: these "
                            "are no rotation, and their rates are not w. C is 2 v";
  const char* const axis = "#normalised-axis the axis alone: C is 2 v, whose length is 2 "
                           "sin(angle/2)";
  const char* const sine = "#sin-angle the sine of the whole angle: it is zero again at a half "
                           "turn";
  const char* const tangent = "the tangent of half the angle: it is unbounded at a half turn";
  const char* const in_1 = "#axes-body-1 in the axes of body 1: C is in the world, q2 start^-1 "
                           "q1^-1";
  const char* const in_2 = "in the axes of body 2: C is in the world, q2 start^-1 q1^-1";
  const char* const turned = "#to-world-body1 turned once more with a body: q2 start^-1 q1^-1 is "
                             "in the world";

  CaseTable<Case> table{{"4.2", "the error C of a lock"}, {"C"}, {}, of(C), {}, lock_cases()};
  table.yours = [=](const Case& c) {
    Body body1, body2;
    body1.q = c.q1;
    body2.q = c.q2;
    return numbers(RotationLock{c.start}.error(body1, body2));
  };
  table.mistakes = {
      {"#sign-rule-w-alone the sign rule is forgotten: where s < 0, take -q", as_it_comes(C)},
      {"#minus the sign: body 2 is turned too far, so q2 stands first and q1 is inverted; and -q "
       "is taken where s < 0, not where s > 0", of([=](const quat& e) { return -C(e); })},
      {"#half-the-rotation the factor 2 is forgotten: v is only half the rotation", of(vector_of)},
      {"the factor 2 and the sign rule are forgotten", as_it_comes(vector_of)},
      {"#sign-by-x x decides which of q and -q is taken: the sign of s does",
       as_it_comes([=](const quat& e) { return C(e.x < 0 ? -e : e); })},
      {"#angle-vector the vector of the rotation itself: C is 2 v, whose length is 2 sin(angle/2)",
       of([](const quat& e) {
         const real size = length(vector_of(e));
         return size > 0 ? 2 * std::atan2(size, e.w) / size * vector_of(e) : vec3(0);
       })},
      {axis, of([](const quat& e) { return direction(vector_of(e)); })},
      {axis, of([](const quat& e) { return normalize(vector_of(e)); })},
      {"the half angle in place of its sine: C is 2 v",
       of([](const quat& e) { return 2 * std::acos(std::min(e.w, real(1))) * vector_of(e); })},
      {"#xzy the numbers x, z, y: the vector of q is (q.x, q.y, q.z)",
       of([](const quat& e) { return real(2) * vec3(e.x, e.z, e.y); })},
      {"the numbers y, z, w: the vector of q is (q.x, q.y, q.z)",
       of([](const quat& e) { return real(2) * vec3(e.y, e.z, e.w); })},
      {sine, of([=](const quat& e) { return e.w * C(e); })},
      {tangent, of([=](const quat& e) { return C(e) / e.w; })},
      {"#abs-components no absolute values: each number of v has a sign",
       of([=](const quat& e) { return abs(C(e)); })},
      {"#wxy the numbers w, x, y: the vector of q is (q.x, q.y, q.z)",
       of([](const quat& e) { return real(2) * vec3(e.w, e.x, e.y); })},
      {three, angles([](const Case& c) {
         return glm::eulerAngles(c.q2) - glm::eulerAngles(c.q1);
       })},
      {three, angles([=](const Case& c) {
         return glm::eulerAngles(back(c.q1) * c.q2) - glm::eulerAngles(c.start);
       })},
      {three, angles([=](const Case& c) {
         return glm::eulerAngles(c.q2 * back(c.start)) - glm::eulerAngles(c.q1);
       })},
      {three, of([](const quat& e) { return glm::eulerAngles(e); })},
      {three, as_it_comes([](const quat& e) { return glm::eulerAngles(e); })},
      {"#difference-of-q a difference of quaternions is no rotation",
       [=](const Case& c) { return numbers(C(c.q2 - c.q1)); }},
      {in_1, in_axes_of([=](const Case& c) { return back(c.q1); })},
      {in_2, in_axes_of([=](const Case& c) { return back(c.q2); })},
      {turned, in_axes_of([](const Case& c) { return c.q1; })},
      {turned, in_axes_of([](const Case& c) { return c.q2; })},
      {"#x-y-only C is zero, though body 2 is turned too far",
       [=](const Case&) { return numbers(vec3(0)); }}};
  for (const real small : {real(1e-1), real(1e-2), real(1e-4)})
    table.mistakes.push_back({"#zero-near a small rotation is an error, too: no threshold belongs "
                              "here",
                              of([=](const quat& e) {
                                return length(C(e)) < small ? vec3(0) : C(e);
                              })});

  // other products, with and without the factor 2 and the sign rule
  using Product = Call<quat(const Case&)>;
  const char* const order = "the order of the product: q2, then start^-1, then q1^-1";
  const std::pair<const char*, Product> products[] = {
      {"start is forgotten: the initial relative rotation is not an error",
       [=](const Case& c) { return c.q2 * back(c.q1); }},
      {"start is forgotten, and the order is q2 q1^-1",
       [=](const Case& c) { return back(c.q1) * c.q2; }},
      {"#start-twice start is taken away twice",
       [=](const Case& c) { return c.q2 * back(c.start) * back(c.start) * back(c.q1); }},
      {"#q1-for-q2 body 1 alone: the rotation is that of body 2",
       [=](const Case& c) { return c.q1 * back(c.start) * back(c.q1); }},
      {"body 2 alone: q1 and start say where it should be", [](const Case& c) { return c.q2; }},
      {"#start-not-inverted start must be inverted",
       [=](const Case& c) { return c.q2 * c.start * back(c.q1); }},
      {"start is on the wrong side of q1^-1: (q1 start)^-1 = start^-1 q1^-1",
       [=](const Case& c) { return c.q2 * back(c.q1) * back(c.start); }},
      {"#nothing-inverted start and q1 must be inverted",
       [](const Case& c) { return c.q2 * c.start * c.q1; }},
      {"q1 must be inverted", [=](const Case& c) { return c.q2 * back(c.start) * c.q1; }},
      {order, [=](const Case& c) { return back(c.start) * c.q2 * back(c.q1); }},
      {order, [=](const Case& c) { return back(c.q1) * back(c.start) * c.q2; }},
      {order, [=](const Case& c) { return back(c.q1) * c.start * c.q2; }},
      {in_1, [=](const Case& c) { return back(c.q1) * c.q2 * back(c.start); }},
      {in_2, [=](const Case& c) { return back(c.start) * back(c.q1) * c.q2; }},
      {"start must be inverted, and the order is q2 start^-1 q1^-1",
       [=](const Case& c) { return back(c.q1) * c.q2 * c.start; }}};
  for (const auto& [words, product] : products) {
    const std::string known = words;
    const auto add = [&, p = product](const std::string& more, auto f) {
      table.mistakes.push_back({known + more, [=](const Case& c) { return numbers(f(p(c))); }});
    };
    add("", [](const quat& q) { return real(2) * short_way(q); });
    add("; the sign is wrong as well", [](const quat& q) { return real(-2) * short_way(q); });
    add("; the sign rule is forgotten as well", C);
    add("; the factor 2 is forgotten as well", short_way);
    add("; the factor 2 and the sign rule are forgotten as well", vector_of);
  }
  table.tolerance = 10 * rounding;
  table.leave_out_harmless();
  return table;
}

}  // namespace joints::testing
