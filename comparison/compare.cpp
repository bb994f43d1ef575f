// The list of methods, the runs and the recommendation.
#include "comparison/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

#include "comparison/track.h"
#include "direct/direct_solver.h"
#include "engine/instruments/measure.h"
#include "engine/simd/packed.h"
#include "reduced/reduced.h"

namespace joints {

namespace {

// Returns what the solver says of the step.
using Stepper = std::function<std::vector<std::string>(World&, real)>;
constexpr double none = std::numeric_limits<double>::infinity();

// ---- the methods --------------------------------------------------------------------------------

struct Method {
  const char* name;
  const char* code;
  Stepper (*make)(World& world);
};

template <class S>
Stepper by(const S& settings, const StepOptions& how) {
  const auto solver = std::make_shared<S>(settings);
  return [=](World& world, real h) {
    step(world, *solver, h, how);
    if constexpr (requires { solver->report().sentences(); }) return solver->report().sentences();
    else return std::vector<std::string>{};
  };
}
Stepper by(const std::shared_ptr<Reduced>& tree) {
  return [=](World& world, real h) {
    tree->step(world, h);
    return tree->report().sentences();
  };
}

// What is recommended is what has run: the code is the text of the settings. A method that refuses
// the scene says why.
#define TEXT(...) #__VA_ARGS__
#define PLAIN(...) __VA_ARGS__
#define SOLVED(name, Solver, how, ...)                                                 \
  {name, #Solver " solver;" __VA_OPT__(" " #__VA_ARGS__ ";")                           \
   "\nstep(world, solver, h, " TEXT how ");", []([[maybe_unused]] World& world) {      \
     Solver solver;                                                                    \
     __VA_ARGS__;                                                                      \
     return by(solver, PLAIN how);                                                     \
   }}
#define REDUCED(name, ...)                                                             \
  {name, "Reduced tree(world);" __VA_OPT__(" " #__VA_ARGS__ ";")                       \
   "\ntree.step(world, h);", [](World& world) {                                        \
     const auto made = std::make_shared<Reduced>(world);                               \
     [[maybe_unused]] Reduced& tree = *made;                                           \
     __VA_ARGS__;                                                                      \
     return by(made);                                                                  \
   }}

// From few lines of settings to many.
const Method methods[] = {
    SOLVED("10 iterations, warm", PackedImpulses, ({.warm_start = true}),
           solver.iterations = 10; world.set_beta(0.1)),
    SOLVED("30 iterations", PackedImpulses, ({}), solver.iterations = 30),
    SOLVED("4 substeps of 8", PackedImpulses, ({.substeps = 4}),
           solver.iterations = 8; world.set_beta(1)),
    SOLVED("16 substeps of 2", PackedImpulses, ({.substeps = 16}),
           solver.iterations = 2; world.set_beta(1)),
    SOLVED("direct, velocities only", DirectSolver, ({.leapfrog = true}),
           solver = DirectSolver::velocities_only(); world.set_beta(1)),
    SOLVED("direct, no added inertia", DirectSolver, ({.leapfrog = true}),
           solver.added_inertia = 0),
    SOLVED("the default", DirectSolver, ({.leapfrog = true})),
    SOLVED("the default, 4 substeps", DirectSolver, ({.substeps = 4, .leapfrog = true})),
    SOLVED("direct, 4 substeps, warm", DirectSolver, ({.warm_start = true, .substeps = 4}),
           solver.added_inertia = 0),
    REDUCED("reduced coordinates"),
    REDUCED("reduced, Runge-Kutta", tree.method = Reduced::Method::runge_kutta),
};
#undef TEXT
#undef PLAIN
#undef SOLVED
#undef REDUCED
constexpr int reference_method = 5;

// ---- a run --------------------------------------------------------------------------------------

double now_us() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * double(time.tv_sec) + 1e-3 * double(time.tv_nsec);
}

// Measures the joints of a run on a second world, so that measuring changes nothing.
class Gauge {
 public:
  explicit Gauge(World world) : world_(std::move(world)) {}
  void look(const World& run, real h, MethodResult& out) {
    for (int slot = 0; slot < run.bodies.slots() && slot < world_.bodies.slots(); ++slot)
      if (run.bodies.used(slot)) world_.bodies.at(slot) = run.bodies.at(slot);
    blocks_.clear();
    for (const auto& joint : world_.joints()) {
      joint->begin_step(world_.bodies, h);
      if (joint->can_move() && !joint->transient()) joint->append(world_.bodies, blocks_);
    }
    for (const Block& block : blocks_.list) {
      const bool one_sided = block.settings.one_sided();  // a soft one has a depth, too
      if (!block.settings.holds_position || (block.settings.frequency > 0 && !one_sided)) continue;
      for (int row = block.first; row < block.first + block.rows; ++row) {
        const Row& J = blocks_.J[std::size_t(row)];
        const double C = double(blocks_.C[std::size_t(row)]);
        const bool turns = J.v1 == vec3(0) && J.v2 == vec3(0);
        double& most = one_sided ? out.depth : turns ? out.angle : out.gap;
        most = std::max(most, one_sided ? -C : std::abs(C));
      }
    }
  }

