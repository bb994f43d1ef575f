// expects: Fails at broken; holds at upright, turned and moved.
// expects: Likely mistake: divided by the length of the rod: that is the distance only while C = 0
// expects: (broken)
  const vec3 n = (body2.x - body1.x) / length;
  return {-n, vec3(0), n, vec3(0)};
