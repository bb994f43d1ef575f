// A block: up to six rows that are solved together, as plain data. All that a solver ever sees.
#pragma once

#include <type_traits>
#include <vector>

#include "engine/matrix.h"

/// \addtogroup rows
/// @{
namespace joints {

/// What the rows of a block have to reach, apart from their geometry: feedback, target and bounds.
/// An aggregate: name only what you need, as in `RowTarget{.beta = real(0.2), .lower = 0}`.
struct RowTarget {
  real beta = 0;       ///< share of the error C that is removed in one step [1]
  real frequency = 0;  ///< soft instead of beta: natural frequency [Hz]; 0 means not soft
  real damping = 1;    ///< soft: damping ratio [1]
  real rate = 0;       ///< wanted rate of the last row [unit of C per s]: the speed of a motor
  bool holds_position = true;  ///< C is an error to be removed; false for a motor
  /// Not 0, for a block of one row: its bounds are -+`upper` * impulse[follows], another impulse of
  /// the same joint; `upper` is a factor [1] then, and `lower` is not read.
  int follows = 0;
  real lower = -unbounded;  ///< least force of the last row [N or N m]; 0 for C >= 0
  real upper = unbounded;   ///< greatest force of the last row [N or N m]
};

/// Which half of the bodies' velocities a block touches.
enum class Touches : signed char { linear, angular, both };

/// One block. Its rows and errors stand in the flat arrays of Blocks, from `first` on.
/// Target rate and bounds belong to the last row; the other rows are equalities.
struct Block {
  int body1 = 0, body2 = 0;         ///< slots of the two bodies
  int rows = 0;                     ///< 1 to 6
  int first = 0;                    ///< where its rows begin in Blocks::J and Blocks::C
  Touches touches = Touches::both;  ///< what the inner loop may leave out
  RowTarget target;                 ///< what its rows have to reach
  real* impulse = nullptr;          ///< the accumulated impulses [N s or N m s], in the joint
};

/// The blocks of one step: a list of headers and two flat arrays.
class Blocks {
 public:
  std::vector<Block> list;  ///< the headers, in the order in which they are solved
  std::vector<Row> J;       ///< Jacobian, a row each
  std::vector<real> C;      ///< error, a number each row [m or rad]

  void clear() { keep(0); }  ///< forgets all blocks, keeps the room
  void keep(int count);      ///< forgets all blocks but the first `count`
  void reserve(int rows);    ///< makes room, so that appending as many rows does not allocate

  /// Appends the rows of a part between two bodies, as they stand now. Two static bodies cannot be
  /// moved: nothing is appended for them, and the impulses become zero.
  /// \param part any type with error() and jacobian() of two bodies
  /// \param impulse where its accumulated impulses live (one number a row), kept by the joint
  template <class Part>
  void append(const Bodies& bodies, BodyId id1, BodyId id2, const Part& part,
              const RowTarget& target, real* impulse) {
    const Body &body1 = bodies[id1], &body2 = bodies[id2];
    append(bodies, id1, id2, to_jacobian(part.jacobian(body1, body2)),
           to_vector(part.error(body1, body2)), target, impulse);
  }

  /// The same from the numbers themselves.
  template <int N>
  void append(const Bodies& bodies, BodyId id1, BodyId id2, const Jacobian<N>& rows_J,
              const std::type_identity_t<Vector<N>>& rows_C, const RowTarget& target,
              real* impulse) {
    static_assert(N >= 1 && N <= 6, "a block has one to six rows");
    append(bodies, id1, id2, N, rows_J.row.data(), rows_C.data(), target, impulse);
  }

 private:
  void append(const Bodies& bodies, BodyId id1, BodyId id2, int rows, const Row* rows_J,
              const real* rows_C, const RowTarget& target, real* impulse);
};

}  // namespace joints
/// @}
