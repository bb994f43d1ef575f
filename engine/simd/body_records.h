// Where the velocities stand during the iterations: a record a body or, where every body keeps its
// lane, in columns.
#pragma once

#include <utility>

#include "engine/body.h"
#include "engine/simd/arrange.h"
#include "engine/simd/records.h"

/// \addtogroup world
/// @{
namespace joints {

/// The velocities that the iterations change, and which of them each group's bodies have.
class BodyRecords {
 public:
  /// \param groups of at most `width` pairs \param columns columns_of the groups, if there are any
  /// \param count how many bodies there are
  void arrange(const Groups& groups, const std::vector<BodyPair>& pairs,
               const std::optional<Columns>& columns, int count, int width) {
    columns_ = columns;
    bodies_ = count;  // one more record belongs to lanes that are not used
    records_.assign(columns ? columns->bodies.size() : std::size_t(count) + 1, {});
    ends_.clear();
    for (std::size_t k = 0; k < groups.size(); ++k)
      for (int BodyPair::*end : {&BodyPair::body1, &BodyPair::body2})
        if (columns)
          ends_.push_back(columns->ends[k].*end);
        else
          for (std::size_t lane = 0; lane < std::size_t(width); ++lane)
            ends_.push_back(lane < groups[k].size() ? pairs[groups[k][lane]].*end : count);
  }
  /// The bodies' velocities into their records. \param body gives a body by its number
  template <class F>
  void take(const F& body) {
    const auto record_of = [](const Body& from) -> Velocities<real> {
      return {triple(from.v), from.inverse_mass, triple(from.w), 0};
    };
    if (!columns_)
      for (int k = 0; k < bodies_; ++k) records_[k] = record_of(body(k));
    else
      for (std::size_t k = 0; k < records_.size(); ++k)
        if (const int its = columns_->bodies[k]; its >= 0)
          scatter(record_of(body(its)), column(k), int(k % lane_count));
  }
  /// And back to those that move.
  template <class F>
  void give_back(const F& body) const {
    const auto give = [](const Velocities<real>& from, Body& to) {
      if (to.is_static()) return;
      to.v = vec3(from.v.x, from.v.y, from.v.z);
      to.w = vec3(from.w.x, from.w.y, from.w.z);
    };
    if (!columns_)
      for (int k = 0; k < bodies_; ++k) give(records_[k], body(k));
    else
      for (std::size_t k = 0; k < records_.size(); ++k)
        if (const int its = columns_->bodies[k]; its >= 0)
          give(gather<Velocities<real>>(column(k), int(k % lane_count)), body(its));
  }

  /// The columns in which they stand, if they do; else each record has its body's number.
  const std::optional<Columns>& columns() const { return columns_; }
  /// What the iterations work on.
  BodyView view() { return {records_.data(), ends_.data(), columns_.has_value()}; }
  const std::vector<int>& ends() const { return ends_; }  ///< BodyView::ends

 private:
  // The column in which a record stands.
  const Velocities<LaneNumber>& column(std::size_t number) const {
    return reinterpret_cast<const Velocities<LaneNumber>*>(records_.data())[number / lane_count];
  }
  Velocities<LaneNumber>& column(std::size_t number) {
    return const_cast<Velocities<LaneNumber>&>(std::as_const(*this).column(number));
  }

  std::vector<Velocities<real>> records_;
  std::vector<int> ends_;
  std::optional<Columns> columns_;
  int bodies_ = 0;
};

}  // namespace joints
/// @}
