// Every kernel of the packed iteration against the engine's scalar solver: rows that hold a point
// and any rows, 1 to 6 of them, hard or not, inertia of one number or of six.
#include <functional>
#include <map>
#include <numeric>

#include "tests/oracle/packings.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

std::string words(const BlockKind& kind) {
  return std::to_string(kind.rows) + " rows" + (kind.point ? " of a point" : "") +
         (kind.hard ? ", hard" : "") + (kind.isotropic ? ", isotropic" : "") +
         (kind.lone ? ", lone" : "");
}
const BlockKind& kind_of(const LaneGroup& group) { return group; }

// All that the switch can tell apart, but those that follow and those that are lone.
std::vector<BlockKind> all_kinds() {
  std::vector<BlockKind> kinds;
  for (const unsigned char rows : {1, 2, 3, 4, 5, 6})
    for (const bool hard : {true, false}) {
      kinds.push_back({rows, false, hard, false});
      for (const bool isotropic : {true, false})
        if (rows >= 3) kinds.push_back({rows, true, hard, isotropic});
    }
  return kinds;
}

// The three ways not to be hard.
std::vector<RowSettings> targets(bool hard) {
  if (hard) return {{.beta = real(0.2)}};
  return {{.frequency = 6, .damping = real(0.3)},
          {.beta = real(0.2), .lower = 0},
          {.frequency = 6, .lower = -40, .upper = 30}};
}

// Random directions at right angles to each other: no row nearly says what the others say.
Dense directions(Random& random, int size) {
  Dense out(size, size);
  for (long i = 0; i < out.size(); ++i) out.data()[i] = double(random.uniform(-1, 1));
  return symmetric_eigenvectors(out + out.transpose());
}
vec3 vector_of(const Dense& Q, long row, long first) {
  return {real(Q(row, first)), real(Q(row, first + 1)), real(Q(row, first + 2))};
}

// A joint of random rows, or of a point's rows and random ones that turn.
template <int N>
void join(World& world, BodyId a, BodyId b, const BlockKind& kind, const RowSettings& target,
          Random& random) {
  auto& joint = world.add<AnyJoint<N>>(a, b);
  const Dense of1 = directions(random, 6), of2 = directions(random, 6);
  for (int i = 0; i < N; ++i)
    joint.J[i] = {vector_of(of1, i, 0), vector_of(of1, i, 3), vector_of(of2, i, 0),
                  vector_of(of2, i, 3)};
  if (kind.point) {
    joint.form = Form::point;
    const Jacobian<3> rows = jacobian_from_blocks(mat3(-1), skew(random.vector(1)), mat3(1),
                                                  -skew(random.vector(1)));
    const Dense axes = directions(random, 3);
    for (int i = 0; i < N; ++i) {
      const vec3 axis = vector_of(axes, i % 3, 0);
      joint.J[i] = i < 3 ? rows[i] : Row{vec3(0), -axis, vec3(0), axis};
    }
  }
  for (real& error : joint.C) error = random.uniform(real(-0.05), real(0.05));
  joint.target = target;
}

void join(World& world, BodyId a, BodyId b, const BlockKind& kind, const RowSettings& target,
          Random& random) {
  switch (kind.rows) {
    case 1: return join<1>(world, a, b, kind, target, random);
    case 2: return join<2>(world, a, b, kind, target, random);
    case 3: return join<3>(world, a, b, kind, target, random);
    case 4: return join<4>(world, a, b, kind, target, random);
    case 5: return join<5>(world, a, b, kind, target, random);
    case 6: return join<6>(world, a, b, kind, target, random);
  }
}

// Eleven chains of three joints of one kind, in any order of the joints.
World chains(const BlockKind& kind, const RowSettings& target, const std::vector<int>& order) {
  World world;
  Random random(91);
  std::vector<BodyId> ids;
  for (int k = 0; k < 44; ++k) {
    const vec3 x(real(k % 4), 0, real(k / 4)), uneven(real(0.8), real(0.4), real(0.3));
    Body body = k % 4 == 0   ? static_body(x)
                : kind.isotropic ? ball(real(1 + k % 3), real(0.4), x)
                             : box(real(1 + k % 3), uneven, x, random.turn());
    ids.push_back(world.add(body));
  }
  for (const int k : order) {
    Random own(unsigned(100 + k));  // the same joint wherever it stands in the list
    const BodyId a = ids[std::size_t(4 * (k / 3) + k % 3)];
    const BodyId b = ids[std::size_t(4 * (k / 3) + k % 3 + 1)];
    join(world, a, b, kind, target, own);
  }
  return world;
}

