// expects: Likely mistake: there is a greatest colour: a body may need any number of them
  std::vector<std::vector<bool>> taken(moves.size(), std::vector<bool>(64));
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    int colour = 0;
    const auto is_taken = [&](int body) { return moves[body] && taken[body][colour]; };
    while (colour < 63 && (is_taken(link.body1) || is_taken(link.body2))) ++colour;
    taken[link.body1][colour] = taken[link.body2][colour] = true;
    colours.push_back(colour);
  }
  return colours;
