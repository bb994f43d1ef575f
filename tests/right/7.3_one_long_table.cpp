// A row a body in one table that is wide enough; a static body's row stays empty.
  const std::size_t width = links.size() + 1;
  std::vector<char> taken(moves.size() * width, 0);
  std::vector<int> colours;
  colours.reserve(links.size());
  for (const auto& [body1, body2] : links) {
    char* const one = &taken[body1 * width];
    char* const two = &taken[body2 * width];
    int colour = 0;
    while (one[colour] + two[colour] > 0) ++colour;
    if (moves[body1]) one[colour] = 1;
    if (moves[body2]) two[colour] = 1;
    colours.push_back(colour);
  }
  return colours;
