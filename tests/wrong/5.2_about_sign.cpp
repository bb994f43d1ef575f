// region: 2
// expects: Likely mistake: the sign of the new share, (from - to) x F: from and to are exchanged
  return {load.force, load.torque + cross(to - from, load.force)};
