// wrong drawn-side: if (K == 0) ==> if (K == 0 || body2.is_static())
// mistake "nothing is done where the bias is 0: even where C = 0 the velocity J V would change C":
//         == 0 ==> == 0 || std::abs(bias) < epsilon
// mistake "the bias is missing: the error is not fed back": (row_velocity(J, body1, body2) + bias)
//         ==> row_velocity(J, body1, body2)
// mistake "nothing is done where K is small: K is small for heavy bodies, and only 0 means that no
//         body can move": == 0 ==> < real(1e-3)
// mistake "nothing is done where K is small: K is small for heavy bodies, and only 0 means that no
//         body can move": == 0 ==> < real(1e-9)
// wrong division-by-zero: if (K == 0) return 0; ==>
// mistake "0 is returned where K is not 0: is the condition the wrong way round?": == 0 ==> != 0
// mistake "where K is 0 no body can move: lambda is 0": 0; ==> bias;
// mistake "the sign: the impulse works against J V + b": return - ==> return
// mistake "the sign of the bias": + bias ==> - bias
// mistake "only the bias is divided by K: put J V + b in brackets": (row_velocity(J, body1, body2)
//         + bias) ==> row_velocity(J, body1, body2) + bias
// mistake "only J V is divided by K: put J V + b in brackets": (row_velocity(J, body1, body2) +
//         bias) / K ==> row_velocity(J, body1, body2) / K + bias
// mistake "K is missing: a velocity is no impulse": / K ==>
// mistake "times K where its inverse belongs": / K ==> * K
// mistake "bodies 1 and 2 are exchanged in J V": body1, body2 ==> body2, body1
// mistake "the angular velocities are missing in J V: row_velocity reads all four blocks":
//         row_velocity(J, body1, body2) ==> (dot(J.v1, body1.v) + dot(J.v2, body2.v))
// mistake "J V is written out as if J.v1 and J.v2 were known: row_velocity reads all four blocks":
//         row_velocity(J, body1, body2) ==> dot(J.v2, body2.v - body1.v)
// mistake "K is an argument: it is 1/m1 + 1/m2 only for a rod from centre to centre": K; ==>
//         (body1.inverse_mass + body2.inverse_mass);
// mistake "a row may push and pull: lambda has either sign": -(row_velocity(J, body1, body2) +
//         bias) / K ==> glm::max(-(row_velocity(J, body1, body2) + bias) / K, real(0))
// mistake "the sign is lost: lambda is not a size": return - ==> return std::abs
// mistake "nothing is done where J V is 0: the error still has to be corrected": K == ==> K == 0 ||
//         row_velocity(J, body1, body2) ==
// mistake "nothing is done where J V + b is small: there is no such threshold": return - ==> if
//         (std::abs(row_velocity(J, body1, body2) + bias) < real(1e-6)) return 0; return -
// mistake "nothing is done where one body is static: the other one can move": K == 0 ==>
//         body1.is_static() || body2.is_static()
// mistake "the bias b is used as it is: neither beta nor h belongs here": bias ==> real(0.2) * bias
// wrong never-set: return -(row_velocity(J, body1, body2) + bias) ==> real e; e += row_velocity(J,
//         body1, body2) + bias; return -e
// mistake "the sign of the bias; and K = 0 is divided by": if (K == 0) return 0; ==> ;; + bias ==>
//         - bias
// mistake "the sign: the impulse works against J V + b; and nothing is done where K is small: K is
//         small for heavy bodies, and only 0 means that no body can move": == 0 ==> < real(1e-3) ;;
//         return - ==> return
// mistake "body 1 is missing in J V": row_velocity(J, body1, body2) ==> (dot(J.v2, body2.v) +
//         dot(J.w2, body2.w))
// mistake "the sign of a body in J V: all four products are added": 0; ==> 0; const real rate =
//         dot(J.v2, body2.v) + dot(J.w2, body2.w) - dot(J.v1, body1.v) - dot(J.w1, body1.w); ;;
//         row_velocity(J, body1, body2) ==> rate
// right K not positive: if (K == 0) return 0; return ==> return K <= 0 ? real(0) :
// right J V written out: 0; ==> 0; const real JV = dot(J.v1, body1.v) + dot(J.w1, body1.w) +
//         dot(J.v2, body2.v) + dot(J.w2, body2.w); ;; row_velocity(J, body1, body2) ==> JV
// right times the effective mass: / K ==> * (1 / K)
// mistake "0 is returned always": if (K == 0) ==>
// mistake "J V is missing": row_velocity(J, body1, body2) + ==>
// mistake "only the bias is divided by K: put J V + b in brackets": -(row_velocity(J, body1, body2)
//         + bias) / K ==> bias / K - row_velocity(J, body1, body2)
// mistake "only the bias is divided by K: put J V + b in brackets": -(row_velocity(J, body1, body2)
//         + bias) / K ==> -bias / K - row_velocity(J, body1, body2)
// mistake "only J V is divided by K: put J V + b in brackets": -(row_velocity(J, body1, body2) +
//         bias) / K ==> bias - row_velocity(J, body1, body2) / K
// mistake "only J V is divided by K: put J V + b in brackets": -(row_velocity(J, body1, body2) +
//         bias) / K ==> -bias - row_velocity(J, body1, body2) / K
// mistake "body 2 is missing in J V": row_velocity(J, body1, body2) ==> (dot(J.v1, body1.v) +
//         dot(J.w1, body1.w))
// mistake "the sign of a body in J V: all four products are added": row_velocity(J, body1, body2)
//         ==> (dot(J.v1, body1.v) + dot(J.w1, body1.w) - (dot(J.v2, body2.v) + dot(J.w2, body2.w)))
// mistake "J V is written out as if J.v1 and J.v2 were known: row_velocity reads all four blocks":
//         row_velocity(J, body1, body2) ==> (dot(J.v2, body2.v - body1.v) + dot(J.w1, body1.w) +
//         dot(J.w2, body2.w))
// mistake "the fraction is cut off: an int holds whole numbers only": return -( ==> return int(-(
//         ;; / K; ==> / K);
// mistake "a factor of 0.5": / K ==> / K / 2
// mistake "a factor of 2": / K ==> / K * 2
// mistake "a row may push and pull: lambda has either sign": -(row_velocity(J, body1, body2) +
//         bias) / K ==> glm::min(-(row_velocity(J, body1, body2) + bias) / K, real(0))
// mistake "the sign is lost: lambda is not a size": return - ==> return -std::abs
// mistake "the bias b is used as it is: neither beta nor h belongs here": + bias ==> + 60 * bias
// mistake "the bias b is used as it is: neither beta nor h belongs here": + bias ==> + bias / 60
// mistake "nothing is done where the bias is 0: even where C = 0 the velocity J V would change C":
//         K == 0 ==> K == 0 || std::abs(bias) < real(1e-12)
// mistake "nothing is done where the bias is 0: even where C = 0 the velocity J V would change C":
//         K == 0 ==> K == 0 || std::abs(bias) < real(1e-8)
// mistake "nothing is done where J V is 0: the error still has to be corrected": K == 0 ==> K == 0
//         || std::abs(row_velocity(J, body1, body2)) < real(1e-12)
// mistake "nothing is done where J V is 0: the error still has to be corrected": K == 0 ==> K == 0
//         || std::abs(row_velocity(J, body1, body2)) < real(1e-8)
// mistake "nothing is done where K is small: K is small for heavy bodies, and only 0 means that no
//         body can move": K == 0 ==> K < real(0.1)
// mistake "nothing is done where K is small: K is small for heavy bodies, and only 0 means that no
//         body can move": K == 0 ==> K < real(1e-15)
// mistake "nothing is done where J V + b is small: there is no such threshold": return - ==> if
//         (std::abs(row_velocity(J, body1, body2) + bias) < real(1e-3)) return 0; return -

