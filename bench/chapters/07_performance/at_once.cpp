// Joints that are all solved from the same velocities: the chain, with e computed once per step or
// once per iteration, and balls around a hub.
#include <cmath>
#include <random>

#include "bench/chapters/07_performance/experiments.h"

namespace joints::chapter7 {

namespace {

using Records = std::vector<Velocities<real>>;

Records records_of(const std::vector<Body>& bodies) {
  Records records;
  for (const Body& body : bodies)
    records.push_back({triple(body.v), body.inverse_mass, triple(body.w), 0});
  return records;
}

// Solves every hinge from the velocities `seen`, and adds this fraction of the changes to `now`.
void answer(const HingeLoop<real>& loop, const Records& seen, real fraction, Records& now) {
  for (std::size_t k = 0; k < loop.links.size(); ++k) {
    const auto [index1, index2] = loop.links[k];
    Velocities<real> body1 = seen[index1], body2 = seen[index2];
    solve(loop.numbers()[k], body1, body2);
    now[index1].v += fraction * (body1.v - seen[index1].v);
    now[index1].w += fraction * (body1.w - seen[index1].w);
    now[index2].v += fraction * (body2.v - seen[index2].v);
    now[index2].w += fraction * (body2.w - seen[index2].w);
  }
}

void give_back(const Records& records, std::vector<Body>& bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    bodies[k].v = vec3(records[k].v.x, records[k].v.y, records[k].v.z);
    bodies[k].w = vec3(records[k].w.x, records[k].w.y, records[k].w.z);
  }
}

void step_at_once(HingeLoop<real>& loop, bool once_a_step, int iterations, real fraction) {
  for (Body& body : loop.bodies) integrate_forces(body, loop.gravity, h);
  loop.prepare(h);
  Records now = records_of(loop.bodies), seen = now;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    if (!once_a_step) seen = now;
    answer(loop, seen, fraction, now);
  }
  give_back(now, loop.bodies);
  for (Body& body : loop.bodies)
    if (!body.is_static()) integrate_pose(body, h);
}

struct Try {
  std::string found;  // when e is computed
  int cubes, iterations;
  double fraction;  // of each change that is applied
};

void chains_at_once(const Choice& choice) {
  CsvFile table(choice.out + "/at_once.csv",
                {"found", "cubes", "iterations", "fraction", "gap_rms_m", "step_of_1_km"});
  const int k = choice.iterations;
  for (const Try& one : {Try{"once a step", 2, k, 1}, {"once a step", 100, k, 1},
                         {"once an iteration", 100, 2 * k, 1},
                         {"once an iteration", 100, 2 * k + 1, 1},
                         {"once an iteration", 100, 2 * k + 1, 0.9}}) {
    const Chains chains = cube_chains(1, one.cubes, choice.beta);
    HingeLoop<real> loop = loop_over<real>(chains, chain_order(chains), 0);
    Experiment experiment = experiment_of(loop, chains, steps_in(choice.seconds, h));
    experiment.step = [&] {
      step_at_once(loop, one.found == "once a step", one.iterations, real(one.fraction));
    };
    int far = 0;  // the first step after which a gap is 1 km; 0: none
    const Measures found = run(experiment, [&](int n) {
      for (std::size_t i = 0; i < loop.links.size() && far == 0; ++i)
        if (!(loop.gap(i) < 1000)) far = n;
    });
    table.row({one.found}, {double(one.cubes), double(one.iterations), one.fraction, found.gap_rms,
                            double(far)});
  }
}

// Numbers between -0.5 and 0.5, the same on every machine.
std::vector<double> anyhow(std::size_t count) {
  std::mt19937 random(7);
  std::vector<double> numbers(count);
  for (double& one : numbers) one = double(random()) / 4294967296.0 - 0.5;
  return numbers;
}

template <class Numbers>
double size_of(const Numbers& numbers) {
  double sum = 0;
  for (const auto one : numbers) sum += double(one) * double(one);
  return std::sqrt(sum);
}

// Twelve balls of mass 1 around a hub, one row each, all in one direction; e of a row is the
// velocity of its ball minus that of the hub. \param part of the hub's mass in each row
// \return the factor of e per iteration, the mean of 1000 after 200
double hub_left(double mass, double part, bool all_at_once) {
  const std::size_t balls = 12;
  const double K = 1 + 1 / (part * mass);
  std::vector<double> e = anyhow(balls);
  double sum = 0;
  const int first = 200, last = 1200;
  for (int iteration = 0; iteration < last; ++iteration) {
    const std::vector<double> seen = e;
    for (std::size_t j = 0; j < balls; ++j) {
      const double lambda = -(all_at_once ? seen : e)[j] / K;
      for (std::size_t i = 0; i < balls; ++i) e[i] += lambda * ((i == j ? 1 : 0) + 1 / mass);
    }
    const double left = size_of(e);
    for (double& one : e) one /= left;
    if (iteration >= first) sum += std::log(left);
  }
  return std::exp(sum / (last - first));
}

// The level chain from random velocities, without gravity. In the long run every iteration
// multiplies the change of e by the same factor. \return the magnitude of this factor
double chain_left(const Choice& choice) {
  const Chains chains = cube_chains(1, 100, choice.beta);
  HingeLoop<real> loop = loop_over<real>(chains, chain_order(chains), 0);
  loop.prepare(h);
  const std::vector<double> start = anyhow(6 * loop.bodies.size());
  for (std::size_t k = 1; k < loop.bodies.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      loop.bodies[k].v[int(i)] = real(start[6 * k + i]);
      loop.bodies[k].w[int(i)] = real(start[6 * k + 3 + i]);
    }
  Records now = records_of(loop.bodies);
  std::vector<real> e = loop.errors(), change = e;
  double before = 0;
  for (int iteration = 0; iteration < 400; ++iteration) {
    const Records seen = now;
    answer(loop, seen, 1, now);
    give_back(now, loop.bodies);
    before = size_of(change);
    const std::vector<real> next = loop.errors();
    for (std::size_t i = 0; i < e.size(); ++i) change[i] = next[i] - e[i];
    e = next;
  }
  return size_of(change) / before;
}

void what_is_left(const Choice& choice) {
  CsvFile table(choice.out + "/left.csv", {"scene", "order", "hub_mass", "left"});
  for (const double mass : {1.0, 12.0, 100.0}) {
    table.row({"hub", "one after the other"}, {mass, hub_left(mass, 1, false)});
    table.row({"hub", "all at once"}, {mass, hub_left(mass, 1, true)});
    table.row({"hub", "hub split"}, {mass, hub_left(mass, 1.0 / 12, true)});
  }
  table.row({"chain", "all at once"}, {0, chain_left(choice)});
}

}  // namespace

void at_once(const Choice& choice) {
  chains_at_once(choice);
  what_is_left(choice);
}

}  // namespace joints::chapter7
