// Colour after colour: each takes, from the first joint on, all that fit beside one another.
  std::vector<int> colours(links.size(), -1);
  std::size_t left = links.size();
  for (int colour = 0; left > 0; ++colour) {
    std::vector<bool> held(moves.size(), false);
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (colours[k] >= 0) continue;
      const auto [one, two] = links[k];
      if (held[one] || held[two]) continue;
      held[one] = moves[one];
      held[two] = moves[two];
      colours[k] = colour;
      --left;
    }
  }
  return colours;
