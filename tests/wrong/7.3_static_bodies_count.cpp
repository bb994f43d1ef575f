// expects: joint 1 (bodies 2 and 0 (static))
// expects: Likely mistake: a static body counts: it does not move
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(link.body1) || is_taken(link.body2)) ++colour;
    for (const int body : {link.body1, link.body2}) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    colours.push_back(int(colour));
  }
  return colours;
