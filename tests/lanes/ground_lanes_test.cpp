// Contacts and joints on lanes: the same rows, the same numbers, and bounds that follow a sum in
// another group.
#include "tests/ground/rigs.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/packings.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Figures beside each other on one ground: a box each, or a trunk with two limbs on a hinge and a
// ball joint. They fall by 1 to 11 cm, slide and come to rest. \param alike all of them have limbs
World field(int figures, bool limbs, bool alike, real drop = 1) {
  World world;
  const BodyId ground = world.add(static_body(vec3(0)));
  const auto stand = [&](BodyId body) {
    world.add<GroundContact>(ground, body, Top{}, box_outline(brick)).restitution = real(0.3);
  };
  for (int k = 0; k < figures; ++k) {
    const real x = real(5 * k), y = real(0.3) + drop * real(0.01 + 0.05 * (k % 3));
    Body trunk = box(real(5 + k), brick, vec3(x, y, 0), rotation(vec3(0, real(0.1) * real(k), 0)));
    trunk.v = vec3(real(k % 4), 0, 1);
    const BodyId body = world.add(trunk);
    if (limbs && (alike || k % 3 > 0)) {
      const BodyId left = world.add(box(3, brick, vec3(x - real(1.1), y, 0)));
      const BodyId right = world.add(box(2, brick, vec3(x + real(1.1), y, 0)));
      world.add<BallJoint>(body, left, point_at(world.bodies[body], world.bodies[left],
                                                vec3(x - real(0.55), y, 0)));
      world.add<HingeJoint>(body, right, vec3(x + real(0.55), y, 0), vec3(0, 0, 1));
      stand(left);
      stand(right);
    }
    stand(body);
  }
  return world;
}

// A step of the scalar solver whose iterations solve the blocks in the order of the packed ones.
void step_in_order(SequentialImpulses& solver, World& world, const PackedBlocks& packed,
                   const StepOptions& stepping = {}) {
  begin_step(world, solver, h, stepping);
  const std::vector<int>& blocks = packed.order().blocks;
  REQUIRE(std::count_if(blocks.begin(), blocks.end(), [](int k) { return k >= 0; }) ==
          int(world.blocks.list.size()));
  for (int n = 0; n < solver.iterations; ++n)
    for (const int k : blocks)
      if (k >= 0) solver.iterate(world.bodies, k, k + 1);
  Blocks more;  // late limits goes on from here: it must find nothing
  for (const auto& joint : world.joints()) joint->activate_missed_limits(world.bodies, h, more);
  REQUIRE(more.list.empty());
  end_step(world, solver, h, stepping);
}

// Two rows of one joint, a block each; the second is bounded by a multiple of the first's sum.
class Following : public Joint {
 public:
  Row followed, follower;
  bool alive = true;  // has the followed row a block?
  bool twice = false;  // is the following block one of two rows?
  mutable real impulse[3] = {0, 0, 0};

  using Joint::Joint;
  void append(const Bodies& bodies, Blocks& blocks) const override {
    if (alive)
      blocks.append(bodies, body1, body2, to_jacobian(followed), {0}, {.lower = 0}, &impulse[0]);
    const RowSettings target{.holds_position = false, .follows = -1, .upper = real(0.4)};
    if (twice)
      blocks.append(bodies, body1, body2, Jacobian<2>{{follower, follower}}, {0, 0}, target,
                    &impulse[1]);
    else
      blocks.append(bodies, body1, body2, to_jacobian(follower), {0}, target, &impulse[1]);
  }
};

// Many of them between bodies that are thrown at each other.
World followings(Random& random, int count) {
  World world = weightless();
  for (int k = 0; k < count; ++k) {
    const BodyId a = world.add(box(2, brick, vec3(0), random.turn()));
    const BodyId b = world.add(box(random.uniform(1, 3), brick, vec3(0), random.turn()));
    auto& joint = world.add<Following>(a, b);
    joint.followed = random_row(random);
    joint.follower = random_row(random);
  }
  push_at_random(world.bodies, random);
  return world;
}
const Following& following(const World& world, int k) {
  return static_cast<const Following&>(*world.joints()[std::size_t(k)]);
}

}  // namespace

