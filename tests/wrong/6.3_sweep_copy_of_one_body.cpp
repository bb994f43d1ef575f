// region: 3
// expects: Likely mistake: body k + 1 is a copy: take it by reference
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    auto body = chain.bodies[k + 1];
    project(chain.joints[k], chain.bodies[k], body);
  }
