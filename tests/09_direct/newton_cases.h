// Exercise 9.6: Newton's method on the positions as a table: correctors that a test can follow.
#pragma once

#include <memory>

#include "chapters/09_direct/direct.h"
#include "tests/checker/padded.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

/// A corrector that writes down what it is asked.
class Written : public Corrector {
 public:
  explicit Written(Bodies& bodies) : bodies(bodies), before(bodies.at(1)) {}
  Bodies& bodies;
  Body before;             ///< body 1 as it was
  int asked = 0, changed = 0;
  Numbers seen, rates;     ///< body 1 at each errors(), and the arguments of each change_rates()

  std::vector<double>& errors() override {
    const Body& body = bodies.at(1);
    seen.insert(seen.end(), {double(body.x.x), double(body.x.y), double(body.q.w),
                             double(body.q.z)});
    C_ = error(asked++);
    return C_;
  }
  void change_rates(std::vector<double>& wanted) override {
    wanted.resize(3, 0);
    rates.insert(rates.end(), wanted.begin(), wanted.end());
    change(vec3(real(wanted[0]), real(wanted[1]), real(wanted[2])));
    ++changed;
    for (double& used_up : wanted) used_up = 99;
  }

 protected:
  virtual std::vector<double> error(int call) = 0;
  virtual void change(const vec3& rates) = 0;

 private:
  std::vector<double> C_;
};

/// A body on a pin at the origin: C is where its lever ends. J is that of the beginning, exact.
class Pin : public Written {
 public:
  Pin(Bodies& bodies, const vec3& lever) : Written(bodies), lever_(lever) {}

 protected:
  std::vector<double> error(int) override {
    const vec3 C = world_point(bodies.at(1), lever_);
    return {double(C.x), double(C.y), double(C.z)};
  }
  void change(const vec3& rates) override {
    const mat3 r = skew(to_world(before, lever_)), inertia = inverse_inertia(before);
    const mat3 K = mat3(before.inverse_mass) - r * inertia * r;
    const vec3 impulse = inverse(K) * rates;
    bodies.at(1).v += before.inverse_mass * impulse;
    bodies.at(1).w += inertia * (r * impulse);
  }

 private:
  vec3 lever_;
};

/// Errors that are known beforehand, whatever the bodies do; then the last of them for ever. The
/// velocities change all the same.
class Script : public Written {
 public:
  Script(Bodies& bodies, std::vector<std::vector<double>> script)
      : Written(bodies), script_(std::move(script)) {}

 protected:
  std::vector<double> error(int call) override {
    return script_[std::min(std::size_t(call), script_.size() - 1)];
  }
  void change(const vec3& rates) override {
    bodies.at(1).v += rates;
    bodies.at(1).w += real(0.1) * rates;
  }

 private:
  std::vector<std::vector<double>> script_;
};

/// A body that slides along x to a mark. Only a fraction of each change arrives: 1 is exact.
class Mark : public Written {
 public:
  Mark(Bodies& bodies, double mark, double share)
      : Written(bodies), mark_(mark), share_(share) {}

 protected:
  std::vector<double> error(int) override { return {double(bodies.at(1).x.x) - mark_}; }
  void change(const vec3& rates) override { bodies.at(1).v.x += real(share_) * rates.x; }

 private:
  double mark_, share_;
};

/// C = 1 + x^2 has no zero: the mark is out of reach.
class Reach : public Written {
 public:
  explicit Reach(Bodies& bodies) : Written(bodies) {}

 protected:
  std::vector<double> error(int) override {
    const double x = double(bodies.at(1).x.x);
    return {1 + x * x};
  }
  void change(const vec3& rates) override { bodies.at(1).v.x += rates.x / (2 * before.x.x); }
};

using MakeCorrector = Call<std::unique_ptr<Written>(Bodies&)>;
struct NewtonCase {
  std::string words;
  Body body;  ///< slot 1
  double h;
  int iterations;
  MakeCorrector corrector;
  double tolerance = sizeof(real) == 4 ? 1e-4 : 1e-8;  ///< [m]
};

/// The one that the corrector holds is body 1, body 2 is static, the others fly by and turn.
inline Bodies newton_bodies(const NewtonCase& c) {
  Bodies bodies;
  Body other = body_with(3, vec3(1), vec3(-2, 1, 4));
  other.v = vec3(1, 2, -3);
  other.w = vec3(real(0.5), 3, 1);
  bodies.add(other);
  bodies.add(c.body);
  bodies.add(static_body(vec3(7)));
  other.x = vec3(3, 3, 3);
  bodies.add(other);
  return bodies;
}

inline Body on_pin(real speed) {
  Body body = body_with(2, vec3(real(0.3), real(0.5), real(0.4)), vec3(1, 0, 0));
  body.w = speed * vec3(real(0.2), real(0.1), 1);
  body.v = cross(body.w, body.x);
  return body;
}
inline Body sliding(real x, real v) {
  Body body = ball(1, real(0.5), vec3(x, 0, 0));
  body.v.x = v;
  body.w = vec3(0, 0, 2);
  return body;
}

