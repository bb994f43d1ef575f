// region: 3
// Squares in the place of lengths: no root is drawn.
  const auto over = [](const vec3& a, real bound) { return dot(a, a) > bound * bound; };
  return over(load.force, strength.force) || over(load.torque, strength.torque);
