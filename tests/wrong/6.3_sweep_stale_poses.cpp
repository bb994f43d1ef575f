// region: 3
// expects: Likely mistake: the poses are stale
  const std::vector<Body> before = chain.bodies;
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body one = before[k], two = before[k + 1];
    project(chain.joints[k], one, two);
    chain.bodies[k].x += one.x - before[k].x;
    chain.bodies[k + 1].x += two.x - before[k + 1].x;
    chain.bodies[k].q = one.q * conjugate(before[k].q) * chain.bodies[k].q;
    chain.bodies[k + 1].q = two.q * conjugate(before[k + 1].q) * chain.bodies[k + 1].q;
  }
