// Known answers of exercise 9.5, each put in the place of the solution's.

// ---- wrong: kick of full h
// expects: Likely mistake: forces act for the whole of h: for the mean of the last step and this
// change: (world.last_h + h) / 2 ==> h

// ---- wrong: kick of half h
// expects: Likely mistake: forces act for half of h: for the mean of the last step and this one
// change: (world.last_h + h) / 2 ==> h / 2

// ---- wrong: kick of the last step
// expects: Likely mistake: forces act for the last step: for the mean of it and this one
// change: (world.last_h + h) / 2 ==> world.last_h

// ---- wrong: kick of the sum
// expects: Likely mistake: forces act for the last step and this one: for their mean, the half of
// change: (world.last_h + h) / 2 ==> world.last_h + h

// ---- wrong: last_h set first
// expects: Likely mistake: forces act for the whole of h: for the mean of the last step and this
  world.last_h = h; kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  turn(world.bodies, h / 2);
  integrate_poses(world.bodies, h);
  turn(world.bodies, h / 2);  // Eq. 9-9

// ---- wrong: brackets forgotten
// expects: Likely mistake: half of this step only: (last_h + h) / 2 needs its brackets
// change: (world.last_h + h) / 2 ==> world.last_h + h / 2

// ---- wrong: first step a full kick
// expects: Likely mistake: in the first step forces act for all of h: nothing came before it
// change: (world.last_h + h) / 2 ==> world.last_h == 0 ? h : (world.last_h + h) / 2

// ---- wrong: no kick
// expects: Likely mistake: no forces act: kick() the bodies
// change: kick(world.bodies, world.gravity, (world.last_h + h) / 2); ==>

// ---- wrong: integrate_forces
// expects: Likely mistake: integrate_forces() turns the bodies, too: kick() alone, the turns come
// change: kick(world ==> integrate_forces(world

// ---- wrong: last_h not kept
// expects: Likely mistake: h is not kept in world.last_h: the next step's mean needs it
// change: world.last_h = h; ==>

// ---- wrong: last_h gets the mean
// expects: Likely mistake: the mean is kept in world.last_h: h, the length of this step
// change: world.last_h = h; ==> world.last_h = (world.last_h + h) / 2;

// ---- wrong: blocks not cleared
// expects: Likely mistake: the blocks of the last step are still there: world.blocks.clear()
// change: world.blocks.clear(); ==>

// ---- wrong: begin_step of the joints missing
// expects: Likely mistake: begin_step() of the joints is missing: they choose their rows there
// change: for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h); ==>

// ---- wrong: append missing
// expects: Likely mistake: no joint appends its blocks: the bodies move as if free
// change: for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks); ==>

// ---- wrong: begin and append with half h
// expects: Likely mistake: begin_step() of the joints has half of h: all of it
// change: begin_step(world.bodies, h) ==> begin_step(world.bodies, h / 2)

// ---- wrong: prepare with half h
// expects: Likely mistake: prepare() has half of h: all of it
// change: world.blocks, 0, h) ==> world.blocks, 0, h / 2)

// ---- wrong: prepare from the end
// expects: it threw an exception: solver: blocks have come or gone since they wer
// change: world.blocks, 0, h) ==> world.blocks, int(world.blocks.list.size()), h)

// ---- wrong: prepare missing
// expects: it threw an exception: solver: was prepared for the blocks of another
// change: solver.prepare(world.bodies, world.blocks, 0, h); ==>

// ---- wrong: warm start
// expects: Likely mistake: a warm start: the ratio is 0, the impulses of the last step are not
// change: warm_start(world.bodies, 0) ==> warm_start(world.bodies, 1)

// ---- wrong: warm start by the ratio
// expects: Likely mistake: a warm start: the ratio is 0, the impulses of the last step are not
// change: warm_start(world.bodies, 0) ==> warm_start(world.bodies, h / world.last_h)

// ---- wrong: warm_start missing
// expects: Likely mistake: warm_start() is missing: the impulses of the last step must become 0
// change: solver.warm_start(world.bodies, 0); ==>

// ---- wrong: solve missing
// expects: Likely mistake: solve() is missing: no joint holds
// change: solver.solve(world.bodies); ==>

// ---- wrong: solve twice
// expects: Likely mistake: solve() twice: once
// change: solver.solve(world.bodies); ==> solver.solve(world.bodies); solver.solve(world.bodies);

// ---- wrong: no turns
// expects: Likely mistake: turn() is missing: turn() half of h before the bodies move, and half
// change: turn(world.bodies, h / 2); ==>
// change: turn(world.bodies, h / 2); ==>

// ---- wrong: second turn missing
// expects: Likely mistake: the second turn() is missing: turn() half of h before the bodies move
  kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  turn(world.bodies, h / 2);
  integrate_poses(world.bodies, h);

// ---- wrong: first turn missing
// expects: Likely mistake: the first turn() is missing: turn() half of h before the bodies move
// change: turn(world.bodies, h / 2); ==>

// ---- wrong: one turn of h before
// expects: Likely mistake: turn() for all of h before the bodies move: turn() half of h before
// change: h / 2 ==> h
// change: turn(world.bodies, h / 2); ==>

// ---- wrong: one turn of h after
// expects: Likely mistake: turn() for all of h after the bodies have moved: turn() half of h
// change: turn(world.bodies, h / 2); ==>
// change: h / 2 ==> h

