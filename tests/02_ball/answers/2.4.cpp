// Known answers of exercise 2.4, each put in the place of the solution's.

// ---- wrong: divides by zero
// expects: Case: a body at rest.
// expects: Likely mistake: a division by zero
  const real angle = h * length(w);
  const vec3 v = std::sin(angle / 2) * w / length(w);
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);

// ---- wrong: first order
// expects: Likely mistake: q + h/2 (0, w) q is only the first term of the exponential
  const vec3 v = h / 2 * w;
  return normalize(q + quat(0, v.x, v.y, v.z) * q);

// ---- wrong: from the right
// expects: Likely mistake: the rotation is multiplied from the right
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

// ---- wrong: h forgotten
// expects: Likely mistake: h is missing: the angle is h |w|
// change: h * ==>

// ---- wrong: not normalised
// expects: Likely mistake: the product is not normalised
// change: normalize ==>

// ---- wrong: small angles left out
// expects: Likely mistake: a small angle is left out
// change: == 0 ==> < real(1e-3)

// ---- wrong: smaller angles left out
// expects: Likely mistake: a small angle is left out
// change: == 0 ==> < real(1e-6)

// ---- wrong: slow bodies left out
// expects: Likely mistake: a small angle is left out
// change: angle == 0 ==> length(w) < real(1e-3)

// ---- wrong: order of the four numbers
// expects: Likely mistake: the order of the four numbers: quat(w, x, y, z)
// change: std::cos(angle / 2), ==>
// change: v.z ==> v.z, std::cos(angle / 2)

// ---- wrong: half of the angle in the cosine only
// expects: Likely mistake: the half of the angle belongs to both
// change: / 2 ==>

// ---- wrong: half of the half
// expects: Likely mistake: the angle is halved twice
// change: / 2 ==> / 4
// change: / 2 ==> / 4

// ---- wrong: sine and cosine exchanged
// expects: Likely mistake: sine and cosine are exchanged
  const real angle = h * length(w);
  if (angle == 0) return q;
  const vec3 axis = w / length(w);
  const vec3 v = std::cos(angle / 2) * axis;
  return normalize(quat(std::sin(angle / 2), v.x, v.y, v.z) * q);

// ---- wrong: axis not of length 1
// expects: Likely mistake: the axis must be a unit vector
// change: / length(w) ==>

// ---- wrong: angleAxis with w
// expects: Likely mistake: the axis must be a unit vector
// change: quat(std::cos(angle / 2), v.x, v.y, v.z) ==> glm::angleAxis(angle, w)

// ---- wrong: sign of the turn
// expects: Likely mistake: the sign of the rotation
// change: std ==> -std

// ---- wrong: old orientation lost
// expects: Likely mistake: the old orientation is lost
// change: * q ==>

// ---- wrong: w turned by q
// expects: Likely mistake: the rotation is multiplied from the right, or w is turned by q
  const real angle = h * length(w);
  if (angle == 0) return q;
  const vec3 axis = q * (w / length(w));
  const vec3 v = std::sin(angle / 2) * axis;
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);

// ---- wrong: w into body axes
// expects: Likely mistake: w is in world axes already
  const real angle = h * length(w);
  if (angle == 0) return q;
  const vec3 axis = conjugate(q) * (w / length(w));
  const vec3 v = std::sin(angle / 2) * axis;
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);

// ---- wrong: radians of radians
// expects: Likely mistake: degrees: std::sin, std::cos and angleAxis take radians
// change: angle / 2 ==> glm::radians(angle / 2)
// change: (angle / 2), ==> (glm::radians(angle / 2)),

// ---- wrong: back to the start at rest
// expects: Likely mistake: a body at rest keeps q
// change: q; ==> quat(1, 0, 0, 0);

// ---- wrong: half as a whole number
// expects: Likely mistake: nothing turns
// change: / 2 ==> * (1 / 2)
// change: angle / 2 ==> angle * (1 / 2)

// ---- wrong: rotation added
// expects: Likely mistake: the rotation is added to q
// change: * q ==> + q

// ---- wrong: square of w
// expects: Likely mistake: the angle is h |w|, not h w.w
// change: length(w) ==> dot(w,w)

// ---- wrong: first order without the half
// expects: Likely mistake: q + h (0, w) q is only the first term
// change: return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q); ==> const vec3 s = h * w;
//         return normalize(q + quat(0, s.x, s.y, s.z) * q);

// ---- wrong: Euler angles
// expects: Likely mistake: h w holds no Euler angles
// change: std::cos(angle / 2), v.x, v.y, v.z ==> h * w

// ---- wrong: from the right and without h
// expects: Likely mistake: h is missing: the angle is h |w|; and the rotation is multiplied from
// expects: right
  const real angle = length(w);
  if (angle == 0) return q;
  const vec3 axis = w / length(w);
  const vec3 v = std::sin(angle / 2) * axis;
  return normalize(q * quat(std::cos(angle / 2), v.x, v.y, v.z));

// ---- wrong: sign of the turn and small angles left out
// expects: Likely mistake: the sign of the rotation; and a small angle is left out
// change: == 0 ==> < real(1e-3)
// change: std ==> -std

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

// ---- right: the engine's rotation
// change: quat(std::cos(angle / 2), v.x, v.y, v.z) ==> rotation(h * w)

// ---- right: a guard at the last digit
// An angle that rounding swallows turns nothing.
  const real angle = h * length(w);
  if (angle < epsilon) return q;
  const vec3 axis = w / length(w);
  const vec3 v = std::sin(angle / 2) * axis;
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);

// ---- right: series for small angles
  const real angle = h * length(w);
  const real s = angle < real(1e-4) ? real(0.5) - angle * angle / 48 : std::sin(angle / 2) / angle;
  const vec3 v = s * h * w;
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);

// ---- right: normalised at rest, too
// change: q; ==> normalize(q);

// ---- right: normalised by glm
// change: w / length ==> normalize

// ---- wrong units: without h
// expects: Units: in q, the sine of 1/s: h is missing
  const real angle = length(w);
  if (angle == 0) return q;
  const vec3 v = std::sin(angle / 2) * w / angle;
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);
