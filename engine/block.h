// A block: up to six rows that are solved together, as plain data. Solvers receive only blocks and
// do not depend on joints.
#pragma once

#include <algorithm>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/matrix.h"

/// \addtogroup rows
/// @{
namespace joints {

class Solver;
class World;

/// Feedback, target rate and bounds of a block's rows. `rate`, `follows`, `lower`, `upper` and
/// `slop` are those of the last row, the others of all rows. Set only those that you need, as in
/// `RowSettings{.beta = real(0.2), .lower = 0}`.
struct RowSettings {
  real beta = 0;       ///< fraction of the error C that is removed in one step [1]
  real frequency = 0;  ///< above 0: a spring of this natural frequency [Hz] replaces beta
  real damping = 1;    ///< damping ratio of that spring [1]
  real rate = 0;       ///< target rate of the last row [unit of C per s]: the speed of a motor
  bool holds_position = true;  ///< true: C is computed and fed back; false: only a rate is given
  /// If not 0: the bounds are -+upper * impulse[follows], by the impulse of another row of the same
  /// joint, `follows` places further on in the joint's array and equally far in Blocks (before, if
  /// negative). That row must be one-sided. This block has one row, `upper` is a factor [1], and
  /// `lower` is ignored.
  int follows = 0;
  real lower = -unbounded;  ///< least force of the last row [N or N m]; 0 for C >= 0
  real upper = unbounded;   ///< greatest force of the last row [N or N m]
  // They apply to the impulses of a step, not to position projection:
  real slop = 0;          ///< violation of a one-sided last row that is not corrected [unit of C]
  /// Greatest speed at which an error is corrected [unit of C per s], but for springs, of which it
  /// bounds one-sided rows alone.
  real push = unbounded;

  /// True if the last row enforces C >= 0: its impulse is not negative. While C > 0 the gap may
  /// close but not more: see bias().
  bool one_sided() const { return holds_position && follows == 0 && lower == 0; }
};
/// Its name before version 0.10.
using RowTarget [[deprecated("write RowSettings")]] = RowSettings;

/// RowSettings turned into numbers for a step of length h, for hard rows as well: bounds as
/// impulses, and the coefficients of the change that an iterative solver adds to an accumulated
/// impulse lambda, dlambda = -mass_scale K^-1 (J V + bias) - impulse_scale lambda.
struct SoftCoefficients {
  real bias_rate;      ///< factor of C in the bias [1/s]: beta/h for hard rows
  real softness;       ///< J V + bias + softness K lambda = 0 is solved [1]; 0 for hard rows
  real mass_scale;     ///< relaxation / (1 + softness) [1]
  real impulse_scale;  ///< relaxation * softness / (1 + softness): 0 for hard rows [1]
  real lower, upper;   ///< bounds of the last row's accumulated impulse [N s or N m s]; if the
                       ///< bound follows another impulse, `upper` is the factor RowSettings::upper
};
/// Computes it from beta, or from frequency and damping: a spring and damper, implicit in time.
/// \param h step [s] \param relaxation over-relaxation [1]
/// \param duration of the impulses of the step, Blocks::duration_or() [s]
/// Source: Catto, "Soft Constraints", GDC 2011.
inline SoftCoefficients soft_coefficients(const RowSettings& row, real h, real duration,
                                          real relaxation = 1) {
  real bias_rate = row.beta / h, softness = 0;
  if (row.frequency != 0) {
    const real omega = 2 * std::numbers::pi_v<real> * row.frequency;
    const real a1 = 2 * row.damping + h * omega;
    bias_rate = omega / a1, softness = 1 / (duration * omega * a1);
  }
  const real mass_scale = relaxation / (1 + softness);
  const real impulse_scale = relaxation - mass_scale;  // relaxation softness / (1 + softness)
  const real unit = row.follows == 0 ? duration : real(1);  // makes a force an impulse
  return {bias_rate, softness, mass_scale, impulse_scale, unit * row.lower, unit * row.upper};
}

/// The header of a block. Its rows and errors are in the flat arrays of Blocks, from `first` on.
struct Block {
  int body1 = 0, body2 = 0;         ///< slots of the two bodies
  int first = 0;                    ///< where its rows begin in Blocks::J and Blocks::C
  short rows = 0;                   ///< 1 to 6
  Form form = Form::any;            ///< the form of its rows
  /// True for hard rows that hold a position: a way to step may make them soft, or correct their
  /// error by other means. False if only a rate is given, if the bounds follow an impulse, or for
  /// a spring of the joint (RowSettings::frequency).
  bool corrects = false;
  RowSettings settings;             ///< feedback, target rate and bounds
  real* impulse = nullptr;          ///< the accumulated impulses [N s or N m s], in the joint
};

/// The part of the error C <= 0 of a one-sided row that the step corrects, without the slop and at
/// most at the speed `push`. \param bias_rate of SoftCoefficients [1/s]
/// \return unit of C, not positive
inline real corrected(const RowSettings& row, real C, real bias_rate) {
  return std::max(std::min(C + row.slop, real(0)), -row.push / bias_rate);
}
/// The bias of a row that is not one-sided, without its target rate; at most `push` where
/// Block::corrects, that is, not of a spring. \param bias_rate of SoftCoefficients [1/s]
inline real feedback(const Block& block, real C, real bias_rate) {
  const real most = block.corrects ? block.settings.push : unbounded;
  return std::min(std::max(bias_rate * C, -most), most);
}
/// The bias of row `i` of a block from its error C: solvers make J V + bias = 0. That of a
/// one-sided row with C > 0 is C / h, as for a rope (Eq. 1-11): the gap may close, but not more.
/// \param bias_rate of SoftCoefficients [1/s] \param h step [s]
inline real bias(const Block& block, int i, real C, real bias_rate, real h) {
  if (i < block.rows - 1) return feedback(block, C, bias_rate);
  const RowSettings& last = block.settings;
  if (!last.one_sided()) return feedback(block, C, bias_rate) - last.rate;
  return (C > 0 ? C / h : bias_rate * corrected(last, C, bias_rate)) - last.rate;
}

/// The blocks of one step: a list of headers and two flat arrays.
class Blocks {
 public:
  std::vector<Block> list;  ///< the headers, in the order in which they are solved
  /// The error of each row [m, rad, or 1 for a small sine]; 0 in a block that holds no position.
  std::vector<real> C;
  std::vector<Row> J;  ///< the rows in use; what follows them is of former steps
  /// One function for the whole world, called once the bodies have moved; null for none. One kind
  /// of joint alone sets it, as it appends blocks; it finds these joints in the world.
  void (*after_move)(World& world, Solver& solver, real h) = nullptr;
  bool errors_only = false;  ///< append only C and no rows of J: for the errors at other poses
  real last_impulse_duration = 0;  ///< that of the step before [s]; 0 in the first
  /// The duration of this step's impulses [s], by which a force is multiplied. You may take it as
  /// h: only leapfrog steps that change h have another one, the mean of the last h and this one.
  real impulse_duration = 0;
  /// Warm-start data of a solver in addition to the impulses; part of a world's state.
  mutable std::vector<real> memory;

