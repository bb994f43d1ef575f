// expects: Holds in
// expects: Likely mistake: the number of joints that a body has had so far is no colour
  std::vector<int> count(moves.size(), 0), colours;
  for (const BodyPair& link : links) {
    int colour = 0;
    for (const int body : {link.body1, link.body2})
      if (moves[body]) colour = std::max(colour, count[body]++);
    colours.push_back(colour);
  }
  return colours;
