// The checker of parts, asked as a program outside asks it: parts of the library are right, wrong
// ones are told what is wrong, and a report says the same as data.
#include "checker/check_part.h"
#include "joints/distance_joint.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"
#include "tests/oracle/test.h"

namespace {

// A row with the possible mistakes of a wrong part. Right: C = a1.a2.
struct Crossed {
  real sign1 = 1, sign2 = -1, push = 0;
  vec3 a1_local{1, 0, 0}, a2_local{0, 1, 0};
  static constexpr int rows = 1;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::angular;
  real error(const Body& body1, const Body& body2) const {
    return dot(to_world(body1, a1_local), to_world(body2, a2_local));
  }
  Row jacobian(const Body& body1, const Body& body2) const {
    const vec3 n = cross(to_world(body1, a1_local), to_world(body2, a2_local));
    return {push * n, sign1 * n, vec3(0), sign2 * n};
  }
};

// A rod with the possible mistakes of its levers.
struct Levers : Distance {
  real lever1 = 1, lever2 = 1, pull2 = 1;  // factors of w1, w2 and v2
  Row jacobian(const Body& body1, const Body& body2) const {
    const Row J = Distance::jacobian(body1, body2);
    return {J.v1, lever1 * J.w1, pull2 * J.v2, lever2 * J.w2};
  }
};

bool says(const PartReport& report, const std::string& words) {
  return report.text().find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("the checker finds nothing wrong with the parts of the chapters, wherever made") {
  PoseRandom random(11);
  for (int n = 0; n < 5; ++n) {
    const PosePair pair = any_pose(random);
    const Body &a = pair.body1, &b = pair.body2;
    const vec3 anchor = random.vector(1), axis = random.vector(1);
    const auto right = [](const PartReport& report) {
      INFO(report.text());
      CHECK(report.good());
      CHECK(report["poses"].right >= (is_float ? 38 : 40));
    };
    const CheckSettings exact{.seed = unsigned(100 * n + 1), .exact_when_broken = true};
    right(check_part(point_at(a, b, anchor), any_pose, exact));
    right(check_part(Distance{anchor, axis, real(0.7)}, any_pose, exact));
    right(check_part(lock_of(a, b)));
    right(check_part(Composite<Point, RotationLock>{point_at(a, b, anchor), lock_of(a, b)}));
    right(check_part(Crossed{}, any_pose, exact));
  }
}

TEST_CASE("the checker names the block of a wrong row, its factor, and what its forces do") {
  const PartReport factor = check_part(Crossed{.sign1 = real(0.5)});
  INFO(factor.text());
  CHECK(!factor.good());
  CHECK(!factor["J"].holds);
  CHECK(factor["J"].right == 0);
  CHECK(factor["J"].worst > 0.1);
  CHECK(says(factor, "in row C, w1 is 0.5 times the slope"));
  CHECK(!factor["momentum"].holds);
  CHECK(!factor["power"].holds);
  CHECK(!factor["form"].holds);
  CHECK(factor["rank"].holds);

  const PartReport whole = check_part(Crossed{.sign1 = 2, .sign2 = -2});
  CHECK(!whole["J"].holds);  // only a factor: the forces are in the right directions
  CHECK(whole["momentum"].holds);
  CHECK(whole["power"].holds);

  const PartReport pushes = check_part(Crossed{.push = 1});
  CHECK(!pushes["momentum"].holds);
  CHECK(!pushes["form"].holds);
}

TEST_CASE("the checker tells levers that do not meet from forces that are not opposite") {
  const std::string opposite = "they are opposite, but their levers", against = "must be opposite";
  PoseRandom random(12);
  int all = 0, told = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Distance rod{random.vector(1), random.vector(1), random.uniform(real(0.3), 1)};
    const real wrong = random.uniform(real(-1), real(0.8));
    const CheckSettings settings{.seed = seed};
    const auto words = [&](const Levers& part) {
      return check_part(part, any_pose, settings)["momentum"].words;
    };
    all += 4;
    told += words({rod, wrong, 1, 1}).find(opposite) != std::string::npos;
    told += words({rod, 1, wrong, 1}).find(opposite) != std::string::npos;
    told += words({rod, 1, 1, wrong}).find(against) != std::string::npos;
    told += words({rod, 1, 1, 1}) == "The forces conserve linear and angular momentum.";
  }
  INFO(told << " of " << all << " rods were told the right sentence");
  CHECK(told == all);
}

TEST_CASE("the checker finds rows that follow from others, and numbers that are none") {
  const Point one{vec3(1, 0, 0), vec3(0)}, other{vec3(0, 1, 0), vec3(1, 1, 0)};
  const PartReport twice = check_part(Composite<Point, Point>{one, other});
  INFO(twice.text());
  CHECK(!twice["rank"].holds);
  CHECK(twice["J"].holds);
  const PartReport none = check_part(Crossed{.sign1 = real(0) / real(0.0)});
  CHECK(!none.good());
  CHECK(says(none, "In J: a division by zero"));
}

namespace {

// C = the angle.
struct Angle {
  HingeAngle angle{vec3(0, 0, 1)};
  bool far_wrong = false;
  static constexpr int rows = 1;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::any;
  real error(const Body& body1, const Body& body2) const {
    return angle.error(body1, body2);
  }
  Row jacobian(const Body& body1, const Body& body2) const {
    const Row J = angle.jacobian(body1, body2);
    const real s = far_wrong && body2.x.x > real(0.8) ? -1 : 1;
    return {J.v1, s * J.w1, J.v2, s * J.w2};
  }
};
PosePair near_the_axis(PoseRandom& random) {
  PosePair pair = any_pose(random);
  pair.body2.q = pair.body1.q * rotation(random.vector(real(0.5)));
  return pair;
}

}  // namespace

TEST_CASE("the checker notes that an angle jumps by a turn, but no length and no product") {
  for (const unsigned seed : {1, 2, 3, 4, 5}) {
    const PartReport angle = check_part(Angle{}, near_the_axis, {.seed = seed});
    INFO(angle.text());
    CHECK(angle.good());
    CHECK(angle["turns"].note);
    CHECK(angle["turns"].right == 0);
    CHECK(angle["turns"].worst == Approx(2 * 3.14159265).epsilon(1e-3));
    CHECK(says(angle, "note   turns: C jumps by 6.28"));
    CHECK_FALSE(check_part(Crossed{}, any_pose, {.seed = seed})["turns"].note);
    CHECK_FALSE(check_part(Distance{vec3(1, 0, 0), vec3(0, 2, 0), 1}, any_pose,
                           {.seed = seed})["turns"].note);
  }
}

TEST_CASE("the checker blames no usual mistake for a part that is right at most poses") {
  const PartReport report = check_part(Angle{.far_wrong = true}, near_the_axis);
  INFO(report.text());
  CHECK_FALSE(report["J"].holds);
  CHECK(4 * report["J"].right >= 3 * report["J"].poses);
  CHECK(says(report, "It is right at"));
  CHECK_FALSE(says(report, "Likely mistake"));
}
