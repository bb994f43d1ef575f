// The numeric checker: a part against its numeric reference at four kinds of poses, with a report
// that teaches. A part comes with a fixture, a struct of about ten lines:
//
//   struct PointFixture {
//     using Part = Point;
//     using Exercise = Point;                               // its functions are exercises
//     static constexpr Subject J{"2.1", "J of the ball joint"}, K{"2.2", "K of the ball joint"};
//     static constexpr std::array rows{"C.x", "C.y", "C.z"};
//     static constexpr bool exact_when_broken = true;       // is J exact where C is not 0?
//     static Part make(const Pair&);                        // C = 0 for this pair
//     static void move_freely(const Part&, Pair&, Random&); // C stays 0
//   };
#pragma once

#include "checker/samples.h"
#include "tests/checker/known.h"
#include "tests/checker/proved.h"

namespace joints::testing {

/// What is being checked: the exercise (or "" where it is none) and its name in words.
struct Subject {
  const char* id;
  const char* words;
  int region = 1;  ///< which of the regions that share the id
  const char* given = "";  ///< the arguments of the case, for the report
};

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
/// The same where it is known already what explains yours: the first of these words.
void expect_or_say(const Subject& subject, const std::string& entry, double yours,
                   double expected, double tolerance, const std::vector<std::string>& words);
void expect_or_say(const Subject& subject, const std::string& entry, const vec3& yours,
                   const vec3& expected, double tolerance, const std::vector<std::string>& words);

/// The numbers of a case, of which the report shows those that are wrong. \param words what the
/// case is, or "" \param likely the mistakes that explain them, the first is named
void expect(const Subject& subject, const std::string& words,
            const std::vector<std::string>& entries, const Numbers& yours,
            const Numbers& expected, double tolerance, const std::vector<std::string>& likely);

/// Fails with a report unless it is empty.
void check(const Subject& subject, const std::string& report);
/// The same, and counts the samples if it is empty. \param what "Jacobians", for the summary
inline void check(const Subject& subject, const std::string& report, const std::string& what,
                  const std::vector<Sample>& samples) {
  if (report.empty()) {
    proved(what.c_str());
    proved(("poses of " + what).c_str(), long(samples.size()));
  }
  check(subject, report);
}
/// Fails a test with the exercise's file, line and next command under the words.
[[noreturn]] void fail(const Subject& subject, const std::string& words);

// ---- parts --------------------------------------------------------------------------------------

/// What the known mistakes of a subject's region make of a part.
/// \tparam Function of the exercise's part and two bodies
template <class Function, class Part, class Flat>
Wrong known_of(const Subject& subject, const Part& part, const Pair& pair, bool slip, Flat flat) {
  Wrong out;
  for (const auto& [words, wrong] : known_mistakes<Function>(subject.id, subject.region, slip))
    out.push_back({words, flat(wrong(part, pair.body1, pair.body2))});
  return out;
}

/// \tparam Fixture may name the part whose functions are exercises, as `Exercise`: their known
/// mistakes are tried. It may have others in a function `mistakes(part, pair)`
template <class Fixture>
Seen seen(const typename Fixture::Part& part) {
  Seen out;
  out.J = [part](const Pair& at) { return flat(to_jacobian(part.jacobian(at.body1, at.body2))); };
  if constexpr (requires(const Pair& at) { part.K(at.body1, at.body2); })
    out.K = [part](const Pair& at) { return flat(to_matrix(part.K(at.body1, at.body2))); };
  out.slope = [part](const Pair& at) { return flat(numeric_jacobian(part, at.body1, at.body2)); };
  if constexpr (requires(const Pair& at) { Fixture::mistakes(part, at); })
    out.mistakes = [part](const Pair& at) {
      Wrong wrong;
      for (const auto& [words, J] : Fixture::mistakes(part, at)) wrong.push_back({words, flat(J)});
      return wrong;
    };
  if constexpr (requires { typename Fixture::Exercise; }) {
    using Of = typename Fixture::Exercise;
    using Rows = decltype(part.jacobian(Body{}, Body{}))(const Of&, const Body&, const Body&);
    const auto asked = [part](bool slip) {
      return [part, slip](const Pair& at) {
        return known_of<Rows>(Fixture::J, part, at, slip,
                              [](const auto& J) { return flat(to_jacobian(J)); });
      };
    };
    out.mistakes = asked(false), out.slips = asked(true);
  }
  if constexpr (requires { typename Fixture::Exercise; Fixture::K; }) {
    using Of = typename Fixture::Exercise;
    using K = decltype(part.K(Body{}, Body{}))(const Of&, const Body&, const Body&);
    const auto asked = [part](bool slip) {
      return [part, slip](const Pair& at) {
        return known_of<K>(Fixture::K, part, at, slip,
                           [](const auto& K) { return flat(to_matrix(K)); });
      };
    };
    out.K_mistakes = asked(false), out.K_slips = asked(true);
  }
  if constexpr (requires { Fixture::broken; }) out.broken = Fixture::broken;
  return out;
}

/// Calls `look(pose, part, pair)` at every pose of the fixture's part where J is exact.
template <class Fixture>
void for_each_pose(
    const std::function<void(int, const typename Fixture::Part&, const Pair&)>& look) {
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

/// The J of a part beside the numeric one at every pose.
template <class Fixture>
std::vector<Sample> jacobian_samples() {
  std::vector<Sample> samples;
  for_each_pose<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    const Seen as_numbers = seen<Fixture>(part);
    samples.push_back(jacobian_sample(pose, as_numbers, pair, as_numbers.slope(pair)));
  });
  return samples;
}

