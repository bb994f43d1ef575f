// wrong drawn-side: if (K == 0) ==> if (K == 0 || body2.is_static())
// wrong nothing-done-where-bias: == 0 ==> == 0 || std::abs(bias) < epsilon
// wrong without-bias: (row_velocity(J, body1, body2) + bias) ==> row_velocity(J, body1, body2)
// wrong small-k-taken-none: == 0 ==> < real(1e-3)
// wrong small-k-taken-none: == 0 ==> < real(1e-9)
// wrong division-by-zero: if (K == 0) return 0; ==>
// wrong condition-wrong-way-round: == 0 ==> != 0
// wrong bias-where-nothing-can: 0; ==> bias;
// wrong sign-impulse: return - ==> return
// wrong sign-bias: + bias ==> - bias
// wrong brackets-forgotten-bias-over: (row_velocity(J, body1, body2) + bias) ==> row_velocity(J,
//         body1, body2) + bias
// wrong brackets-forgotten-rate-over: (row_velocity(J, body1, body2) + bias) / K ==>
//         row_velocity(J, body1, body2) / K + bias
// wrong without-k: / K ==>
// wrong times-k: / K ==> * K
// wrong bodies-exchanged-j-v: body1, body2 ==> body2, body1
// wrong angular-velocities-left-out: row_velocity(J, body1, body2) ==> (dot(J.v1, body1.v) +
//         dot(J.v2, body2.v))
// wrong j-v-rod: row_velocity(J, body1, body2) ==> dot(J.v2, body2.v - body1.v)
// wrong k-rod: K; ==> (body1.inverse_mass + body2.inverse_mass);
// wrong never-a-pull: -(row_velocity(J, body1, body2) + bias) / K ==> glm::max(-(row_velocity(J,
//         body1, body2) + bias) / K, real(0))
// wrong size-impulse: return - ==> return std::abs
// wrong only-where-something-moves: K == ==> K == 0 || row_velocity(J, body1, body2) ==
// wrong small-rates-left-out: return - ==> if (std::abs(row_velocity(J, body1, body2) + bias) <
//         real(1e-6)) return 0; return -
// wrong nothing-done-where-one: K == 0 ==> body1.is_static() || body2.is_static()
// wrong beta-once-more: bias ==> real(0.2) * bias
// wrong never-set: return -(row_velocity(J, body1, body2) + bias) ==> real e; e += row_velocity(J,
//         body1, body2) + bias; return -e
// wrong "the sign of the bias; and K = 0 is divided by": if (K == 0) return 0; ==> ;; + bias ==> -
//         bias
// wrong sign-impulse + small-k-taken-none: == 0 ==> < real(1e-3) ;; return - ==> return
// wrong body-1-left-out: row_velocity(J, body1, body2) ==> (dot(J.v2, body2.v) + dot(J.w2,
//         body2.w))
// wrong minus-body-1-j: 0; ==> 0; const real rate = dot(J.v2, body2.v) + dot(J.w2, body2.w) -
//         dot(J.v1, body1.v) - dot(J.w1, body1.w); ;; row_velocity(J, body1, body2) ==> rate
// right K not positive: if (K == 0) return 0; return ==> return K <= 0 ? real(0) :
// right J V written out: 0; ==> 0; const real JV = dot(J.v1, body1.v) + dot(J.w1, body1.w) +
//         dot(J.v2, body2.v) + dot(J.w2, body2.w); ;; row_velocity(J, body1, body2) ==> JV
// right times the effective mass: / K ==> * (1 / K)

// region 2
// wrong j-missing (v1 and v2): lambda * J.v1 ==> lambda ;; lambda * J.v2 ==> lambda
// wrong j-missing (v1, w1, v2 and w2): += body1.inverse_mass * lambda * J.v1 ==> -=
//         body1.inverse_mass * lambda ;; lambda * J.w1 ==> vec3(lambda) ;; lambda * J.v2 ==> lambda
//         ;; lambda * J.w2 ==> vec3(lambda)
// wrong drawn-side: body1.v += ==> if (!body2.is_static()) body1.v += ;; body1.w += ==> if
//         (!body2.is_static()) body1.w +=
// wrong drawn-threshold: body1.v += ==> if (std::abs(lambda) < real(1e-9)) return; body1.v +=
// wrong drawn-cut: body1.v += ==> if (std::abs(lambda) > real(1e3)) return; body1.v +=
// wrong body-space-inertia (w1 and w2): inverse_inertia(body1) ==> body1.inverse_inertia_local ;;
//         inverse_inertia(body2) ==> body2.inverse_inertia_local
// wrong one-sign-too-many (v1 and w1): += body1 ==> -= body1 ;; w += ==> w -=
// wrong velocities-set (v1, w1, v2 and w2): += body1 ==> = body1 ;; w += ==> w = ;; += body2 ==> =
//         body2 ;; w += ==> w =
// wrong not-changed (w1 and w2):
  body1.v += body1.inverse_mass * lambda * J.v1;
  body2.v += body2.inverse_mass * lambda * J.v2;
// wrong both-shares-body-1: body2 ==> body1 ;; body2.w ==> body1.w
// wrong "the block v of the other body (v2); the block w of the other body (w2)": v2; ==> v1; ;; w2
//         ==> w1
// wrong blocks-v-w (w1 and w2): w1 ==> v1 ;; w2 ==> v2
// wrong masses-exchanged (v1 and v2): += body2 ==> += body1 ;; += body1 ==> += body2
// wrong without-lambda (v1, w1, v2 and w2): * lambda ==> ;; lambda * ==> ;; * lambda ==> ;; lambda
//         * ==>
// wrong masses-inverse-masses (v1 and v2): body1.inverse_mass * lambda * J.v1 ==> lambda * J.v1 /
//         body1.inverse_mass ;; body2.inverse_mass * lambda * J.v2 ==> lambda * J.v2 /
//         body2.inverse_mass
// wrong inertia-inverse (w1 and w2): inverse_inertia(body1) ==> inverse(inverse_inertia(body1)) ;;
//         inverse_inertia(body2) ==> inverse(inverse_inertia(body2))
// wrong nothing-done-where-one: body1 ==> if (body1.is_static() || body2.is_static()) return; body1
// wrong small-impulses-left-out: body1 ==> if (std::abs(lambda) < real(1e-6)) return; body1
// wrong negative-impulses-left-out: body1 ==> if (lambda < 0) return; body1
// wrong not-changed (v1, w1, v2 and w2): body2.w ==> b.w ;; body2 ==> b ;; body1.w ==> a.w ;; body1
//         ==> Body a = body1, b = body2; a
// wrong positions-moved-too (x): v2; ==> v2; body1.x += body1.v / real(60);
// wrong "the inverse mass is missing (v1 and v2); the inverse inertia is missing (w1 and w2)":
//         body1.inverse_mass * ==> ;; inverse_inertia(body1) * ==> ;; body2.inverse_mass * ==> ;;
//         inverse_inertia(body2) * ==>
// right vector times symmetric matrix: inverse_inertia(body1) * (lambda * J.w1) ==> lambda * J.w1 *
//         inverse_inertia(body1)
// right walls left out: body1 ==> if (body1.is_static() && body2.is_static()) return; body1
// wrong units "in V + M^-1 J^T lambda, adding kg m/s to m/s: the inverse mass is missing":
//         body1.inverse_mass * ==> ;; body2.inverse_mass * ==>
