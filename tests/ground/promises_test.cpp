// What chapter 8 promises for families: no rebound makes energy, a sliding box follows Coulomb's
// law however it is pushed, and bodies that overlap are not shot apart.
#include "bench/families.h"
#include "tests/ground/rigs.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A motor that pushes body 2 along z with a constant force [N].
class SidePush : public Joint {
 public:
  SidePush(BodyId a, BodyId b, real force) : Joint(a, b), force_(force) {}
  void append(const Bodies& bodies, Blocks& blocks) const override {
    Jacobian<1> J;
    J.row[0] = {vec3(0, 0, -1), vec3(0), vec3(0, 0, 1), vec3(0)};
    blocks.append(bodies, body1, body2, J, {0},
                  {.rate = 1000, .holds_position = false, .lower = -force_, .upper = force_},
                  &impulse_);
  }

 private:
  real force_;
  mutable real impulse_ = 0;
};

}  // namespace

TEST_CASE("no box of any shape, tilt, restitution and friction gains energy when it bounces") {
  for (const bench::Family& family : bench::contact_families()) {
    if (family.name != "tilted boxes") continue;
    for (const char* setting : {"si30", "rows10", "lanes10", "plain"})
      for (unsigned seed = 1; seed <= 100; ++seed) {
        CAPTURE(setting, seed);
        CHECK(bench::run_drawn(family.draw(seed), setting).gain < 0.01);
      }
  }
}

TEST_CASE("a box that lands flat rebounds with e times its speed on all four corners") {
  for (const double e : {0.3, 0.7, 1.0}) {
    Grounded box = standing();
    box.it().x.y += 1;
    box.contact->restitution = real(e);
    double highest = 0;
    bool up = false;
    for (int n = 0; n < 240 && !(up && box.it().v.y < 0); ++n) {
      step(box.world, box.solver, h, box.stepping);
      up = up || box.it().v.y > 0;
      if (up) highest = std::max(highest, double(box.it().x.y - brick.y / 2));
    }
    CHECK(highest == Approx(e * e).epsilon(0.01));
    CHECK(double(length(box.it().w)) < tolerance(1e-9, 1e-4));
  }
}

TEST_CASE("with the circle a joint or a force moves a sliding box sideways by Coulomb's law") {
  for (const double mu : {0.2, 0.5, 0.8})
    for (const double part : {0.1, 0.5, 0.9})  // of the greatest friction
      for (const int kind : {0, 1, 2}) {  // a force; a joint; a joint without the circle
        Grounded box(joints::box(10, vec3(1, real(0.2), 1), vec3(0, real(0.1), 0)),
                     box_outline(vec3(1, real(0.2), 1)));
        box.contact->friction = real(mu);
        box.contact->circle = kind < 2;
        box.it().v.x = 10;
        const double force = part * mu * 10 * g;
        if (kind > 0) box.world.add<SidePush>(box.ground, box.body, real(force));
        double vx = 10, vz = 0, z = 0;
        for (int n = 0; n < int(0.8 * 10 / (mu * g) * 60); ++n) {
          if (kind == 0) box.it().force = vec3(0, 0, real(force));
          step(box.world, box.solver, h, box.stepping);
          for (int k = 0; k < 200; ++k) {
            const double d = double(h) / 200, speed = std::hypot(vx, vz);
            vx -= d * mu * g * vx / speed;
            vz += d * (force / 10 - mu * g * vz / speed);
            z += d * vz;
          }
        }
        CAPTURE(mu, part, kind);
        if (kind == 2) CHECK(std::abs(double(box.it().x.z)) < 1e-3);  // the square holds it
        else CHECK(double(box.it().x.z) == Approx(z).epsilon(0.1));
      }
}

TEST_CASE("bodies that overlap by 0.3 m separate with less than 1 m/s, soft or hard") {
  for (const real frequency : {real(0), real(60)})
    for (const double beta : {0.2, 1.0}) {
      World world;
      const BodyId ground = world.add(static_body(vec3(0)));
      const vec3 cube(1);
      const BodyId low = world.add(box(10, cube, vec3(0, real(0.5), 0)));
      const BodyId high = world.add(box(10, cube, vec3(0, real(1.2), 0)));
      for (GroundContact* contact :
           {&world.add<GroundContact>(ground, low, Top{}, box_outline(cube)),
            &world.add<GroundContact>(low, high, box_top(cube), box_outline(cube))}) {
        contact->frequency = frequency, contact->damping = 10;
        contact->beta = real(beta);
      }
      SequentialImpulses solver;
      double fastest = 0;
      for (int n = 0; n < 180; ++n) {
        step(world, solver, h, {.warm_start = true, .substeps = 4});
        fastest = std::max(fastest, double(length(world.bodies[high].v)));
      }
      CAPTURE(frequency, beta);
      CHECK(fastest < 1);
      CHECK(fastest > 0.5);  // they did overlap
      CHECK(double(world.bodies[high].x.y) == Approx(1.5).margin(0.01));
    }
}
