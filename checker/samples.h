// A J or a K at some poses beside the right one, and the report about it.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "checker/numeric.h"

namespace joints::testing {

using Numbers = std::vector<double>;

/// The four kinds of poses at which a part is checked, what they are for, the one in the text, and
/// the one of check_part().
inline constexpr std::array pose_names{"upright", "turned", "moved", "broken", "pencil and paper",
                                       "closed"};
inline constexpr std::array pose_words{"body 1 is not turned", "both bodies are turned",
                                       "far along what the joint leaves free", "C is not 0",
                                       "Numbers, in the text", "C is 0"};
inline constexpr int broken_pose = 3, pencil_and_paper = 4, closed_pose = 5;
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
  long own = 0;  ///< how many of these, the first, are the fixture's own words
  std::vector<std::string> slips = {};  ///< asked where no mistake explains all samples
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
/// K of a part may be a scalar or a GLM type, too.
inline Matrix<1> to_matrix(real a) { return {{{{a}}}}; }
inline Matrix<3> to_matrix(const mat3& a) {
  const mat3 t = transpose(a);  // GLM's columns become rows
  return {{{{t[0].x, t[0].y, t[0].z}, {t[1].x, t[1].y, t[1].z}, {t[2].x, t[2].y, t[2].z}}}};
}
template <int N>
const Matrix<N>& to_matrix(const Matrix<N>& a) { return a; }

template <int N>
Numbers flat(const Matrix<N>& K) {
  Numbers out;
  for (const auto& row : K.m)
    for (real number : row) out.push_back(double(number));
  return out;
}
bool close(const Numbers& a, const Numbers& b, double tolerance);
/// The same for numbers that may be infinite or NaN in both.
bool same_numbers(const Numbers& a, const Numbers& b, double tolerance);

/// Mistakes in words, each with the numbers that it gives.
using Wrong = std::vector<std::pair<std::string, Numbers>>;

/// A part as numbers, at any pose of its bodies.
struct Seen {
  std::function<Numbers(const Pair&)> J, K;              ///< yours
  std::function<Numbers(const Pair&)> slope;             ///< J by central differences
  std::function<Wrong(const Pair&)> mistakes = nullptr;    ///< the fixture's own, of J
  std::function<Wrong(const Pair&)> K_mistakes = nullptr;  ///< and of K
  PoseWords broken = {};
  std::function<Wrong(const Pair&)> slips = nullptr, K_slips = nullptr;
};
Sample jacobian_sample(int pose, const Seen& part, const Pair& pair, const Numbers& right);
Sample K_sample(int pose, const Seen& part, const Pair& pair, const Numbers& right);
/// J M^-1 J^T of a J with 12 numbers a row.
Numbers whole_K(const Numbers& J, const Pair& pair);

}  // namespace joints::testing
