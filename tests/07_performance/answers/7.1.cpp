// mistake "added to the old value: = and not += (the axis)": + i] = ==> + i] +=
// mistake "the two of the axis are exchanged: first a1.b, then a1.c": 3 + ==> 4 -
// mistake "the bodies are exchanged: axis.jacobian(body1, body2)": body1, body2 ==> body2, body1
// mistake "the first row stands there twice: the second one is c x a1": axis[i] ==> axis[0]
// mistake "the sign of the first row: b x a1 is the block w2": triple(axis[i].w2) ==> triple(i == 0
//         ? axis[i].w1 : axis[i].w2)
// mistake "the axis is turned with the wrong body: a1 rides on body 1, b and c on body 2": for (int
//         i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2 ==> const vec3 a = to_world(body2,
//         hinge.axis.a1_local); out.axis_row[0] = triple(cross(to_world(body2, hinge.axis.b_local),
//         a) ;; I1 ==> axis_row[1] = triple(cross(to_world(body2, hinge.axis.c_local), a)); out.I1
// mistake "60 in the place of 1/h: a step may have another length than 1/60 s": hinge.beta / h ==>
//         60 * hinge.beta
// expects: holds at upright, turned and moved
// mistake "the gap in the axes of body 1: point.error is in world axes already":
//         hinge.point.error(body1, body2) ==> to_local(body1, hinge.point.error(body1, body2))
// wrong drawn-threshold: const vec3 gap = hinge.point.error(body1, body2) ==> vec3 gap =
//         hinge.point.error(body1, body2); if (length(gap) < real(1e-9)) gap = vec3(0)
// wrong drawn-threshold: rate * tilt ==> std::abs(tilt[i]) < real(1e-6) ? real(0) : rate * tilt
// wrong few-digits: const real rate ==> const float rate
// mistake "the bodies are exchanged: axis.error(body1, body2)": hinge.axis.error(body1, body2) ==>
//         hinge.axis.error(body2, body1)
// mistake "the two of the axis begin one place too early: bias[3] and bias[4]": 3 + ==> 2 +
// wrong "an index outside": out.bias[3 + i] ==> out.bias[4 + i]
// wrong never-set: out.bias[i] = rate * gap[i] ==> { real sum; sum += rate * gap[i]; out.bias[i] =
//         sum; }
// mistake "h is forgotten: beta C is a length or an angle, a bias is a velocity: beta C / h": / h
//         ==>
// expects: bias[0]
// mistake "I1 and I2: body-space: it must be turned into the world, R I^-1 R^T,
//         inverse_inertia(body)": out ==> const auto local = [](const Body& body) { const vec3 i =
//         body.inverse_inertia_local; return Symmetric<real>{i.x, i.y, i.z, 0, 0, 0}; }; out ;;
//         symmetric(inverse_inertia(body1)); out.I2 = symmetric(inverse_inertia(body2)) ==>
//         local(body1); out.I2 = local(body2)
// expects: Fails at upright, turned, moved, broken, 1 static, 2 static and no levers.
// mistake "r1 and r2: not turned into the world: to_world(body, anchor)": to_world(body1,
//         hinge.point.anchor1_local) ==> hinge.point.anchor1_local ;; to_world(body2,
//         hinge.point.anchor2_local) ==> hinge.point.anchor2_local
// expects: Fails at upright, turned, moved, broken, 1 static and 2 static; holds at no levers
// mistake "I2: the inertia of the other body": (body2) ==> (body1)
// expects: I2.xx
// mistake "I1 and I2: row after row: the diagonal xx, yy, zz comes first, then xy, xz, yz
//         (symmetric(m))": out ==> const auto six = [](const mat3& m) { return
//         Symmetric<real>{m[0][0], m[0][1], m[0][2], m[1][1], m[1][2], m[2][2]}; }; out ;;
//         symmetric ==> six ;; symmetric ==> six
// wrong inverse-k-filled: out ==> for (int i = 0; i < 5; ++i) out.inverse_K[out.place(i, i)] = 1;
//         out
// wrong "all of out is set to zero, or replaced: inverse_K stays": out ==> out = {}; out
// expects: inverse_K[0]
// wrong "r2: not written yet; and r1: the lever of the other body": out.r2 ==> out.r1
// mistake "r1 and r2: the lever of the other body": r2 ==> r1 ;; r1 ==> r2
// expects: Pose: pencil and paper.
// expects: r1.z
// mistake "not written yet: bias[4]. All five errors are fed back, three of the point and two of
//         the axis": for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i] ==> out.bias[3] =
//         rate * tilt[0]
// mistake "r2: turned with the other body: each anchor rides on its own body": body2 ==> body1
// expects: r2.x
// mistake "r1 and r2: the place of the anchor: a lever begins at the centre of its body, to_world
//         and not world_point": to_world ==> world_point ;; to_world ==> world_point
// mistake "the sign: b x a1 and c x a1 are the blocks w2, the blocks w1 are their opposites": w2
//         ==> w1
// expects: axis_row[0].z
// mistake "not written yet: bias[3], bias[4]. All five errors are fed back, three of the point and
//         two of the axis": for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i]; ==>
// mistake "r{1|2}: not written yet": out.r{1|2} = triple(to_world(body{1|2},
//         hinge.point.anchor{1|2}_local)); ==>
// mistake "r{1|2}: not turned into the world: to_world(body, anchor)": to_world(body{1|2},
//         hinge.point.anchor{1|2}_local) ==> hinge.point.anchor{1|2}_local
// mistake "r{1|2}: turned the wrong way: to_world, not to_local": to_world(body{1|2} ==>
//         to_local(body{1|2}
// mistake "r{1|2}: the place of the anchor: a lever begins at the centre of its body, to_world and
//         not world_point": to_world(body{1|2} ==> world_point(body{1|2}
// mistake "r{1|2}: the lever of the other body": to_world(body{1|2}, hinge.point.anchor{1|2}_local)
//         ==> to_world(body{2|1}, hinge.point.anchor{2|1}_local)
// mistake "r{1|2}: the anchor of the other body, turned with this one": to_world(body{1|2},
//         hinge.point.anchor{1|2}_local) ==> to_world(body{1|2}, hinge.point.anchor{2|1}_local)
// mistake "r{1|2}: turned with the other body: each anchor rides on its own body": body{1|2} ==>
//         body{2|1}
// mistake "r{1|2}: the anchor of the other body, not turned": to_world(body{1|2},
//         hinge.point.anchor{1|2}_local) ==> hinge.point.anchor{2|1}_local
// mistake "r{1|2}: the sign: from the centre to the anchor": to_world(body{1|2} ==>
//         -to_world(body{1|2}
// mistake "r{1|2}: to the anchor on the other body: that is the same point only while the gap is
//         zero": to_world(body{1|2}, hinge.point.anchor{1|2}_local) ==> world_point(body{2|1},
//         hinge.point.anchor{2|1}_local) - body{1|2}.x
// mistake "r{1|2}: it begins at the centre of the other body: at that of its own":
//         to_world(body{1|2}, hinge.point.anchor{1|2}_local) ==> world_point(body{1|2},
//         hinge.point.anchor{1|2}_local) - body{2|1}.x
// mistake "r1 and r2: not written yet": out.r2 = triple(to_world(body2,
//         hinge.point.anchor2_local)); ==>  ;; out.r1 = triple(to_world(body1,
//         hinge.point.anchor1_local)); ==>
// mistake "r1 and r2: turned the wrong way: to_world, not to_local": to_world(body2 ==>
//         to_local(body2 ;; to_world(body1 ==> to_local(body1
// mistake "r1 and r2: the sign: from the centre to the anchor": to_world(body2 ==> -to_world(body2
//         ;; to_world(body1 ==> -to_world(body1
// mistake "r1 and r2: to the anchor on the other body: that is the same point only while the gap is
//         zero": to_world(body2, hinge.point.anchor2_local) ==> world_point(body1,
//         hinge.point.anchor1_local) - body2.x ;; to_world(body1, hinge.point.anchor1_local) ==>
//         world_point(body2, hinge.point.anchor2_local) - body1.x
// mistake "r1 and r2: the anchor of the other body, turned with this one": anchor2_local ==>
//         anchor1_local ;; anchor1_local ==> anchor2_local
// mistake "r1 and r2: turned with the other body: each anchor rides on its own body": body2 ==>
//         body1 ;; body1 ==> body2
// mistake "the rows are not written yet": for (int i = 0; i < 2; ++i) out.axis_row[i] =
//         triple(axis[i].w2); ==>
// mistake "the {first|second} row is not written yet": for (int i = 0; i < 2; ++i) out.axis_row[i]
//         = triple(axis[i].w2); ==> out.axis_row[{1|0}] = triple(axis[{1|0}].w2);
// mistake "the sign of the second row: c x a1 is the block w2": axis[i].w2 ==> (i == 1 ? axis[i].w1
//         : axis[i].w2)
// mistake "the two rows are exchanged: b comes first, then c": axis[i] ==> axis[1 - i]
// mistake "the second row stands there twice: the first one is b x a1": axis[i] ==> axis[1]
// mistake "the blocks v of the rows, which are zero: take w2": ].w2 ==> ].v2
// mistake "turned back into the axes of body {1|2}: the iterations need the rows in world axes":
//         axis[i].w2 ==> to_local(body{1|2}, axis[i].w2)
// mistake "turned once more: axis.jacobian gives world axes already": axis[i].w2 ==>
//         to_world(body2, axis[i].w2)
// mistake "b and c themselves: their cross products with a1 belong there": axis[i].w2 ==>
//         to_world(body2, i == 0 ? hinge.axis.b_local : hinge.axis.c_local)
// mistake "a2, the axis of body 2, in the place of a1: then the rows are -c and b, right only while
//         the axes agree": axis[i].w2 ==> to_world(body2, i == 0 ? -hinge.axis.c_local :
//         hinge.axis.b_local)
// mistake "nothing is turned into the world: b, c and a1 are body-space": axis[i].w2 ==>
//         cross(hinge.axis.b_local * real(i == 0) + hinge.axis.c_local * real(i == 1),
//         hinge.axis.a1_local)
// mistake "a1_local is not turned into the world": axis[i].w2 ==> cross(to_world(body2,
//         hinge.axis.b_local) * real(i == 0) + to_world(body2, hinge.axis.c_local) * real(i == 1),
//         hinge.axis.a1_local)
// mistake "b_local and c_local are not turned into the world": axis[i].w2 ==>
//         cross(hinge.axis.b_local * real(i == 0) + hinge.axis.c_local * real(i == 1),
//         to_world(body1, hinge.axis.a1_local))
// mistake "b and c are turned with the wrong body: they ride on body 2": axis[i].w2 ==>
//         cross(to_world(body1, hinge.axis.b_local) * real(i == 0) + to_world(body1,
//         hinge.axis.c_local) * real(i == 1), to_world(body1, hinge.axis.a1_local))
// mistake "I{1|2}: not written yet": out.I{1|2} = symmetric(inverse_inertia(body{1|2})); ==>
// mistake "I{1|2}: body-space: it must be turned into the world, R I^-1 R^T,
//         inverse_inertia(body)": inverse_inertia(body{1|2}) ==> [&](Body b) { b.q = quat(1, 0, 0,
//         0); return inverse_inertia(b); }(body{1|2})
// mistake "I{1|2}: turned the wrong way round: R I^-1 R^T, not R^T I^-1 R":
//         inverse_inertia(body{1|2}) ==> [&](Body b) { b.q = conjugate(b.q); return
//         inverse_inertia(b); }(body{1|2})
// mistake "I{1|2}: the inertia of the other body": (body{1|2}) ==> (body{2|1})
// mistake "I{1|2}: turned with the other body": inverse_inertia(body{1|2}) ==> [&](Body b) { b.q =
//         body{2|1}.q; return inverse_inertia(b); }(body{1|2})
// mistake "I{1|2}: the inertia itself, not its inverse": inverse_inertia(body{1|2}) ==>
//         inverse(inverse_inertia(body{1|2}))
// mistake "I{1|2}: times the inverse mass: an inverse inertia has the mass in it":
//         inverse_inertia(body{1|2}) ==> body{1|2}.inverse_mass * inverse_inertia(body{1|2})
// mistake "I{1|2}: R^T is missing: R I^-1 R^T": inverse_inertia(body{1|2}) ==> [](const Body& b) {
//         mat3 R = glm::mat3_cast(b.q); for (int k = 0; k < 3; ++k) R[k] *=
//         b.inverse_inertia_local[k]; return R; }(body{1|2})
// mistake "I{1|2}: R^T is missing: R I^-1 R^T": inverse_inertia(body{1|2}) ==> [](const Body& b) {
//         mat3 R = glm::mat3_cast(b.q); for (int k = 0; k < 3; ++k) R[k] *=
//         b.inverse_inertia_local[k]; return transpose(R); }(body{1|2})
// mistake "I{1|2}: row after row: the diagonal xx, yy, zz comes first, then xy, xz, yz
//         (symmetric(m))": symmetric(inverse_inertia(body{1|2})) ==> [](const mat3& m) { return
//         Symmetric<real>{m[0].x, m[0].y, m[0].z, m[1].y, m[1].z, m[2].z};
//         }(inverse_inertia(body{1|2}))
// mistake "I{1|2}: the entries beside the diagonal are in another order: xy, xz, yz":
//         symmetric(inverse_inertia(body{1|2})) ==> [](const mat3& m) { return
//         Symmetric<real>{m[0].x, m[1].y, m[2].z, m[1].z, m[0].z, m[0].y};
//         }(inverse_inertia(body{1|2}))
// mistake "I{1|2}: the entries beside the diagonal are in another order: xy, xz, yz":
//         symmetric(inverse_inertia(body{1|2})) ==> [](const mat3& m) { return
//         Symmetric<real>{m[0].x, m[1].y, m[2].z, m[0].y, m[1].z, m[0].z};
//         }(inverse_inertia(body{1|2}))
// mistake "I{1|2}: only the diagonal: a turned body has numbers beside it":
//         symmetric(inverse_inertia(body{1|2})) ==> [](const mat3& m) { return
//         Symmetric<real>{m[0].x, m[1].y, m[2].z, 0, 0, 0}; }(inverse_inertia(body{1|2}))
// mistake "I1 and I2: the inertia itself, not its inverse": inverse_inertia(body2) ==>
//         inverse(inverse_inertia(body2)) ;; inverse_inertia(body1) ==>
//         inverse(inverse_inertia(body1))
// mistake "I1 and I2: the inertia of the other body": (body2) ==> (body1) ;; body1) ==> body2)
// mistake "I1 and I2: times the inverse mass: an inverse inertia has the mass in it":
//         inverse_inertia(body2) ==> body2.inverse_mass * inverse_inertia(body2) ;;
//         inverse_inertia(body1) ==> body1.inverse_mass * inverse_inertia(body1)
// mistake "I1 and I2: not written yet": out.I1 = symmetric(inverse_inertia(body1)); out.I2 =
//         symmetric(inverse_inertia(body2)); ==>
// mistake "h is forgotten: beta C is a length or an angle, a bias is a velocity: beta C / h":
//         hinge.beta / h ==> hinge.beta
// mistake "h is forgotten: beta C is a length or an angle, a bias is a velocity: beta C / h (the
//         {point|axis})": rate * {gap|tilt} ==> hinge.beta * {gap|tilt}
// mistake "beta is forgotten: this removes all of the error in one step": hinge.beta / h ==> 1 / h
// mistake "beta is forgotten: this removes all of the error in one step (the {point|axis})": rate *
//         {gap|tilt} ==> 1 / h * {gap|tilt}
// mistake "the error itself: beta C / h": hinge.beta / h ==> 1
// mistake "the error itself: beta C / h (the {point|axis})": rate * {gap|tilt} ==> 1 * {gap|tilt}
// mistake "times h where it must be divided by h": hinge.beta / h ==> hinge.beta * h
// mistake "times h where it must be divided by h (the {point|axis})": rate * {gap|tilt} ==>
//         hinge.beta * h * {gap|tilt}
// mistake "divided by h twice": hinge.beta / h ==> hinge.beta / h / h
// mistake "divided by h twice (the {point|axis})": rate * {gap|tilt} ==> hinge.beta / h / h *
//         {gap|tilt}
// mistake "the sign: a bias has the sign of C": hinge.beta / h ==> -hinge.beta / h
// mistake "the sign: a bias has the sign of C (the {point|axis})": rate * {gap|tilt} ==>
//         -hinge.beta / h * {gap|tilt}
// mistake "divided by beta: it is a fraction, a factor": hinge.beta / h ==> 1 / hinge.beta / h
// mistake "divided by beta: it is a fraction, a factor (the {point|axis})": rate * {gap|tilt} ==> 1
//         / hinge.beta / h * {gap|tilt}
// mistake "h and beta are exchanged: beta / h": hinge.beta / h ==> h / hinge.beta
// mistake "h and beta are exchanged: beta / h (the {point|axis})": rate * {gap|tilt} ==> h /
//         hinge.beta * {gap|tilt}
// mistake "1 - beta in the place of beta": hinge.beta / h ==> (1 - hinge.beta) / h
// mistake "1 - beta in the place of beta (the {point|axis})": rate * {gap|tilt} ==> (1 -
//         hinge.beta) / h * {gap|tilt}
// mistake "0.2 in the place of beta: take hinge.beta": hinge.beta / h ==> real(0.2) / h
// mistake "0.2 in the place of beta: take hinge.beta (the {point|axis})": rate * {gap|tilt} ==>
//         real(0.2) / h * {gap|tilt}
// mistake "60 in the place of 1/h: a step may have another length than 1/60 s": hinge.beta / h ==>
//         60 * hinge.beta
// mistake "60 in the place of 1/h: a step may have another length than 1/60 s (the {point|axis})":
//         rate * {gap|tilt} ==> 60 * hinge.beta * {gap|tilt}
// mistake "beta / h is cut to a whole number: an int has no fraction": hinge.beta / h ==>
//         int(hinge.beta / h)
// mistake "beta / h is cut to a whole number: an int has no fraction (the {point|axis})": rate *
//         {gap|tilt} ==> int(hinge.beta / h) * {gap|tilt}
// mistake "the size of the error: a bias has its sign": rate * gap[i] ==> rate * std::abs(gap[i])
//         ;; rate * tilt[i] ==> rate * std::abs(tilt[i])
// mistake "the size of the error: a bias has its sign (the {point|axis})": rate * {gap|tilt}[i] ==>
//         rate * std::abs({gap|tilt}[i])
// mistake "only negative errors are fed back": rate * gap[i] ==> rate * std::min(gap[i], real(0))
//         ;; rate * tilt[i] ==> rate * std::min(tilt[i], real(0))
// mistake "only negative errors are fed back (the {point|axis})": rate * {gap|tilt}[i] ==> rate *
//         std::min({gap|tilt}[i], real(0))
// mistake "only positive errors are fed back": rate * gap[i] ==> rate * std::max(gap[i], real(0))
//         ;; rate * tilt[i] ==> rate * std::max(tilt[i], real(0))
// mistake "only positive errors are fed back (the {point|axis})": rate * {gap|tilt}[i] ==> rate *
//         std::max({gap|tilt}[i], real(0))
// mistake "added to the old value: = and not +=": bias[i] = ==> bias[i] += ;; + i] = ==> + i] +=
// mistake "added to the old value: = and not += (the point)": out.bias[i] = ==> out.bias[i] +=
// mistake "the biases are not written yet": for (int i = 0; i < 3; ++i) out.bias[i] = rate *
//         gap[i]; for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i]; ==>
// mistake "all are zero: beta C / h, with the error as it is now": hinge.beta / h ==> 0
// mistake "{not written yet|zero}: bias[0], bias[1], bias[2]. All five errors are fed back, three
//         of the point and two of the axis": out.bias[i] = rate * gap[i]; ==> {h|out.bias[i] = 0};
// mistake "{not written yet|zero}: bias[3], bias[4]. All five errors are fed back, three of the
//         point and two of the axis": out.bias[3 + i] = rate * tilt[i] ==> {h|out.bias[3 + i] = 0}
// mistake "{not written yet|zero}: bias[4]. All five errors are fed back, three of the point and
//         two of the axis": out.bias[3 + i] = rate * tilt[i]; ==> if (i == 0) out.bias[3] = rate *
//         tilt[0]; else {h|out.bias[4]=0};
// mistake "{not written yet|zero}: bias[2]. All five errors are fed back, three of the point and
//         two of the axis": out.bias[i] = rate * gap[i]; ==> if (i < 2) out.bias[i] = rate *
//         gap[i]; else {h|out.bias[2]=0};
// mistake "a1.b stands there twice: the last one is of a1.c": tilt[i] ==> tilt[0]
// mistake "a1.c stands there twice: the one before the last is of a1.b": tilt[i] ==> tilt[1]
// mistake "the gap stands there once more in the place of the axis error: axis.error": rate * tilt
//         ==> rate * gap
// mistake "the bodies are exchanged: point.error(body1, body2)": hinge.point.error(body1, body2)
//         ==> hinge.point.error(body2, body1)
// mistake "the gap from centre to centre: it runs from anchor to anchor, point.error":
//         hinge.point.error(body1, body2) ==> body2.x - body1.x
// mistake "the gap with levers that are not turned into the world: point.error":
//         hinge.point.error(body1, body2) ==> body2.x + hinge.point.anchor2_local - body1.x -
//         hinge.point.anchor1_local
// mistake "the gap of the levers alone: it runs from anchor to anchor, point.error":
//         hinge.point.error(body1, body2) ==> to_world(body2, hinge.point.anchor2_local) -
//         to_world(body1, hinge.point.anchor1_local)
// mistake "the gap in the axes of body 2: point.error is in world axes already":
//         hinge.point.error(body1, body2) ==> to_local(body2, hinge.point.error(body1, body2))
// mistake "the length of the gap in all three: it has three numbers": gap[i] ==> length(gap)
// mistake "the axis error with nothing turned into the world: axis.error": hinge.axis.error(body1,
//         body2) ==> [&](Body one, Body two) { one.q = two.q = quat(1, 0, 0, 0); return
//         hinge.axis.error(one, two); }(body1, body2)
// mistake "the axis error with a1_local not turned into the world: axis.error":
//         hinge.axis.error(body1, body2) ==> [&](Body one, Body two) { one.q = quat(1, 0, 0, 0);
//         return hinge.axis.error(one, two); }(body1, body2)
// mistake "the axis error with b_local and c_local not turned into the world: axis.error":
//         hinge.axis.error(body1, body2) ==> [&](Body one, Body two) { two.q = quat(1, 0, 0, 0);
//         return hinge.axis.error(one, two); }(body1, body2)
// mistake "the velocities are included: the bias does not depend on them, J V is computed in the
//         solve": ]; ==> ] + (point_velocity(body2, to_world(body2, hinge.point.anchor2_local)) -
//         point_velocity(body1, to_world(body1, hinge.point.anchor1_local)))[i]; ;; tilt[i] ==>
//         tilt[i] + dot(axis[i].w2, body2.w - body1.w)
// mistake "the velocities are included: the bias does not depend on them, J V is computed in the
//         solve": rate * gap[i]; ==> rate * (gap[i] + (point_velocity(body2, to_world(body2,
//         hinge.point.anchor2_local)) - point_velocity(body1, to_world(body1,
//         hinge.point.anchor1_local)))[i]); ;; rate * tilt[i]; ==> rate * (tilt[i] +
//         dot(axis[i].w2, body2.w - body1.w));
// mistake "the velocities are included: the bias does not depend on them, J V is computed in the
//         solve": rate * gap[i]; ==> rate * (gap[i] + (point_velocity(body2, to_world(body2,
//         hinge.point.anchor2_local)) - point_velocity(body1, to_world(body1,
//         hinge.point.anchor1_local)))[i]);
// mistake "the velocities are included: the bias does not depend on them, J V is computed in the
//         solve": gap[i]; ==> gap[i] + (body2.v - body1.v)[i];
// mistake "the velocities are included: the bias does not depend on them, J V is computed in the
//         solve": tilt[i]; ==> tilt[i] + dot(axis[i].w2, body2.w - body1.w);
// mistake "the velocities are included: the bias does not depend on them, J V is computed in the
//         solve": ]; ==> ] + (point_velocity(body2, to_world(body2, hinge.point.anchor2_local)) -
//         point_velocity(body1, to_world(body1, hinge.point.anchor1_local)))[i];
// right levers by matrices:
  // R as a matrix, for the levers and for R I^-1 R^T.
  const mat3 R1 = glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q);
  out.r1 = triple(R1 * hinge.point.anchor1_local);
  out.r2 = triple(R2 * hinge.point.anchor2_local);
  mat3 I1(0), I2(0);
  for (int k = 0; k < 3; ++k) {
    I1[k][k] = body1.inverse_inertia_local[k];
    I2[k][k] = body2.inverse_inertia_local[k];
  }
  out.I1 = symmetric(R1 * I1 * transpose(R1));
  out.I2 = symmetric(R2 * I2 * transpose(R2));
  const vec3 a1 = R1 * hinge.axis.a1_local;
  const vec3 b = R2 * hinge.axis.b_local, c = R2 * hinge.axis.c_local;
  out.axis_row[0] = triple(cross(b, a1));
  out.axis_row[1] = triple(cross(c, a1));
  const vec3 u = body2.x + R2 * hinge.point.anchor2_local - body1.x -
                 R1 * hinge.point.anchor1_local;
  const real C[] = {u.x, u.y, u.z, dot(a1, b), dot(a1, c)};
  for (int i = 0; i < 5; ++i) out.bias[i] = hinge.beta * C[i] / h;
