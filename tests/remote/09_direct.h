// The functions of chapter 9 whose arguments are more than values, on both sides.
// By hand: add_coupling
// By hand: factor
// By hand: solve
// By hand: move_onto_constraints
// By hand: second_order_step
#pragma once

#include <tuple>

#include "chapters/09_direct/direct.h"
#include "tests/remote/function.h"
#include "tests/remote/world.h"

namespace joints {

inline auto members(JointMatrix& A) {
  return std::tie(A.nodes, A.edges, A.targets, A.numbers, A.original);
}

namespace by_hand {

using namespace joints::testing::remote;
using Coupling = Function<void(const std::vector<HalfRow>&, const std::vector<HalfRow>&,
                               const InverseMass&, std::vector<double>&)>;
using Factor = Function<void(JointMatrix&)>;
using Solution = Function<void(const JointMatrix&, std::vector<double>&)>;
using Moved = Function<bool(std::vector<Body>&, double, int, double, std::vector<Body>&)>;

inline void back(std::vector<double>& all, double* to, std::size_t count) {
  all.resize(count);
  std::copy(all.begin(), all.end(), to);
}

inline void add_coupling(const HalfRow* J, int n, const HalfRow* other, int m,
                         const InverseMass& mass, double* A) {
  std::vector<double> all(A, A + n * m);
  Coupling::call("9.1", "add_coupling", nullptr, {J, J + n}, {other, other + m}, mass, all);
  back(all, A, std::size_t(n * m));
}

inline void factor(JointMatrix& A, PivotInverse inverse) {
  const Asked asked = [&](Bytes& question, Bytes& reply) {
    const auto pivot = got<double>(question);
    put(reply, inverse(pivot, got<double>(question)));
  };
  JointMatrix factored = A;  // of which nothing but the numbers is the answer's
  Factor::call("9.2", "factor", asked, factored);
  back(factored.numbers, A.numbers.data(), A.numbers.size());
}

inline void solve(const JointMatrix& A, double* x) {
  std::vector<double> all(x, x + A.original.size());
  Solution::call("9.2", "solve", nullptr, A, all);
  back(all, x, A.original.size());
}

inline bool move_onto_constraints(Bodies& bodies, double h, int iterations, double tolerance,
                                  Corrector& corrector, std::vector<Body>& start) {
  const Asked asked = [&](Bytes& question, Bytes& reply) {
    set(bodies, got<std::vector<Body>>(question));
    auto rates = got<std::vector<double>>(question);
    if (got<bool>(question)) {
      corrector.change_rates(rates);
    } else {
      rates = corrector.errors();
    }
    put(reply, list(bodies));
    put(reply, rates);
  };
  std::vector<Body> all = list(bodies);
  const bool result =
      Moved::call("9.6", "move_onto_constraints", asked, all, h, iterations, tolerance, start);
  set(bodies, all);
  return result;
}

inline void second_order_step(World& world, Solver& solver, real h) {
  step_elsewhere("9.5", "second_order_step", world, solver, h);
}

/// Asks the tests' own.
class Elsewhere : public Corrector {
 public:
  explicit Elsewhere(Bodies& bodies) : bodies_(bodies) {}
  std::vector<double>& errors() override { return exchanged(C_, false); }
  void change_rates(std::vector<double>& rates) override { exchanged(rates, true); }

 private:
  std::vector<double>& exchanged(std::vector<double>& rates, bool changes) {
    Bytes question;
    put(question, list(bodies_));
    put(question, rates);
    put(question, changes);
    Bytes reply = ask(question);
    set(bodies_, got<std::vector<Body>>(reply));
    get(reply, rates);
    return rates;
  }
  Bodies& bodies_;
  std::vector<double> C_;
};

inline void serve() {
  Coupling::serve("add_coupling", [](const auto& J, const auto& other, const auto& mass, auto& A) {
    joints::add_coupling(J.data(), int(J.size()), other.data(), int(other.size()), mass, A.data());
  });
  Factor::serve("factor", [](JointMatrix& A) {
    joints::factor(A, [](double pivot, double original) {
      Bytes question;
      put(question, pivot);
      put(question, original);
      Bytes reply = ask(question);
      return got<double>(reply);
    });
  });
  Solution::serve("solve", [](const JointMatrix& A, std::vector<double>& x) {
    joints::solve(A, x.data());
  });
  Moved::serve("move_onto_constraints", [](std::vector<Body>& all, double h, int iterations,
                                           double tolerance, std::vector<Body>& start) {
    Bodies bodies;
    for (const Body& one : all) bodies.add(one);
    Elsewhere corrector(bodies);
    const bool result =
        joints::move_onto_constraints(bodies, h, iterations, tolerance, corrector, start);
    all = list(bodies);
    return result;
  });
  serve_step("second_order_step", joints::second_order_step);
}

}  // namespace by_hand
}  // namespace joints