TEST_CASE("on lanes figures fall on the ground and slide as with the scalar solver") {
  // Rounding grows where bodies tumble on joints, and warm by a factor of ten in five steps: 25 of
  // them are compared, which is the fall and some of the sliding; boxes alone for a second.
  for (const bool limbs : {false, true})
    for (const Packing packing : {Packing::automatic, Packing::list})
      for (const bool warm : {false, true}) {
        CAPTURE(limbs, int(packing), warm);
        World one = field(9, limbs, true), other = field(9, limbs, true);
        SequentialImpulses scalar;
        StepOptions stepping;
        PackedImpulses wide;
        wide.packing = packing;
        stepping.warm_start = warm;
        double most = 0;
        for (int n = 0; n < (limbs ? 25 : 60); ++n) {
          step(one, scalar, h, stepping);
          step(other, wide, h, stepping);
          most = std::max({most, apart(one, other), speeds_apart(one, other)});
        }
        CHECK(most < tolerance(1e-10, 2e-2));
        CHECK(double(one.bodies.at(1).v.z) < 0.9);  // it was rubbed
      }
}

TEST_CASE("in colours contacts and joints give the scalar solver's numbers in that order") {
  for (const Packing packing : packings) {
    CAPTURE(int(packing));
    World one = field(7, true, false, 0), other = field(7, true, false, 0);
    SequentialImpulses scalar;
    StepOptions stepping;
    PackedImpulses wide;
    wide.packing = packing;
    stepping.warm_start = true;
    for (int n = 0; n < 20; ++n) {
      step(other, wide, h, stepping);
      step_in_order(scalar, one, wide.packed(), stepping);
      CHECK(apart(one, other) < tolerance(1e-9, 1e-2));
      CHECK(speeds_apart(one, other) < tolerance(1e-9, 1e-2));
    }
  }
}

TEST_CASE("on lanes a bound that follows is mu times the followed impulse to the last bit") {
  for (const Packing packing : packings) {
    Random random(86);
    World world = followings(random, 21);
    PackedImpulses wide;
    wide.iterations = 7;
    wide.packing = packing;
    step(world, wide, h);
    int at_bound = 0, inside = 0, off = 0;
    for (int k = 0; k < 21; ++k) {  // the follower was solved last
      const real* const sum = following(world, k).impulse;
      CHECK(sum[0] >= 0);
      CHECK(std::abs(sum[1]) <= real(0.4) * sum[0]);
      ++(sum[0] == 0 ? off : std::abs(sum[1]) == real(0.4) * sum[0] ? at_bound : inside);
    }
    CAPTURE(int(packing), at_bound, inside, off);
    CHECK(std::min({at_bound, inside, off}) > 0);
  }
}

TEST_CASE("a row that follows an impulse without a row is refused by every solver") {
  const std::string words = "follows: the impulse that bounds a row must have a row of its own";
  Random random(87);
  World world = followings(random, 9);
  auto& orphan = static_cast<Following&>(*world.joints()[4]);
  const auto refused = [&](auto solver, const StepOptions& how = {}) {
    return refusal([&] { step(world, solver, h, how); });
  };
  for (const bool alive : {true, false}) {
    orphan.alive = alive;
    for (const bool row_by_row : {true, false})
      CHECK(refused(SequentialImpulses(), {.row_by_row = row_by_row}) ==
            (alive ? "accepted" : words));
    for (const Packing packing : packings) {
      PackedImpulses wide;
      wide.packing = packing;
      CHECK(refused(wide) == (alive ? "accepted" : words));
    }
  }
  orphan.alive = orphan.twice = true;
  for (const std::string& said : {refused(SequentialImpulses()), refused(PackedImpulses())})
    CHECK(said == "follows: only a block of one row can follow another impulse");
  const Block following{.settings = {.follows = 1, .lower = 0}};  // that bound is not read
  CHECK_FALSE((following.settings.one_sided() || following.corrects));
}

