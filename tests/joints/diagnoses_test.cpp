// What the checker says of a J or K that is wrong in a usual way: each mistake is called by its
// name, whatever the part.
#include "checker/report.h"
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/test.h"

namespace {

// The report of a part whose J or K is made by `yours(part, pair)` at every pose.
template <class Fixture, class Yours>
std::string told_of(bool of_K, Yours yours) {
  std::vector<Sample> samples;
  for_each_pose<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    Seen as_numbers = seen<Fixture>(part);
    (of_K ? as_numbers.K : as_numbers.J) = [=](const Pair& at) { return flat(yours(part, at)); };
    const Numbers J = as_numbers.slope(pair);
    samples.push_back(of_K ? K_sample(pose, as_numbers, pair, whole_K(J, pair))
                           : jacobian_sample(pose, as_numbers, pair, J));
  });
  const auto rows = row_names<Fixture>();
  return without_ids(of_K ? K_report(rows, samples, K_tolerance)
                          : jacobian_report(rows, samples, difference_tolerance));
}
// The first likely mistake begins with these words, and explains all poses.
void names(const std::string& report, const std::string& words) {
  const std::size_t at = report.find("Likely mistake: ");
  INFO(words << "\n" << report);
  REQUIRE(at != report.npos);
  CHECK(report.substr(at + 16).starts_with(words));
  CHECK(report.find("None of the usual") == report.npos);
}
template <class Fixture, class Change>
void J_names(const std::string& words, Change change) {
  names(told_of<Fixture>(false, [=](const auto& part, const Pair& at) {
          auto J = to_jacobian(part.jacobian(at.body1, at.body2));
          change(J, at);
          return J;
        }), words);
}
// K from other inverse masses and inertias.
template <class Change>
void K_names(const std::string& words, Change change) {
  names(told_of<PointFixture>(true, [=](const auto& part, const Pair& at) {
          real m1 = at.body1.inverse_mass, m2 = at.body2.inverse_mass;
          mat3 I1 = inverse_inertia(at.body1), I2 = inverse_inertia(at.body2);
          change(m1, I1, m2, I2);
          return product_K(numeric_jacobian(part, at.body1, at.body2), m1, I1, m2, I2);
        }), words);
}
template <class Change>
void written_K_names(const std::string& words, Change change) {
  names(told_of<PointFixture>(true, [=](const auto& part, const Pair& at) {
          Matrix<3> K = to_matrix(part.K(at.body1, at.body2));
          change(K);
          return K;
        }), words);
}

// A ball joint in skew axes: blocks that are neither symmetric nor the opposite.
const mat3 skew_axes(1, real(0.4), -1, real(0.3), real(1.2), real(0.1), real(-0.6), real(0.5), 2);
struct SkewPoint : Point {
  vec3 error(const Body& body1, const Body& body2) const {
    return skew_axes * Point::error(body1, body2);
  }
  Jacobian<3> jacobian(const Body& body1, const Body& body2) const {
    const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
    return jacobian_from_blocks(-skew_axes, skew_axes * skew(r1), skew_axes,
                                -skew_axes * skew(r2));
  }
};
struct SkewFixture : PointFixture {
  using Part = SkewPoint;
  static Part make(const Pair& pair) { return {PointFixture::make(pair)}; }
};

}  // namespace

TEST_CASE("a row of J that is missing or repeated or exchanged is named") {
  J_names<PointFixture>("J[1], the row C.y, is zero: was it never written?",
                        [](auto& J, const Pair&) { J[1] = {}; });
  J_names<PointFixture>("J[2], the row C.z, repeats J[0]",
                        [](auto& J, const Pair&) { J[2] = J[0]; });
  J_names<LineFixture>("J[0] is written twice, J[1] never: the row C.2 stands in the place of C.1",
                       [](auto& J, const Pair&) { J[0] = J[1], J[1] = {}; });
  J_names<PointFixture>("the rows C.x and C.z are exchanged",
                        [](auto& J, const Pair&) { std::swap(J[0], J[2]); });
  J_names<LineFixture>("w2 of J[1] is that of J[0]",
                       [](auto& J, const Pair&) { J[1].w2 = J[0].w2; });
  J_names<PointFixture>("in C.y alone: the sign of the block w1",
                        [](auto& J, const Pair&) { J[1].w1 = -J[1].w1; });
}

