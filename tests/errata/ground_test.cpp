// Where the thesis speaks of contacts: the sign of its inequality, and a contact that is solved as
// an equality. Each test shows the printed way failing and ours holding.
#include "tests/ground/rigs.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const real radius = real(0.5);

// A ball over level ground, at this gap, its speed after one step without gravity.
// `append`: what a joint makes of the corner.
template <class Append>
class Ground : public Joint {
 public:
  Ground(BodyId ground, BodyId body, Append append) : Joint(ground, body), append_(append) {}
  void append(const Bodies& bodies, Blocks& blocks) const override {
    const int slot1 = bodies.index(body1), slot2 = bodies.index(body2);
    const Corner corner{vec3(0), radius, 0};
    append_(corner, bodies.at(slot1), bodies.at(slot2),
            [&](real sign, const RowSettings& target) {
              const Body &a = bodies.at(slot1), &b = bodies.at(slot2);
              const Jacobian<1> J = to_jacobian(corner.along(sign * Corner::up(a), a, b));
              blocks.append(bodies, body1, body2, J, {sign * corner.error(a, b)}, target,
                            &impulse_);
            });
  }

 private:
  Append append_;
  mutable real impulse_ = 0;
};

template <class Append>
double speed_after(real gap, real speed, Append append) {
  World world = weightless();
  const BodyId ground = world.add(static_body(vec3(0)));
  const BodyId body = world.add(ball(2, radius, vec3(0, radius + gap, 0)));
  world.bodies[body].v.y = speed;
  world.add<Ground<Append>>(ground, body, append);
  step_once(world, h);
  return double(world.bodies[body].v.y);
}
double speed_on_our_ground(real gap, real speed) {
  Grounded falling(ball(2, radius, vec3(0, radius + gap, 0)), ball_outline(radius));
  falling.world.gravity = vec3(0);
  falling.it().v.y = speed;
  step(falling.world, falling.solver, h, falling.stepping);
  return double(falling.it().v.y);
}

}  // namespace

TEST_CASE("E1 a depth that must not be negative pulls what flies into the ground", "[E1]") {
  // printed: C = depth >= 0. A ball 0.3 m over the ground has a depth of -0.3 m.
  const auto printed = [](const auto&, const Body&, const Body&, const auto& row) {
    row(-1, RowSettings{.beta = real(0.2), .lower = 0});
  };
  CHECK(speed_after(real(0.3), 0, printed) == Approx(-0.2 * 0.3 * 60).epsilon(1e-4));
  CHECK(speed_after(real(-0.05), -4, printed) == Approx(-4).epsilon(1e-4));  // it may sink on
  CHECK(speed_on_our_ground(real(0.3), 0) == 0);
  CHECK(speed_on_our_ground(real(-0.05), -4) == Approx(0.2 * 0.05 * 60).epsilon(1e-3));
}

TEST_CASE("E5 a contact solved as an equality is sticky: it holds back what leaves the ground",
          "[E5]") {
  // printed: a violated inequality is an equality. 5 cm deep, on its way out at 5 m/s.
  const auto printed = [](const Corner& corner, const Body& a, const Body& b, const auto& row) {
    if (corner.error(a, b) < 0) row(1, RowSettings{.beta = real(0.2)});
  };
  CHECK(speed_after(real(-0.05), 5, printed) == Approx(0.2 * 0.05 * 60).epsilon(1e-3));
  CHECK(speed_on_our_ground(real(-0.05), 5) == Approx(5).epsilon(1e-6));
}

TEST_CASE("E5 a contact ignored until it is violated lets a ball into the ground by up to a step",
          "[E5]") {
  const auto printed = [](const Corner& corner, const Body& a, const Body& b, const auto& row) {
    if (corner.error(a, b) < 0) row(1, RowSettings{.beta = real(0.2)});
  };
  const double gap = 0.01, speed = -10;
  CHECK(gap + speed_after(real(gap), real(speed), printed) / 60 ==
        Approx(0.01 - 10.0 / 60).epsilon(1e-4));  // 0.157 m deep
  CHECK(gap + speed_on_our_ground(real(gap), real(speed)) / 60 ==
        Approx(0).margin(tolerance(1e-12, 1e-6)));
}
