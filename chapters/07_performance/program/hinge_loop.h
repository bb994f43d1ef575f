// The loop of chapter 7's program: hinges only, moved by your own four functions. Given, there is
// nothing to edit here.
#pragma once

#include <algorithm>

#include "chapters/07_performance/program/columns.h"
#include "engine/simd/lanes.h"

/// \addtogroup chapter7
/// @{
namespace joints {

/// Every joint by itself, in the order of the list: one lane.
inline Groups one_by_one(const std::vector<int>& order) {
  Groups groups;
  for (const int link : order) groups.push_back({link});
  return groups;
}

/// Colour after colour, `width` joints at a time; with a width of 1 the same order, one at a time.
/// \throws std::invalid_argument for a colour that cannot be one
inline Groups by_colour(const std::vector<int>& colours, int width) {
  Groups groups;
  std::vector<int> open;  // of each colour, the group that still has room, or -1
  for (const int colour : colours) {
    require(colour >= 0 && colour < int(colours.size()),
            "colours_of: a colour must be at least 0 and less than there are joints");
    open.resize(std::max(open.size(), std::size_t(colour) + 1), -1);
  }
  for (int colour = 0; colour < int(open.size()); ++colour)
    for (std::size_t link = 0; link < colours.size(); ++link) {
      if (colours[link] != colour) continue;
      if (open[colour] < 0 || int(groups[open[colour]].size()) == width) {
        open[colour] = int(groups.size());
        groups.push_back({});
      }
      groups[open[colour]].push_back(int(link));
    }
  return groups;
}

/// The first joint of every chain, then the second of every chain, and so on, `width` chains at a
/// time; with a width of 1 the same order, one at a time: interleaved chains.
/// \param chains how many \param length joints of each, which stand in the list in a row
inline Groups a_chain_a_lane(int chains, int length, int width) {
  Groups groups;
  for (int k = 0; k < length; ++k)
    for (int first = 0; first < chains; first += width) {
      groups.push_back({});
      for (int chain = first; chain < std::min(chains, first + width); ++chain)
        groups.back().push_back(chain * length + k);
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

  std::vector<Body> bodies;        ///< those that the links name
  std::vector<BodyPair> links;     ///< a hinge each
  std::vector<Hinge> hinges;       ///< their geometry
  Groups groups;                   ///< who comes with whom, and when; at most `width` in each
  vec3 gravity{0, real(-9.81), 0};  ///< [m/s^2]
  int iterations = 30;             ///< iterations a step
  real relaxation = 1;             ///< over-relaxation: factor of every impulse [1], below 2
  bool once_a_step = true;         ///< false: prepare anew before every solve

  /// Forces, preparation, iterations, places. \param h the step [s]
  void step(real h) {
    for (Body& body : bodies) integrate_forces(body, gravity, h);
    arrange();
    records_.resize(bodies.size() + 1);  // the last one belongs to lanes that are not used
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Body& body = bodies[k];
      records_[k] = {triple(body.v), body.inverse_mass, triple(body.w), 0};
    }
    for_each_in_columns([](real& column, real& record) { column = record; });
    numbers_.resize(groups.size());
    ends_.resize(groups.size());
    for (std::size_t k = 0; k < groups.size(); ++k) prepare_group(k, h);
    for (int iteration = 0; iteration < iterations; ++iteration)
      for (std::size_t k = 0; k < groups.size(); ++k) {
        if (!once_a_step) prepare_group(k, h);
        visit(k);
      }
    for_each_in_columns([](real& column, real& record) { record = column; });
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      Body& body = bodies[k];
      if (body.is_static()) continue;
      body.v = vec3(records_[k].v.x, records_[k].v.y, records_[k].v.z);
      body.w = vec3(records_[k].w.x, records_[k].w.y, records_[k].w.z);
      integrate_pose(body, h);
    }
  }

  /// Gap of a hinge [m].
  real gap(std::size_t k) const {
    return length(hinges[k].point.error(bodies[links[k].body1], bodies[links[k].body2]));
  }

