// region: 3
// expects: Likely mistake: the sweep runs backwards
  for (std::size_t k = chain.joints.size(); k-- > 0;)
    project(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]);
