// expects: yours expected error
// expects: 120.000000 90.000000 30.000000
// expects: Likely mistake: the angle of the whole turn: that has the swing in it, and no sign. The
// expects: twist takes only p, the part of v along the axis
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::acos(std::clamp(q.w, real(-1), real(1)));
