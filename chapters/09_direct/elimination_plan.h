// How the blocks of an island are eliminated: their order, fill-in and closed loops, which depend
// only on the bodies that the blocks connect. Given, there is nothing to edit here.
#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

/// \addtogroup chapter9
/// @{
namespace joints {

/// Makes a vector a copy of another one, with as much room.
template <class Number>
void copy_with_room(const std::vector<Number>& from, std::vector<Number>& to) {
  to.reserve(from.capacity());
  to.assign(from.begin(), from.end());
}
/// Makes a vector of zeros, with room for more than that if it has to grow.
template <class Number>
void zeros(std::vector<Number>& list, std::size_t count) {
  list.resize(count);
  std::fill(list.begin(), list.end(), Number{});
}

/// The bodies and joints of a closed loop.
struct ClosedLoop {
  int bodies = 0;     ///< number of its moving bodies
  int rows = 0;       ///< number of the rows of its joints, without bounded rows
  bool held = false;  ///< whether one of its joints is attached to a static body
  /// Its degrees of freedom in the present pose, without those of the loop as a whole.
  /// \param dependent number of its rows that depend on others
  int motions(int dependent) const { return 6 * (bodies - !held) - rows + dependent; }
};

/// A block of an island's shape: a joint, not an optional row beside it.
struct ShapeBlock {
  int link = 0;                  ///< blocks between the same two bodies form a link
  std::array<int, 2> columns{};  ///< its bodies, numbered within the island
  std::array<bool, 2> moves{};   ///< whether they can move
  int rows = 0;                  ///< number of its rows without bounds
  bool operator==(const ShapeBlock&) const = default;  ///< all members are equal
  bool operator<(const ShapeBlock& other) const {      ///< by all members
    return std::tie(link, columns, moves, rows) <
           std::tie(other.link, other.columns, other.moves, other.rows);
  }
};

/// How an island with a given shape is eliminated. Optional rows beside a joint change nothing of
/// it: they couple the same two bodies.
struct EliminationPlan {
  std::vector<int> links;        ///< in the order of elimination
  /// For each of them the places in that order of all its neighbours that are eliminated later,
  /// including those that become neighbours by elimination.
  std::vector<std::vector<int>> later;
  int rows = 0;                  ///< of the shape, without bounds
  double multiplications = 0;    ///< of their factorisation, about (Eq. 9-6)
  std::vector<int> loop;         ///< of each block of the shape the closed loop, or -1
  std::vector<ClosedLoop> loops;  ///< all closed loops of the shape

  /// Plans the elimination of a shape. \param shape its blocks
  explicit EliminationPlan(const std::vector<ShapeBlock>& shape);
};

}  // namespace joints
/// @}
