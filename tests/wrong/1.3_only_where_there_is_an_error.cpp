// expects: Likely mistake: nothing is done where the bias is 0. C = 0 does not mean that there is
// expects: nothing to solve
  if (K == 0 || std::abs(bias) < epsilon) return 0;  // the guard of the thesis' listing (E23)
  return -(row_velocity(J, body1, body2) + bias) / K;
