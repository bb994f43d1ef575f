// K is never negative, so that K <= 0 asks the same as K == 0.
  return K <= 0 ? real(0) : -(row_velocity(J, body1, body2) + bias) / K;
