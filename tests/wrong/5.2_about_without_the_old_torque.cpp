// region: 2
// expects: Likely mistake: the old torque is lost: the new share is added to it
  return {load.force, cross(from - to, load.force)};
