// The table of the settings, and how one becomes a step.
#include "bench/settings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bench/next_door/conjugate_gradients.h"
#include "bench/next_door/nonsmooth.h"
#include "bench/next_door/xpbd.h"
#include "bench/textbook.h"
#include "reduced/reduced.h"

namespace joints::bench {

namespace {

// ---- the table ----------------------------------------------------------------------------------

// Keys of scenes: S1x is S1 with twice the chains, S2 stands for all its ratios. The effect of an
// iteration does not depend on the loop: for scenes with islands the settings are tried on lanes.
const char* const alone = "S2 S3 S3b S5 S6";  // one chain: no two islands
const char* const islands = "S1 S7";            // ten of them side by side
const char* const all = "S1 S1b S1x S2 S3 S3b S5 S6 S7";

}  // namespace

std::vector<Way> ways() {
  const Packing colours = Packing::colours, list = Packing::list;
  return {
      {.name = "cold", .scenes = "S1 S1b S1x S2 S3 S3b S5 S6", .quick = true},
      {.name = "cold", .scenes = "S7", .most = 60},
      {.name = "warm", .scenes = "S2 S3 S3b S5 S6", .warm = true, .quick = true},
      {.name = "rows one by one", .scenes = "S1 S2 S3 S3b S5 S6", .row_by_row = true, .most = 30},
      {.name = "two blocks a hinge", .scenes = "S1 S3 S5 S6 S7", .whole = false, .most = 30},
      {.name = "backward", .scenes = "S1", .order = Order::backward, .most = 30},
      {.name = "alternating", .scenes = "S1", .order = Order::alternating, .most = 30},
      {.name = "shuffled", .scenes = "S1", .order = Order::shuffled, .most = 30},
      {.name = "projection 1", .scenes = alone, .projections = 1},
      {.name = "beta 1", .scenes = alone, .beta = 1},
      {.name = "4 substeps", .scenes = alone, .substeps = 4},
      {.name = "half a kick", .scenes = "S2 S5", .leapfrog = true},

      {.name = "list", .scenes = "S1", .loop = Loop::packed, .packing = list, .most = 30},
      {.name = "list", .scenes = "S2 S3 S3b S5 S6", .loop = Loop::packed, .packing = list},
      {.name = "islands", .scenes = "S1 S1x", .loop = Loop::packed},
      {.name = "omega 1.5", .scenes = alone, .loop = Loop::packed, .relaxation = real(1.5)},
      {.name = "omega 1.9", .scenes = alone, .loop = Loop::packed, .relaxation = real(1.9),
       .quick = true},
      {.name = "omega 1.9 beta 1", .scenes = alone, .loop = Loop::packed, .beta = 1,
       .relaxation = real(1.9)},
      {.name = "omega 1.5 beta 1", .scenes = alone, .loop = Loop::packed, .beta = 1,
       .relaxation = real(1.5)},
      {.name = "omega 1.5 half a kick", .scenes = "S2 S5", .loop = Loop::packed,
       .relaxation = real(1.5), .leapfrog = true, .quick = true},
      {.name = "omega 1.5 4 substeps half a kick", .scenes = "S2 S5", .loop = Loop::packed,
       .relaxation = real(1.5), .substeps = 4, .leapfrog = true},
      {.name = "omega 1.5 4 substeps", .scenes = alone, .loop = Loop::packed,
       .relaxation = real(1.5), .substeps = 4},
      {.name = "16 substeps", .scenes = alone, .loop = Loop::packed, .substeps = 16},

      {.name = "islands", .scenes = "S1 S1x S7", .loop = Loop::lanes, .quick = true},
      {.name = "colours", .scenes = "S1 S1x S2 S3 S3b S7", .loop = Loop::lanes,
       .packing = colours, .quick = true},
      {.name = "islands omega 1.5", .scenes = "S1", .loop = Loop::lanes, .relaxation = real(1.5)},
      {.name = "islands omega 1.9", .scenes = "S1 S1x S7", .loop = Loop::lanes,
       .relaxation = real(1.9), .quick = true},
      {.name = "colours omega 1.9", .scenes = "S1 S3 S7", .loop = Loop::lanes,
       .packing = colours, .relaxation = real(1.9)},
      {.name = "islands beta 1", .scenes = islands, .loop = Loop::lanes, .beta = 1},
      {.name = "islands omega 1.9 beta 1", .scenes = "S1 S1x S7", .loop = Loop::lanes, .beta = 1,
       .relaxation = real(1.9), .quick = true},
      {.name = "islands warm", .scenes = islands, .loop = Loop::lanes, .warm = true},
      {.name = "islands omega 1.5 beta 1", .scenes = "S1", .loop = Loop::lanes, .beta = 1,
       .relaxation = real(1.5)},
      {.name = "islands projection 1", .scenes = islands, .loop = Loop::lanes, .projections = 1},
      {.name = "islands 4 substeps", .scenes = islands, .loop = Loop::lanes, .substeps = 4},
      {.name = "islands omega 1.9 half a kick", .scenes = "S1", .loop = Loop::lanes,
       .relaxation = real(1.9), .leapfrog = true, .quick = true},

      {.name = "hinges alone", .scenes = "S1 S1x", .loop = Loop::hinges},
      {.name = "hinges alone omega 1.9", .scenes = "S1 S1x", .loop = Loop::hinges,
       .relaxation = real(1.9), .quick = true},
      {.name = "hinges alone omega 1.9 beta 1", .scenes = "S1 S1x", .loop = Loop::hinges,
       .beta = 1, .relaxation = real(1.9)},
      {.name = "hinges alone omega 1.9 half a kick", .scenes = "S1", .loop = Loop::hinges,
       .relaxation = real(1.9), .leapfrog = true},

      {.name = "velocities", .scenes = all, .loop = Loop::direct, .beta = 1, .leapfrog = true,
       .quick = true},
      {.name = "SHAKE", .scenes = all, .loop = Loop::direct, .beta = 1, .leapfrog = true,
       .newton = 8, .quick = true},
      {.name = "SHAKE added inertia 8", .scenes = alone, .loop = Loop::direct, .beta = 1,
       .leapfrog = true, .newton = 8, .added_inertia = 8},
      {.name = "Runge-Kutta", .scenes = all, .loop = Loop::runge_kutta, .quick = true},

      {.name = "set up once a step", .scenes = "S1 S1x", .loop = Loop::textbook},
      {.name = "recomputed", .scenes = "S1", .loop = Loop::recomputed, .most = 30},
  };
}

bool Way::means_something_on(const std::string& scene) const {
  return (" " + scenes + " ").find(" " + scene + " ") != std::string::npos;
}

std::string Way::solver() const {
  switch (loop) {
    case Loop::rows: return "sequential impulses";
    case Loop::packed: return "packed";
    case Loop::lanes: return "lanes";
    case Loop::hinges: return "chapter 7";
    case Loop::direct:
    case Loop::runge_kutta: return "direct";
    case Loop::tree:
    case Loop::tree_runge_kutta: return "reduced coordinates";
    case Loop::xpbd: return "XPBD";
    case Loop::gradients: return "conjugate gradients";
    case Loop::nonsmooth: return "NNCG";
    default: return "textbook";
  }
}

bool Way::of_second_order() const {
  return loop == Loop::runge_kutta || loop == Loop::tree || loop == Loop::tree_runge_kutta;
}

int Way::iterations_of(int a_step) const {
  if (loop == Loop::direct || of_second_order()) return 1;
  return std::max(1, (a_step + substeps / 2) / substeps);
}

// ---- a setting becomes a step -------------------------------------------------------------------

namespace {

StepOptions stepping_of(const Way& way) {
  return {.warm_start = way.warm, .substeps = way.substeps, .projections = way.projections,
          .leapfrog = way.leapfrog, .frequency = way.frequency, .row_by_row = way.row_by_row};
}

template <class Kind>
Step step_with(Kind solver, const Way& way, int iterations) {
  solver.iterations = iterations;
  if constexpr (requires { solver.relaxation; }) solver.relaxation = way.relaxation;
  return [solver, how = stepping_of(way)](World& world, real h) mutable {
    joints::step(world, solver, h, how);
  };
}

Step of_the_engine(const Way& way, int iterations) {
  if (way.loop == Loop::rows) {
    OrderedImpulses solver;
    solver.order = way.order;
    solver.relax_iterations = way.relax;
    solver.split_iterations = way.split;
    return step_with(solver, way, iterations);
  }
  PackedImpulses solver;
  const bool islands = way.packing == Packing::automatic;
  solver.packing = islands && way.loop == Loop::packed ? Packing::interleaved : way.packing;
  return step_with(solver, way, iterations);
}

std::vector<TextbookHinge> textbook_hinges(World& world) {
  std::vector<TextbookHinge> hinges;
  for (const auto& joint : world.joints()) {
    Body &a = world.bodies[joint->body1], &b = world.bodies[joint->body2];
    hinges.emplace_back(a, b, a.x, vec3(1, 0, 0), joint->beta);
  }
  return hinges;
}

Step of_the_textbook(const Way& way, int iterations) {
  const auto solver = std::make_shared<TextbookSolver>();
  solver->iterations = iterations;
  solver->recompute = way.loop == Loop::recomputed;
  return [solver](World& world, real h) {
    if (solver->joints.empty())
      for (const TextbookHinge& hinge : textbook_hinges(world))
        solver->joints.push_back(std::make_unique<TextbookHinge>(hinge));
    solver->step(world, h);
  };
}

Step of_the_flat_textbook(int iterations) {
  const auto solver = std::make_shared<FlatSolver>();
  solver->iterations = iterations;
  return [solver](World& world, real h) {
    if (solver->hinges.empty()) solver->hinges = textbook_hinges(world);
    solver->step(world, h);
  };
}

// Chapter 7's loop has bodies of its own: `loop` keeps them, for those who want to see them.
Step of_chapter_7(const Way& way, int iterations, std::shared_ptr<std::unique_ptr<OwnLoop>> loop) {
  loop->reset();
  return [=](World& world, real h) {
    if (!*loop) {
      if (way.leapfrog) integrate_forces(world.bodies, world.gravity, -h / 2);
      *loop = own_loop(world, iterations, way.visits, way.relaxation);
    }
    (*loop)->step(h);
  };
}

Step of_the_direct_solver(const Way& way) {
  DirectSolver solver = DirectSolver::velocities_only();
  solver.newton = way.newton;
  solver.added_inertia = way.added_inertia;
  return [solver, how = stepping_of(way)](World& world, real h) mutable {
    joints::step(world, solver, h, how);
  };
}

Step of_the_tree(const Way& way) {
  return [way, tree = std::shared_ptr<Reduced>()](World& world, real h) mutable {
    if (!tree) {
      tree = std::make_shared<Reduced>(world);
      if (way.loop == Loop::tree_runge_kutta) tree->method = Reduced::Method::runge_kutta;
    }
    for (int n = 0; n < way.substeps; ++n) tree->step(world, h / real(way.substeps));
  };
}

Step step_of(const Way& way, int iterations) {
  switch (way.loop) {
    case Loop::tree:
    case Loop::tree_runge_kutta: return of_the_tree(way);
    case Loop::direct: return of_the_direct_solver(way);
    case Loop::runge_kutta:
      return [method = RungeKutta()](World& world, real h) mutable { method.step(world, h); };
    case Loop::textbook:
    case Loop::recomputed: return of_the_textbook(way, iterations);
    case Loop::flat: return of_the_flat_textbook(iterations);
    case Loop::xpbd: return step_with(Xpbd(), way, iterations);
    case Loop::nonsmooth: return step_with(NonsmoothGradients(), way, iterations);
    case Loop::gradients: {
      ConjugateGradients solver;
      solver.tolerance = way.tolerance;
      return step_with(solver, way, iterations);
    }
    default: return of_the_engine(way, iterations);
  }
}

}  // namespace

Setting Way::setting(int iterations_a_step) const {
  Setting setting{solver(), name, iterations_of(iterations_a_step), warm, {}, {}, {},
                  leapfrog && substeps == 1, leapfrog && substeps > 1};
  if (!leapfrog && !of_second_order()) setting.lag = 0.5 / substeps;
  const auto loop = std::make_shared<std::unique_ptr<OwnLoop>>();
  setting.make = [way = *this, iterations = setting.iterations, loop] {
    return way.loop == Loop::hinges ? of_chapter_7(way, iterations, loop)
                                    : step_of(way, iterations);
  };
  setting.show = [loop](World& world) {
    if (*loop) (*loop)->show(world);
  };
  setting.prepare = [beta = beta, whole = whole](World& world) {
    for (const auto& joint : world.joints()) {
      joint->beta = beta;
      if (auto* hinge = dynamic_cast<HingeJoint*>(joint.get())) hinge->whole = whole;
    }
  };
  return setting;
}

// ---- the front ----------------------------------------------------------------------------------

std::vector<int> pareto_front(const std::vector<Cost>& costs) {
  std::vector<int> order, front;
  for (int k = 0; k < int(costs.size()); ++k)
    if (std::isfinite(costs[k].time) && std::isfinite(costs[k].error)) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return costs[a].time != costs[b].time ? costs[a].time < costs[b].time
                                          : costs[a].error < costs[b].error;
  });
  for (const int k : order)
    if (front.empty() || costs[k].error < 0.999 * costs[front.back()].error) front.push_back(k);
  return front;
}

}  // namespace joints::bench
