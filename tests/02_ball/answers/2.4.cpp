// Known answers of exercise 2.4, each put in the place of the solution's.

// ---- wrong: divides by zero
// expects: q of a body at rest.w
// expects: Likely mistake: a division by zero
  const real angle = h * length(w);
  const vec3 v = std::sin(angle / 2) * w / length(w);
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);

// ---- wrong: first order
// expects: Likely mistake: q + h/2 (0, w) q is only the first term of the exponential
  const vec3 v = h / 2 * w;
  return normalize(q + quat(0, v.x, v.y, v.z) * q);

// ---- wrong: from the right
// expects: Likely mistake: the turn is multiplied from the right: w is in world axes, not body axes
  const real angle = h * length(w);
  if (angle == 0) return q;
  const vec3 v = std::sin(angle / 2) * w / length(w);
  return normalize(q * quat(std::cos(angle / 2), v.x, v.y, v.z));

// ---- wrong: half angle forgotten
// expects: Likely mistake: the half of the angle is forgotten
  const real angle = h * length(w);
  if (angle == 0) return q;
  const vec3 v = std::sin(angle) * w / length(w);
  return normalize(quat(std::cos(angle), v.x, v.y, v.z) * q);

// ---- right: angle and axis
// GLM makes the same quaternion of an angle and an axis.
  const real speed = length(w);
  if (speed == 0) return q;
  return normalize(glm::angleAxis(h * speed, w / speed) * q);

// ---- right: opposite quaternion
// -q is the same orientation as q.
  const real angle = h * length(w);
  if (angle == 0) return -q;
  const vec3 v = std::sin(angle / 2) * w / length(w);
  return -normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);

// ---- wrong units: without h
// expects: Units: in q, the sine of 1/s: h is missing
  const real angle = length(w);
  if (angle == 0) return q;
  const vec3 v = std::sin(angle / 2) * w / angle;
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);
