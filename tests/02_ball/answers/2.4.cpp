// wrong drawn-cut: if (angle == 0) ==> if (angle > real(3.15)) return q; if (angle == 0)
// wrong drawn-threshold: if (angle == 0) return q; ==> if (angle < real(1e-2)) return normalize(q +
//         quat(0, h * w.x / 2, h * w.y / 2, h * w.z / 2) * q); if (angle == 0) return q;
// wrong "a division by zero": length(w); if (angle == 0) return q; const vec3 axis = w / ==> ;;
//         axis ==> w / length(w)
// expects: Case: a body at rest.
// wrong first-order:
  const vec3 v = h / 2 * w;
  return normalize(q + quat(0, v.x, v.y, v.z) * q);
// wrong from-the-right: * q ==> ;; quat ==> q * quat ;; axis; ==> w / length(w); ;; axis = w /
//         length(w); const vec3 ==>
// wrong half-angle-forgotten: axis = w / length(w); const vec3 ==> ;; (angle / 2) * axis ==>
//         (angle) * w / length(w) ;; / 2 ==>
// wrong h-forgotten: h * ==>
// wrong not-normalised: normalize ==>
// wrong small-angles-left-out: == 0 ==> < real(1e-3)
// wrong small-angles-left-out: == 0 ==> < real(1e-6)
// wrong order-four-numbers: std::cos(angle / 2), ==> ;; v.z ==> v.z, std::cos(angle / 2)
// wrong half-angle-cosine-only: / 2 ==>
// wrong half-half: / 2 ==> / 4 ;; / 2 ==> / 4
// wrong sine-cosine-exchanged: cos ==> sin ;; sin ==> cos
// wrong axis-not-length-1: / length(w) ==>
// wrong sign-turn: std ==> -std
// wrong old-orientation-lost: * q ==>
// wrong w-into-body-axes: w / length(w) ==> conjugate(q) * (w / length(w))
// wrong radians-of-radians: angle / 2 ==> glm::radians(angle / 2) ;; (angle / 2), ==>
//         (glm::radians(angle / 2)),
// wrong back-start-rest: q; ==> quat(1, 0, 0, 0);
// wrong half-whole-number: / 2 ==> * (1 / 2) ;; angle / 2 ==> angle * (1 / 2)
// wrong rotation-added: * q ==> + q
// wrong square-of-w: length(w) ==> dot(w,w)
// wrong first-order-without-half: return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);
//         ==> const vec3 s = h * w; return normalize(q + quat(0, s.x, s.y, s.z) * q);
// wrong euler-angles: std::cos(angle / 2), v.x, v.y, v.z ==> h * w
// wrong h-forgotten + from-the-right: * q ==> ;; quat ==> q * quat ;; h * ==>
// wrong sign-turn + small-angles-left-out: == 0 ==> < real(1e-3) ;; std ==> -std
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
