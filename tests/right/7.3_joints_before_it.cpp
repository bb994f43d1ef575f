// Every joint asks all joints before it.
  std::vector<int> colours;
  for (std::size_t k = 0; k < links.size(); ++k) {
    std::vector<bool> taken(k + 1, false);
    for (std::size_t n = 0; n < k; ++n)
      for (const int body : {links[n].body1, links[n].body2})
        if (moves[body] && (body == links[k].body1 || body == links[k].body2))
          taken[colours[n]] = true;
    int colour = 0;
    while (taken[colour]) ++colour;
    colours.push_back(colour);
  }
  return colours;