/// J against central differences of C. Fails with a report where they differ.
template <class Fixture>
void check_jacobian() {
  const std::vector<Sample> samples = jacobian_samples<Fixture>();
  check(Fixture::J, jacobian_report(row_names<Fixture>(), samples, difference_tolerance),
        "Jacobians", samples);
}
/// J against the one computed by hand at the pose of the text; the other poses help to explain.
template <class Fixture, int N>
void check_jacobian(const typename Fixture::Part& part, const Pair& pair,
                    const Jacobian<N>& by_hand) {
  const Sample paper = jacobian_sample(pencil_and_paper, seen<Fixture>(part), pair, flat(by_hand));
  std::vector<Sample> samples{paper};
  if (!close(paper.yours, paper.right, difference_tolerance))
    for (const Sample& sample : jacobian_samples<Fixture>()) samples.push_back(sample);
  check(Fixture::J, jacobian_report(row_names<Fixture>(), samples, difference_tolerance),
        "Jacobians", samples);
}

/// The K of a part beside J M^-1 J^T with the numeric J at every pose.
template <class Fixture>
std::vector<Sample> K_samples() {
  std::vector<Sample> samples;
  for_each_pose<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    const Seen as_numbers = seen<Fixture>(part);
    samples.push_back(
        K_sample(pose, as_numbers, pair, whole_K(as_numbers.slope(pair), pair)));
  });
  return samples;
}

/// K against J M^-1 J^T with the numeric J. Fails with a report where they differ.
template <class Fixture>
void check_K() {
  const std::vector<Sample> samples = K_samples<Fixture>();
  check(Fixture::K, K_report(row_names<Fixture>(), samples, K_tolerance), "effective masses",
        samples);
}
/// K against the one computed by hand at the pose of the text; the other poses help to explain.
template <class Fixture, int N>
void check_K(const typename Fixture::Part& part, const Pair& pair, const Matrix<N>& by_hand) {
  const Sample paper = K_sample(pencil_and_paper, seen<Fixture>(part), pair, flat(by_hand));
  std::vector<Sample> samples{paper};
  if (!close(paper.yours, paper.right, K_tolerance))
    for (const Sample& sample : K_samples<Fixture>()) samples.push_back(sample);
  check(Fixture::K, K_report(row_names<Fixture>(), samples, K_tolerance), "effective masses",
        samples);
}

}  // namespace joints::testing
