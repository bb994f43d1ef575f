// expects: Likely mistake: from the last joint to the first
  std::vector<std::vector<bool>> taken(moves.size(), std::vector<bool>(links.size() + 1));
  std::vector<int> colours(links.size());
  for (std::size_t k = links.size(); k-- > 0;) {
    int colour = 0;
    for (bool again = true; again;) {
      again = false;
      for (const int body : {links[k].body1, links[k].body2})
        again = again || (moves[body] && taken[body][colour]);
      colour += again;
    }
    taken[links[k].body1][colour] = taken[links[k].body2][colour] = true;
    colours[k] = colour;
  }
  return colours;
