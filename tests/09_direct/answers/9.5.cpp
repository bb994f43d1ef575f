// mistake "only the y of gravity acts: world.gravity is a vector": world.gravity, ==> vec3(0,
//         world.gravity.y, 0),
// wrong drawn-stops: const auto& joint : world.joints()) joint->append ==> std::size_t k = 0; k <
//         world.joints().size() && k < 4; ++k) world.joints()[k]->append
// mistake "1/60 s in the place of h: each step has a length of its own": h) ==> real(1) / 60)
// mistake "the longer of both steps: their mean": (world.last_h + h) / 2 ==> std::max(world.last_h,
//         h)
// mistake "half of h in the first step and h in the later ones: the mean of the last step and this
//         one": (world.last_h + h) / 2 ==> world.last_h == 0 ? h / 2 : h
// mistake "append() comes before begin_step(), which chooses the rows: first begin_step() of all
//         joints": world.blocks.clear(); ==> world.blocks.clear(); for (const auto& one :
//         world.joints()) one->append(world.bodies, world.blocks); ;; for (const auto& joint :
//         world.joints()) joint->append(world.bodies, world.blocks); ==>
// mistake "forces act for the whole of h: for the mean of the last step and this one. Is
//         world.last_h set before them?": (world.last_h + h) / 2 ==> h
// mistake "forces act for half of h: for the mean of the last step and this one": (world.last_h +
//         h) / 2 ==> h / 2
// mistake "forces act for the last step: for the mean of it and this one": (world.last_h + h) / 2
//         ==> world.last_h
// mistake "forces act for the last step and this one: for their mean, the half of that":
//         (world.last_h + h) / 2 ==> world.last_h + h
// mistake "half of this step only: (last_h + h) / 2 needs its brackets": (world.last_h + h) / 2 ==>
//         world.last_h + h / 2
// mistake "in the first step forces act for all of h: nothing came before it, last_h is 0 then":
//         gravity, ==> gravity, world.last_h == 0 ? h :
// mistake "no forces act: integrate_forces()": integrate_forces(world.bodies, world.gravity,
//         (world.last_h + h) / 2); ==>
// mistake "h is not kept in world.last_h: the next step's mean needs it": world.last_h = h; ==>
// mistake "the mean is kept in world.last_h: h, the length of this step": world.last_h = h; ==>
//         world.last_h = (world.last_h + h) / 2;
// mistake "the blocks of the last step are still there: world.blocks.clear()":
//         world.blocks.clear(); ==>
// mistake "begin_step() of the joints is missing: they choose their rows there": for (const auto&
//         joint : world.joints()) joint->begin_step(world.bodies, h); ==>
// mistake "no joint appends its blocks: the bodies move as if free": for (const auto& joint :
//         world.joints()) joint->append(world.bodies, world.blocks); ==>
// mistake "begin_step() of the joints has half of h: all of it": , h ==> , h / 2
// mistake "prepare() has the mean of the last step and this one: only the forces act for the mean,
//         prepare() needs h": integrate_forces(world.bodies, world.gravity, (world.last_h + h) / 2)
//         ==> const real mean = (world.last_h + h) / 2; integrate_forces(world.bodies,
//         world.gravity, mean) ;; 0, h ==> 0, mean
// mistake "begin_step() of the joints has the mean of the last step and this one: only the forces
//         act for the mean, begin_step() needs h": integrate_forces(world.bodies, world.gravity,
//         (world.last_h + h) / 2 ==> const real mean = (world.last_h + h) / 2;
//         integrate_forces(world.bodies, world.gravity, mean ;; , h ==> , mean
// mistake "prepare() has half of h: all of it": 0, h ==> 0, h / 2
// wrong "the solver did not get the blocks of this step: solver.prepare(": 0 ==>
//         int(world.blocks.list.size())
// wrong "the solver did not get the blocks of this step: solver.prepare(":
//         solver.prepare(world.bodies, world.blocks, 0, h); ==>
// mistake "a warm start: the ratio is 0, the impulses of the last step are not used": 0) ==> 1)
// mistake "warm_start() is missing: the impulses of the last step must become 0":
//         solver.warm_start(world.bodies, 0); ==>
// mistake "solve() is missing: no joint holds": solver.solve(world.bodies); ==>
// mistake "solve() twice: once": integrate_poses ==> solver.solve(world.bodies); integrate_poses
// mistake "the bodies move before solve(): by the new velocities, behind it":
//         integrate_poses(world.bodies, h); ==> ;; solver.solve ==> integrate_poses(world.bodies,
//         h); solver.solve
// mistake "the bodies move at first: by the new velocities, behind solve()":
//         integrate_poses(world.bodies, h); ==> ;; integrate_forces ==>
//         integrate_poses(world.bodies, h); integrate_forces
// mistake "the bodies move for half of h: for all of it": integrate_poses(world.bodies, h) ==>
//         integrate_poses(world.bodies, h / 2)
// mistake "the bodies do not move: integrate_poses()": integrate_poses(world.bodies, h); ==>
// mistake "the forces act after solve(): they must act before the impulses":
//         integrate_forces(world.bodies, world.gravity, (world.last_h + h) / 2) ==> const real mean
//         = (world.last_h + h) / 2 ;; integrate_poses ==> integrate_forces(world.bodies,
//         world.gravity, mean); integrate_poses
// mistake "forces act again at the end: only once, for the mean of the last step and this one":
//         integrate_poses(world.bodies, h); ==> integrate_poses(world.bodies, h);
//         integrate_forces(world.bodies, world.gravity, h / 2);
// mistake "forces act for the whole of h: for the mean of the last step and this one. Is
//         world.last_h set before them?":
  step(world, solver, h);
// mistake "force and torque of the bodies are forgotten: integrate_forces() has all of it":
//         integrate_forces(world.bodies, world.gravity, (world.last_h + h) / 2); ==> for (int k =
//         0; k < world.bodies.slots(); ++k) if (!world.bodies.at(k).is_static())
//         world.bodies.at(k).v += (world.last_h + h) / 2 * world.gravity;
// mistake "only the first joint appends its blocks: all of them": for (const auto& joint :
//         world.joints()) joint->append ==> if (!world.joints().empty()) world.joints()[0]->append
// mistake "gravity is another one: world.gravity": world.gravity, ==> vec3(0, real(-9.81), 0),
// mistake "half of the last step only: (last_h + h) / 2 needs its brackets": (world.last_h + h) / 2
//         ==> world.last_h / 2 + h
// mistake "forces act twice for half of h: once, for the mean of the last step and this one":
//         (world.last_h + h) / 2 ==> h / 2 ;; integrate_poses(world.bodies, h); ==>
//         integrate_poses(world.bodies, h); integrate_forces(world.bodies, world.gravity, h / 2);
// mistake "a warm start with half of the impulses: the ratio is 0": 0) ==> real(0.5))
// mistake "the bodies move twice: integrate_poses() once": integrate_poses(world.bodies, h); ==>
//         integrate_poses(world.bodies, h); integrate_poses(world.bodies, h);
// mistake "the bodies move before solve(): by the new velocities, behind it":
//         integrate_poses(world.bodies, h); ==> ;; world.blocks.clear(); ==>
//         integrate_poses(world.bodies, h); world.blocks.clear();
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
