// Chains of short links whose joints leave free what a draw says: at a step of 1/60 s they fold.
#include "engine/instruments/measure.h"
#include "joints/driven_joints.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

// Adds a joint whose point is held, and of whose angles a draw locks none to two.
void add_point_joint(World& world, BodyId a, BodyId b, const vec3& anchor, const vec3& axis,
                     const vec3& across, int kind) {
  if (kind == 0) {
    world.add<UniversalJoint>(a, b, anchor, across, cross(axis, across));
  } else if (kind == 1) {
    world.add<ConeTwistJoint>(a, b, anchor, axis, across, real(4)).twist().set_limits(0, 0);
  } else {
    auto& six = world.add<SixDofJoint>(a, b, anchor, axis, across);
    six.slide1().set_limits(0, 0);
    six.slide2().set_limits(0, 0);
    six.slide3().set_limits(0, 0);
    if (kind >= 4) six.twist().set_limits(0, 0);
    if (kind == 3 || kind == 5) six.swing2().set_limits(0, 0);
    if (kind == 6) six.swing3().set_limits(0, 0);
  }
}

struct Chain {
  World world;
  std::vector<Pair> anchors;  // of each joint: its bodies at the beginning
  real link = 0;              // length [m]
};

// 16 links of 2 to 10 cm in a zigzag. \param kind of all joints; negative: each is drawn
Chain drawn_chain(Random& random, int kind) {
  Chain out;
  out.link = random.uniform(real(0.02), real(0.1));
  BodyId last = out.world.add(static_body(vec3(0)));
  vec3 tip(0);
  for (int k = 0; k < 16; ++k) {
    const vec3 d = normalize(random.vector(1)), across = normalize(cross(d, vec3(0, 0, 1)));
    const real mass = std::exp(random.uniform(real(-1.15), real(1.15)));
    Body link = box(mass, out.link * vec3(1, real(0.3), real(0.3)), tip + out.link / 2 * d);
    link.q = normalize(quat(1 + d.x, 0, -d.z, d.y));  // turns the x axis to d
    const BodyId id = out.world.add(link);
    const int drawn = int(random.uniform(0, real(6.999)));
    add_point_joint(out.world, last, id, tip, d, across, kind < 0 ? drawn : kind);
    last = id;
    tip += out.link * d;
  }
  out.world.set_beta(1);
  return out;
}

struct Fold {
  double gap = 0;  // the widest, in lengths of a link
  int halved = 0;
};
Fold folded(Chain&& chain, int steps, DirectSolver solver) {
  std::vector<Point> points;
  const Bodies& bodies = chain.world.bodies;
  for (const auto& joint : chain.world.joints()) {
    const Body &a = bodies[joint->body1], &b = bodies[joint->body2];
    points.push_back(point_at(a, b, b.x - chain.link / 2 * to_world(b, vec3(1, 0, 0))));
  }
  Fold out;
  for (int n = 0; n < steps; ++n) {
    step(chain.world, solver, sixtieth, second_order);
    out.halved += solver.report().halved;
    std::size_t k = 0;
    for (const auto& joint : chain.world.joints()) {
      const vec3 open = points[k++].error(bodies[joint->body1], bodies[joint->body2]);
      out.gap = std::max(out.gap, double(length(open) / chain.link));
    }
  }
  return out;
}

}  // namespace

TEST_CASE("chains of short links fold without opening a joint, or the step says it slowed them") {
  for (const real added : {real(8), real(0)}) {
    Random random(162);
    int held = 0, all = 0;
    double worst = 0;
    for (int kind = -1; kind < 7; ++kind)
      for (int draw = 0; draw < (kind < 0 ? 12 : 4); ++draw) {
        const Fold now = folded(drawn_chain(random, kind), 200, with(8, added));
        CAPTURE(added, kind, draw, now.gap);
        const bool holds = now.gap < tolerance(1e-3, 1e-2);
        CHECK((holds || now.halved > 0));
        ++all, held += holds, worst = std::max(worst, now.gap);
      }
    INFO("added inertia " << added << ": " << held << " of " << all << " held, widest gap "
                          << worst << " links");
    CHECK(held >= all - 2);
  }
}
