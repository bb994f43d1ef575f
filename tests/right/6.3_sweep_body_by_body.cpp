// region: 3
// Counted by the second body of each joint.
  for (std::size_t k = 1; k < chain.bodies.size(); ++k) {
    Body &before = chain.bodies[k - 1], &body = chain.bodies[k];
    project(chain.joints[k - 1], before, body);
  }
