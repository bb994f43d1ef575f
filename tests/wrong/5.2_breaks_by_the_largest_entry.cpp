// region: 3
// expects: 12 N of 10 downwards
// expects: Likely mistake: the largest entry where the length belongs, and entries may be negative
  const auto largest = [](const vec3& a) { return glm::max(a.x, glm::max(a.y, a.z)); };
  return largest(load.force) > strength.force || largest(load.torque) > strength.torque;