// region 2
// mistake "J is missing: lambda acts along J.v1, J.w1, J.v2 and J.w2. A number added to a vector is
//         added to each of its components": lambda * J.v1 ==> lambda ;; lambda * J.v2 ==> lambda
// mistake "J is missing: lambda acts along J.v1, J.w1, J.v2 and J.w2. A number added to a vector is
//         added to each of its components": += body1.inverse_mass * lambda * J.v1 ==> -=
//         body1.inverse_mass * lambda ;; lambda * J.w1 ==> vec3(lambda) ;; lambda * J.v2 ==> lambda
//         ;; lambda * J.w2 ==> vec3(lambda)
// wrong drawn-side: body1.v += ==> if (!body2.is_static()) body1.v += ;; body1.w += ==> if
//         (!body2.is_static()) body1.w +=
// wrong drawn-threshold: body1.v += ==> if (std::abs(lambda) < real(1e-9)) return; body1.v +=
// wrong drawn-cut: body1.v += ==> if (std::abs(lambda) > real(1e3)) return; body1.v +=
// mistake "body-space inertia: take inverse_inertia(body)": inverse_inertia(body1) ==>
//         body1.inverse_inertia_local ;; inverse_inertia(body2) ==> body2.inverse_inertia_local
// mistake "the sign: velocities grow by +M^-1 J^T lambda": += body1 ==> -= body1 ;; w += ==> w -=
// mistake "the velocity is set where it must grow: += and not =": += body1 ==> = body1 ;; w += ==>
//         w = ;; += body2 ==> = body2 ;; w += ==> w =
// mistake "not changed at all":
  body1.v += body1.inverse_mass * lambda * J.v1;
  body2.v += body2.inverse_mass * lambda * J.v2;
