// region: 3
// expects: Likely mistake: the bodies are exchanged: joint k holds body k to body k + 1
  for (std::size_t k = 0; k < chain.joints.size(); ++k)
    project(chain.joints[k], chain.bodies[k + 1], chain.bodies[k]);
