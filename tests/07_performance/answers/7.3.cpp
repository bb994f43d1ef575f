// Known answers of exercise 7.3, each put in the place of the solution's.

// ---- wrong: a colour a body
// expects: There are 10 colours for 4 joints.
  std::vector<int> colours(moves.size() + links.size() + 1);
  for (std::size_t k = 0; k < links.size(); ++k) colours[k] = int(k % 2);
  return colours;

// ---- wrong: after the last one
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

// ---- wrong: colour of its own
// expects: Likely mistake: every joint has a colour of its own
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return moves[body] && colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(link.body1) || is_taken(link.body2)) ++colour;
    for (const int body : {link.body1, link.body2}) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    colours.push_back(int(colours.size()));
  }
  return colours;

// ---- wrong: free at one of them
// expects: Likely mistake: the colour must be free at both bodies: go on while
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return moves[body] && colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(link.body1) && is_taken(link.body2)) ++colour;
    for (const int body : {link.body1, link.body2}) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    colours.push_back(int(colour));
  }
  return colours;

// ---- wrong: from one
// expects: Scene: a chain of 4 on a wall
// expects: Likely mistake: the colours are counted from 0
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    std::size_t colour = 1;
    const auto is_taken = [&](int body) {
      return moves[body] && colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(link.body1) || is_taken(link.body2)) ++colour;
    for (const int body : {link.body1, link.body2}) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    colours.push_back(int(colour));
  }
  return colours;

// ---- wrong: joints counted
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

// ---- wrong: kept for body 2 only
// expects: Likely mistake: the colour is kept for body 2 of a joint only
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return moves[body] && colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(link.body1) || is_taken(link.body2)) ++colour;
    for (const int body : {link.body2}) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    colours.push_back(int(colour));
  }
  return colours;

// ---- wrong: last joint first
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

// ---- wrong: moves turned round
// expects: Likely mistake: the other way round: the bodies that move are those
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return !moves[body] && colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(link.body1) || is_taken(link.body2)) ++colour;
    for (const int body : {link.body1, link.body2}) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    colours.push_back(int(colour));
  }
  return colours;

// ---- wrong: only body 1 asked
// expects: Likely mistake: only body 1 of a joint is asked
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return moves[body] && colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(link.body1)) ++colour;
    for (const int body : {link.body1, link.body2}) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    colours.push_back(int(colour));
  }
  return colours;

// ---- wrong: only the last one kept
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

// ---- wrong: sixty four colours at most
// expects: Likely mistake: there is a greatest colour, 63: a body may need any number of them
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

// ---- wrong: static bodies count
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

// ---- wrong: two in turn
// expects: Likely mistake: two colours in turn: that fits a chain and nothing else
  std::vector<int> colours;
  for (std::size_t k = 0; k < links.size(); ++k) colours.push_back(int(k % 2));
  return colours;

// ---- right: colour after colour
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

// ---- right: joints before it
// Every joint asks all joints before it.
  std::vector<int> colours;
  for (std::size_t k = 0; k < links.size(); ++k) {
    std::vector<bool> taken(k + 1, false);
    for (std::size_t n = 0; n < k; ++n)
      for (const int body : {links[n].body1, links[n].body2})
        if (moves[body] && (body == links[k].body1 || body == links[k].body2))
          taken[colours[n]] = true;
    int colour = 0;
    while (taken[colour]) ++colour;
    colours.push_back(colour);
  }
  return colours;

// ---- right: one long table
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
