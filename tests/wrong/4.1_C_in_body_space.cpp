// expects: Likely mistake: n is left in body space: turn it into the world with body 1
  return {dot(u, n1_local), dot(u, n2_local)};
