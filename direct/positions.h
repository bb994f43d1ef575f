// The direct solver moves the bodies onto the constraints.
#pragma once

#include <span>

#include "direct/added_inertia.h"
#include "direct/secants.h"
#include "engine/solver.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Moves the bodies of a step such that the joints are closed at their new poses.
///
/// Newton's method with the factor of the step corrects all islands together. If it fails in an
/// island, secants take over there: they converge where an iteration multiplies some errors by
/// nearly 1, as it does near the singular pose of a linkage. Their impulses still act along the
/// rows of the step, which keeps the energy. If they fail as well, the factors of the new poses are
/// used. They begin with the best velocities of the secants or, if these are no good either, with
/// those that solve the velocity equations, without the correction predicted for the poses. If this
/// does not close the joints, a body turns too far in the step, and the island is slowed down.
class Positions : public Corrector {
 public:
  /// Counts of a step.
  struct Report {
    int corrections = 0;         ///< of the positions: of all, and then of single islands
    bool moved_exactly = false;  ///< the errors of the positions are at most `tolerance` times h^2
    int projected = 0;           ///< islands whose poses needed the factors of new poses
    /// How often the velocities of an island were halved to reach this: a body turns too far in a
    /// step. Take a shorter step if its energy matters.
    int halved = 0;
    /// Largest fraction by which closing the joints of an island has changed its kinetic energy,
    /// where the factors of new poses were needed [1].
    double changed = 0;
    double opened = 0;  ///< the largest error of a joint at the beginning of the step [m or rad]
  };
  /// What is kept from step to step: results, and the memory of a move.
  struct Memory {
    Report report;                  ///< of the last step
    std::vector<double> errors_met;  ///< the largest error before each iteration [m or rad]
    /// The bodies before the move, with the velocities that led them where they are.
    std::vector<Body> start;

   private:
    friend Positions;
    struct Try {  // the corrections of an island
      double most = 0;                     // the largest error that need not be corrected
      double last = JointSystem::infinite;  // the last error
      bool moving = false;                 // its corrections go on
      bool exact = false;                  // its errors are at most `most`
    };
    std::vector<Try> tries;                // of the islands
    Blocks poses;                          // at new poses
    std::vector<int> met;                  // number of each of its blocks in the step, or -1
    std::vector<int> corrected;            // of each block: bit i is set if row i is corrected
    std::vector<double> C, last_C, rates;
    std::vector<vec3> spins;               // angular velocities before a correction
    std::vector<real> expected;            // SolverMemory::expected at the beginning
    std::vector<bool> moved;               // for each slot
    std::vector<std::vector<double>> impulses;  // of each island at the beginning
    std::vector<Body> begin;               // the bodies before the move, without corrections
    std::vector<Body> best;                // of the island: velocities to which it may go back
    std::vector<double> best_impulses;     // and impulses
    Secants secants;
  };

  /// Of the islands and the blocks of a step. \param append as for Solver::advance()
  Positions(Memory& memory, JointIslands& islands, const AddedInertia& inertia,
            const Blocks& blocks, SolverMemory& corrections, Bodies& bodies, real h,
            const Solver::Append& append)
      : own_(memory), islands_(islands), inertia_(inertia), blocks_(blocks), list_(blocks.list),
        corrections_(corrections), bodies_(bodies), h_(h), append_(append) {}

  /// Moves all bodies. \param newton largest number of corrections of all islands together
  /// \param tolerance DirectSolver::tolerance
  void move(int newton, double tolerance);

  // Of the islands that have been chosen.
  std::vector<double>& errors() override;
  void change_rates(std::vector<double>& rates) override;

 private:
  static double largest(std::span<const double> C);  // size of an error
  void choose(int from, int end);
  void begin(double tolerance);
  void find_corrected();
  void evaluate(bool rows);
  void mark_moving(bool mark);
  void expect();

  // Of a single island, whose number is from_.
  bool move_alone();
  double move_by_secants(double most);
  bool project(double most);
  bool opened(double most);
  double twice_kinetic();
  double largest_change();
  double next_error();  // the largest one before an iteration
  void move_bodies();
  void move_back();  // to the poses and the velocities before move_bodies()
  void keep_best();  // stores velocities and impulses that may have to be restored
  void back_to_best();

  bool moving(int island) const {
    return island >= from_ && island < end_ && own_.tries[island].moving;
  }
  // Calls f(island, its number) for all chosen islands that have a matrix.
  template <class F>
  void for_islands(const F& f) {
    for (int k = from_; k < end_; ++k)
      if (!islands_.list[k].left) f(islands_.list[k], k);
  }
  // Calls f(body, slot).
  template <class F>
  void for_bodies(const F& f) {
    for_islands([&](Island& island, int) {
      island.for_moving([&](int slot) { f(bodies_.at(slot), slot); });
    });
  }

  // The error of a bounded row of a chosen island.
  double& C_of(const Island& island, const BoundedRow& bound) {
    const SystemBlock& block = island.system.blocks[bound.block];
    return own_.C[block.row + block.rows - 1 - base_];
  }

  Memory& own_;
  JointIslands& islands_;
  const AddedInertia& inertia_;
  const Blocks& blocks_;
  const std::vector<Block>& list_;
  SolverMemory& corrections_;
  Bodies& bodies_;
  real h_;
  const Solver::Append& append_;
  int from_ = 0, end_ = 0, base_ = 0;  // the chosen islands, and their first row
};

}  // namespace joints
/// @}