// right made anew with its K:
  // Everything at once, and the old contents of inverse_K are put back.
  const HingeNumbers<real> before = out;
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  const vec3 u = hinge.point.error(body1, body2);
  const Vector<2> C = hinge.axis.error(body1, body2);
  const real share = hinge.beta / h;
  out = {triple(to_world(body1, hinge.point.anchor1_local)),
         triple(to_world(body2, hinge.point.anchor2_local)),
         {triple(axis[0].w2), triple(axis[1].w2)},
         symmetric(inverse_inertia(body1)),
         symmetric(inverse_inertia(body2)),
         {share * u.x, share * u.y, share * u.z, share * C[0], share * C[1]},
         {}};
  for (int n = 0; n < 15; ++n) out.inverse_K[n] = before.inverse_K[n];
// right rows of body 1 turned round:
  // The blocks w1 are the opposites of those that are wanted; the point's levers stand in its J.
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(-axis[i].w1);
  out.r1 = triple(world_point(body1, hinge.point.anchor1_local) - body1.x);
  out.r2 = triple(world_point(body2, hinge.point.anchor2_local) - body2.x);
  const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
  out.I1 = {I1[0].x, I1[1].y, I1[2].z, I1[0].y, I1[0].z, I1[1].z};
  out.I2 = {I2[0].x, I2[1].y, I2[2].z, I2[0].y, I2[0].z, I2[1].z};
  const vec3 gap = hinge.point.error(body1, body2) * hinge.beta / h;
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  out.bias[0] = gap.x;
  out.bias[1] = gap.y;
  out.bias[2] = gap.z;
  out.bias[3] = hinge.beta * tilt[0] / h;
  out.bias[4] = hinge.beta * tilt[1] / h;
// wrong units "a bias of the point is in m and should be in m/s: a time too many": / h ==>
// wrong units "in the hoisted numbers, adding m/s to m": gap[i] ==> (gap[i] + body2.v[i] - body1.v[i])
// wrong units "I2 is in kg m^2 and should be in 1/(kg m^2): inertia where its inverse":
//         inverse_inertia(body2) ==> inverse(inverse_inertia(body2))