TEST_CASE("the blocks of a body that are another body's or frame's are named") {
  const auto each = [](auto change) {
    return [=](auto& J, const Pair& at) { for (Row& row : J.row) change(row, at); };
  };
  J_names<PointFixture>("the lever of body 1 for both bodies: each has its own",
                        each([](Row& row, const Pair&) { row.w2 = -row.w1; }));
  J_names<DistanceFixture>("the lever of body 2 for both bodies: each has its own",
                           each([](Row& row, const Pair&) { row.w1 = -row.w2; }));
  J_names<SlideFixture>("the sign of the blocks v1 and w1: body 1 carries the minus sign",
                        each([](Row& row, const Pair&) { row.v1 = -row.v1, row.w1 = -row.w1; }));
  J_names<SkewFixture>("the blocks v1, w1, v2 and w2 are transposed", [](auto& J, const Pair&) {
    const auto right = J;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        J[i].v1[j] = right[j].v1[i], J[i].w1[j] = right[j].w1[i];
        J[i].v2[j] = right[j].v2[i], J[i].w2[j] = right[j].w2[i];
      }
  });
  // a lever from another orientation
  const auto turned = [](auto other) {
    return [=](const Point& part, const Pair& at) {
      const vec3 r2 = to_world(at.body2, part.anchor2_local);
      return jacobian_from_blocks(mat3(-1), skew(other(at) * part.anchor1_local), mat3(1),
                                  -skew(r2));
    };
  };
  const auto says = [&](const char* words, auto other) {
    names(told_of<PointFixture>(false, turned(other)), words);
  };
  says("the lever of body 1 is turned with the other body",
       [](const Pair& at) { return at.body2.q; });
  says("the lever of body 1 is turned the wrong way round: to_world, not to_local",
       [](const Pair& at) { return conjugate(at.body1.q); });
  says("body-space lever: the lever of body 1 is not turned into the world",
       [](const Pair&) { return quat(1, 0, 0, 0); });
}

TEST_CASE("one body's mass or inertia for both bodies and a wrong sign are named in K") {
  using m = real&;
  using I = mat3&;
  K_names("the inertia of body 1 for both bodies", [](m, I I1, m, I I2) { I2 = I1; });
  K_names("the inertia of body 2 for both bodies", [](m, I I1, m, I I2) { I1 = I2; });
  K_names("the inverse mass of body 1 for both bodies", [](m m1, I, m m2, I) { m2 = m1; });
  K_names("the sign of body 1's terms", [](m m1, I I1, m, I) { m1 = -m1, I1 = -I1; });
  K_names("the sign of the rotation of body 2", [](m, I, m, I I2) { I2 = -I2; });
  K_names("body 1 is missing", [](m m1, I I1, m, I) { m1 = 0, I1 = mat3(0); });
}

TEST_CASE("a K that is written in part is named") {
  written_K_names("the lower half is missing", [](Matrix<3>& K) {
    K[1][0] = K[2][0] = K[2][1] = 0;
  });
  written_K_names("the entries beside the diagonal are missing", [](Matrix<3>& K) {
    K = {{{{K[0][0], 0, 0}, {0, K[1][1], 0}, {0, 0, K[2][2]}}}};
  });
  written_K_names("K[2], the row C.z, is zero: was it never written?",
                  [](Matrix<3>& K) { K[2] = {}; });
  written_K_names("K is symmetric, and yours is not", [](Matrix<3>& K) { K[0][1] += 1; });
}

TEST_CASE("a value that was never set is called so and not a division by zero") {
  const real unset = is_float ? real(-1.69e38) : real(-5.31e303);
  J_names<PointFixture>("a value that was never set",
                        [=](auto& J, const Pair&) { J[1].w1.x = unset; });
  written_K_names("a value that was never set", [=](Matrix<3>& K) { K[0][0] = unset; });
  written_K_names("a division by zero", [](Matrix<3>& K) { K[0][0] = unbounded; });
}
