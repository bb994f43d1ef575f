// The four lines by which two bodies are given an impulse, v1, w1, v2 and w2, and possible mistakes
// in one of them, in both of a body, in both of a kind, or in all.
#pragma once

#include "checker/report.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

using FourVectors = std::array<vec3, 4>;  ///< of v1, w1, v2, w2

struct ImpulseLines {
  std::array<mat3, 4> inverse_M, local_M;  ///< 1/m and I^-1, and the same in body space
  FourVectors before;                      ///< the velocities
  std::array<real, 4> factor{1, 1, 1, 1};
  std::array<bool, 4> set{};  ///< the velocity is replaced, and nothing is added to it

  ImpulseLines() = default;
  explicit ImpulseLines(const Pair& pair)
      : before{pair.body1.v, pair.body1.w, pair.body2.v, pair.body2.w} {
    for (int k = 0; k < 4; ++k) {
      Body body = k < 2 ? pair.body1 : pair.body2;
      for (std::array<mat3, 4>* M : {&inverse_M, &local_M}) {
        (*M)[std::size_t(k)] = k % 2 ? inverse_inertia(body) : mat3(body.inverse_mass);
        body.q = quat(1, 0, 0, 0);
      }
    }
  }
  /// How much the four velocities change by J^T lambda.
  FourVectors changes(const FourVectors& impulse) const {
    FourVectors out;
    for (std::size_t k = 0; k < 4; ++k)
      out[k] = inverse_M[k] * (factor[k] * impulse[k]) - (set[k] ? before[k] : vec3(0));
    return out;
  }
};

/// J^T lambda.
template <int N>
FourVectors impulses(const Jacobian<N>& J, const Vector<N>& lambda) {
  FourVectors out;
  out.fill(vec3(0));
  for (int i = 0; i < N; ++i) {
    const vec3* const blocks[] = {&J[i].v1, &J[i].w1, &J[i].v2, &J[i].w2};
    for (std::size_t k = 0; k < 4; ++k) out[k] += lambda[std::size_t(i)] * *blocks[k];
  }
  return out;
}

/// \param body_space are there inertias in body space that could be taken?
template <class Reference>
Pieces<Reference> wrong_lines(ImpulseLines Reference::*lines, bool body_space = true) {
  Pieces<Reference> out;
  const char* const names[] = {"v1", "w1", "v2", "w2"};
  for (const int which : {15, 5, 10, 3, 12, 1, 2, 4, 8}) {
    std::vector<std::string> who;
    for (int k = 0; k < 4; ++k)
      if (which >> k & 1) who.push_back(names[k]);
    const std::string all = joined(who);
    const bool v = which & 5, w = which & 10;
    const std::string kind = v && w ? "inverse mass and inverse inertia"
                             : v    ? "inverse mass"
                                    : "inverse inertia";
    const auto add = [&](const std::string& words, auto change) {
      out.push_back({words, [=](Reference& t) {
                       for (std::size_t k = 0; k < 4; ++k)
                         if (which >> k & 1) change(t.*lines, k);
                     }});
    };
    using L = ImpulseLines;
    add(all + (who.size() == 1 ? " is" : " are") + " never changed",
        [](L& l, std::size_t k) { l.factor[k] = 0; });
    add("#w-body-2-taken the sign of the change of " + all,
        [](L& l, std::size_t k) { l.factor[k] = -1; });
    add("the change of " + all + " is doubled", [](L& l, std::size_t k) { l.factor[k] = 2; });
    add("the change of " + all + " is halved",
        [](L& l, std::size_t k) { l.factor[k] = real(0.5); });
    add(all + (who.size() == 1 ? " takes" : " take") +
            " a new value where it is added to the old one: += and not =",
        [](L& l, std::size_t k) { l.set[k] = true; });
    add("the " + kind + (v && w ? " are" : " is") + " missing in " + all,
        [](L& l, std::size_t k) { l.inverse_M[k] = mat3(1); });
    if (who.size() == 1)
      add("the " + kind + " of the other body in " + all, [](L& l, std::size_t k) {
        l.inverse_M[k] = L(l).inverse_M[(k + 2) % 4];
      });
    if (!v && body_space)
      add("body-space inertia in " + all + ": take inverse_inertia(body)",
          [](L& l, std::size_t k) { l.inverse_M[k] = l.local_M[k]; });
  }
  const char* const exchanged[] = {"inverse mass of the other body in v1 and v2",
                                   "inverse inertia of the other body in w1 and w2",
                                   "inverse mass and inertia of the other body in all four lines"};
  for (const int which : {0, 1, 2})
    out.push_back({std::string("the ") + exchanged[which], [=](Reference& t) {
                     auto& M = (t.*lines).inverse_M;
                     if (which != 1) std::swap(M[0], M[2]);
                     if (which != 0) std::swap(M[1], M[3]);
                   }});
  return out;
}

}  // namespace joints::testing
