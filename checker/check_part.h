// The checker for parts of your own: do C, J and K belong together, at which poses, and what is
// probably wrong? As text and as data. The workbook's own tests use the same reports.
#pragma once

#include "checker/samples.h"
#include "engine/parts/part.h"

/// \defgroup checker Checker
/// \brief Compares the J and the K of any part with finite differences of its C, in words.
/// @{
namespace joints {

/// Repeatable random numbers for a pose, the same on every machine.
using PoseRandom = testing::Random;
/// Two bodies in a pose at which a part is checked.
using PosePair = testing::Pair;

/// The answer to one question about a part.
struct Finding {
  std::string question;  ///< a word: poses, numbers, J, broken J, form, rank, K, momentum, power or
                         ///< turns
  bool holds = true;     ///< false: the part is wrong here
  int right = 0;         ///< poses at which it holds
  int poses = 0;         ///< poses at which it was asked
  double worst = 0;      ///< the largest deviation found, in the units of the compared numbers
  std::string words;     ///< a sentence, or a report of several lines
  bool note = false;     ///< true: no mistake, but it limits the poses in which the part works
};

/// All answers about a part.
struct PartReport {
  std::vector<Finding> findings;  ///< one per question, in the order in which they were asked
  /// True if every finding holds.
  bool good() const;
  /// The finding with that name. \throws std::invalid_argument if there is none
  const Finding& operator[](const std::string& question) const;
  /// The findings, those that do not hold in full, for a terminal: lines of at most 76 columns.
  std::string text() const;
};

/// A part as functions of two bodies, so that its type is not needed.
struct PartFunctions {
  int rows = 1;            ///< 1 to 6
  bool one_sided = false;  ///< the last row holds C >= 0
  Form form = Form::any;   ///< the form that the part promises
  std::function<testing::Numbers(const PosePair&)> C;  ///< `rows` numbers
  std::function<testing::Numbers(const PosePair&)> J;  ///< 12 numbers per row: v1, w1, v2, w2
  std::function<testing::Numbers(const PosePair&)> K;  ///< rows x rows numbers, or empty
  std::vector<std::string> names = {};  ///< of the rows, for the report; empty: C.1, C.2, ...
};

/// Makes the poses of a check. It need not close the joint: the checker moves the bodies until C
/// is 0, by differences alone, and it also asks at poses where C is not 0. Make the poses in which
/// the part is used: near half a turn an angle has no slope, so a part with a HingeAngle needs axes
/// within about two radians of each other.
using PoseMaker = std::function<PosePair(PoseRandom&)>;
/// Two bodies of different mass and uneven inertia within 1 m of each other, with any orientations.
PosePair any_pose(PoseRandom& random);

/// How a part is checked.
struct CheckSettings {
  int poses = 40;                  ///< how many are drawn
  unsigned seed = 1;               ///< of the first pose
  bool exact_when_broken = false;  ///< true: J must be the slope of C also where C is not 0
  std::vector<std::string> names = {};  ///< of the rows, for the report
};

/// Checks a part that is given as functions. \param pose makes the poses
PartReport check_functions(const PartFunctions& part, const PoseMaker& pose = any_pose,
                           const CheckSettings& settings = {});

/// The functions of a part.
template <Part P>
PartFunctions functions_of(const P& part) {
  PartFunctions out{P::rows, P::one_sided, P::form, nullptr, nullptr, nullptr, {}};
  out.C = [part](const PosePair& at) {
    const Vector<P::rows> C = to_vector(part.error(at.body1, at.body2));
    return testing::Numbers(C.begin(), C.end());
  };
  out.J = [part](const PosePair& at) {
    return testing::flat(to_jacobian(part.jacobian(at.body1, at.body2)));
  };
  if constexpr (requires(const Body& body) { part.K(body, body); })
    out.K = [part](const PosePair& at) {
      return testing::flat(testing::to_matrix(part.K(at.body1, at.body2)));
    };
  return out;
}

/// Checks a part: whether J is the slope of C, whether its rows are independent, whether they have
/// the form that it promises, whether K = J M^-1 J^T (if it has one), and whether its forces
/// conserve momentum and do no work on a motion that keeps C. A note says whether C jumps while a
/// body is turned once. Give the part uneven numbers, such as an anchor away from both centres,
/// because a lever of length 0 hides mistakes.
///
/// Look first at the number of poses. J that is right at all of them is right; if it is wrong only
/// where C is not 0, it is an approximation that later steps correct. If rows are singular at some
/// poses, decide how the joint behaves there.
/// \param pose makes the poses at which it is checked
template <Part P>
PartReport check_part(const P& part, const PoseMaker& pose = any_pose,
                      const CheckSettings& settings = {}) {
  return check_functions(functions_of(part), pose, settings);
}

}  // namespace joints
/// @}
