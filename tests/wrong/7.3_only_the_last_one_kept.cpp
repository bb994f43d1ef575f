// expects: Likely mistake: only the last colour of a body is kept
  std::vector<int> last(moves.size(), -1), colours;
  for (const BodyPair& link : links) {
    int colour = 0;
    while ((moves[link.body1] && last[link.body1] == colour) ||
           (moves[link.body2] && last[link.body2] == colour))
      ++colour;
    last[link.body1] = last[link.body2] = colour;
    colours.push_back(colour);
  }
  return colours;
