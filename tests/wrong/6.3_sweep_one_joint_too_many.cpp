// region: 3
// expects: this->size()
  for (std::size_t k = 0; k < chain.bodies.size(); ++k)
    project(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]);
