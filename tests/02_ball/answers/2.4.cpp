// wrong drawn-cut: if (angle == 0) ==> if (angle > real(3.15)) return q; if (angle == 0)
// wrong drawn-threshold: if (angle == 0) return q; ==> if (angle < real(1e-2)) return normalize(q +
//         quat(0, h * w.x / 2, h * w.y / 2, h * w.z / 2) * q); if (angle == 0) return q;
// wrong "a division by zero": length(w); if (angle == 0) return q; const vec3 axis = w / ==> ;;
//         axis ==> w / length(w)
// expects: Case: a body at rest.
// mistake "q + h/2 (0, w) q is only the first term of the exponential":
  const vec3 v = h / 2 * w;
  return normalize(q + quat(0, v.x, v.y, v.z) * q);
// mistake "the rotation is multiplied from the right, or w is turned by q: w is in world axes, not
//         body axes": * q ==> ;; quat ==> q * quat ;; axis; ==> w / length(w); ;; axis = w /
//         length(w); const vec3 ==>
// mistake "the half of the angle is forgotten": axis = w / length(w); const vec3 ==> ;; (angle / 2)
//         * axis ==> (angle) * w / length(w) ;; / 2 ==>
// mistake "h is missing: the angle is h |w|": h * ==>
// wrong not-normalised: normalize ==>
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": == 0 ==> < real(1e-3)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": == 0 ==> < real(1e-6)
// mistake "the order of the four numbers: quat(w, x, y, z), the cosine first": std::cos(angle / 2),
//         ==> ;; v.z ==> v.z, std::cos(angle / 2)
// mistake "the half of the angle belongs to both, the sine and the cosine": / 2 ==>
// mistake "the angle is halved twice": / 2 ==> / 4 ;; / 2 ==> / 4
// mistake "sine and cosine are exchanged: the cosine comes first": cos ==> sin ;; sin ==> cos
// mistake "the axis must be a unit vector, w / |w|": / length(w) ==>
// mistake "the sign of the rotation": std ==> -std
// mistake "the old orientation is lost: exp(h w) q": * q ==>
// mistake "w is in world axes already: it is not turned by q": w / length(w) ==> conjugate(q) * (w
//         / length(w))
// mistake "degrees: std::sin, std::cos and angleAxis take radians": angle / 2 ==>
//         glm::radians(angle / 2) ;; (angle / 2), ==> (glm::radians(angle / 2)),
// mistake "a body at rest keeps q: it does not go back to (1, 0, 0, 0)": q; ==> quat(1, 0, 0, 0);
// mistake "nothing turns. Is the half 1 / 2, which is 0 in whole numbers?": / 2 ==> * (1 / 2) ;;
//         angle / 2 ==> angle * (1 / 2)
// mistake "the rotation is added to q: it is multiplied": * q ==> + q
// mistake "the angle is h |w|, not h w.w": length(w) ==> dot(w,w)
// mistake "q + h (0, w) q is only the first term of the exponential, and without its half": return
//         normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q); ==> const vec3 s = h * w; return
//         normalize(q + quat(0, s.x, s.y, s.z) * q);
// mistake "h w holds no Euler angles: it is an axis times an angle": std::cos(angle / 2), v.x, v.y,
//         v.z ==> h * w
// mistake "h is missing: the angle is h |w|; and the rotation is multiplied from the right, or w is
//         turned by q: w is in world axes, not body axes": * q ==> ;; quat ==> q * quat ;; h * ==>
// mistake "the sign of the rotation; and a small angle is left out: many small steps add up, and
//         only an angle of 0 is no rotation": == 0 ==> < real(1e-3) ;; std ==> -std
// right angle and axis: angle = h * ==> speed = ;; angle ==> speed ;; const vec3 axis = w /
//         length(w); const vec3 v = std::sin(angle / 2) * axis; ==> ;; quat(std::cos(angle / 2),
//         v.x, v.y, v.z) ==> glm::angleAxis(h * speed, w / speed)
// right opposite quaternion: q; const vec3 axis = w / length(w) ==> -q ;; axis; return ==> w /
//         length(w); return -
// right the engine's rotation: quat(std::cos(angle / 2), v.x, v.y, v.z) ==> rotation(h * w)
// right a guard at the last digit: == 0 ==> < epsilon
// right series for small angles: if (angle == 0) return q; const vec3 axis = w / length(w); const
//         vec3 v = ==> const real s = angle < real(1e-4) ? real(0.5) - angle * angle / 48 : ;; *
//         axis ==> / angle; const vec3 v = s * h * w
// right normalised at rest, too: q; ==> normalize(q);
// right normalised by glm: w / length ==> normalize
// wrong units "in q, the sine of 1/s: h is missing": h * ==> ;; axis = w / length(w); const vec3
//         ==> ;; axis ==> w / angle
// mistake "the angle is h |w|, with one h": angle = h * ==> angle = h * h *
// mistake "degrees: std::sin, std::cos and angleAxis take radians": angle / 2 ==>
//         glm::degrees(angle / 2) ;; std::cos(angle / 2) ==> std::cos(glm::degrees(angle / 2))
// mistake "the angle is h |w|, from all three numbers of w": angle = h * length(w) ==> angle = h *
//         std::abs(w.x)
// mistake "the angle is h |w|, from all three numbers of w": angle = h * length(w) ==> angle = h *
//         std::abs(w.y)
// mistake "the angle is h |w|, from all three numbers of w": angle = h * length(w) ==> angle = h *
//         std::abs(w.z)
// mistake "the half of the angle belongs to both, the sine and the cosine": std::cos(angle / 2) ==>
//         std::cos(angle)
// mistake "the axis must be a unit vector, w / |w|": axis = w / length(w) ==> axis = h * w
// mistake "the axis must be a unit vector, w / |w|": axis = w / length(w) ==> axis = w / angle
// mistake "q is inverted: the rotation stands on the left of q itself": * q) ==> * conjugate(q))
// mistake "q is no vector: the rotation stands on its left alone": quat(std::cos(angle / 2), v.x,
//         v.y, v.z) * q ==> quat(std::cos(angle / 2), v.x, v.y, v.z) * q *
//         conjugate(quat(std::cos(angle / 2), v.x, v.y, v.z))
// mistake "q + h/2 q (0, w) is only the first term of the exponential, and from the wrong side":
//         const real angle ==> const vec3 g = h / 2 * w; if (w != vec3(0)) return normalize(q + q *
//         quat(0, g.x, g.y, g.z)); const real angle
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> angle < real(1e-1)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> angle < real(1e-2)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> angle < real(1e-4)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> angle < real(1e-5)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> angle < real(1e-7)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> angle < real(1e-8)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> length(w) < real(1e-1)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> length(w) < real(1e-2)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> length(w) < real(1e-3)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> length(w) < real(1e-4)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> length(w) < real(1e-5)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> length(w) < real(1e-6)
// mistake "a small angle is left out: many small steps add up, and only an angle of 0 is no
//         rotation": angle == 0 ==> length(w) < real(1e-7)
// mistake "the rotation is multiplied from the right, or w is turned by q: w is in world axes, not
//         body axes; and the sign of the rotation": quat(std::cos(angle / 2), v.x, v.y, v.z) * q
//         ==> q * quat(std::cos(angle / 2), -v.x, -v.y, -v.z)
// mistake "the half of the angle is forgotten; and the rotation is multiplied from the right: w is
//         in world axes, not body axes": std::sin(angle / 2) ==> std::sin(angle) ;;
//         quat(std::cos(angle / 2), v.x, v.y, v.z) * q ==> q * quat(std::cos(angle), v.x, v.y, v.z)
// mistake "a fixed step of 1/60 s: take the h that is given": angle = h * length(w) ==> angle =
//         length(w) / 60
