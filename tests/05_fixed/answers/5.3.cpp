// mistake "the axis stands above the line: translations come first": all.C[i] ==> all.C[i + 2] ;;
//         all.C[i + 2] = tilt ==> all.C[i] = tilt ;; all.J[i] ==> all.J[i + 2] ;; all.J[i + 2] =
//         lower ==> all.J[i] = lower
// mistake "the first two rows of the point: they follow the axes of the world, and the sleeve
//         slides along its shaft": const Vector<2> aside = kit.line.error(body1, body2), ==> const
//         vec3 aside = kit.point.error(body1, body2); const Vector<2> ;; Jacobian<2> upper =
//         kit.line ==> Jacobian<3> upper = kit.point
// mistake "the first two rows of the lock: they follow the axes of the world, and the sleeve
//         rotates about its shaft": tilt = kit.axis.error(body1, body2); ==> other = aside;
//         (void)other; const vec3 tilt = kit.lock.error(body1, body2); ;; Jacobian<2> lower =
//         kit.axis ==> Jacobian<3> lower = kit.lock
// mistake "three rows of the point and one of the axis: now the sleeve does not slide": for ==>
//         const vec3 gap = kit.point.error(body1, body2); const Jacobian<3> three =
//         kit.point.jacobian(body1, body2); (void)aside; (void)upper; for ;; i < 2 ==> i < 3 ;;
//         all.C[i] = aside[i], all.C[i + 2] = tilt[i]; all.J[i] = upper[i], all.J[i + 2] =
//         lower[i]; ==> all.C[i] = gap[i], all.C[3] = tilt[0]; all.J[i] = three[i], all.J[3] =
//         lower[0];
// mistake "one row of the line and three of the lock: now the sleeve does not rotate": for ==>
//         const vec3 turn = kit.lock.error(body1, body2); const Jacobian<3> three =
//         kit.lock.jacobian(body1, body2); (void)tilt; (void)lower; for ;; i < 2 ==> i < 3 ;;
//         all.C[i] = aside[i], all.C[i + 2] = tilt[i]; all.J[i] = upper[i], all.J[i + 2] =
//         lower[i]; ==> all.C[0] = aside[0], all.C[i + 1] = turn[i]; all.J[0] = upper[0], all.J[i +
//         1] = three[i];
// mistake "K of two blocks of two: what each does to the other is missing": all.K[i][j] = ==> if (i
//         / 2 == j / 2) all.K[i][j] =
// mistake "only the diagonal of K: what each row does to the others is missing": all.K[i][j] = ==>
//         if (i == j) all.K[i][j] =
// mistake "K has nothing below its diagonal: it is symmetric": int j = 0 ==> int j = i
// mistake "K has nothing above its diagonal: it is symmetric": j < 4 ==> j <= i
// mistake "the rows of the axis are not in K: it has four rows": all.K[i][j] = ==> if (i < 2 && j <
//         2) all.K[i][j] =
// mistake "the bodies are exchanged: the rows belong to body1, body2": coupling(all.J[i], all.J[j],
//         body1, body2) ==> coupling(all.J[i], all.J[j], body2, body1)
// mistake "C of the axis is missing": all.C[i] = aside[i], all.C[i + 2] = tilt[i]; ==> all.C[i] =
//         aside[i]; (void)tilt;
// mistake "C of the line is missing": all.C[i] = aside[i], all.C[i + 2] = tilt[i]; ==> all.C[i + 2]
//         = tilt[i]; (void)aside;
// mistake "J of the axis is missing": all.J[i] = upper[i], all.J[i + 2] = lower[i]; ==> all.J[i] =
//         upper[i]; (void)lower;
// mistake "J of the line is missing": all.J[i] = upper[i], all.J[i + 2] = lower[i]; ==> all.J[i +
//         2] = lower[i]; (void)upper;
// mistake "row i + 1 in the place of row i + 2: a line has two rows": i + 2 ==> i + 1 ;; i + 2 ==>
//         i + 1
// right the engine's composite:
  const Composite<Line, Axis> both{kit.line, kit.axis};
  return {both.error(body1, body2), both.jacobian(body1, body2), both.K(body1, body2)};
// right half of K is copied: int j = 0 ==> int j = i ;; all.K[i][j] = ==> all.K[j][i] = all.K[i][j]
//         =
// right four by four:
  FourRows all{{}, {}, {}};
  const auto put = [&](const auto& part, int first) {
    const auto C = part.error(body1, body2);
    const auto J = part.jacobian(body1, body2);
    all.C[first] = C[0], all.C[first + 1] = C[1];
    all.J[first] = J[0], all.J[first + 1] = J[1];
  };
  put(kit.line, 0);
  put(kit.axis, 2);
  all.K = K_of(all.J, body1, body2);
  return all;

