// region: 3
// expects: Likely mistake: nothing moves: nothing is done yet, or copies move: take the bodies
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body body1 = chain.bodies[k], body2 = chain.bodies[k + 1];
    project(chain.joints[k], body1, body2);
  }
