// A loop over hinges only, moved by the four functions of chapter 7's exercises. Given, there is
// nothing to edit here.
#pragma once

#include <algorithm>
#include <numeric>

#include "chapters/07_performance/performance.h"
#include "engine/kernels.h"
#include "engine/simd/body_records.h"
#include "engine/simd/lanes.h"
#include "engine/simd/places.h"

/// \addtogroup chapter7
/// @{
namespace joints {

/// For each body, whether it can move.
inline std::vector<bool> moving(const std::vector<Body>& bodies) {
  std::vector<bool> moves;
  for (const Body& body : bodies) moves.push_back(!body.is_static());
  return moves;
}

/// The order of the solves: hinges in groups that are solved side by side, one group after the
/// other. Of each group the hinge of every lane, -1: none.
using Groups = std::vector<int>;
/// Instead of such a list: the first hinge of every island, then the second of every one; with
/// several lanes each island has a lane of its own.
inline const Groups by_islands{};
/// `count` groups of one hinge each, in order.
inline Groups one_by_one(int count) {
  Groups groups(static_cast<std::size_t>(count));
  std::iota(groups.begin(), groups.end(), 0);
  return groups;
}
/// Colour after colour, at most `width` hinges of one colour in a group.
inline Groups by_colour(const std::vector<int>& colours, int width) {
  Groups groups;
  const int count = colours.empty() ? 0 : 1 + *std::max_element(colours.begin(), colours.end());
  for (int colour = 0; colour < count; ++colour) {
    for (std::size_t k = 0; k < colours.size(); ++k)
      if (colours[k] == colour) groups.push_back(int(k));
    while (groups.size() % std::size_t(width) != 0) groups.push_back(-1);
  }
  return groups;
}

/// Bodies and hinges, and the iterations over them. Number is `real`, one hinge at a time, or
/// Lanes, `width` hinges at a time. It needs the four functions of performance.h and no joint or
/// solver of the engine.
template <class Number>
class HingeLoop {
 public:
  static constexpr int width = int(sizeof(Number) / sizeof(real));  ///< hinges side by side

  std::vector<Body> bodies;        ///< the bodies of the links
  std::vector<BodyPair> links;     ///< one per hinge
  std::vector<Hinge> hinges;       ///< their geometry
  vec3 gravity{0, real(-9.81), 0};  ///< [m/s^2]
  int iterations = 30;             ///< iterations per step
  real relaxation = 1;             ///< over-relaxation: factor of every impulse [1], below 2
  bool once_a_step = true;         ///< false: prepare anew before every solve

  /// Sets the order of the solves. Call it after adding the bodies and the links.
  /// \param groups of `width` lanes, or by_islands
  void arrange(const Groups& groups) {
    const std::vector<bool> moves = moving(bodies);
    const auto slot = [&](int body) { return moves[std::size_t(body)] ? body : -1; };
    std::vector<Member> members;
    for (const BodyPair& link : links)
      members.push_back({{slot(link.body1), slot(link.body2)}});
    if (groups.empty()) {
      Places places;
      places.place(members, moves, width);
      places.append(order_, members, 0);
    } else {
      order_.clear(width, int(bodies.size()));
      for (std::size_t k = 0; k < groups.size(); k += width) order_.append(&groups[k], members);
    }
  }
  const LaneOrder& order() const { return order_; }  ///< the hinges solved together, in order

  /// Forces, preparation, iterations, positions. \param h the step [s]
  void step(real h) {
    for (Body& body : bodies) integrate_forces(body, gravity, h);
    records_.gather(order_, bodies.data());
    const BodyView view = records_.view(order_);
    prepare(h);
    for (int iteration = 0; iteration < iterations; ++iteration)
      for (int k = 0; k < order_.groups(); ++k) {
        if (!once_a_step) prepare_group(k, h);
        with_bodies<Number>(view, k, [&](auto& body1, auto& body2) JOINTS_INLINED {
          solve(numbers_[std::size_t(k)], body1, body2);
        });
      }
    records_.scatter(order_, bodies.data());
    for (Body& one : bodies)
      if (!one.is_static()) integrate_pose(one, h);
  }

  /// Computes the numbers of every group that the iterations of a step read. \param h the step [s]
  void prepare(real h) {
    numbers_.resize(std::size_t(order_.groups()));
    for (int k = 0; k < order_.groups(); ++k) prepare_group(k, h);
  }
  /// The numbers computed by prepare(), group by group.
  const std::vector<HingeNumbers<Number>>& numbers() const { return numbers_; }

  /// Gap of a hinge [m].
  real gap(std::size_t k) const {
    return length(hinges[k].point.error(bodies[links[k].body1], bodies[links[k].body2]));
  }

  /// The errors after the iterations of the last step: bias + J V of every row of every hinge, with
  /// the velocities after them [m/s for the point's rows, rad/s for the axis' rows].
  std::vector<real> errors() const {
    std::vector<real> found;
    for (int group = 0; group < order_.groups(); ++group)
      for (int lane = 0; lane < width; ++lane) {
        const int k = hinge_in(group, lane);
        if (k < 0) continue;
        const auto one = gather<HingeNumbers<real>>(numbers_[std::size_t(group)], lane);
        const BodyPair& link = links[std::size_t(k)];
        const Body &body1 = bodies[link.body1], &body2 = bodies[link.body2];
        const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int i = 0; i < 5; ++i) {  // row after row of J, each times the velocities
          const Triple<real> v = i < 3 ? unit[i] : Triple<real>{0, 0, 0};
          const Triple<real> w1 = i < 3 ? cross(one.r1, v) : one.axis_row[i - 3];
          const Triple<real> w2 = i < 3 ? cross(one.r2, v) : one.axis_row[i - 3];
          const real rate = dot(v, triple(body2.v)) + dot(w2, triple(body2.w)) -
                            dot(v, triple(body1.v)) - dot(w1, triple(body1.w));
          found.push_back(one.bias[i] + rate);
        }
      }
    return found;
  }

 private:
  // Computes the numbers of a group: each hinge's numbers in its lane, zeros in a lane without a
  // hinge. Every K is inverted on lanes, all of a group at once.
  void prepare_group(int group, real h) {
    HingeNumbers<Number>& out = numbers_[std::size_t(group)];
    std::array<Number, 15> K;  // lower triangle
    for (int lane = 0; lane < width; ++lane) {
      HingeNumbers<real> one{};
      std::array<real, 15> lower{};
      if (const int k = hinge_in(group, lane); k >= 0) {
        const BodyPair& link = links[std::size_t(k)];
        const Body &body1 = bodies[link.body1], &body2 = bodies[link.body2];
        hoist(hinges[k], body1, body2, h, one);
        const Matrix<5> all = whole_K(one, body1.inverse_mass, body2.inverse_mass);
        for (int i = 0; i < 5; ++i)
          for (int j = 0; j <= i; ++j) lower[std::size_t(lower_index(i, j))] = all[i][j];
      }
      scatter(one, out, lane);
      scatter(lower, K, lane);
    }
    invert_lower<5>(K.data());
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j <= i; ++j) {
        const Number& entry = K[std::size_t(lower_index(i, j))];
        out.inverse_K[std::size_t(out.place(i, j))] = relaxation * entry;
      }
  }

  int hinge_in(int group, int lane) const {
    return order_.blocks[std::size_t(group * width + lane)];
  }

  LaneOrder order_;
  BodyRecords records_;
  std::vector<HingeNumbers<Number>> numbers_;
};

}  // namespace joints
/// @}
