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

#include "tests/checker/numeric.h"

namespace joints::testing {

/// What is being checked: the exercise (or "" where it is none) and its name in words.
struct Subject {
  const char* id;
  const char* words;
  int region = 1;  ///< which of the regions that share the id
  const char* given = "";  ///< the arguments of the case, for the report
};

using Numbers = std::vector<double>;

/// A value that somebody gets who makes a common mistake, and that mistake in words.
template <class T>
struct SuspectOf {
  T value;
  std::string words;
};
using Suspect = SuspectOf<double>;
using VectorSuspect = SuspectOf<vec3>;
using MatrixSuspect = SuspectOf<mat3>;
using QuatSuspect = SuspectOf<quat>;

// ---- numbers and vectors ------------------------------------------------------------------------

/// Fails with a report unless yours is expected, within tolerance (absolute). A suspect is named
/// where all its numbers are yours.
void expect(const Subject& subject, const std::string& entry, double yours, double expected,
            double tolerance, const std::vector<Suspect>& suspects = {});
void expect(const Subject& subject, const std::string& entry, const vec3& yours,
            const vec3& expected, double tolerance,
            const std::vector<VectorSuspect>& suspects = {});
void expect(const Subject& subject, const std::string& entry, const mat3& yours,
            const mat3& expected, double tolerance,
            const std::vector<MatrixSuspect>& suspects = {});
/// q and -q are the same orientation: either will do.
void expect(const Subject& subject, const std::string& entry, const quat& yours,
            const quat& expected, double tolerance,
            const std::vector<QuatSuspect>& suspects = {});

/// The numbers of a case, of which the report shows those that are wrong. \param words what the
/// case is, or "" \param likely the mistakes that explain them, the first is named
void expect(const Subject& subject, const std::string& words,
            const std::vector<std::string>& entries, const Numbers& yours,
            const Numbers& expected, double tolerance, const std::vector<std::string>& likely);

/// Fails with a report unless it is empty.
void check(const Subject& subject, const std::string& report);
/// Fails a test with the exercise's file, line and next command under the words.
[[noreturn]] void fail(const Subject& subject, const std::string& words);

// ---- parts --------------------------------------------------------------------------------------

/// The four kinds of poses at which a part is checked, what they are for, and the one in the text.
inline constexpr std::array pose_names{"upright", "turned", "moved", "broken", "pencil and paper"};
inline constexpr std::array pose_words{"body 1 is not turned", "both bodies are turned",
                                       "far along what the joint leaves free", "C is not 0",
                                       "Numbers, in the text"};
inline constexpr int pencil_and_paper = 4;
inline constexpr int draws_of_a_pose = 4;

/// What the pose "broken" is called where C is no gap: a fixture may have its own, `broken`.
struct PoseWords {
  const char *name = pose_names[3], *words = pose_words[3];
};

/// J (12 numbers a row) or K at one pose.
struct Sample {
  int pose;
  Numbers yours, right;
  std::vector<std::string> mistakes;  ///< everything that would explain yours, in words
  PoseWords broken = {};
};

/// How far a K may be from J M^-1 J^T with J by differences.
inline constexpr double K_tolerance = 10 * difference_tolerance;

/// Words for everything that is wrong, or "" where all is right.
std::string jacobian_report(const std::vector<std::string>& rows, std::vector<Sample> samples,
                            double tolerance);
std::string K_report(const std::vector<std::string>& rows, std::vector<Sample> samples,
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

/// Calls `look(pose, part, pair)` at every pose of the fixture's part where J is exact.
template <class Fixture>
void visit_poses(const std::function<void(int, const typename Fixture::Part&, const Pair&)>& look) {
  for (int pose = 0; pose < (Fixture::exact_when_broken ? 4 : 3); ++pose)
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

/// The pair with body 1, body 2, both not turned: an answer that is right there and wrong elsewhere
/// has left a lever in body space.
inline std::array<Pair, 3> unturned(const Pair& pair) {
  std::array<Pair, 3> out{pair, pair, pair};
  out[0].body1.q = out[1].body2.q = out[2].body1.q = out[2].body2.q = quat(1, 0, 0, 0);
  return out;
}
inline constexpr std::array body_space_arm{
    "body-space arm: the lever of body 1 is not turned into the world",
    "body-space arm: the lever of body 2 is not turned into the world",
    "body-space arm: the levers of both bodies are not turned into the world"};
/// The Jacobians of some mistakes with levers. A fixture may have more of them in a function
/// `mistakes(part, pair)`.
template <class Fixture, int N>
auto wrong_jacobians(const typename Fixture::Part& part, const Jacobian<N>& J, const Pair& pair) {
  std::vector<std::pair<std::string, Jacobian<N>>> out;
  if constexpr (requires { Fixture::mistakes(part, pair); }) out = Fixture::mistakes(part, pair);
  Jacobian<N> points = J, exchanged = J, reversed = J, missing = J;
  for (int i = 0; i < N; ++i) {
    points[i].w1 += cross(pair.body1.x, J[i].v1);
    points[i].w2 += cross(pair.body2.x, J[i].v2);
    exchanged[i].w1 = -J[i].w2;
    exchanged[i].w2 = -J[i].w1;
    reversed[i] = {J[i].v1, -J[i].w1, J[i].v2, -J[i].w2};
    missing[i] = {J[i].v1, vec3(0), J[i].v2, vec3(0)};
  }
  out.push_back({"the sign of the blocks w1 and w2: a x b is -(b x a)", reversed});
  out.push_back({"the blocks w1 and w2 are missing: they hold the levers", missing});
  out.push_back({"a point where a lever belongs: r runs from the body's centre to the anchor "
                 "(to_world, not world_point)", points});
  out.push_back({"the levers r1 and r2 are exchanged", exchanged});
  return out;
}

/// The J of a part beside the right one, with what would explain a difference.
template <class Fixture, int N>
Sample jacobian_sample(int pose, const typename Fixture::Part& part, const Pair& pair,
                       const Jacobian<N>& right) {
  const auto yours = [&](const Pair& at) {
    return flat(to_jacobian(part.jacobian(at.body1, at.body2)));
  };
  Sample sample{pose, yours(pair), flat(right), {}};
  if constexpr (requires { Fixture::broken; }) sample.broken = Fixture::broken;
  if (close(sample.yours, sample.right, difference_tolerance)) return sample;
  for (const auto& [words, wrong] : wrong_jacobians<Fixture>(part, right, pair))
    if (close(sample.yours, flat(wrong), difference_tolerance)) sample.mistakes.push_back(words);
  for (int k = 0; k < 3; ++k) {
    const Pair at = unturned(pair)[k];
    if (close(yours(at), flat(numeric_jacobian(part, at.body1, at.body2)), difference_tolerance))
      sample.mistakes.push_back(body_space_arm[k]);
  }
  return sample;
}

/// The J of a part beside the numeric one at every pose.
template <class Fixture>
std::vector<Sample> jacobian_samples() {
  std::vector<Sample> samples;
  visit_poses<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    samples.push_back(jacobian_sample<Fixture>(pose, part, pair,
                                               numeric_jacobian(part, pair.body1, pair.body2)));
  });
  return samples;
}

/// J against central differences of C. Fails with a report where they differ.
template <class Fixture>
void check_jacobian() {
  check(Fixture::J,
        jacobian_report(row_names<Fixture>(), jacobian_samples<Fixture>(), difference_tolerance));
}
/// J against the one computed by hand at the pose of the text; the other poses help to explain.
template <class Fixture, int N>
void check_jacobian(const typename Fixture::Part& part, const Pair& pair,
                    const Jacobian<N>& by_hand) {
  const Sample paper = jacobian_sample<Fixture>(pencil_and_paper, part, pair, by_hand);
  std::vector<Sample> samples{paper};
  if (!close(paper.yours, paper.right, difference_tolerance))
    for (const Sample& sample : jacobian_samples<Fixture>()) samples.push_back(sample);
  check(Fixture::J, jacobian_report(row_names<Fixture>(), samples, difference_tolerance));
}

/// The matrices K of some mistakes, from J M^-1 J^T with something else for M or J.
template <class Fixture, int N>
auto wrong_Ks(const typename Fixture::Part& part, const Jacobian<N>& J, const Pair& pair) {
  const Body &a = pair.body1, &b = pair.body2;
  const mat3 I1 = inverse_inertia(a), I2 = inverse_inertia(b), none(0);
  const auto with_turn = [](Body body, const quat& q) {
    body.q = q;
    return inverse_inertia(body);
  };
  const quat unturned(1, 0, 0, 0);
  const mat3 local1 = with_turn(a, unturned), local2 = with_turn(b, unturned);
  const real m1 = a.inverse_mass, m2 = b.inverse_mass, both = 1 / (1 / m1 + 1 / m2);
  std::vector<std::pair<std::string, Matrix<N>>> out;
  const auto add = [&](const char* words, real p1, const mat3& A1, real p2, const mat3& A2) {
    out.push_back({words, product_K(J, p1, A1, p2, A2)});
  };
  Matrix<N> inverse = product_K(J, m1, I1, m2, I2), everywhere = inverse;
  invert_symmetric(inverse.m[0].data(), N);
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      if (i != j) everywhere[i][j] += m1 + m2;

  const bool walls = m1 == 0 || m2 == 0;
  const char* const masses = "masses where inverse masses belong: K is in 1/kg";
  if (!walls) {
    add(masses, 1 / m1, none, 1 / m2, none);
    add(masses, 1 / m1, I1, 1 / m2, I2);
    add(masses, 1 / m1, glm::inverse(I1), 1 / m2, glm::inverse(I2));
    add("one over the sum of the masses: each mass is inverted first, then they are added",
        both / 2, I1, both / 2, I2);
    add("inertia where inverse inertia belongs", m1, glm::inverse(I1), m2, glm::inverse(I2));
  }
  out.push_back({"the inverse of K: that is the effective mass, the solver inverts K itself",
                 inverse});
  add("the share of the rotation is missing", m1, none, m2, none);
  add("the rotation of body 1 is missing", m1, none, m2, I2);
  add("the rotation of body 2 is missing", m1, I1, m2, none);
  add("the inverse mass of body 1 is missing", 0, I1, m2, I2);
  add("the inverse mass of body 2 is missing", m1, I1, 0, I2);
  add("the inverse masses are missing", 0, I1, 0, I2);
  add("the inverse inertia is missing", m1, mat3(1), m2, mat3(1));
  add("body-space inertia of body 1: it must be turned into the world, R I^-1 R^T", m1, local1, m2,
      I2);
  add("body-space inertia of body 2: it must be turned into the world, R I^-1 R^T", m1, I1, m2,
      local2);
  add("body-space inertia of both bodies: it must be turned into the world, R I^-1 R^T", m1, local1,
      m2, local2);
  add("the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R", m1,
      with_turn(a, conjugate(a.q)), m2, with_turn(b, conjugate(b.q)));
  add("the sign of the rotation's share: it is added (skew(r) I^-1 skew(r) lacks a transpose)", m1,
      -I1, m2, -I2);
  add("the sign of body 1's share: the shares of both bodies are added", -m1, -I1, m2, I2);
  add("the sign of body 2's share: the shares of both bodies are added", m1, I1, -m2, -I2);
  add("the lever of one body with the inertia of the other", m1, I2, m2, I1);
  out.push_back({"a matrix plus a number adds it to all nine entries: write mat3(a)",
                 everywhere});
  for (const auto& [words, wrong] : wrong_jacobians<Fixture>(part, J, pair))
    out.push_back({words, product_K(wrong, m1, I1, m2, I2)});
  return out;
}

/// The K of a part beside the right one, with what would explain a difference.
template <class Fixture, int N>
Sample K_sample(int pose, const typename Fixture::Part& part, const Pair& pair,
                const Matrix<N>& right) {
  const auto yours = [&](const Pair& at) { return flat(to_matrix(part.K(at.body1, at.body2))); };
  const auto J = [&](const Pair& at) { return numeric_jacobian(part, at.body1, at.body2); };
  const auto holds = [&](const Pair& at) {
    return close(yours(at), flat(dense_K(J(at), at.body1, at.body2)), K_tolerance);
  };
  Sample sample{pose, yours(pair), flat(right), {}};
  if (close(sample.yours, sample.right, K_tolerance)) return sample;
  for (const auto& [words, wrong] : wrong_Ks<Fixture>(part, J(pair), pair))
    if (close(sample.yours, flat(wrong), K_tolerance)) sample.mistakes.push_back(words);
  for (int k = 0; k < 3; ++k)
    if (holds(unturned(pair)[k])) sample.mistakes.push_back(body_space_arm[k]);
  return sample;
}

/// The K of a part beside J M^-1 J^T with the numeric J at every pose.
template <class Fixture>
std::vector<Sample> K_samples() {
  std::vector<Sample> samples;
  visit_poses<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    const auto J = numeric_jacobian(part, pair.body1, pair.body2);
    samples.push_back(K_sample<Fixture>(pose, part, pair, dense_K(J, pair.body1, pair.body2)));
  });
  return samples;
}

/// K against J M^-1 J^T with the numeric J. Fails with a report where they differ.
template <class Fixture>
void check_K() {
  check(Fixture::K, K_report(row_names<Fixture>(), K_samples<Fixture>(), K_tolerance));
}
/// K against the one computed by hand at the pose of the text; the other poses help to explain.
template <class Fixture, int N>
void check_K(const typename Fixture::Part& part, const Pair& pair, const Matrix<N>& by_hand) {
  const Sample paper = K_sample<Fixture>(pencil_and_paper, part, pair, by_hand);
  std::vector<Sample> samples{paper};
  if (!close(paper.yours, paper.right, K_tolerance))
    for (const Sample& sample : K_samples<Fixture>()) samples.push_back(sample);
  check(Fixture::K, K_report(row_names<Fixture>(), samples, K_tolerance));
}

}  // namespace joints::testing
