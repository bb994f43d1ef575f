// Known answers of exercise 6.1, each put in the place of the solution's.

// ---- wrong: bias beta in an int
// expects: Likely mistake: beta is cut to a whole number: an int has no fraction
// change: return beta ==> const int share = beta; return share

// ---- wrong: bias by a formula of one's own
// expects: Likely mistake: yours is C^2 beta / h in every case
// change: beta * C / h ==> beta * C * C / h

// ---- wrong: bias doubled
// expects: Likely mistake: a factor of 2, in every case
// change: beta * C / h ==> 2 * beta * C / h

// ---- wrong: bias kept small
// expects: Likely mistake: b is kept from -1 to 1: there is no such bound
  return glm::clamp(beta * C / h, real(-1), real(1));

// ---- wrong: bias of a fixed beta
// expects: Likely mistake: 0.2 in the place of beta
// change: beta * ==> real(0.2) *

// ---- wrong: bias of small errors
// expects: Likely mistake: an error of a few centimetres counts as none
  return std::abs(C) < real(0.05) ? 0 : beta * C / h;

// ---- wrong: bias over 60
// expects: Likely mistake: divided by 60: one over h is times 60
  return beta * C / 60;

// ---- wrong: bias sign
// expects: Likely mistake: the sign: b has the sign of C.
  return -beta * C / h;

// ---- wrong: bias sixty steps
// expects: b, C -0.02 beta 0.15 h 1/100
// expects: Likely mistake: 60 in the place of 1/h
  return beta * C * 60;

// ---- wrong: bias upside down
// expects: Likely mistake: yours is beta h / C in every case
// change: beta * C / h ==> beta * h / C

// ---- wrong: bias value never set
// expects: Likely mistake: a value that was never set
  real b;
  b += beta * C / h;
  return b;

// ---- wrong: bias whole steps a second
// expects: h 1/72.5
// expects: Likely mistake: 1/h is cut to a whole number: an int has no fraction
// change: return beta * C / h ==> const int rate = 1 / h; return beta * C * rate

// ---- wrong: bias without h
// expects: b, C 0.02 beta 0.15 h 1/60
// expects: Likely mistake: h is forgotten: beta C is a length
  return beta * C;

// ---- wrong: half time in float
// region: 3
// expects: Likely mistake: right to a few digits only: is there a float among the reals
// change: -h / half_time ==> float(-h / half_time)

// ---- wrong: half time natural
// region: 3
// expects: beta, T 0.1 s, h 1/60 s
// expects: Likely mistake: e in the place of 2
  return 1 - std::exp(-h / half_time);

// ---- wrong: half time share that is left
// region: 3
// expects: Likely mistake: this is the share that a step leaves, beta is the one that it takes
  return std::exp2(-h / half_time);

// ---- wrong: half time squared
// region: 3
// expects: Likely mistake: yours is 1 - h^2 / T^2
  return 1 - std::pow(-h / half_time, real(2));

// ---- wrong: half time straight line
// region: 3
// expects: Likely mistake: a straight line, h/(2T): each step takes its share of what is LEFT
  return h / (2 * half_time);

// ---- wrong: half time twice
// region: 3
// expects: Likely mistake: yours is 1 - 2^-(2 h / T)
// change: -h ==> -2 * h

// ---- wrong: half time upside down
// region: 3
// expects: Likely mistake: h and T are exchanged
  return 1 - std::exp2(-half_time / h);

// ---- wrong: half time whole numbers
// region: 3
// expects: Likely mistake: it is always 1: 1/2 of whole numbers is 0
  return 1 - std::pow(1 / 2, h / half_time);

// ---- wrong: half time whole steps
// region: 3
// expects: Likely mistake: T/h is cut to a whole number
  const int steps = half_time / h;
  return 1 - std::pow(real(0.5), real(1) / steps);

// ---- wrong: limit ahead is zero
// region: 2
// expects: Likely mistake: a limit that lies ahead stops the approach far from it
  return C < 0 ? beta * C / h : 0;

// ---- wrong: limit ahead with beta
// region: 2
// expects: b, C 0.02 beta 0.15 h 1/60
// expects: Likely mistake: a limit that lies ahead needs no beta: C/h just reaches it
  return beta * C / h;

// ---- wrong: limit beta in an int
// region: 2
// expects: Likely mistake: beta is cut to a whole number: an int has no fraction
  const int share = C < 0 ? beta : 1;
  return share * C / h;

// ---- wrong: limit compared with beta
// region: 2
// expects: Likely mistake: C is compared with beta: ask for the sign of C
// change: C < 0 ==> C < beta

// ---- wrong: limit hard behind and free ahead
// region: 2
// expects: Likely mistake: where C < 0 yours is C / h, and where C > 0 it is 0
  return C < 0 ? C / h : 0;

// ---- wrong: limit larger of the two
// region: 2
// expects: b, C -0.02 beta 1.5 h 1/60
// expects: Likely mistake: the larger one of the two
  return std::max(beta * C / h, C / h);

// ---- wrong: limit lines exchanged
// region: 2
// expects: b, C -0.02 beta 0.15 h 1/60
// expects: Likely mistake: the two lines are exchanged
  return C > 0 ? beta * C / h : C / h;

// ---- wrong: limit precedence
// region: 2
// expects: Likely mistake: where C < 0 yours is beta, and where C > 0 it is C / h
  return C < 0 ? beta : 1 * C / h;

// ---- right: bias by a rate
// beta/h is a rate: first the rate, then the error.
  const real rate = beta / h;
  return rate * C;

// ---- right: half time as a power of a half
// region: 3
// A half, h/T times.
  return 1 - std::pow(real(0.5), h / half_time);

// ---- right: half time with the logarithm
// region: 3
// 2 to the power x is e to the power x ln 2.
  return -std::expm1(-std::log(real(2)) * h / half_time);

// ---- right: limit by smaller and larger
// region: 2
// What is behind and what is ahead, each by itself: one of them is zero.
  return (beta * glm::min(C, real(0)) + glm::max(C, real(0))) / h;

// ---- right: limit by the bias
// region: 2
// The bias of an equality, with all of the error where the limit lies ahead.
  return bias(C, C < 0 ? beta : 1, h);

// ---- right: limit zero on the side of beta
// region: 2
// At C = 0 both lines agree.
  const real b = C / h;
  return C <= 0 ? beta * b : b;

// ---- wrong units: bias without h
// expects: Units: the bias is in m and should be in m/s: a time too many
  return beta * C;

// ---- wrong units: half time without h
// region: 3
// expects: Units: in beta, the exponential of 1/s
  return 1 - std::exp2(-1 / half_time);
