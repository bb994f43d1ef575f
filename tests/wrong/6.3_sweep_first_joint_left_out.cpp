// region: 3
// expects: x of body 1
// expects: Likely mistake: the first joint is left out
  for (std::size_t k = 1; k < chain.joints.size(); ++k)
    project(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]);