// region 2
// mistake "the load on body 1: ask what a row does to body 2": J[0].v2 ==> J[0].v1 ;; J[0].w2 ==>
//         J[0].w1 ;; J[i].v2 ==> J[i].v1 ;; J[i].w2 ==> J[i].w1
// mistake "the row does not push with its w2: v2 pushes and w2 rotates": vec3 push = impulse[0] *
//         J[0].v2, couple = impulse[0] * J[0].w2; ==> vec3 couple = impulse[0] * J[0].v2, push =
//         impulse[0] * J[0].w2; ;; push += impulse[i] * J[i].v2; couple += ==> couple += impulse[i]
//         * J[i].v2; push +=
// mistake "as with a weld: the rows of a sleeve do not lie along the axes of the world": vec3 push
//         = impulse[0] * J[0].v2, couple = impulse[0] * J[0].w2; ==> vec3 push(impulse[0],
//         impulse[1], 0), couple(impulse[2], impulse[3], 0); ;; push += impulse[i] * J[i].v2;
//         couple += impulse[i] * J[i].w2; ==> (void)J;
// mistake "only the last two rows rotate body 2: a row of the line does, too, by its lever": couple
//         = impulse[0] * J[0].w2; ==> couple(0); ;; couple += ==> if (i > 1) couple +=
// mistake "the lever of each row is missing: w2 has it": couple = impulse[0] * J[0].w2; ==>
//         couple(0); ;; couple += impulse[i] * J[i].w2; ==>
// mistake "the first row is missing": vec3 push = impulse[0] * J[0].v2, couple = impulse[0] *
//         J[0].w2; ==> vec3 push(0), couple(0);
// mistake "the last row is missing": i < 4 ==> i < 3
// mistake "only the first row counts: add all four": i < 4 ==> i < 1
// mistake "the impulses are not divided by h": push / h, (couple + cross(body2.x - seam, push)) / h
//         ==> push, couple + cross(body2.x - seam, push)
// mistake "the impulses are multiplied by h: a force is an impulse over a time": push / h ==> push
//         * h ;; push)) / h ==> push)) * h
// mistake "the force is not divided by h": {push / h ==> {push
// mistake "the torque is not divided by h": push)) / h ==> push))
// mistake "the torque of the couple is not divided by h": (couple + cross(body2.x - seam, push)) /
//         h ==> couple + cross(body2.x - seam, push) / h
// mistake "the torque of the force is not divided by h": (couple + cross(body2.x - seam, push)) / h
//         ==> couple / h + cross(body2.x - seam, push)
// mistake "the torque is about the centre of body 2: express it about the seam": + cross(body2.x -
//         seam, push) ==>
// mistake "the sign of the lever: it leads from the seam to the centre": body2.x - seam ==> seam -
//         body2.x
// mistake "the lever is the centre itself: it leads from the seam to the centre": body2.x - seam
//         ==> body2.x
// mistake "the lever is the seam itself: it leads from the seam to the centre": body2.x - seam ==>
//         seam
// mistake "the load of body 1: its sign": return {push / h, (couple ==> return {-push / h, -(couple
// mistake "the sign of the force": {push / h ==> {-push / h
// mistake "the sizes of the impulses: they have signs": impulse[0] * J[0].v2 ==>
//         std::abs(impulse[0]) * J[0].v2 ;; impulse[0] * J[0].w2 ==> std::abs(impulse[0]) * J[0].w2
//         ;; impulse[i] * J[i].v2 ==> std::abs(impulse[i]) * J[i].v2 ;; impulse[i] * J[i].w2 ==>
//         std::abs(impulse[i]) * J[i].w2
// wrong drawn-threshold: return {push / h ==> if (length(push) < real(1e-6)) push = vec3(0); return
//         {push / h
// right with the function about:
  vec3 push(0), couple(0);
  for (int i = 0; i < 4; ++i) push += impulse[i] * J[i].v2 / h, couple += impulse[i] * J[i].w2 / h;
  return about({push, couple}, body2.x, seam);
// right row after row:
  Reaction load{vec3(0), vec3(0)};
  for (int i = 0; i < 4; ++i) {
    const vec3 push = impulse[i] / h * J[i].v2;
    load.force += push;
    load.torque += impulse[i] / h * J[i].w2 + cross(body2.x - seam, push);
  }
  return load;
