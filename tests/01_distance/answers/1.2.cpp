// wrong inverse-of-k: body1.inverse_mass + body2.inverse_mass ==> 1 / (body1.inverse_mass +
//         body2.inverse_mass)
// expects: itself (upright, turned, moved, broken)
// wrong masses-added (pencil and paper, upright, turned, moved, broken): body1 ==> 1 / body1 ;;
//         body2 ==> 1 / body2
// expects: Likely mistake: masses where inverse masses belong: K is in 1/kg (upright, turned,
// wrong one-over-whole-mass: body1.inverse_mass + body2.inverse_mass ==> 1 / (1 /
//         body1.inverse_mass + 1 / body2.inverse_mass)
// expects: are added (upright, turned, moved, broken)
// wrong inverse-masses-subtracted: + body2 ==> - body2
// wrong inverse-masses-multiplied: + body2 ==> * body2
// wrong body-1-twice: body2 ==> body1
// wrong body-2-alone: body1.inverse_mass + ==>
// wrong "a factor of 0.5": body1.inverse_mass + body2.inverse_mass ==> (body1.inverse_mass +
//         body2.inverse_mass) / 2
// mistake "times the length of the rod: n is a unit vector, so K is independent of it":
//         body1.inverse_mass + body2.inverse_mass ==> (body1.inverse_mass + body2.inverse_mass) *
//         length
// mistake "not a unit vector: take direction(...) of the difference": return body1.inverse_mass +
//         body2.inverse_mass ==> const vec3 u = body2.x - body1.x; return (body1.inverse_mass +
//         body2.inverse_mass) * dot(u, u)
// mistake "times the error: K is independent of the error": body1.inverse_mass + body2.inverse_mass
//         ==> error(body1, body2) * (body1.inverse_mass + body2.inverse_mass)
// wrong squares-inverse-masses: body1 ==> body1.inverse_mass * body1 ;; inverse_mass; ==>
//         inverse_mass * body2.inverse_mass;
// wrong the-larger-one: body1.inverse_mass + body2.inverse_mass ==> glm::max(body1.inverse_mass,
//         body2.inverse_mass)
// wrong nothing-beside-wall: return body1 ==> if (body1.is_static() || body2.is_static()) return 0;
//         return body1
// wrong one-between-two-walls: return body1 ==> if (body1.is_static() && body2.is_static()) return
//         1; return body1
// wrong never-set: return ==> real k; k += ;; inverse_mass; ==> inverse_mass; return k;
// mistake "K is 1 here: it comes from the masses, and nothing bounds it": body1.inverse_mass +
//         body2.inverse_mass ==> 1
// wrong cut-int: return body1.inverse_mass + body2.inverse_mass; ==> const int k =
//         int(body1.inverse_mass + body2.inverse_mass); return real(k);
// right with the square of a unit vector: return ==> const vec3 n = direction(body2.x - body1.x);
//         if (n == vec3(0)) return ;; inverse_mass; ==> inverse_mass; return body1.inverse_mass *
//         dot(n, n) + body2.inverse_mass * dot(n, n);
// right nothing where there is no direction: return ==> if (body1.x == body2.x) return 0; return
// wrong units "K is in kg and should be in 1/kg: a mass where an inverse mass belongs": body1 ==> 1
//         / body1 ;; body2 ==> 1 / body2