 private:
  World world_;
  Blocks blocks_;
};

int steps_of(const Wish& wish) {
  return std::max(1, int(std::lround(wish.seconds / double(wish.h))));
}
bool holds(const Wish& wish, const MethodResult& run) {
  return run.failed.empty() && run.gap <= wish.gap && run.angle <= wish.angle &&
         run.depth <= wish.depth;
}

// Runs a method with `parts` steps in each step of the wish. What stops it is in `out.failed`.
// `only_while_it_holds` ends it where it leaves the wish or patience does, and keeps no frames.
Track run(const std::function<World()>& make_world, const Wish& wish, const Method& method,
          int parts, MethodResult& out, bool only_while_it_holds = false) {
  Track track;
  const int steps = steps_of(wish);
  try {
    World world = make_world();
    Gauge gauge(make_world());
    const Stepper advance = method.make(world);
    const auto energy_now = [&] { return energy(all_of(world.bodies), world.gravity); };
    const double energy_before = energy_now();
    std::vector<double> times;
    track.frames.push_back(centres_of(world));
    for (int n = 0; n < steps; ++n) {
      double us = 0;
      for (int part = 0; part < parts; ++part) {
        if (wish.control) wish.control(world, (n + double(part) / parts) * double(wish.h));
        const double start = now_us();
        const std::vector<std::string> said = advance(world, wish.h / real(parts));
        us += now_us() - start;
        if (!said.empty() && out.steps_said++ == 0) out.said = said.front();
      }
      times.push_back(us);
      track.us += us;
      gauge.look(world, wish.h, out);
      out.seconds = (n + 1) * double(wish.h);
      if (!only_while_it_holds) track.frames.push_back(centres_of(world));
      else if (!holds(wish, out) || 1e-6 * track.us > wish.patience) return track;
    }
    std::sort(times.begin(), times.end());
    const auto quantile = [&](double share) { return times[std::size_t(share * (steps - 1))]; };
    out.us = quantile(0.5);
    out.spread = (quantile(0.75) - quantile(0.25)) / std::max(out.us, 1e-9);
    out.energy = energy_now() - energy_before;
  } catch (const std::exception& error) {
    out.failed = error.what();
  }
  return track;
}

std::string shown(double number) {
  char words[32];
  std::snprintf(words, sizeof words, number < none ? "%.2g" : "-", number);
  return words;
}

}  // namespace

// ---- all methods --------------------------------------------------------------------------------

Comparison compare(const std::function<World()>& make_world, const Wish& wish) {
  require(wish.seconds > 0 && wish.seconds < none, "seconds", real(wish.seconds),
          "must be positive and finite [s]");
  require(wish.h > 0 && wish.h < unbounded, "h", wish.h, "must be positive and finite [s]");
  Comparison out;
  out.wish = wish;
  const Reference reference = refine(
      [&](int n) -> std::optional<Track> {
        MethodResult unused;
        Track track;
        if (n < 5) track = run(make_world, wish, methods[reference_method], 4 << n, unused);
        return n < 5 && unused.failed.empty() ? std::optional(track) : std::nullopt;
      },
      std::size_t(steps_of(wish)) + 1, wish.gap / 3, wish.patience / 3);
  if (reference.frames > 0) out.reference_until = double(reference.frames - 1) * double(wish.h);
  out.reference_apart = apart(reference.before, reference.track, reference.frames);

  for (const Method& method : methods) {
    MethodResult result;
    result.name = method.name, result.code = method.code;
    const Track track = run(make_world, wish, method, 1, result);
    result.distance = apart(track, reference.track, reference.frames);
    result.meets = holds(wish, result) && result.distance <= wish.distance &&
                   result.us <= wish.budget;
    out.methods.push_back(result);
  }
  // The fastest one that still meets the wish in a longer run.
  Wish longer = wish;
  longer.seconds *= wish.times;
  for (;;) {
    out.recommended = -1;
    for (int k = 0; k < int(out.methods.size()); ++k)
      if (out.methods[std::size_t(k)].meets &&
          (out.recommended < 0 || out.methods[std::size_t(k)].us <
                                      out.methods[std::size_t(out.recommended)].us))
        out.recommended = k;
    if (out.recommended < 0 || wish.times <= 1) return out;
    MethodResult& best = out.methods[std::size_t(out.recommended)];
    MethodResult again;
    run(make_world, longer, methods[out.recommended], 1, again, true);
    best.seconds = again.seconds;
    best.meets = holds(wish, again);
    if (!again.failed.empty()) ++best.steps_said, best.said = again.failed;
    if (best.meets) return out;
  }
}

std::string Comparison::table() const {
  std::string out;
  char line[200];
  std::snprintf(line, sizeof line, "%-26s%9s%8s%9s%9s%9s%10s%10s\n", "", "us a step", "spread",
                "gap m", "angle", "depth", "from ref.", "energy J");
  out += line;
  for (const MethodResult& m : methods) {
    const std::string until = m.seconds > wish.seconds + double(wish.h) / 2
                                  ? "  until " + shown(m.seconds) + " s" : "  no";
    if (m.failed.empty())
      std::snprintf(line, sizeof line, "%-26s%9.3g%7.0f%%%9.1e%9.1e%9.1e%10.1e%+10.1e%s\n",
                    m.name.c_str(), m.us, 100 * m.spread, m.gap, m.angle, m.depth, m.distance,
                    m.energy, m.meets ? "" : until.c_str());
    else
      std::snprintf(line, sizeof line, "%-26s  %.160s\n", m.name.c_str(), m.failed.c_str());
    out += line;
  }
  for (const MethodResult& m : methods)
    if (m.steps_said > 0)
      out += "Said by " + m.name + " in " + std::to_string(m.steps_said) + " steps: " + m.said +
             "\n";
  if (reference_until > 0)
    out += "The reference: two refinements agree for " + shown(reference_until) + " s, to " +
           shown(reference_apart) + " m.\n";
  else
    out += "There is no reference: refinements of the step do not agree.\n";
  const std::string wanted = "(gap " + shown(wish.gap) + " m, angle " + shown(wish.angle) +
                             ", depth " + shown(wish.depth) + ")";
  if (recommended >= 0) {
    const MethodResult& best = methods[std::size_t(recommended)];
    return out + "The fastest that meets the wish " + wanted + " for " + shown(best.seconds) +
           " s: " + best.name + ".\n\n" + best.code + "\n";
  }
  const auto nearest = std::min_element(
      methods.begin(), methods.end(), [](const MethodResult& a, const MethodResult& b) {
        return (a.failed.empty() ? a.gap : none) < (b.failed.empty() ? b.gap : none);
      });
  return out + "None meets the wish " + wanted + ". The smallest gap has: " + nearest->name +
         ". Try a shorter step.\n";
}

void Comparison::write_csv(const std::string& path) const {
  std::ofstream file(path);
  require(bool(file), ("cannot write " + path).c_str());
  file << "method,us_per_step,spread,gap_m,angle_rad,depth,distance_m,energy_j,meets,recommended,"
          "wish_gap_m,reference_s,reference_m,failed\n";
  for (const MethodResult& m : methods)
    file << '"' << m.name << "\"," << m.us << ',' << m.spread << ',' << m.gap << ',' << m.angle
         << ',' << m.depth << ',' << m.distance << ',' << m.energy << ',' << m.meets << ','
         << (recommended >= 0 && &m == &methods[std::size_t(recommended)]) << ',' << wish.gap << ','
         << reference_until << ',' << reference_apart << ",\"" << m.failed << "\"\n";
}

int compare_main(const std::function<World()>& make_world, int argc, const char* const* argv) {
  try {
    Wish wish;
    std::string csv;
    for (int k = 1; k < argc; ++k) {
      const std::string name = argv[k];
      require(k + 1 < argc, (name + ": a value is missing").c_str());
      const std::string text = argv[++k];
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      require(name == "--csv" || (end != text.c_str() && !*end),
              (name + ": " + text + " is no number").c_str());
      if (name == "--seconds") wish.seconds = value;
      else if (name == "--hz") wish.h = real(1 / value);
      else if (name == "--gap") wish.gap = value;
      else if (name == "--depth") wish.depth = value;
      else if (name == "--budget") wish.budget = value;
      else if (name == "--csv") csv = text;
      else refuse(name + ": there are --seconds, --hz, --gap, --depth, --budget and --csv");
    }
    const Comparison found = compare(make_world, wish);
    std::fputs(found.table().c_str(), stdout);
    if (!csv.empty()) found.write_csv(csv);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}

}  // namespace joints
