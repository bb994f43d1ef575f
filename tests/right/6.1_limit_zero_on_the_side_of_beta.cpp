// region: 2
// At C = 0 both lines agree.
  const real b = C / h;
  return C <= 0 ? beta * b : b;
