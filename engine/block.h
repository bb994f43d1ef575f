// A block: up to six rows that are solved together, as plain data. All that a solver ever sees.
#pragma once

#include <type_traits>
#include <vector>

#include "engine/matrix.h"

/// \addtogroup rows
/// @{
namespace joints {

/// What is asked of a block, apart from its geometry. An aggregate: name only what you need, as in
/// `RowTarget{.beta = real(0.2), .lower = 0}`.
struct RowTarget {
  real beta = 0;       ///< share of the error C that is removed in one step [1]
  real frequency = 0;  ///< soft instead of beta: natural frequency [Hz]; 0 means not soft
  real damping = 1;    ///< soft: damping ratio [1]
  real rate = 0;       ///< wanted rate of the last row [unit of C per s]: the speed of a motor
  bool holds_position = true;  ///< C is an error to be removed; false for a motor
  /// Not 0, for a block of one row: its bounds are not fixed. They are -+`upper` times another sum
  /// of the same joint, the one that stands so many places behind its own; `upper` is a factor [1]
  /// then, and `lower` is not read.
  int follows = 0;
  real lower = -unbounded;  ///< least force of the last row [N or N m]; 0 for C >= 0
  real upper = unbounded;   ///< greatest force of the last row [N or N m]
};

/// Which half of the bodies' velocities a block touches.
enum class Touches : signed char { linear, angular, both };

/// One block. Its rows, errors and matrix stand in the flat arrays of Blocks, from `first` on.
/// Bounds belong to the last row; the other rows are equalities.
struct Block {
  int body1 = 0, body2 = 0;          ///< slots of the two bodies
  int rows = 0;                      ///< 1 to 6
  int first = 0;                     ///< where its rows begin in Blocks::J and Blocks::C
  int first_K = 0;                   ///< where its rows x rows numbers begin in Blocks::K
  Touches touches = Touches::both;   ///< what the inner loop may leave out
  RowTarget target;                     ///< what is asked of it
  real* impulse = nullptr;           ///< the accumulated impulses [N s or N m s], in the joint
};

/// The blocks of one step: a list of headers and three flat arrays.
class Blocks {
 public:
  std::vector<Block> list;  ///< the headers, in the order in which they are solved
  std::vector<Row> J;   ///< Jacobian, a row each
  std::vector<real> C;  ///< error, a number each row [m or rad]
  std::vector<real> K;  ///< J M^-1 J^T, rows x rows numbers a block [1/kg or 1/(kg m^2)]

  void clear();  ///< forgets all blocks, keeps the room
  /// Makes room, so that appending as many rows does not allocate.
  void reserve(int rows);

  /// Appends the rows of a part between two bodies, as they stand now.
  /// Two static bodies cannot be moved: nothing is appended for them.
  /// \param part any type with error(), jacobian() and K() of two bodies
  /// \param impulse where its accumulated impulses live (one number a row), kept by the joint
  template <class Part>
  void append(const Bodies& bodies, BodyId id1, BodyId id2, const Part& part,
              const RowTarget& target, real* impulse) {
    const int slot1 = bodies.index(id1), slot2 = bodies.index(id2);
    const Body &body1 = bodies.at(slot1), &body2 = bodies.at(slot2);
    if (body1.is_static() && body2.is_static()) return;
    const auto J_part = to_jacobian(part.jacobian(body1, body2));
    const auto C_part = to_vector(part.error(body1, body2));
    if constexpr (requires { part.K_of_rows(J_part, body1, body2); })  // made of others: knows J
      append(slot1, slot2, J_part, C_part, part.K_of_rows(J_part, body1, body2), target, impulse);
    else
      append(slot1, slot2, J_part, C_part, to_matrix(part.K(body1, body2)), target, impulse);
  }

  /// The same from the numbers themselves.
  template <int N>
  void append(int slot1, int slot2, const Jacobian<N>& J_block,
              const std::type_identity_t<Vector<N>>& C_block, const Matrix<N>& K_block,
              const RowTarget& target, real* impulse) {
    static_assert(N >= 1 && N <= 6, "a block has one to six rows");
    append(slot1, slot2, N, J_block.row.data(), C_block.data(), K_block.m[0].data(), target,
           impulse);
  }

 private:
  void append(int slot1, int slot2, int rows, const Row* rows_J, const real* rows_C,
              const real* rows_K, const RowTarget& target, real* impulse);
};

}  // namespace joints
/// @}
