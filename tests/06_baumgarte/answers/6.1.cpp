// mistake "h is forgotten: beta C is a length, b is a velocity": / h ==>
// mistake "times h where it must be divided by h": / h ==> * h
// mistake "60 in the place of 1/h: a step may have another length than 1/60 s": / h ==> * 60
// expects: b, C -0.02 beta 0.15 h 1/100
// mistake "divided by 60: one over h is times 60, and a step need not be 1/60 s": h ==> 60
// mistake "the sign: b has the sign of C. J V + b = 0 turns it round already": beta ==> -beta
// mistake "beta is forgotten: this takes all of the error in one step": beta * ==>
// mistake "1 - beta is the fraction that stays: b removes the fraction beta": beta ==> (1 - beta)
// mistake "1 - beta is the fraction that stays: b removes the fraction beta. And the sign": beta
//         ==> (beta - 1)
// mistake "0.2 in the place of beta: take the one that is given": beta * ==> real(0.2) *
// mistake "divided by beta: beta is a fraction, a factor": beta * C ==> C / beta
// mistake "divided by h twice: that is an acceleration": / h ==> / h / h
// mistake "the size of C: an error has a sign, and so has its correction": C ==> std::abs(C)
// mistake "only positive errors are fed back": C ==> glm::max(C, real(0))
// mistake "only negative errors are fed back": C ==> glm::min(C, real(0))
// mistake "an error of a few centimetres counts as none: there is no threshold here": beta ==>
//         std::abs(C) < real(0.05) ? 0 : beta
// mistake "C itself is returned": beta * C / h ==> C
// mistake "it is always zero": beta * C / h ==> 0
// wrong drawn-threshold: return ==> if (std::abs(C) < real(1e-9)) return 0; return
// wrong "beta is cut to a whole number: an int has no fraction": return beta ==> const int share =
//         beta; return share
// wrong "1/h is cut to a whole number: an int has no fraction": return beta * C / h ==> const int
//         rate = 1 / h; return beta * C * rate
// expects: h 1/72.5
// wrong "b is kept from -1 to 1: there is no such bound": beta * C / h ==> glm::clamp(beta * C / h,
//         real(-1), real(1))
// wrong "yours is C^2 beta / h in every case": beta * C / h ==> beta * C * C / h
// wrong "yours is beta h / C in every case": beta * C / h ==> beta * h / C
// wrong "a factor of 2, in every case": beta * C / h ==> 2 * beta * C / h
// wrong never-set: return ==> real b; b += ;; h; ==> h; return b;
// right bias by a rate: return beta * C / h; ==> const real rate = beta / h; return rate * C;
// wrong units "the bias is in m and should be in m/s: a time too many": / h ==>

// region 2
// mistake "a limit that lies ahead needs no beta: C/h just reaches it, beta C/h brakes long
//         before": C < 0 ? ==> ;; : C / h ==>
// expects: b, C 0.02 beta 0.15 h 1/60
// mistake "a limit that lies ahead stops the approach far from it: b = 0 gives up the gap C. It may
//         come as near as C/h": C / h; ==> 0;
// mistake "a limit that is passed comes back by the fraction beta: C/h throws it back in one step":
//         C < 0 ? beta * C / h : ==>
// mistake "the two lines are exchanged: the fraction beta belongs to C < 0": < 0 ==> > 0
// expects: b, C -0.02 beta 0.15 h 1/60
// mistake "the sign: b has the sign of C on both sides": beta ==> -beta ;; : C ==> : -C
// mistake "the sign of a limit that lies ahead: b has the sign of C on both sides": : C ==> : -C
// mistake "the sign of a limit that is passed: b has the sign of C on both sides": beta ==> -beta
// mistake "nothing is done where the limit is passed: it has to come back": beta * C / h : ==> 0 :
// mistake "h is forgotten on both sides: b is a velocity": / h : C / h ==> : C
// mistake "h is forgotten for a limit that lies ahead: b is a velocity": C / h; ==> C;
// mistake "h is forgotten where the limit is passed: b is a velocity": / h : ==> :
// mistake "the larger one of the two: that is the right one only where beta is below 1, the sign of
//         C decides": C < 0 ? beta * C / h : C / h ==> std::max(beta * C / h, C / h)
// expects: b, C -0.02 beta 1.5 h 1/60
// mistake "the smaller one of the two: the sign of C decides": C < 0 ? beta * C / h : C / h ==>
//         std::min(beta * C / h, C / h)
// mistake "60 in the place of 1/h: a step may have another length than 1/60 s": / h : C / h ==> *
//         60 : C * 60
// mistake "divided by 60: one over h is times 60, and a step need not be 1/60 s": / h : C / h ==> /
//         60 : C / 60
// mistake "times h where it must be divided by h": / h : C / h ==> * h : C * h
// mistake "divided by h twice: that is an acceleration": / h : C / h ==> / h / h : C / h / h
// mistake "C is compared with beta: the sign of C decides": C < 0 ==> C < beta
// mistake "1 - beta for a limit that lies ahead: C/h just reaches it": : C ==> : (1 - beta) * C
// mistake "1 - beta is the fraction that stays where the limit is passed: b removes the fraction
//         beta": beta ==> (1 - beta)
// mistake "0.2 in the place of beta: take the one that is given": beta ==> real(0.2)
// mistake "divided by beta: beta is a fraction, a factor": beta * C ==> C / beta
// mistake "an error of a few centimetres counts as none: there is no threshold here": return ==>
//         return std::abs(C) < real(0.05) ? 0 :
// mistake "it is always zero": C < 0 ? beta * C / h : C / h ==> 0
// wrong drawn-threshold: return C < 0 ==> return C < real(-1e-9)
// wrong "beta is cut to a whole number: an int has no fraction": return C < 0 ? beta * C / h : C /
//         h ==> const int share = C < 0 ? beta : 1; return share * C / h
// wrong "where C < 0 yours is C / h, and where C > 0 it is 0": beta * C / h : C / h ==> C / h : 0
// wrong "where C < 0 yours is beta, and where C > 0 it is C / h": * C / h : C / h ==> : 1 * C / h
// right limit by smaller and larger: C < 0 ? beta * C / h : C ==> (beta * glm::min(C, real(0)) +
//         glm::max(C, real(0)))
// right limit by the bias: C < 0 ? beta * C / h : C / h ==> bias(C, C < 0 ? beta : 1, h)
// right limit zero on the side of beta: return C < ==> const real b = C / h; return C <= ;; C / h :
//         C / h ==> b : b

