// expects: Likely mistake: this is the impulse: a force is the impulse over the step h
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};
