// expects: Likely mistake: the bias is missing: the error is not fed back
  if (K == 0) return 0;
  return -row_velocity(J, body1, body2) / K;
