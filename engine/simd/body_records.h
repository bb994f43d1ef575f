// The velocities during the iterations: one record per body or, if every body keeps its lane,
// columns.
#pragma once

#include <utility>

#include "engine/body.h"
#include "engine/simd/arrange.h"
#include "engine/simd/records.h"

/// \addtogroup world
/// @{
namespace joints {

/// The velocities that the iterations change, and where each group finds those of its bodies.
class BodyRecords {
 public:
  /// Allocates the records and computes BodyView::ends. A static body gets a record for each pair:
  /// what overflows in one never reaches another. \param groups of at most `width` pairs
  /// \param columns columns_of() these groups, if any \param moves for each body, if it can move
  void arrange(const Groups& groups, const std::vector<BodyPair>& pairs,
               const std::optional<Columns>& columns, const std::vector<bool>& moves, int width) {
    columns_ = columns;
    bodies_ = int(moves.size());  // the record with this number is a dummy for unused lanes
    copies_.clear();
    ends_.clear();
    const auto record_of = [&](int body) {
      if (moves[std::size_t(body)]) return body;
      copies_.push_back(body);
      return bodies_ + int(copies_.size());
    };
    for (std::size_t k = 0; k < groups.size(); ++k)
      for (int BodyPair::*end : {&BodyPair::body1, &BodyPair::body2})
        if (columns)
          ends_.push_back(columns->ends[k].*end);
        else
          for (std::size_t lane = 0; lane < std::size_t(width); ++lane)
            ends_.push_back(lane < groups[k].size() ? record_of(pairs[groups[k][lane]].*end)
                                                    : bodies_);
    records_.assign(columns ? columns->bodies.size() : std::size_t(bodies_) + 1 + copies_.size(),
                    {});
  }
  /// Copies the bodies' velocities into the records. \param body function from index to body
  template <class F>
  void take(const F& body) {
    const auto record_of = [](const Body& from) -> Velocities<real> {
      return {triple(from.v), from.inverse_mass, triple(from.w), 0};
    };
    if (!columns_) {
      for (int k = 0; k < bodies_; ++k) records_[k] = record_of(body(k));
      for (std::size_t k = 0; k < copies_.size(); ++k)
        records_[std::size_t(bodies_) + 1 + k] = record_of(body(copies_[k]));
    } else
      for (std::size_t k = 0; k < records_.size(); ++k)
        if (const int index = columns_->bodies[k]; index >= 0)
          scatter(record_of(body(index)), column(k), int(k % lane_count));
  }
  /// Copies the velocities back to the bodies that are not static.
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
        if (const int index = columns_->bodies[k]; index >= 0)
          give(gather<Velocities<real>>(column(k), int(k % lane_count)), body(index));
  }

  /// The columns, if the records are arranged in columns; else record k belongs to body k,
  /// and static bodies have more behind those.
  const std::optional<Columns>& columns() const { return columns_; }
  /// Pointers to the records, for an iteration.
  BodyView view() { return {records_.data(), ends_.data(), columns_.has_value()}; }
  const std::vector<int>& ends() const { return ends_; }  ///< BodyView::ends

 private:
  // The column that contains record `number`.
  const Velocities<LaneNumber>& column(std::size_t number) const {
    return reinterpret_cast<const Velocities<LaneNumber>*>(records_.data())[number / lane_count];
  }
  Velocities<LaneNumber>& column(std::size_t number) {
    return const_cast<Velocities<LaneNumber>&>(std::as_const(*this).column(number));
  }

  std::vector<Velocities<real>> records_;
  std::vector<int> ends_;
  std::vector<int> copies_;  // the static body of each record behind the dummy
  std::optional<Columns> columns_;
  int bodies_ = 0;
};

}  // namespace joints
/// @}
