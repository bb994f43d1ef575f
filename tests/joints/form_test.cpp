// What the type of a part promises of its rows is true of them: packed solvers rely on it.
#include "tests/oracle/test.h"

static const real h = real(1) / 60;

TEST_CASE("at any pose rows have the form that the type of their part promises") {
  const auto angular = [](const Row& J) {
    return J.v1 == vec3(0) && J.v2 == vec3(0) && J.w1 == -J.w2 && J.w2 != vec3(0);
  };
  const auto of_a_point = [](const Row* J) {
    const vec3 r1(J[2].w1.y, J[0].w1.z, J[1].w1.x), r2(-J[2].w2.y, -J[0].w2.z, -J[1].w2.x);
    const Jacobian<3> right = jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2));
    for (int i = 0; i < 3; ++i)
      if (J[i].v1 != right[i].v1 || J[i].w1 != right[i].w1 || J[i].v2 != right[i].v2 ||
          J[i].w2 != right[i].w2)
        return false;
    return true;
  };
  Random random(5);
  int forms[3] = {0, 0, 0};
  for (int n = 0; n < 50; ++n)
    for (const bool whole : {true, false}) {
      World world;
      const BodyId a = world.add(box(1, vec3(1, 2, 3), random.vector(1), random.turn()));
      const BodyId b = world.add(box(2, vec3(1, 2, 3), random.vector(1), random.turn()));
      const vec3 at = random.vector(1), axis = random.vector(1) + vec3(2, 0, 0);
      auto& hinge = world.add<HingeJoint>(a, b, at, axis);
      auto& slider = world.add<SliderJoint>(a, b, at, axis);
      auto& fixed = world.add<FixedJoint>(a, b, at);
      world.add<BallJoint>(a, b, point_at(world.bodies[a], world.bodies[b], at));
      hinge.whole = slider.whole = fixed.whole = whole;
      hinge.set_limits(0, 0), slider.set_limits(0, 0);
      hinge.set_motor(1, 1), slider.set_motor(1, 1);
      for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
      for (const BodyId id : {a, b}) world.bodies[id].q = random.turn();
      Blocks blocks;
      for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
      for (const joints::Block& block : blocks.list) {
        const Row* const J = &blocks.J[std::size_t(block.first)];
        ++forms[int(block.form)];
        if (block.form == Form::point) CHECK(of_a_point(J));
        if (block.form != Form::any)
          for (int i = block.form == Form::point ? 3 : 0; i < block.rows; ++i)
            CHECK(angular(J[i]));
      }
    }
  CHECK(*std::min_element(forms, forms + 3) > 100);
}
