// region: 2
// b x a1 = -(a1 x b): the matrix of a1 with a minus.
  const vec3 first = -skew(a1) * b, second = -skew(a1) * c;
  return {{Row{vec3(0), -first, vec3(0), first}, Row{vec3(0), -second, vec3(0), second}}};
