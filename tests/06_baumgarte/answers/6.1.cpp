// wrong drawn-threshold: return ==> if (std::abs(C) < real(1e-9)) return 0; return
// wrong "beta is cut to a whole number: an int has no fraction": return beta ==> const int share =
//         beta; return share
// wrong "yours is C^2 beta / h in every case": beta * C / h ==> beta * C * C / h
// wrong "a factor of 2, in every case": beta * C / h ==> 2 * beta * C / h
// wrong "b is kept from -1 to 1: there is no such bound": beta * C / h ==> glm::clamp(beta * C / h,
//         real(-1), real(1))
// wrong fixed-beta: beta * ==> real(0.2) *
// wrong of-small-errors: beta ==> std::abs(C) < real(0.05) ? 0 : beta
// wrong over-60: h ==> 60
// wrong sign-b-has-sign: beta ==> -beta
// wrong "60 in the place of 1/h": / h ==> * 60
// expects: b, C -0.02 beta 0.15 h 1/100
// wrong "yours is beta h / C in every case": beta * C / h ==> beta * h / C
// wrong never-set: return ==> real b; b += ;; h; ==> h; return b;
// wrong "1/h is cut to a whole number: an int has no fraction": return beta * C / h ==> const int
//         rate = 1 / h; return beta * C * rate
// expects: h 1/72.5
// wrong "h is forgotten: beta C is a length": / h ==>
// expects: b, C 0.02 beta 0.15 h 1/60
// right bias by a rate: return beta * C / h; ==> const real rate = beta / h; return rate * C;
// wrong units "the bias is in m and should be in m/s: a time too many": / h ==>

// region 2
// wrong drawn-threshold: return C < 0 ==> return C < real(-1e-9)
// wrong "a limit that lies ahead stops the approach far from it": C / h; ==> 0;
// wrong "a limit that lies ahead needs no beta: C/h just reaches it": C < 0 ? ==> ;; : C / h ==>
// expects: b, C 0.02 beta 0.15 h 1/60
// wrong "beta is cut to a whole number: an int has no fraction": return C < 0 ? beta * C / h : C /
//         h ==> const int share = C < 0 ? beta : 1; return share * C / h
// wrong compared-with-beta: C < 0 ==> C < beta
// wrong "where C < 0 yours is C / h, and where C > 0 it is 0": beta * C / h : C / h ==> C / h : 0
// wrong "the larger one of the two": C < 0 ? beta * C / h : C / h ==> std::max(beta * C / h, C / h)
// expects: b, C -0.02 beta 1.5 h 1/60
// wrong "the two lines are exchanged": < 0 ==> > 0
// expects: b, C -0.02 beta 0.15 h 1/60
// wrong "where C < 0 yours is beta, and where C > 0 it is C / h": * C / h : C / h ==> : 1 * C / h
// right limit by smaller and larger: C < 0 ? beta * C / h : C ==> (beta * glm::min(C, real(0)) +
//         glm::max(C, real(0)))
// right limit by the bias: C < 0 ? beta * C / h : C / h ==> bias(C, C < 0 ? beta : 1, h)
// right limit zero on the side of beta: return C < ==> const real b = C / h; return C <= ;; C / h :
//         C / h ==> b : b

// region 3
// wrong few-digits: -h / half_time ==> float(-h / half_time)
// wrong "e in the place of 2": exp2 ==> exp
// expects: beta, T 0.1 s, h 1/60 s
// wrong time-share-that-left: 1 - ==>
// wrong "yours is 1 - h^2 / T^2": exp2(-h / half_time) ==> pow(-h / half_time, real(2))
// wrong time-straight-line: 1 - std::exp2(-h / half_time) ==> h / (2 * half_time)
// wrong "yours is 1 - 2^-(2 h / T)": -h ==> -2 * h
// wrong time-upside-down: h / half_time ==> half_time / h
// wrong time-whole-numbers: exp2 ==> pow ;; -h ==> 1 / 2, h
// wrong time-whole-steps: return 1 - std::exp2(-h / half_time) ==> const int steps = half_time / h;
//         return 1 - std::pow(real(0.5), real(1) / steps)
// right half time as a power of a half: exp2 ==> pow ;; -h ==> real(0.5), h
// right half time with the logarithm: 1 - std::exp2(-h / half_time) ==>
//         -std::expm1(-std::log(real(2)) * h / half_time)
// wrong units "in beta, the exponential of 1/s": h ==> 1