// Velocities and sums of impulses after two steps, the second one warm. The sums stand in the order
// of the joints' numbers, not of the list.
struct Outcome {
  Column V, lambda;
};
template <class Solver>
Outcome outcome(World world, Solver& solver, const std::vector<int>& order) {
  solver.iterations = 10;
  Random random(92);
  Column V;
  for (int n = 0; n < 2; ++n) {  // each begins with another push
    push_at_random(world.bodies, random, 4);
    begin_step(world, solver, h, {.warm_start = true});
    solver.solve(world.bodies);
    V = velocities(snapshot(world.bodies));
    end_step(world, solver, h);
  }
  Blocks blocks;
  std::vector<std::vector<double>> sums(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    blocks.clear();
    world.joints()[k]->append(world.bodies, blocks);
    const Column lambda = impulses(blocks);
    sums[std::size_t(order[k])].assign(lambda.begin(), lambda.end());
  }
  std::vector<double> flat;
  for (const auto& some : sums) flat.insert(flat.end(), some.begin(), some.end());
  return {V,
          {long(flat.size()), 1, flat}};
}

// The kinds that a world's blocks are of, and how many groups of each.
std::map<BlockKind, int> kinds_of(World& world) {
  PackedImpulses solver;
  solver.packing = Packing::list;
  step(world, solver, h);
  std::map<BlockKind, int> out;
  for (const LaneGroup& group : solver.packed().groups()) ++out[kind_of(group)];
  return out;
}

}  // namespace

TEST_CASE("every kernel of the packed iteration finds what the scalar solver finds") {
  std::vector<int> in_list(33);
  std::iota(in_list.begin(), in_list.end(), 0);
  std::map<BlockKind, std::map<int, int>> met;  // kind -> numbers at a time -> groups
  for (const BlockKind& kind : all_kinds())
    for (const RowSettings& target : targets(kind.hard))
      for (const Packing packing : packings) {
        INFO(words(kind) << ", packing " << int(packing));
        PackedImpulses wide;
        wide.packing = packing;
        const Outcome packed = outcome(chains(kind, target, in_list), wide, in_list);
        // the scalar solver in the order in which the groups stand
        std::vector<int> order;
        for (const int block : wide.packed().order().blocks)
          if (block >= 0) order.push_back(block);
        REQUIRE(order.size() == 33);
        for (const LaneGroup& group : wide.packed().groups()) {
          BlockKind found = kind_of(group);
          found.lone = false;  // the first joint of a chain, if it has one row
          CHECK(found == kind);
          ++met[kind_of(group)][wide.packed().order().width];
        }
        SequentialImpulses one;
        const Outcome scalar = outcome(chains(kind, target, order), one, order);
        const double near = tolerance(1e-12, 1e-4);
        CHECK(scalar.lambda.norm() > 1000 * near);  // there was something to find
        CHECK(difference(packed.V, scalar.V) < near);
        CHECK(difference(packed.lambda, scalar.lambda) < near);
      }
  std::vector<BlockKind> kinds = all_kinds();
  REQUIRE(kinds.size() == 28);  // 12 of any rows, 16 of a point
  for (const bool hard : {true, false}) kinds.push_back({.rows = 1, .hard = hard, .lone = true});
  for (const BlockKind& kind : kinds) {
    INFO(words(kind));
    CHECK(met[kind][1] > 0);
    CHECK(met[kind][lane_count] > 0);
  }
  CHECK(met.size() == kinds.size());
}

TEST_CASE("a body that does not move may be body 1 or body 2, and have a velocity of its own") {
  // As a conveyor has one. Rows of one body, of a point and of any kind, drawn by a seed.
  std::vector<int> order(2 * lane_count + 1);
  std::iota(order.begin(), order.end(), 0);
  for (const BlockKind& kind : all_kinds())
    for (const RowSettings& target : targets(kind.hard))
      for (const bool second : {true, false})
        for (const Packing packing : packings) {
          INFO(words(kind) << ", packing " << int(packing) << ", still body second: " << second);
          const auto world = [&] {
            World out;
            Random random(93);
            for (std::size_t k = 0; k < order.size(); ++k) {
              Body still = static_body(random.vector(1), random.turn());
              still.v = random.vector(1);
              still.w = random.vector(1);
              const BodyId a = out.add(still);
              const BodyId b = out.add(kind.isotropic ? ball(2, real(0.4), random.vector(1))
                                                      : box(2, vec3(1, 2, 3), random.vector(1)));
              join(out, second ? b : a, second ? a : b, kind, target, random);
            }
            return out;
          };
          PackedImpulses wide;
          wide.packing = packing;
          SequentialImpulses one;
          const Outcome packed = outcome(world(), wide, order);
          const Outcome scalar = outcome(world(), one, order);
          const double near = tolerance(1e-12, 1e-4);
          CHECK(scalar.lambda.norm() > 1000 * near);
          CHECK(difference(packed.V, scalar.V) < near);
          CHECK(difference(packed.lambda, scalar.lambda) < near);
        }
}