// mistake "the part of body 2 is given to body 1": body2 ==> body1 ;; body2.w ==> body1.w
// wrong "the block v of the other body (v2); the block w of the other body (w2)": v2; ==> v1; ;; w2
//         ==> w1
// mistake "the block v of the row where w belongs": w1 ==> v1 ;; w2 ==> v2
// mistake "the inverse mass of the other body": += body2 ==> += body1 ;; += body1 ==> += body2
// mistake "lambda is missing": * lambda ==> ;; lambda * ==> ;; * lambda ==> ;; lambda * ==>
// mistake "mass where inverse mass belongs": body1.inverse_mass * lambda * J.v1 ==> lambda * J.v1 /
//         body1.inverse_mass ;; body2.inverse_mass * lambda * J.v2 ==> lambda * J.v2 /
//         body2.inverse_mass
// mistake "inertia where inverse inertia belongs": inverse_inertia(body1) ==>
//         inverse(inverse_inertia(body1)) ;; inverse_inertia(body2) ==>
//         inverse(inverse_inertia(body2))
// mistake "nothing is done where one body is static: the other one can move": body1 ==> if
//         (body1.is_static() || body2.is_static()) return; body1
// mistake "a small lambda is left out: a light body needs only a small one": body1 ==> if
//         (std::abs(lambda) < real(1e-6)) return; body1
// mistake "a negative lambda is left out: it pulls": body1 ==> if (lambda < 0) return; body1
// mistake "not changed at all": body2.w ==> b.w ;; body2 ==> b ;; body1.w ==> a.w ;; body1 ==> Body
//         a = body1, b = body2; a
// wrong positions-moved-too (x): v2; ==> v2; body1.x += body1.v / real(60);
// wrong "the inverse mass is missing (v1 and v2); the inverse inertia is missing (w1 and w2)":
//          body1.inverse_mass * ==> ;; inverse_inertia(body1) * ==> ;; body2.inverse_mass * ==> ;;
//         inverse_inertia(body2) * ==>
// right vector times symmetric matrix: inverse_inertia(body1) * (lambda * J.w1) ==> lambda * J.w1 *
//         inverse_inertia(body1)
// right walls left out: body1 ==> if (body1.is_static() && body2.is_static()) return; body1
// wrong units "in V + M^-1 J^T lambda, adding kg m/s to m/s: the inverse mass is missing":
//          body1.inverse_mass * ==> ;; body2.inverse_mass * ==>
// mistake "not changed at all": body1.v += body1.inverse_mass * lambda * J.v1; ==>  ;; body1.w +=
//         inverse_inertia(body1) * (lambda * J.w1); ==>  ;; body2.v += body2.inverse_mass * lambda
//         * J.v2; ==>  ;; body2.w += inverse_inertia(body2) * (lambda * J.w2); ==>
// mistake "the sign: velocities grow by +M^-1 J^T lambda": body1.v += body1.inverse_mass * lambda *
//         J.v1; ==> body1.v -= body1.inverse_mass * lambda * J.v1; ;; body1.w +=
//         inverse_inertia(body1) * (lambda * J.w1); ==> body1.w -= inverse_inertia(body1) * (lambda
//         * J.w1); ;; body2.v += body2.inverse_mass * lambda * J.v2; ==> body2.v -=
//         body2.inverse_mass * lambda * J.v2; ;; body2.w += inverse_inertia(body2) * (lambda *
//         J.w2); ==> body2.w -= inverse_inertia(body2) * (lambda * J.w2);
// mistake "a factor of 0.5": body1.v += body1.inverse_mass * lambda * J.v1; ==> body1.v +=
//         real(0.5) * body1.inverse_mass * lambda * J.v1; ;; body1.w += inverse_inertia(body1) *
//         (lambda * J.w1); ==> body1.w += real(0.5) * inverse_inertia(body1) * (lambda * J.w1); ;;
//         body2.v += body2.inverse_mass * lambda * J.v2; ==> body2.v += real(0.5) *
//         body2.inverse_mass * lambda * J.v2; ;; body2.w += inverse_inertia(body2) * (lambda *
//         J.w2); ==> body2.w += real(0.5) * inverse_inertia(body2) * (lambda * J.w2);
// mistake "a factor of 2": body1.v += body1.inverse_mass * lambda * J.v1; ==> body1.v += real(2) *
//         body1.inverse_mass * lambda * J.v1; ;; body1.w += inverse_inertia(body1) * (lambda *
//         J.w1); ==> body1.w += real(2) * inverse_inertia(body1) * (lambda * J.w1); ;; body2.v +=
//         body2.inverse_mass * lambda * J.v2; ==> body2.v += real(2) * body2.inverse_mass * lambda
//         * J.v2; ;; body2.w += inverse_inertia(body2) * (lambda * J.w2); ==> body2.w += real(2) *
//         inverse_inertia(body2) * (lambda * J.w2);
// mistake "the block w of the other body": body1.w += inverse_inertia(body1) * (lambda * J.w1); ==>
//         body1.w += inverse_inertia(body1) * (lambda * J.w2); ;; body2.w += inverse_inertia(body2)
//         * (lambda * J.w2); ==> body2.w += inverse_inertia(body2) * (lambda * J.w1);
// mistake "the block w of the other body with its sign turned": body1.w += inverse_inertia(body1) *
//         (lambda * J.w1); ==> body1.w -= inverse_inertia(body1) * (lambda * J.w2); ;; body2.w +=
//         inverse_inertia(body2) * (lambda * J.w2); ==> body2.w -= inverse_inertia(body2) * (lambda
//         * J.w1);
// mistake "the inverse inertia is missing": body1.w += inverse_inertia(body1) * (lambda * J.w1);
//         ==> body1.w += lambda * J.w1; ;; body2.w += inverse_inertia(body2) * (lambda * J.w2); ==>
//         body2.w += lambda * J.w2;
// mistake "inverse mass where inverse inertia belongs": body1.w += inverse_inertia(body1) * (lambda
//         * J.w1); ==> body1.w += body1.inverse_mass * lambda * J.w1; ;; body2.w +=
//         inverse_inertia(body2) * (lambda * J.w2); ==> body2.w += body2.inverse_mass * lambda *
//         J.w2;
// mistake "the inertia of the other body": body1.w += inverse_inertia(body1) * (lambda * J.w1); ==>
//         body1.w += inverse_inertia(body2) * (lambda * J.w1); ;; body2.w += inverse_inertia(body2)
//         * (lambda * J.w2); ==> body2.w += inverse_inertia(body1) * (lambda * J.w2);
// mistake "one moment stands for all three axes: that is right for a ball alone": body1.w +=
//         inverse_inertia(body1) * (lambda * J.w1); ==> body1.w += body1.inverse_inertia_local.x *
//         lambda * J.w1; ;; body2.w += inverse_inertia(body2) * (lambda * J.w2); ==> body2.w +=
//         body2.inverse_inertia_local.x * lambda * J.w2;
// mistake "one moment stands for all three axes: that is right for a ball alone": body1.w +=
//         inverse_inertia(body1) * (lambda * J.w1); ==> body1.w += body1.inverse_inertia_local.y *
//         lambda * J.w1; ;; body2.w += inverse_inertia(body2) * (lambda * J.w2); ==> body2.w +=
//         body2.inverse_inertia_local.y * lambda * J.w2;
// mistake "one moment stands for all three axes: that is right for a ball alone": body1.w +=
//         inverse_inertia(body1) * (lambda * J.w1); ==> body1.w += body1.inverse_inertia_local.z *
//         lambda * J.w1; ;; body2.w += inverse_inertia(body2) * (lambda * J.w2); ==> body2.w +=
//         body2.inverse_inertia_local.z * lambda * J.w2;
// mistake "the change of w is turned into the axes of its body: w is in world axes": body1.w +=
//         inverse_inertia(body1) * (lambda * J.w1); ==> body1.w += to_local(body1,
//         inverse_inertia(body1) * (lambda * J.w1)); ;; body2.w += inverse_inertia(body2) * (lambda
//         * J.w2); ==> body2.w += to_local(body2, inverse_inertia(body2) * (lambda * J.w2));
// mistake "J.w is turned into the axes of its body: inverse_inertia(body) is in world axes, and J
//         is, too": body1.w += inverse_inertia(body1) * (lambda * J.w1); ==> body1.w +=
//         inverse_inertia(body1) * to_local(body1, lambda * J.w1); ;; body2.w +=
//         inverse_inertia(body2) * (lambda * J.w2); ==> body2.w += inverse_inertia(body2) *
//         to_local(body2, lambda * J.w2);
// mistake "the block v of the other body": body1.v += body1.inverse_mass * lambda * J.v1; ==>
//         body1.v += body1.inverse_mass * lambda * J.v2; ;; body2.v += body2.inverse_mass * lambda
//         * J.v2; ==> body2.v += body2.inverse_mass * lambda * J.v1;
// mistake "the block v of the other body with its sign turned: a row need not be (-n, ..., n,
//         ...)": body1.v += body1.inverse_mass * lambda * J.v1; ==> body1.v -= body1.inverse_mass *
//         lambda * J.v2; ;; body2.v += body2.inverse_mass * lambda * J.v2; ==> body2.v -=
//         body2.inverse_mass * lambda * J.v1;
// mistake "the block w of the row where v belongs": body1.v += body1.inverse_mass * lambda * J.v1;
//         ==> body1.v += body1.inverse_mass * lambda * J.w1; ;; body2.v += body2.inverse_mass *
//         lambda * J.v2; ==> body2.v += body2.inverse_mass * lambda * J.w2;
// mistake "the inverse mass is missing": body1.v += body1.inverse_mass * lambda * J.v1; ==> body1.v
//         += lambda * J.v1; ;; body2.v += body2.inverse_mass * lambda * J.v2; ==> body2.v += lambda
//         * J.v2;
// mistake "the inverse masses of both bodies: each body has its own": body1.v += body1.inverse_mass
//         * lambda * J.v1; ==> body1.v += (body1.inverse_mass + body2.inverse_mass) * lambda *
//         J.v1; ;; body2.v += body2.inverse_mass * lambda * J.v2; ==> body2.v +=
//         (body1.inverse_mass + body2.inverse_mass) * lambda * J.v2;
// mistake "J is missing: lambda acts along J.v1, J.w1, J.v2 and J.w2. A number added to a vector is
//         added to each of its components": body1.v += body1.inverse_mass * lambda * J.v1; ==>
//         body1.v += body1.inverse_mass * lambda; ;; body1.w += inverse_inertia(body1) * (lambda *
//         J.w1); ==> body1.w += inverse_inertia(body1) * vec3(lambda); ;; body2.v +=
//         body2.inverse_mass * lambda * J.v2; ==> body2.v += body2.inverse_mass * lambda; ;;
//         body2.w += inverse_inertia(body2) * (lambda * J.w2); ==> body2.w +=
//         inverse_inertia(body2) * vec3(lambda);
// mistake "J is missing: lambda acts along J.v1, J.w1, J.v2 and J.w2. A number added to a vector is
//         added to each of its components": body1.v += body1.inverse_mass * lambda * J.v1; ==>
//         body1.v -= body1.inverse_mass * lambda; ;; body1.w += inverse_inertia(body1) * (lambda *
//         J.w1); ==> body1.w -= inverse_inertia(body1) * vec3(lambda); ;; body2.v +=
//         body2.inverse_mass * lambda * J.v2; ==> body2.v -= body2.inverse_mass * lambda; ;;
//         body2.w += inverse_inertia(body2) * (lambda * J.w2); ==> body2.w -=
//         inverse_inertia(body2) * vec3(lambda);
// mistake "lambda is an int: it cuts the fraction off": body1.v += ==> const int whole = lambda;
//         body1.v += ;; * lambda ==> * whole ;; (lambda ==> (real(whole) ;; * lambda ==> * whole ;;
//         (lambda ==> (real(whole)
// mistake "a small lambda is left out: a light body needs only a small one": body1 ==> if (lambda <
//         real(1e-4) && lambda >= 0) return; body1
