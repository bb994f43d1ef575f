// expects: Likely mistake: a new colour after the last one that the bodies have
  std::vector<int> next(moves.size(), 0), colours;
  for (const BodyPair& link : links) {
    int colour = 0;
    for (const int body : {link.body1, link.body2})
      if (moves[body]) colour = std::max(colour, next[body]);
    for (const int body : {link.body1, link.body2}) next[body] = colour + 1;
    colours.push_back(colour);
  }
  return colours;