  /// What the last step's iterations left: the greatest |bias + J V| of any row of any hinge, with
  /// the velocities after them [m/s for the point's rows, rad/s for the axis' rows].
  real largest_error() const {
    real largest = 0;
    for (std::size_t group = 0; group < groups.size(); ++group)
      for (std::size_t lane = 0; lane < groups[group].size(); ++lane) {
        const HingeNumbers<real> one = numbers_of(group, lane);
        const BodyPair& link = links[std::size_t(groups[group][lane])];
        const Velocities<real> &body1 = records_[link.body1], &body2 = records_[link.body2];
        const Triple<real> unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int i = 0; i < 5; ++i) {  // row after row of J, each with what the bodies do
          const Triple<real> v = i < 3 ? unit[i] : Triple<real>{0, 0, 0};
          const Triple<real> w1 = i < 3 ? cross(one.r1, v) : one.axis_row[i - 3];
          const Triple<real> w2 = i < 3 ? cross(one.r2, v) : one.axis_row[i - 3];
          const real rate = dot(v, body2.v) + dot(w2, body2.w) - dot(v, body1.v) - dot(w1, body1.w);
          largest = std::max(largest, std::abs(one.bias[i] + rate));
        }
      }
    return largest;
  }

 private:
  static constexpr std::size_t numbers_each = sizeof(HingeNumbers<real>) / sizeof(real);

  // The records of a group's bodies.
  struct Ends {
    int body1[width], body2[width];
  };

  // With groups that are new: can the velocities stand in columns?
  void arrange() {
    if (width == 1 || (groups == arranged_ && !groups.empty())) return;
    arranged_ = groups;
    columns_ = columns_of(groups, links, bodies, width);
    in_columns_.assign(columns_ ? columns_->body.size() / width : 0, Velocities<Number>{});
  }

  // Every number that a column has of a body, beside the same one of the body's record.
  template <class F>
  void for_each_in_columns(const F& f) {
    if (!columns_) return;
    for (std::size_t k = 0; k < columns_->body.size(); ++k) {
      if (columns_->body[k] < 0) continue;
      real* const column = reinterpret_cast<real*>(&in_columns_[k / width]) + k % width;
      real* const record = reinterpret_cast<real*>(&records_[std::size_t(columns_->body[k])]);
      for (int n = 0; n < 8; ++n) f(column[n * width], record[n]);
    }
  }

  // What the iterations read of a hinge.
  void prepare(std::size_t k, real h, HingeNumbers<real>& out) const {
    const Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
    hoist(hinges[k], body1, body2, h, out);
    Matrix<5> K = whole_K(out, body1.inverse_mass, body2.inverse_mass);
    invert_symmetric(K[0].data(), 5);
    for (int i = 0; i < 5; ++i)
      for (int j = i; j < 5; ++j) out.inverse_K[out.place(i, j)] = relaxation * K[i][j];
  }

  // The same for a group: each hinge's numbers into its lane, zeros into a lane without a hinge.
  void prepare_group(std::size_t group, real h) {
    const std::vector<int>& members = groups[group];
    Ends& ends = ends_[group];
    for (int lane = 0; lane < width; ++lane) {
      const bool used = lane < int(members.size());
      const std::size_t k = used ? std::size_t(members[std::size_t(lane)]) : 0;
      ends.body1[lane] = used ? links[k].body1 : int(bodies.size());
      ends.body2[lane] = used ? links[k].body2 : int(bodies.size());
      if constexpr (width == 1) {
        prepare(k, h, numbers_[group]);
      } else {
        HingeNumbers<real> one{};
        if (used) prepare(k, h, one);
        const real* const from = reinterpret_cast<const real*>(&one);
        real* const to = reinterpret_cast<real*>(&numbers_[group]);
        for (std::size_t n = 0; n < numbers_each; ++n) to[n * width + std::size_t(lane)] = from[n];
      }
    }
  }

  // The numbers of one hinge out of its lane.
  HingeNumbers<real> numbers_of(std::size_t group, std::size_t lane) const {
    HingeNumbers<real> one;
    const real* const from = reinterpret_cast<const real*>(&numbers_[group]);
    real* const to = reinterpret_cast<real*>(&one);
    for (std::size_t n = 0; n < numbers_each; ++n) to[n] = from[n * width + lane];
    return one;
  }

  // One solve of a group.
  void visit(std::size_t group) {
    const Ends& ends = ends_[group];
    if constexpr (width == 1) {
      solve(numbers_[group], records_[ends.body1[0]], records_[ends.body2[0]]);
    } else if (columns_) {
      solve(numbers_[group], in_columns_[std::size_t(columns_->end1[group])],
            in_columns_[std::size_t(columns_->end2[group])]);
    } else {
      Velocities<Number> body1, body2;
      load(records_.data(), ends.body1, body1);
      load(records_.data(), ends.body2, body2);
      solve(numbers_[group], body1, body2);
      store(records_.data(), ends.body1, body1);
      store(records_.data(), ends.body2, body2);
    }
  }

  std::vector<Velocities<real>> records_;
  std::vector<HingeNumbers<Number>> numbers_;
  std::vector<Ends> ends_;
  Groups arranged_;                // those that columns_ belong to
  std::optional<Columns> columns_;  // none: a group's bodies are transposed there and back
  std::vector<Velocities<Number>> in_columns_;
};

}  // namespace joints
/// @}
