// The order in which the blocks of a system are eliminated, and the fill-in, which depend only on
// the bodies that the blocks connect. Given, there is nothing to edit here.
#pragma once

#include <array>
#include <tuple>
#include <vector>

/// \addtogroup chapter9
/// @{
namespace joints {

/// A block of a system's shape: a joint, not an optional row beside it.
struct ShapeBlock {
  int link = 0;                  ///< blocks between the same two bodies form a link
  std::array<int, 2> columns{};  ///< its bodies, numbered within the system
  std::array<bool, 2> moves{};   ///< whether they can move
  int rows = 0;                  ///< number of its rows without bounds
  bool operator==(const ShapeBlock&) const = default;  ///< all members are equal
  bool operator<(const ShapeBlock& other) const {      ///< by all members
    return std::tie(link, columns, moves, rows) <
           std::tie(other.link, other.columns, other.moves, other.rows);
  }
};

/// How a system with a given shape is eliminated. Optional rows beside a joint change nothing of
/// it: they couple the same two bodies.
struct EliminationPlan {
  std::vector<int> links;        ///< in the order of elimination
  /// For each of them the places in that order of all its neighbours that are eliminated later,
  /// including those that become neighbours by elimination.
  std::vector<std::vector<int>> later;
  int rows = 0;                  ///< of the shape, without bounds
  double multiplications = 0;    ///< of their factorisation, about (Eq. 9-6)

  /// Plans the elimination of a shape. \param shape its blocks, by links
  explicit EliminationPlan(const std::vector<ShapeBlock>& shape);
};

}  // namespace joints
/// @}
