// expects: Likely mistake: angles: C is 2 v, whose length is 2 sin(angle/2)
// expects: Likely mistake: differences of angles about three axes: these are no rotation
  return glm::eulerAngles(body2.q) - glm::eulerAngles(body1.q);
