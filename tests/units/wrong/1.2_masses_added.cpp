// expects: Units: K is in kg and should be in 1/kg: a mass where an inverse mass belongs
  return 1 / body1.inverse_mass + 1 / body2.inverse_mass;  // the thesis' m1 + m2 (E19)
