// region: 2
// expects: Likely mistake: `measured` is returned as it is: no turn is counted
  return measured;