TEST_CASE("a followed impulse is found whichever neighbour in the list has it") {
  // A pair of rows in one block, and rows behind and before it that follow the pair's second row.
  class Four : public Joint {
   public:
    Row J[4];
    mutable real impulse[4] = {0, 0, 0, 0};
    using Joint::Joint;
    void append(const Bodies& bodies, Blocks& blocks) const override {
      const auto follower = [&](int k, int follows) {
        blocks.append(bodies, body1, body2, to_jacobian(J[k]), {0},
                      {.holds_position = false, .follows = follows, .upper = real(0.3)},
                      &impulse[k]);
      };
      Jacobian<2> pair;
      pair[0] = J[1], pair[1] = J[2];
      follower(0, 2);
      blocks.append(bodies, body1, body2, pair, {0, 0}, {.lower = 0}, &impulse[1]);
      follower(3, -1);
    }
  };
  Random random(89);
  World world = weightless();
  for (int k = 0; k < 10; ++k) {
    const BodyId a = world.add(box(2, brick, vec3(0), random.turn()));
    const BodyId b = world.add(box(random.uniform(1, 3), brick, vec3(0), random.turn()));
    auto& joint = world.add<Four>(a, b);
    for (Row& row : joint.J) row = random_row(random);
  }
  push_at_random(world.bodies, random);
  Blocks blocks;
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
  REQUIRE(blocks.list.size() == 30);
  for (int k = 0; k < 30; ++k) {
    if (k % 3 == 1) continue;
    const auto [block, row] = followed_row(blocks, k);
    CHECK(block == k / 3 * 3 + 1);
    CHECK(row == 1);
  }

  for (const Packing packing : packings) {
    PackedImpulses wide;
    wide.packing = packing;
    step(world, wide, h);
    for (const auto& joint : world.joints()) {
      const real* const sum = static_cast<const Four&>(*joint).impulse;
      CHECK(std::abs(sum[3]) <= real(0.3) * sum[2]);  // it was solved last
    }
  }
}

TEST_CASE("corners come and go, the bodies keep their places and nothing is allocated") {
  World world = field(9, true, true);
  PackedImpulses wide;
  const StepOptions stepping{.warm_start = true};
  const auto jump = [&] {
    for (int slot = 1; slot < world.bodies.slots(); ++slot)
      world.bodies.at(slot).v.y = real(0.5) * real(slot % 4);
    for (int n = 0; n < 120; ++n) step(world, wide, h, stepping);
  };
  for (int n = 0; n < 5; ++n) jump();
  const int before = wide.packed().groupings();
  CHECK(allocations_of(jump) == 0);
  CHECK(wide.packed().groupings() > before);
  CHECK(wide.packed().placings() == 1);
  for (int n = 0; n < 240; ++n) step(world, wide, h, stepping);
  const int fallen = wide.packed().groupings();
  for (int n = 0; n < 30; ++n) step(world, wide, h, stepping);
  CHECK(wide.packed().groupings() == fallen);  // they lie still
}

TEST_CASE("corners come and go again and the scalar solver does not allocate") {
  Random random(88);
  World world = field(3, true, true);
  SequentialImpulses solver;
  StepOptions stepping{.projections = 1};
  const auto throw_up = [&] {
    for (int slot = 1; slot < world.bodies.slots(); ++slot)
      world.bodies.at(slot).v.y = random.uniform(1, 3);
  };
  throw_up();
  for (int n = 0; n < 120; ++n) step(world, solver, h, stepping);
  throw_up();
  std::vector<int> counts(32, 0);
  const long taken = allocations_of([&] {
    for (int n = 0; n < 240; ++n) {
      step(world, solver, h, stepping);
      for (const auto& joint : world.joints())
        if (const auto* contact = dynamic_cast<const GroundContact*>(joint.get()))
          ++counts[std::size_t(contact->touching())];
    }
  });
  CHECK(taken == 0);
  CHECK(std::min({counts[0], counts[1], counts[2]}) > 0);
}