inline std::vector<NewtonCase> newton_cases() {
  const auto mark = [](double at, double share) {
    return [=](Bodies& bodies) { return std::make_unique<Mark>(bodies, at, share); };
  };
  const auto script = [](std::vector<std::vector<double>> errors) {
    return [=](Bodies& bodies) { return std::make_unique<Script>(bodies, errors); };
  };
  const MakeCorrector pin = [](Bodies& bodies) {
    return std::make_unique<Pin>(bodies, vec3(-1, 0, 0));
  };
  const double h = 0.125;  // a power of two: exact in any order
  std::vector<NewtonCase> out{
      {"a slider with a mark half a metre ahead", sliding(0, 3), 0.1, 4, mark(0.5, 1)},
      {"a slider that arrives by itself", sliding(0, 5), 0.1, 4, mark(0.5, 1)},
      {"a slider whose changes arrive by half", sliding(0, 3), 0.1, 4, mark(0.5, 0.5)},
      {"a slider that goes too far each time", sliding(0, 3), 0.1, 4, mark(0.5, 1.5)},
      {"no iterations at all", sliding(0, 3), 0.1, 0, mark(0.5, 1)},
      {"one iteration", sliding(0, 3), 0.1, 1, mark(0.5, 1)},
      {"two iterations of one step", sliding(1, -3), 0.05, 2, mark(0.5, 0.5)},
      {"a slider whose changes hardly arrive", sliding(0, 3), 0.1, 4, mark(0.5, 0.1)},
      {"a slider whose changes arrive four times", sliding(0, 3), 0.1, 4, mark(0.5, 4)},
      {"a mark that is out of reach", sliding(1, -3), 0.1, 5,
       [](Bodies& bodies) { return std::make_unique<Reach>(bodies); }}};
  for (const real speed : {real(0.5), real(2), real(4)})
    for (const double step : {0.05, 0.1})
      out.push_back({"a pendulum at " + short_number(double(speed)) + " rad/s, h " +
                         short_number(step),
                     on_pin(speed), step, 7, pin});
  const auto add = [&](const std::string& words, std::vector<std::vector<double>> errors) {
    out.push_back({words, sliding(1, 2), h, 4, script(errors)});
  };
  add("errors of 1 m, then of 1 m again", {{1}, {1}});
  add("errors of 1 m, 0.4 m, then of 0.35 m", {{1}, {0.4}, {0.35}});
  add("errors of 1 m, 0.5 m, 0.3 m, and so on", {{1}, {0.5}, {0.3}, {0.2}, {0.1}});
  add("the error that is exactly the poorest allowed", {{1}, {poor_contraction}, {0}});
  for (const double e : {1e-6, 0.01}) {  // tolerances
    const std::string of = ", tolerance " + short_number(e);
    add("an error that is exactly the tolerance" + of, {{e}, {1}});
    add("an error just below the tolerance" + of, {{0.9 * e}, {1}});
    add("an error just above the tolerance" + of, {{1.01 * e}, {0}});
    add("an accepted error that has hardly become less" + of, {{1.2 * e}, {0.95 * e}});
    add("an error that the last correction has removed" + of,
        {{1}, {0.5}, {0.3}, {0.15}, {0.9 * e}});
    add("an error that the last correction has left" + of,
        {{1}, {0.5}, {0.3}, {0.15}, {1.1 * e}, {0}});
    for (std::size_t k = out.size() - 6; k < out.size(); ++k) out[k].tolerance = e;
  }
  add("errors of 1 m, 0.5 m, then of 0.65 m", {{1}, {0.5}, {0.65}});
  add("errors of 1 m, 0.2 m, then of 0.25 m", {{1}, {0.2}, {0.25}});
  add("errors of 2 m, 0.3 m, then of 0.35 m", {{2}, {0.3}, {0.35}});
  add("errors of 0.5 m, 0.2 m, 0.1 m, then of 0.09 m", {{0.5}, {0.2}, {0.1}, {0.09}});
  add("two rows, the first of which is better", {{0.1, -1}, {0.05, -0.9}, {0, 0}});
  add("two rows, the last of which is better", {{-1, 0.1}, {-0.9, 0.05}, {0, 0}});
  add("two rows, one becomes worse and the greater one better", {{1, 0.1}, {0.5, 0.4}, {0, 0}});
  add("two rows, the second of which comes up", {{1, 0}, {0.65, 0.65}, {0, 0}});
  add("two rows of opposite signs", {{1, -1}, {0.4, -0.4}, {0, 0}});
  add("a negative error", {{-1}, {-0.3}, {0}});
  add("three rows that become better by degrees", {{0.5, 0.5, 0.5}, {0.3, 0.1, 0}, {0.1, 0, 0},
                                                   {0, 0, 0}});
  add("an error that changes its sign", {{1}, {-0.6}, {0.3}, {0}});
  add("an error that changes its sign and hardly its size", {{1}, {-0.9}, {0.3}, {0}});
  return out;
}

inline constexpr std::size_t asked_at_most = 8, numbers_of_newton = 120;

