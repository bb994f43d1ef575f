// The block w of row i is r x e_i, written out entry by entry.
  const vec3 a = to_world(body1, anchor1_local), b = to_world(body2, anchor2_local);
  return {{Row{vec3(-1, 0, 0), vec3(0, -a.z, a.y), vec3(1, 0, 0), vec3(0, b.z, -b.y)},
           Row{vec3(0, -1, 0), vec3(a.z, 0, -a.x), vec3(0, 1, 0), vec3(-b.z, 0, b.x)},
           Row{vec3(0, 0, -1), vec3(-a.y, a.x, 0), vec3(0, 0, 1), vec3(b.y, -b.x, 0)}}};
