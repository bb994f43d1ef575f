// What the thesis says about the inner loop: the cost of its frame rates in time, and which numbers
// may be computed before the iterations.
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Tables 5.1 and 5.2 as printed: frames a second with so many loops, 0: the engine paused.
struct Table {
  int chains;
  std::vector<std::pair<int, double>> lines;
  double paused() const { return lines[0].second; }
};
const Table printed[] = {
    {10, {{0, 570}, {10, 550}, {30, 520}, {60, 480}, {90, 440}, {120, 410}, {200, 310}}},
    {20, {{0, 490}, {10, 450}, {30, 380}, {60, 320}, {90, 170}, {120, 60}}}};

constexpr double ticks = 60;  // steps a second
// What a step takes [s] where the frames fell from f0 to f a second.
double step_time(double f0, double f) { return (1 - f / f0) / ticks; }

// A program that draws, 1/f0 s a frame, and steps 60 times a second: its frames a second.
double frames_a_second(double f0, double step) {
  double clock = 0, next_tick = 0;
  long frames = 0;
  while (clock < 100) {
    for (; next_tick <= clock; next_tick += 1 / ticks) clock += step;
    clock += 1 / f0;
    ++frames;
  }
  return double(frames) / clock;
}

// Time of a joint and loop [ns] by a line of a table.
double per_joint_and_loop(const Table& table, std::size_t line) {
  const auto& [loops, frames] = table.lines[line];
  return 1e9 * step_time(table.paused(), frames) / (99.0 * table.chains * loops);
}

}  // namespace

TEST_CASE("E46 a program that draws and steps loses frames as the time of a step says", "[E46]") {
  for (const Table& table : printed)
    for (const auto& [loops, frames] : table.lines) {
      const double step = step_time(table.paused(), frames);
      CHECK(frames_a_second(table.paused(), step) == Approx(frames).epsilon(1e-3));
    }
}

TEST_CASE("E46 the printed frame rates are 38 to 69 ns for a joint and loop", "[E46]") {
  const auto range = [](const Table& table) {
    double least = 1e9, most = 0;
    for (std::size_t line = 1; line < table.lines.size(); ++line) {
      least = std::min(least, per_joint_and_loop(table, line));
      most = std::max(most, per_joint_and_loop(table, line));
    }
    return std::pair{least, most};
  };
  const auto [least10, most10] = range(printed[0]);
  CHECK(least10 == Approx(38.4).margin(0.05));
  CHECK(most10 == Approx(59.1).margin(0.05));
  const auto [least20, most20] = range(printed[1]);
  CHECK(least20 == Approx(48.7).margin(0.05));
  CHECK(most20 == Approx(68.7).margin(0.05));
  // the 20 frames that ten loops cost: 0.58 ms a step
  CHECK(1e6 * step_time(570, 550) == Approx(584.8).margin(0.05));
}

TEST_CASE("E46 how many frames a step costs depends on how many there were", "[E46]") {
  const double step = step_time(570, 550);
  const auto lost = [&](double f0) { return f0 - frames_a_second(f0, step); };
  CHECK(lost(570) == Approx(20).epsilon(0.02));
  CHECK(lost(490) == Approx(20.0 * 490 / 570).epsilon(0.02));
  CHECK(lost(100) == Approx(20.0 * 100 / 570).epsilon(0.02));
  // 60 loops of 10 chains and 30 of 20 are as many solves; read as frames they lie 22 % apart,
  // read as time 42 %
  const double frames = (490.0 - 380) / (570 - 480);
  const double time = step_time(490, 380) / step_time(570, 480);
  CHECK(frames == Approx(1.22).epsilon(0.005));
  CHECK(time == Approx(1.42).epsilon(0.005));
  CHECK(time / frames == Approx(570.0 / 490).epsilon(1e-12));
}

