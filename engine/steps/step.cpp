// A step with options, put together from the files of this folder.
#include "engine/steps/step.h"

#include "engine/kept/input.h"
#include "engine/steps/leapfrog.h"
#include "engine/steps/projection.h"
#include "engine/steps/rows.h"
#include "engine/steps/soft.h"

namespace joints {

namespace {

class Chosen : public StepMethod {
 public:
  explicit Chosen(const StepOptions& how) : how_(how) {}
  real integrate_forces(World& world, real h) const override {
    return how_.leapfrog ? Leapfrog().integrate_forces(world, h)
                         : StepMethod::integrate_forces(world, h);
  }
  void change_blocks(Blocks& blocks, int first) const override {
    if (how_.frequency > 0) soften(blocks, first, how_.frequency, how_.damping);
    if (how_.row_by_row) split_into_rows(blocks, first);
  }

 private:
  const StepOptions& how_;
};

}  // namespace

void check_input(const World& world, const Solver& solver, real h, const StepOptions& how) {
  check_input(world, solver, h);
  require(how.projections >= 0, "projections: must not be negative");
  check_softness(how.frequency, how.damping, h);
}

void step(World& world, Solver& solver, real h, const StepOptions& how) {
  require(how.substeps > 0, "substeps: there must be at least one");
  const real h_sub = h / real(how.substeps);
  check_input(world, solver, h_sub, how);  // once for all substeps
  const Chosen method(how);
  for (int substep = 0; substep < how.substeps; ++substep) {
    joints::begin_step(world, solver, h_sub, how.warm_start, method);
    solve_step(world, solver, h_sub, method);
    end_step(world, solver, h_sub, how);
  }
}

void begin_step(World& world, Solver& solver, real h, const StepOptions& how) {
  check_input(world, solver, h, how);
  begin_step(world, solver, h, how.warm_start, Chosen(how));
}

void end_step(World& world, Solver& solver, real h, const StepOptions& how) {
  end_step(world, solver, h, Chosen(how));
  for (int i = 0; i < how.projections; ++i) project_positions(world);
  check_motion(world.bodies);
}

}  // namespace joints
