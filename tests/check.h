// The numeric checker: a part against its numeric twin at four kinds of poses, with a report that
// teaches. A part comes with a fixture, a struct of about ten lines:
//
//   struct PointFixture {
//     using Part = Point;
//     static constexpr Subject J{"2.1", "J of the ball joint"}, K{"2.2", "K of the ball joint"};
//     static constexpr std::array rows{"C.x", "C.y", "C.z"};
//     static constexpr bool exact_when_broken = true;       // is J exact where C is not 0?
//     static Part make(const Pair&);                        // C = 0 for this pair
//     static void move_freely(const Part&, Pair&, Random&); // C stays 0
//   };
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/numeric.h"

namespace joints::testing {

/// What is being checked: the exercise (or "" where it is none) and its name in words.
struct Subject {
  const char* id;
  const char* words;
};

/// A value that somebody may get who makes a common mistake.
struct Suspect {
  double value;
  std::string words;
};

// ---- numbers and vectors ------------------------------------------------------------------------

/// Fails with a report unless yours is expected, within tolerance (absolute).
void expect(const Subject& subject, const std::string& entry, double yours, double expected,
            double tolerance, const std::vector<Suspect>& suspects = {});
/// The same for three numbers at once; a suspect's value is compared with all three.
struct VectorSuspect {
  vec3 value;
  std::string words;
};
void expect(const Subject& subject, const std::string& entry, const vec3& yours,
            const vec3& expected, double tolerance,
            const std::vector<VectorSuspect>& suspects = {});

/// Fails a test with the exercise's file, line and next command under the words.
[[noreturn]] void fail(const Subject& subject, const std::string& words);

// ---- parts --------------------------------------------------------------------------------------

/// The four kinds of poses at which a part is checked.
inline constexpr std::array pose_names{"upright", "turned", "moved", "broken"};
inline constexpr int draws_of_a_pose = 4;

using Numbers = std::vector<double>;
/// J at one pose: 12 numbers a row.
struct JacobianSample {
  int pose;
  Numbers yours, numeric;
  bool right_if_unturned[3];  ///< would it be right if body 1, body 2, both had no rotation?
};
/// K at one pose, with what some mistakes would give.
struct KSample {
  int pose;
  Numbers yours, numeric;
  std::vector<std::pair<std::string, Numbers>> mistakes;
};

/// Words for everything that is wrong, or "" where all is right.
std::string jacobian_report(const std::vector<std::string>& rows,
                            const std::vector<JacobianSample>& samples, double tolerance);
std::string K_report(const std::vector<std::string>& rows, const std::vector<KSample>& samples,
                     double tolerance);

template <int N>
Numbers flat(const Jacobian<N>& J) {
  Numbers out;
  for (const Row& row : J.row)
    for (const vec3& block : {row.v1, row.w1, row.v2, row.w2})
      for (int c = 0; c < 3; ++c) out.push_back(double(block[c]));
  return out;
}
template <int N>
Numbers flat(const Matrix<N>& K) {
  Numbers out;
  for (const auto& row : K.m)
    for (real number : row) out.push_back(double(number));
  return out;
}
bool close(const Numbers& a, const Numbers& b, double tolerance);

/// Calls `look(pose, part, pair)` at every pose of the fixture's part.
template <class Fixture>
void visit_poses(const std::function<void(int, const typename Fixture::Part&, const Pair&)>& look) {
  for (int pose = 0; pose < 4; ++pose)
    for (int draw = 0; draw < draws_of_a_pose; ++draw) {
      Random random(unsigned(100 * pose + draw + 1));
      Pair pair = uneven_pair();
      if (draw > 0) pair.body2.q = random.turn();
      const auto part = Fixture::make(pair);
      if (pose >= 1) {
        move_together(pair, random);
        Fixture::move_freely(part, pair, random);
      }
      if (pose >= 2)
        for (int again = 0; again < 3; ++again) Fixture::move_freely(part, pair, random);
      if (pose == 3) {
        pair.body2.x += random.vector(real(0.3));
        pair.body2.q = normalize(random.turn(real(0.4)) * pair.body2.q);
      }
      look(pose, part, pair);
    }
}

template <class Fixture>
std::vector<std::string> row_names() {
  return {Fixture::rows.begin(), Fixture::rows.end()};
}

/// J against central differences of C. Fails with a report where they differ.
template <class Fixture>
void check_jacobian() {
  std::vector<JacobianSample> samples;
  visit_poses<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    if (pose == 3 && !Fixture::exact_when_broken) return;
    const auto yours = [&](const Body& a, const Body& b) {
      return flat(to_jacobian(part.jacobian(a, b)));
    };
    const auto numeric = [&](const Body& a, const Body& b) {
      return flat(numeric_jacobian(part, a, b));
    };
    JacobianSample sample{pose, yours(pair.body1, pair.body2), numeric(pair.body1, pair.body2), {}};
    for (int which = 0; which < 3; ++which) {
      Body a = pair.body1, b = pair.body2;
      if (which != 1) a.q = quat(1, 0, 0, 0);
      if (which != 0) b.q = quat(1, 0, 0, 0);
      sample.right_if_unturned[which] =
          close(yours(a, b), numeric(a, b), difference_tolerance * 10);
    }
    samples.push_back(sample);
  });
  const std::string report = jacobian_report(row_names<Fixture>(), samples, difference_tolerance);
  if (!report.empty()) fail(Fixture::J, report);
}