  /// impulse_duration, or h if it has not been set, as in a step written by hand. \param h step [s]
  real duration_or(real h) const { return impulse_duration > 0 ? impulse_duration : h; }
  int rows() const { return int(C.size()); }  ///< of all blocks
  void clear() { truncate(0); }  ///< removes all blocks, keeps the capacity
  void truncate(int count);      ///< removes all blocks but the first `count`
  void shrink_to_fit();          ///< gives back the memory that the present blocks do not need

  /// Appends the rows of a part (engine/parts) between two bodies at their present poses. Between
  /// two static bodies it appends nothing and sets the impulses to zero.
  /// \param impulse the accumulated impulses, one per row; the joint owns them
  template <class P>
  void append(const Bodies& bodies, BodyId id1, BodyId id2, const P& part,
              const RowSettings& settings, real* impulse) {
    if (!add(bodies, id1, id2, P::rows, P::form, settings, impulse)) return;
    const Body &body1 = bodies.at(list.back().body1), &body2 = bodies.at(list.back().body2);
    if (settings.holds_position) write_error(part, body1, body2, C.data() + list.back().first);
    if (!errors_only) write_jacobian(part, body1, body2, J.data() + list.back().first);
  }

  /// The same from given J and C.
  template <int N>
  void append(const Bodies& bodies, BodyId id1, BodyId id2, const Jacobian<N>& rows_J,
              const std::type_identity_t<Vector<N>>& rows_C, const RowSettings& settings,
              real* impulse, Form form = Form::any) {
    static_assert(N >= 1 && N <= 6, "a block has one to six rows");
    if (!add(bodies, id1, id2, N, form, settings, impulse)) return;
    const int first = list.back().first;
    std::copy(rows_C.begin(), rows_C.end(), C.begin() + first);
    if (!errors_only) std::copy(rows_J.row.begin(), rows_J.row.end(), J.begin() + first);
  }

 private:
  // Adds a header and makes room for its rows; false between two static bodies.
  bool add(const Bodies& bodies, BodyId id1, BodyId id2, short rows, Form form,
           const RowSettings& settings, real* impulse);
  void extend_J();  // to the rows of all blocks
};

/// The row whose impulse bounds block number k, which must follow one (RowSettings::follows).
/// \return the index of its block in Blocks::list, and its number in that block, from 0
/// \throws std::invalid_argument if that impulse has no row, or if block k has several rows
std::pair<int, int> followed_row(const Blocks& blocks, int k);

}  // namespace joints
/// @}
