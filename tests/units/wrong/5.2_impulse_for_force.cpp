// expects: Units: the force is in kg m/s and should be in kg m/s^2: a time too many: is a
// expects: division by h missing?
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};
