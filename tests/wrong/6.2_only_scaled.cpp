// expects: Likely mistake: nothing is applied: lambda is scaled
  lambda *= ratio;
