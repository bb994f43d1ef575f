// wrong only-y-gravity: world.gravity, ==> vec3(0, world.gravity.y, 0),
// wrong drawn-stops: for (const auto& joint : world.joints()) joint->append(world.bodies,
//         world.blocks); ==> for (std::size_t k = 0; k < world.joints().size() && k < 4; ++k)
//         world.joints()[k]->append(world.bodies, world.blocks);
// wrong fixed-step-length: (world.last_h + h) / 2 ==> (world.last_h + real(1) / 60) / 2
// wrong kick-longer: (world.last_h + h) / 2 ==> std::max(world.last_h, h)
// wrong kick-h-later: (world.last_h + h) / 2 ==> world.last_h == 0 ? h / 2 : h
// wrong append-before-begin: world.blocks.clear(); ==> world.blocks.clear(); for (const auto& one :
//         world.joints()) one->append(world.bodies, world.blocks); ;; for (const auto& joint :
//         world.joints()) joint->append(world.bodies, world.blocks); ==>
// wrong kick-full-h: (world.last_h + h) / 2 ==> h
// wrong kick-half-h: (world.last_h + h) / 2 ==> h / 2
// wrong kick-last-step: (world.last_h + h) / 2 ==> world.last_h
// wrong kick-sum: (world.last_h + h) / 2 ==> world.last_h + h
// wrong brackets-forgotten: (world.last_h + h) / 2 ==> world.last_h + h / 2
// wrong first-step-full-kick: gravity, ==> gravity, world.last_h == 0 ? h :
// wrong no-kick: integrate_forces(world.bodies, world.gravity, (world.last_h + h) / 2); ==>
// wrong last-h-not-kept: world.last_h = h; ==>
// wrong last-h-gets-mean: world.last_h = h; ==> world.last_h = (world.last_h + h) / 2;
// wrong blocks-not-cleared: world.blocks.clear(); ==>
// wrong begin-step-joints-missing: for (const auto& joint : world.joints())
//         joint->begin_step(world.bodies, h); ==>
// wrong append-missing: for (const auto& joint : world.joints()) joint->append(world.bodies,
//         world.blocks); ==>
// wrong begin-append-half-h: begin_step(world.bodies, h) ==> begin_step(world.bodies, h / 2)
// wrong prepare-mean: integrate_forces(world.bodies, world.gravity, (world.last_h + h) / 2)
//         ==> const real mean = (world.last_h + h) / 2; integrate_forces(world.bodies,
//         world.gravity, mean) ;; 0, h ==> 0, mean
// wrong begin-step-mean: integrate_forces(world.bodies, world.gravity, (world.last_h + h) /
//         2) ==> const real mean = (world.last_h + h) / 2; integrate_forces(world.bodies,
//         world.gravity, mean) ;; begin_step(world.bodies, h) ==> begin_step(world.bodies, mean)
// wrong prepare-half-h: 0, h ==> 0, h / 2
// wrong "the solver did not get the blocks of this step: solver.prepare(": 0 ==>
//         int(world.blocks.list.size())
// wrong "the solver did not get the blocks of this step: solver.prepare(":
//         solver.prepare(world.bodies, world.blocks, 0, h); ==>
// wrong warm-start: warm_start(world.bodies, 0) ==> warm_start(world.bodies, 1)
// wrong warm-start-missing: solver.warm_start(world.bodies, 0); ==>
// wrong solve-missing: solver.solve(world.bodies); ==>
// wrong solve-twice: integrate_poses ==> solver.solve(world.bodies); integrate_poses
// wrong poses-before-solve: integrate_poses(world.bodies, h); ==> ;; solver.solve ==>
//         integrate_poses(world.bodies, h); solver.solve
// wrong poses-at-first: integrate_poses(world.bodies, h); ==> ;; integrate_forces ==>
//         integrate_poses(world.bodies, h); integrate_forces
// wrong poses-half-h: integrate_poses(world.bodies, h) ==> integrate_poses(world.bodies, h / 2)
// wrong poses-missing: integrate_poses(world.bodies, h); ==>
// wrong kick-behind-solve: integrate_forces(world.bodies, world.gravity, (world.last_h + h)
//         / 2) ==> const real mean = (world.last_h + h) / 2 ;; integrate_poses ==>
//         integrate_forces(world.bodies, world.gravity, mean); integrate_poses
// wrong another-half-kick-end: integrate_poses(world.bodies, h); ==> integrate_poses(world.bodies,
//         h); integrate_forces(world.bodies, world.gravity, h / 2);
// wrong kick-full-h:
  step(world, solver, h);
// wrong gravity-alone: integrate_forces(world.bodies, world.gravity, (world.last_h + h) /
//         2); ==> for (int k = 0; k < world.bodies.slots(); ++k) if
//         (!world.bodies.at(k).is_static()) world.bodies.at(k).v += (world.last_h + h) / 2 *
//         world.gravity;
// wrong "Case: two bodies and a motor": for (const auto& joint : world.joints()) joint->append ==>
//         if (!world.joints().empty()) world.joints()[0]->append
// wrong earth-s-gravity: world.gravity, ==> vec3(0, real(-9.81), 0),
// wrong units "in the step, adding m to m/s: a time too many: is a division by h missing?":
//         (world.last_h + h) / 2 ==> (world.last_h + h) * h
// wrong units "in the step, adding s to a pure number: a time too many: is a division by h":
//         (world.last_h + h) / 2 ==> (1 + h) / 2
// wrong units "in the step, adding m s to m: a time too many: is a division by h missing?":
//         integrate_poses(world.bodies, h) ==> integrate_poses(world.bodies, h * h)
// wrong units "world.last_h is in 1/s and should be in s": h; ==> 1 / h;
// wrong engine-step:
  step(world, solver, h, {.leapfrog = true});
// right rows chosen before the kick: integrate_forces ==> for (const auto& joint :
//         world.joints()) joint->begin_step(world.bodies, h); integrate_forces ;; (); for (const
//         auto& joint : world.joints()) joint->begin_step(world.bodies, h) ==> ()
// right both in one loop: joint-> ==> { joint-> ;; for (const auto& joint : world.joints()) joint
//         ==> joint ;; solver ==> } solver
// right end_step of the engine: integrate_poses(world.bodies, h); ==> end_step(world, solver, h,
//         {.leapfrog = true});