TEST_CASE("E50 a soft row needs its sum inside the loop: else more iterations make it hard",
          "[E50]") {
  // One soft row between two bodies: J V + beta C/h + gamma lambda = 0, with all but J V and
  // lambda known before the iterations.
  Random random(58);
  for (int draw = 0; draw < 20; ++draw) {
    World world = weightless();
    const Pair pair = uneven_pair();
    const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
    auto& joint = world.add<AnyJoint<1>>(a, b);
    joint.J[0] = random_row(random);
    joint.C[0] = random.uniform(real(0.1), real(0.3));
    joint.target = {.frequency = 4, .damping = real(0.5)};
    const double t = double(h), omega = 8 * std::numbers::pi, a1 = 1 + t * omega;
    const double K = double(dense_K(joint.J, pair.body1, pair.body2)[0][0]);
    const double gamma = K / (t * omega * a1), bias = omega / a1 * double(joint.C[0]);
    const double right = -bias / (K + gamma);  // both bodies at rest

    const auto by_hand = [&](bool inside, int iterations) {
      double rate = 0, sum = 0;
      const double start = sum;  // cold: nothing so far
      for (int k = 0; k < iterations; ++k) {
        const double dlambda = -(rate + bias + gamma * (inside ? sum : start)) / (K + gamma);
        sum += dlambda;
        rate += K * dlambda;
      }
      return sum;
    };
    SequentialImpulses engine;
    step(world, engine, h);  // 30 iterations
    const double near = tolerance(1e-10, 1e-4);
    CHECK(double(joint.impulse[0]) == Approx(right).epsilon(near));
    CHECK(by_hand(true, 30) == Approx(right).epsilon(1e-12));
    CHECK(by_hand(false, 1) == Approx(right).epsilon(1e-12));  // the first iteration is still right
    // then it goes on to the hard row's impulse: what is missing shrinks by gamma/(K + gamma)
    const double hard = -bias / K, left = gamma / (K + gamma);
    for (const int iterations : {2, 30}) {
      const double wrong = by_hand(false, iterations);
      CHECK(wrong == Approx(hard * (1 - std::pow(left, iterations))).epsilon(1e-12));
      CHECK(wrong / right == Approx(iterations == 2 ? 1.63 : 2.68).epsilon(0.003));
    }
    CHECK(hard / right == Approx((K + gamma) / K).epsilon(1e-12));
  }
}

TEST_CASE("E50 a bound needs the sum inside the loop: else every iteration gives the bound again",
          "[E50]") {
  // A motor row that needs far more than its bound: h F once a step.
  const double F = 3, bound = double(h) * F;
  World world = weightless();
  const Pair pair = uneven_pair();
  const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
  auto& motor = world.add<AnyJoint<1>>(a, b);
  motor.J[0] = {vec3(-1, 0, 0), vec3(0), vec3(1, 0, 0), vec3(0)};
  motor.target = {.rate = 1000, .lower = -real(F), .upper = real(F)};
  const double K = double(dense_K(motor.J, pair.body1, pair.body2)[0][0]);
  for (const int iterations : {1, 10, 30}) {
    double rate = 0, sum = 0;
    const double start = sum;
    for (int k = 0; k < iterations; ++k) {
      const double wanted = -(rate - 1000) / K;
      const double dlambda = std::clamp(start + wanted, -bound, bound) - start;
      sum += dlambda;
      rate += K * dlambda;
    }
    CHECK(sum == Approx(iterations * bound).epsilon(1e-12));
    world.bodies[a].v = world.bodies[b].v = vec3(0);
    SequentialImpulses engine;
    engine.iterations = iterations;
    step(world, engine, h);
    CHECK(double(motor.impulse[0]) == Approx(bound).epsilon(tolerance(1e-12, 1e-6)));
  }
}

TEST_CASE("E50 a hard row with Baumgarte needs nothing but what is known before the iterations",
          "[E50]") {
  // Begun with any sum, the iterations find the same velocities: the sum is nowhere read.
  Random random(59);
  World world = weightless();
  const Pair pair = uneven_pair();
  const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
  auto& joint = world.add<AnyJoint<2>>(a, b);
  for (Row& row : joint.J.row) row = random_row(random);
  joint.C = {real(0.1), real(-0.2)};
  joint.target = {.beta = real(0.2)};
  const Bodies start = world.bodies;
  std::vector<Body> first;
  for (const real told : {0, 5, -7}) {
    world.bodies = start;
    SequentialImpulses solver;
    begin_step(world, solver, h);
    joint.impulse = {told, told};
    for (int k = 0; k < 10; ++k) solver.iterate(world.bodies);
    if (told == 0) first = snapshot(world.bodies);
    const std::vector<Body> now = snapshot(world.bodies);
    for (std::size_t k = 0; k < now.size(); ++k)
      CHECK((now[k].v == first[k].v && now[k].w == first[k].w));
    CHECK(double(joint.impulse[0]) != double(told));
  }
}
