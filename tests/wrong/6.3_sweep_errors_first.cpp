// region: 3
// expects: Likely mistake: the errors are taken before the sweep
  std::vector<vec3> C;
  for (std::size_t k = 0; k < chain.joints.size(); ++k)
    C.push_back(chain.joints[k].error(chain.bodies[k], chain.bodies[k + 1]));
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
    const vec3 lambda = -inverse(chain.joints[k].K(body1, body2)) * C[k];
    Body move1 = body1, move2 = body2;
    move1.v = move1.w = move2.v = move2.w = vec3(0);
    apply_impulse(chain.joints[k].jacobian(body1, body2), lambda, move1, move2);
    body1.x += move1.v;
    body2.x += move2.v;
    body1.q = turned(body1.q, move1.w, 1);
    body2.q = turned(body2.q, move2.w, 1);
  }