TEST_CASE("which kernels the joints of the workbook take") {
  struct Line {
    std::string joint;
    std::vector<BlockKind> kinds;
    std::function<void(World&, BodyId, BodyId)> join;
  };
  const vec3 middle(real(0.5), 0, 0), axis(1, 2, 2);
  const auto hinge = [&](World& world, BodyId a, BodyId b) -> HingeJoint& {
    return world.add<HingeJoint>(a, b, middle, axis);
  };
  const auto slider = [&](World& world, BodyId a, BodyId b) -> SliderJoint& {
    return world.add<SliderJoint>(a, b, middle, axis);
  };
  const std::vector<Line> lines = {
      {"rod", {{.rows = 1, .hard = true, .lone = true}},
       [](World& w, BodyId a, BodyId b) { w.add<CentreDistanceJoint>(a, b, CentreDistance{1}); }},
      {"rope", {{.rows = 1, .lone = true}},
       [](World& w, BodyId a, BodyId b) {
         w.add<CentreRopeJoint>(a, b, Rope<CentreDistance>{{1}});
       }},
      {"ball joint", {{3, true, true, true}},
       [&](World& w, BodyId a, BodyId b) {
         w.add<BallJoint>(a, b, point_at(w.bodies[a], w.bodies[b], middle));
       }},
      {"hinge", {{5, true, true, true}},
       [&](World& w, BodyId a, BodyId b) { hinge(w, a, b); }},
      {"hinge in two blocks", {{3, true, true, true}, {2, false, true, false}},
       [&](World& w, BodyId a, BodyId b) { hinge(w, a, b).whole = false; }},
      {"hinge at its limit", {{6, true, false, true}},
       [&](World& w, BodyId a, BodyId b) { hinge(w, a, b).set_limits(0, 1); }},
      {"hinge held", {{6, true, true, true}},
       [&](World& w, BodyId a, BodyId b) { hinge(w, a, b).set_limits(0, 0); }},
      {"driven hinge", {{.rows = 1, .lone = true}, {5, true, true, true}},
       [&](World& w, BodyId a, BodyId b) { hinge(w, a, b).set_motor(1, 1); }},
      {"slider", {{5, false, true, false}},
       [&](World& w, BodyId a, BodyId b) { slider(w, a, b); }},
      {"slider at its limit", {{6, false, false, false}},
       [&](World& w, BodyId a, BodyId b) { slider(w, a, b).set_limits(0, 1); }},
      {"slider in two blocks", {{2, false, true, false}, {3, false, true, false}},
       [&](World& w, BodyId a, BodyId b) { slider(w, a, b).whole = false; }},
      {"weld", {{6, true, true, true}},
       [&](World& w, BodyId a, BodyId b) { w.add<FixedJoint>(a, b, middle); }}};
  for (const Line& line : lines)
    for (const bool isotropic : {true, false}) {
      INFO(line.joint << (isotropic ? ", isotropic bodies" : ""));
      World world = weightless();
      const BodyId a = world.add(static_body(vec3(0)));
      const BodyId b = world.add(isotropic ? box(1, vec3(1), vec3(1, 0, 0))
                                       : box(1, vec3(1, 2, 3), vec3(1, 0, 0)));
      line.join(world, a, b);
      std::map<BlockKind, int> expected;
      for (BlockKind kind : line.kinds) {
        kind.isotropic = kind.point && isotropic;
        ++expected[kind];
      }
      CHECK(kinds_of(world) == expected);
    }
}

TEST_CASE("the kernel for isotropic inertia finds what the one for any inertia finds") {
  const BlockKind isotropic{5, true, true, true}, general{5, true, true, false};
  std::vector<int> order(33);
  std::iota(order.begin(), order.end(), 0);
  for (const Packing packing : packings) {
    World by_one = chains(isotropic, {.beta = real(0.2)}, order);
    World by_six = chains(isotropic, {.beta = real(0.2)}, order);
    for (int slot = 0; slot < by_six.bodies.slots(); ++slot)  // the last digit of one moment
      by_six.bodies.at(slot).inverse_inertia_local.x *= 1 + epsilon;
    CHECK(kinds_of(by_one).begin()->first == isotropic);
    CHECK(kinds_of(by_six).begin()->first == general);
    PackedImpulses first, second;
    first.packing = second.packing = packing;
    const Outcome one = outcome(std::move(by_one), first, order);
    const Outcome six = outcome(std::move(by_six), second, order);
    CHECK(difference(six.V, one.V) < tolerance(1e-12, 1e-4));
    CHECK(difference(six.lambda, one.lambda) < tolerance(1e-12, 1e-4));
  }
}
