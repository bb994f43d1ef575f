// beta/h is a rate: first the rate, then the error.
  const real rate = beta / h;
  return rate * C;
