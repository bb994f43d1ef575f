// expects: Likely mistake: two colours in turn: that fits a chain and nothing else
  std::vector<int> colours;
  for (std::size_t k = 0; k < links.size(); ++k) colours.push_back(int(k % 2));
  return colours;
