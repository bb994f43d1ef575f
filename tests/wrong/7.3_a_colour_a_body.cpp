// expects: There are 10 colours for 4 joints.
  std::vector<int> colours(moves.size() + links.size() + 1);
  for (std::size_t k = 0; k < links.size(); ++k) colours[k] = int(k % 2);
  return colours;