/// K against J M^-1 J^T with the numeric J. Fails with a report where they differ.
template <class Fixture>
void check_K() {
  constexpr int N = Fixture::Part::rows;
  std::vector<KSample> samples;
  visit_poses<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    if (pose == 3 && !Fixture::exact_when_broken) return;
    const Body &a = pair.body1, &b = pair.body2;
    const Jacobian<N> J = numeric_jacobian(part, a, b);
    const mat3 I1 = inverse_inertia(a), I2 = inverse_inertia(b), none(0);
    const real m1 = a.inverse_mass, m2 = b.inverse_mass;
    const vec3 i1 = a.inverse_inertia_local, i2 = b.inverse_inertia_local;
    const mat3 local1(i1.x, 0, 0, 0, i1.y, 0, 0, 0, i1.z);
    const mat3 local2(i2.x, 0, 0, 0, i2.y, 0, 0, 0, i2.z);
    const Matrix<N> K = product_K(J, m1, I1, m2, I2);
    Matrix<N> inverse = K;
    invert_symmetric(inverse.m[0].data(), N);
    Jacobian<N> unturned = J;  // levers left in body space
    {
      Body a0 = a, b0 = b;
      a0.q = b0.q = quat(1, 0, 0, 0);
      const Jacobian<N> J0 = numeric_jacobian(part, a0, b0);
      for (int i = 0; i < N; ++i) unturned[i] = {J[i].v1, J0[i].w1, J[i].v2, J0[i].w2};
    }
    const auto with = [&](real p1, const mat3& A1, real p2, const mat3& A2) {
      return flat(product_K(J, p1, A1, p2, A2));
    };
    samples.push_back(
        {pose, flat(to_matrix(part.K(a, b))), flat(K),
         {{"masses where inverse masses belong: K is in 1/kg",
           with(1 / m1, glm::inverse(I1), 1 / m2, glm::inverse(I2))},
          {"masses where inverse masses belong: K is in 1/kg", with(1 / m1, I1, 1 / m2, I2)},
          {"the inverse of K: that is the effective mass, the solver inverts K itself",
           flat(inverse)},
          {"the share of the rotation is missing", with(m1, none, m2, none)},
          {"the rotation of body 1 is missing", with(m1, none, m2, I2)},
          {"the rotation of body 2 is missing", with(m1, I1, m2, none)},
          {"the inverse mass of body 1 is missing", with(0, I1, m2, I2)},
          {"the inverse mass of body 2 is missing", with(m1, I1, 0, I2)},
          {"the inverse masses are missing", with(0, I1, 0, I2)},
          {"inertia where inverse inertia belongs",
           with(m1, glm::inverse(I1), m2, glm::inverse(I2))},
          {"body-space inertia: turn it into the world, R I^-1 R^T",
           with(m1, local1, m2, local2)},
          {"body-space arm: the lever must be turned into the world",
           flat(product_K(unturned, m1, I1, m2, I2))},
          {"the sign of the rotation's share: skew(r) I^-1 skew(r) lacks the transpose",
           with(m1, -I1, m2, -I2)}}});
  });
  const std::string report = K_report(row_names<Fixture>(), samples, 10 * difference_tolerance);
  if (!report.empty()) fail(Fixture::K, report);
}

}  // namespace joints::testing
