// The loop of chapter 7's program: hinges only, moved by your own four functions. Given, there is
// nothing to edit here.
#pragma once

#include "chapters/07_performance/performance.h"
#include "engine/simd/body_records.h"
#include "engine/kernels.h"
#include "engine/simd/lanes.h"

/// \addtogroup chapter7
/// @{
namespace joints {

/// For each body, whether it can move.
inline std::vector<bool> moving(const std::vector<Body>& bodies) {
  std::vector<bool> moves;
  for (const Body& body : bodies) moves.push_back(!body.is_static());
  return moves;
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
  /// \param groups at most `width` hinges each, one group after the other
  void arrange(const Groups& groups) {
    groups_ = groups;
    std::optional<Columns> columns;
    const std::vector<bool> moves = moving(bodies);
    if (width > 1) columns = columns_of(groups, islands_of(links, moves), links, width);
    records_.arrange(groups, links, columns, moves, width);
  }
  const Groups& groups() const { return groups_; }  ///< the hinges solved together, in order

  /// Forces, preparation, iterations, positions. \param h the step [s]
  void step(real h) {
    for (Body& body : bodies) integrate_forces(body, gravity, h);
    const auto body = [&](int k) -> Body& { return bodies[std::size_t(k)]; };
    records_.take(body);
    const BodyView view = records_.view();
    prepare(h);
    for (int iteration = 0; iteration < iterations; ++iteration)
      for (std::size_t k = 0; k < groups_.size(); ++k) {
        if (!once_a_step) prepare_group(k, h);
        with_bodies<Number>(view, int(k), [&](auto& body1, auto& body2) JOINTS_INLINED {
          solve(numbers_[k], body1, body2);
        });
      }
    records_.give_back(body);
    for (Body& one : bodies)
      if (!one.is_static()) integrate_pose(one, h);
  }

  /// Computes the numbers of every group that the iterations of a step read. \param h the step [s]
  void prepare(real h) {
    numbers_.resize(groups_.size());
    for (std::size_t k = 0; k < groups_.size(); ++k) prepare_group(k, h);
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
    for (std::size_t group = 0; group < groups_.size(); ++group)
      for (std::size_t lane = 0; lane < groups_[group].size(); ++lane) {
        const auto one = gather<HingeNumbers<real>>(numbers_[group], int(lane));
        const BodyPair& link = links[std::size_t(groups_[group][lane])];
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
  void prepare_group(std::size_t group, real h) {
    HingeNumbers<Number>& out = numbers_[group];
    std::array<Number, 15> K;  // lower triangle
    for (int lane = 0; lane < width; ++lane) {
      HingeNumbers<real> one{};
      std::array<real, 15> lower{};
      if (lane < int(groups_[group].size())) {
        const std::size_t k = std::size_t(groups_[group][lane]);
        const Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
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

  BodyRecords records_;
  std::vector<HingeNumbers<Number>> numbers_;
  Groups groups_;
};

}  // namespace joints
/// @}