// region 3
// mistake "h and T are exchanged: a step lasts h/T half-times": h / half_time ==> half_time / h
// mistake "e in the place of 2: after the time T 1/e remains, and not a half": exp2 ==> exp
// expects: beta, T 0.1 s, h 1/60 s
// mistake "e in the place of 2, and h and T are exchanged": exp2(-h / half_time) ==> exp(-half_time
//         / h)
// mistake "a straight line, h/(2T): each step removes a fraction of the REMAINING error, so the
//         factors multiply": 1 - std::exp2(-h / half_time) ==> h / (2 * half_time)
// mistake "a straight line, h/T: each step removes a fraction of the REMAINING error, so the factors
//         multiply": 1 - std::exp2(-h / half_time) ==> h / half_time
// mistake "a straight line, h ln(2)/T: that is right only where h is much shorter than T": 1 -
//         std::exp2(-h / half_time) ==> h * std::log(real(2)) / half_time
// mistake "this is the fraction that remains after a step, beta is the removed one: 1 minus it": 1
//         - ==>
// mistake "this is the fraction that remains after a step, and e in the place of 2": 1 - std::exp2
//         ==> std::exp
// mistake "the sign of the exponent: 2 to the power -h/T": -h ==> h
// mistake "the sign of the exponent, and of the whole: 1 - 2 to the power -h/T": 1 - std::exp2(-h /
//         half_time) ==> std::exp2(h / half_time) - 1
// mistake "h is forgotten in the exponent: 2 to the power -h/T": -h ==> -1
// mistake "h times T in the exponent: it is divided by T": / half_time ==> * half_time
// mistake "T is forgotten in the exponent: 2 to the power -h/T": / half_time ==>
// mistake "1/60 in the place of h: a step need not be 1/60 s": -h ==> real(-1) / 60
// mistake "h/T is cut to a whole number: it is a real, a step is a part of a half-time": -h /
//         half_time ==> -real(int(h / half_time))
// mistake "it is always 1: 1/2 of whole numbers is 0, write real(0.5) or std::exp2": exp2 ==> pow
//         ;; -h ==> 1 / 2, h
// mistake "this is a half in every step: h/T is forgotten": -h / half_time ==> -1
// mistake "T/h is cut to a whole number: it is a real, a half-time need not be whole steps": return
//         1 - std::exp2(-h / half_time) ==> const int steps = half_time / h; return 1 -
//         std::pow(real(0.5), real(1) / steps)
// mistake "it is always 0: h, or the answer, is cut to a whole number: an int has no fraction":
//         -h ==> -int(h)
// mistake "h/T is rounded to whole half-times: it is a real": -h / half_time ==> -std::round(h /
//         half_time)
// mistake "the sign of the whole: 1 minus 2 to the power -h/T": 1 - std::exp2(-h / half_time) ==>
//         std::exp2(-h / half_time) - 1
// mistake "half of the remaining fraction: 1 minus 2 to the power -h/T": 1 - std::exp2(-h /
//         half_time) ==> std::exp2(-h / half_time) / 2
// wrong few-digits: -h / half_time ==> float(-h / half_time)
// wrong "yours is 1 - h^2 / T^2": exp2(-h / half_time) ==> pow(-h / half_time, real(2))
// wrong "yours is 1 - 2^-(2 h / T)": -h ==> -2 * h
// right half time as a power of a half: exp2 ==> pow ;; -h ==> real(0.5), h
// right half time with the logarithm: 1 - std::exp2(-h / half_time) ==>
//         -std::expm1(-std::log(real(2)) * h / half_time)
// wrong units "in beta, the exponential of 1/s": h ==> 1