// ---- wrong: two turns of h
// expects: Likely mistake: turn() for all of h both times: turn() half of h before the bodies
// change: h / 2 ==> h
// change: h / 2 ==> h

// ---- wrong: turn before the solve
// expects: Likely mistake: turn() before solve(): the joints hold the velocities as they were
// change: solver.solve(world.bodies); ==>
// change: integrate_poses ==> solver.solve(world.bodies); integrate_poses

// ---- wrong: turn right behind the kick
// expects: Likely mistake: turn() before solve(): the joints hold the velocities as they were
  kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h; turn(world.bodies, h / 2);
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  integrate_poses(world.bodies, h);
  turn(world.bodies, h / 2);  // Eq. 9-9

// ---- wrong: poses before the solve
// expects: Likely mistake: the bodies move before solve(): by the new velocities, behind it
  kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  integrate_poses(world.bodies, h); solver.solve(world.bodies);
  turn(world.bodies, h / 2);
  turn(world.bodies, h / 2);  // Eq. 9-9

// ---- wrong: poses at first
// expects: Likely mistake: the bodies move at first: by the new velocities, behind solve()
  integrate_poses(world.bodies, h); kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  turn(world.bodies, h / 2);
  turn(world.bodies, h / 2);  // Eq. 9-9

// ---- wrong: poses of half h
// expects: Likely mistake: the bodies move for half of h: only the turns are halves
// change: integrate_poses(world.bodies, h) ==> integrate_poses(world.bodies, h / 2)

// ---- wrong: poses missing
// expects: Likely mistake: the bodies do not move: integrate_poses() between the two turns
// change: integrate_poses(world.bodies, h); ==>

// ---- wrong: half poses twice
// expects: Likely mistake: turn() for all of h before the bodies move: turn() half of h before
  kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  integrate_poses(world.bodies, h / 2); turn(world.bodies, h);
      integrate_poses(world.bodies, h / 2);  // Eq. 9-9

// ---- wrong: kick behind the solve
// expects: Likely mistake: kick() comes behind solve(): the impulses of the joints must see the
  const real mean = (world.last_h + h) / 2; world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies); kick(world.bodies, world.gravity, mean);
  turn(world.bodies, h / 2);
  integrate_poses(world.bodies, h);
  turn(world.bodies, h / 2);  // Eq. 9-9

// ---- wrong: another half kick at the end
// expects: Likely mistake: a second kick() at the end: forces act once, for the mean of the last
// change: turn(world.bodies, h / 2);  // Eq. 9-9 ==>
//         turn(world.bodies, h / 2); kick(world.bodies, world.gravity, h / 2);

// ---- wrong: engine step without leapfrog
// expects: Likely mistake: this is the step of semi-implicit Euler: kick() for the mean, and
  step(world, solver, h);

// ---- wrong: gravity alone
// expects: Likely mistake: force and torque of the bodies are forgotten: kick() has all of it
// change: kick(world.bodies, world.gravity, (world.last_h + h) / 2); ==>
//         for (int k = 0; k < world.bodies.slots(); ++k) if (!world.bodies.at(k).is_static())
//         world.bodies.at(k).v += (world.last_h + h) / 2 * world.gravity;

// ---- wrong: begin_step and append in one loop of the first joint
// expects: Case: two bodies and a motor
// change: for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks); ==>
//         if (!world.joints().empty()) world.joints()[0]->append(world.bodies, world.blocks);

// ---- wrong: earth's gravity
// expects: Likely mistake: gravity is another one: world.gravity
// change: world.gravity, ==> vec3(0, real(-9.81), 0),

// ---- wrong units: kick without half
// expects: Units: in the step, adding m to m/s: a time too many: is a division by h missing?
// change: (world.last_h + h) / 2 ==> (world.last_h + h) * h

// ---- wrong units: kick of one and h
// expects: Units: in the step, adding s to a pure number: a time too many: is a division by h
// change: (world.last_h + h) / 2 ==> (1 + h) / 2

// ---- wrong units: poses of the square of h
// expects: Units: in the step, adding m s to m: a time too many: is a division by h missing?
// change: integrate_poses(world.bodies, h) ==> integrate_poses(world.bodies, h * h)

// ---- wrong units: turn without h
// expects: Units: in the step, adding 1/s^2 to 1/s: h is missing (an impulse is h times a force
// change: turn(world.bodies, h / 2);  // Eq. 9-9 ==> turn(world.bodies, real(0.5));

// ---- wrong units: last_h becomes a rate
// expects: Units: world.last_h is in 1/s and should be in s
// change: world.last_h = h; ==> world.last_h = 1 / h;

// ---- right: the engine's own step
  step(world, solver, h, {.leapfrog = true});

// ---- right: rows chosen before the kick
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
      kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  turn(world.bodies, h / 2);
  integrate_poses(world.bodies, h);
  turn(world.bodies, h / 2);  // Eq. 9-9

// ---- right: both in one loop
  kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) { joint->begin_step(world.bodies, h);
      joint->append(world.bodies, world.blocks); }
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  turn(world.bodies, h / 2);
  integrate_poses(world.bodies, h);
  turn(world.bodies, h / 2);  // Eq. 9-9

// ---- right: end_step of the engine
  kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  end_step(world, solver, h, {.leapfrog = true});
