// region: 2
// expects: Likely mistake: this is the visit of a point
  if (rope.error(body1, body2) >= 0) return;
  project(Point{rope.rod.anchor1_local, rope.rod.anchor2_local}, body1, body2);
