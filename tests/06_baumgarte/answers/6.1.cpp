// Known answers of exercise 6.1, each put in the place of the solution's.

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

// ---- wrong: bias without h
// expects: b, C 0.02 beta 0.15 h 1/60
// expects: Likely mistake: h is forgotten: beta C is the way that a step shall take back
  return beta * C;

// ---- wrong: half time natural
// region: 3
// expects: beta, T 0.1 s, h 1/60 s
// expects: Likely mistake: e in the place of 2
  return 1 - std::exp(-h / half_time);

// ---- wrong: half time share that is left
// region: 3
// expects: Likely mistake: this is the share that a step leaves, beta is the one that it takes
  return std::exp2(-h / half_time);

// ---- wrong: half time straight line
// region: 3
// expects: Likely mistake: a straight line, h/(2T): each step takes its share of what is LEFT
  return h / (2 * half_time);

// ---- wrong: half time upside down
// region: 3
// expects: Likely mistake: h and T are exchanged
  return 1 - std::exp2(-half_time / h);

// ---- wrong: half time whole numbers
// region: 3
// expects: Likely mistake: it is always 1: 1/2 of whole numbers is 0
  return 1 - std::pow(1 / 2, h / half_time);

// ---- wrong: limit ahead is zero
// region: 2
// expects: Likely mistake: a limit that lies ahead stops the approach far from it
  return C < 0 ? beta * C / h : 0;

// ---- wrong: limit ahead with beta
// region: 2
// expects: b, C 0.02 beta 0.15 h 1/60
// expects: Likely mistake: a limit that lies ahead needs no beta: C/h just reaches it
  return beta * C / h;

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