inline void append_body(Numbers& out, const Body& b) {
  for (const vec3& a : {b.x, b.v, b.w})
    for (int i = 0; i < 3; ++i) out.push_back(double(a[i]));
  for (const real a : {b.q.w, b.q.x, b.q.y, b.q.z}) out.push_back(double(a));
}

/// What an answer does: result, calls, what the corrector saw and got, and the bodies at the end
/// where the right answer `ends_well`.
/// \param move of bodies, h, iterations, tolerance, corrector and memory
template <class Move>
Numbers newton_numbers(const NewtonCase& c, bool ends_well, const Move& move) {
  Bodies bodies = newton_bodies(c);
  const std::unique_ptr<Written> corrector = c.corrector(bodies);
  std::vector<Body> start(7, sliding(real(unwritten), real(unwritten)));
  const bool result = move(bodies, c.h, c.iterations, c.tolerance, *corrector, start);
  const auto cut = [](Numbers numbers, std::size_t size) {
    numbers.resize(size, 0);
    return numbers;
  };
  Numbers out{double(result), double(corrector->asked), double(corrector->changed)};
  const auto append = [&](const Numbers& more) {
    out.insert(out.end(), more.begin(), more.end());
  };
  append(cut(corrector->seen, 4 * asked_at_most));
  append(cut(corrector->rates, 3 * asked_at_most));
  append({double(start.size())});
  append(start.size() > 1 ? flat(std::vector<vec3>{start[1].x, start[1].v}) : Numbers(6, 0));
  Numbers at_end;
  for (int k = 0; k < 4; ++k) append_body(at_end, bodies.at(k));
  append(ends_well ? at_end : Numbers(at_end.size(), 0));
  return padded(out, numbers_of_newton);
}

inline std::vector<std::string> newton_names(const NewtonCase&) {
  std::vector<std::string> out{"result (0 false, 1 true)", "calls of errors()",
                               "calls of change_rates()"};
  const auto call = [](std::size_t n) { return " " + std::to_string(n + 1); };
  for (std::size_t n = 0; n < asked_at_most; ++n)
    for (const char* what : {"x.x", "x.y", "q.w", "q.z"})
      out.push_back(std::string(what) + " at errors()" + call(n));
  for (std::size_t n = 0; n < asked_at_most; ++n)
    for (int i = 0; i < 3; ++i)
      out.push_back("rates[" + std::to_string(i) + "] at change_rates()" + call(n));
  out.push_back("bodies in start");
  for (const char* what : {"x.x", "x.y", "x.z", "v.x", "v.y", "v.z"})
    out.push_back(std::string("start[1].") + what);
  for (int k = 0; k < 4; ++k)
    for (const char* what : {"x.x", "x.y", "x.z", "v.x", "v.y", "v.z", "w.x", "w.y", "w.z", "q.w",
                             "q.x", "q.y", "q.z"})
      out.push_back(std::string(what) + " of body " + std::to_string(k) + " at the end");
  return out;
}

/// Eq. 9-10.
inline bool right_move(Bodies& bodies, double h, int iterations, double tolerance,
                       Corrector& corrector, std::vector<Body>& start) {
  for (double most = std::numeric_limits<double>::infinity();; --iterations) {
    start = {bodies.data(), bodies.data() + bodies.slots()};
    integrate_poses(bodies, real(h));
    std::vector<double> rates = corrector.errors();
    double size = 0;
    for (double& rate : rates) {
      if (std::abs(rate) > size) size = std::abs(rate);
      rate = -rate / h;
    }
    if (size <= tolerance || iterations == 0 || size > most) return size <= tolerance;
    most = poor_contraction * size;
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot) = start[std::size_t(slot)];
    corrector.change_rates(rates);
  }
}

inline constexpr Subject newton_subject{"9.6", "Newton's method on the positions"};
inline CaseTable<NewtonCase> newton_table() {
  auto table = padded_table<NewtonCase>(newton_subject, numbers_of_newton, newton_names);
  table.tolerance = 10 * rounding;
  table.cases = newton_cases();
  // the bodies at the end matter where the right answer ends well
  const auto numbers = [](auto move, const NewtonCase& c) {
    Bodies bodies = newton_bodies(c);
    std::vector<Body> start;
    const bool ends_well =
        right_move(bodies, c.h, c.iterations, c.tolerance, *c.corrector(bodies), start);
    return newton_numbers(c, ends_well, move);
  };
  judge(table, move_onto_constraints, numbers);
  table.right = [=](const NewtonCase& c) { return numbers(right_move, c); };
  tell_where_it_holds(table);
  return table;
}

/// For a test of another kind: the table's mistakes explain whatever is wrong.
inline void expect_newton(const std::string& entry, double yours, double right, double tolerance,
                          const std::string& words = "") {
  const bool same = std::abs(yours - right) <= tolerance;
  const std::string given = words.empty() ? "" : "Case: " + words + ".";
  Subject about = newton_subject;
  about.given = given.c_str();
  expect(about, entry, yours, right, tolerance,
         same ? std::vector<Suspect>{} : newton_table().explain(yours));
}

}  // namespace joints::testing
