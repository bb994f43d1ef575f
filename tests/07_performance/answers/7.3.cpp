// wrong drawn-stops: colours.push_back(int(colour)) ==> colours.push_back((signed char)(colour))
// wrong "There are 10 colours for 4 joints.":
  std::vector<int> colours(moves.size() + links.size() + 1);
  for (std::size_t k = 0; k < links.size(); ++k) colours[k] = int(k % 2);
  return colours;
// mistake "every joint has a colour of its own: take the least that is free at its bodies":
//         (colour) ==> (colours.size())
// wrong "the program crashed: it reached for memory that is not its own": const auto is_taken =
//         [&](int body) { return moves[body] && colour < taken[body].size() && taken[body][colour];
//         }; while (is_taken(link.body1) || is_taken(link.body2)) ==> while ((moves[link.body1] &&
//         taken[link.body1][colour]) || (moves[link.body2] && taken[link.body2][colour])) ;; const
//         int ==> int
// expects: std::vector<bool> does not check its own
// mistake "the colour must be free at both bodies: go on while the one or the other has it": ||
//         is_taken ==> && is_taken
// mistake "the colours are counted from 0": 0; ==> 1;
// expects: Scene: a chain of 4 on a wall
// mistake "the colour is stored for body 2 of a joint only: it is taken at both": body1, link.body2
//         ==> body2
// mistake "the other way round: the bodies that move are those that no two joints may share":
//         return moves ==> return ! moves
// mistake "only body 1 of a joint is tested: the colour must be free at both": ||
//         is_taken(link.body2) ==>
// mistake "a static body counts: it does not move, so any number of joints may hold it at once":
//         moves[body] && ==>
// expects: joint 1 (bodies 2 and 0 (static))
// mistake "two colours in turn: that fits a chain and nothing else":
  std::vector<int> colours;
  for (std::size_t k = 0; k < links.size(); ++k) colours.push_back(int(k % 2));
  return colours;
// mistake "only body 2 of a joint is tested: the colour must be free at both": is_taken(link.body1)
//         || ==>
// mistake "the colour is stored for body 1 of a joint only: it is taken at both": , link.body2 ==>
// mistake "all have one colour: a joint must not have that of another one at the same body. Is
//         nothing stored, or is `moves` inverted where it is used?": = true ==> = false
// mistake "all have one colour: a joint must not have that of another one at the same body. Is
//         nothing stored, or is `moves` inverted where it is used?": int(colour) ==> 0
// right colour after colour:
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
// right going up until neither has it:
  std::vector<std::vector<int>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    const auto has = [&](int body, int c) {
      if (!moves[body]) return false;
      for (int t : taken[body]) if (t == c) return true;
      return false;
    };
    int colour = 0;
    for (bool moved = true; moved;) {
      moved = false;
      while (has(link.body1, colour)) ++colour, moved = true;
      while (has(link.body2, colour)) ++colour, moved = true;
    }
    taken[link.body1].push_back(colour);
    taken[link.body2].push_back(colour);
    colours.push_back(colour);
  }
  return colours;
// right joints before it:
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
// right one long table:
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
// right a table that is wide enough:
  std::vector<std::vector<bool>> taken(moves.size(), std::vector<bool>(links.size() + 1));
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    int colour = 0;
    while ((moves[link.body1] && taken[link.body1][colour]) ||
           (moves[link.body2] && taken[link.body2][colour]))
      ++colour;
    taken[link.body1][colour] = taken[link.body2][colour] = true;
    colours.push_back(colour);
  }
  return colours;
// right again from the first where a neighbour has it:
  std::vector<int> colours;
  for (std::size_t k = 0; k < links.size(); ++k) {
    int colour = 0;
    for (std::size_t n = 0; n < k; ++n) {
      const BodyPair &a = links[k], &b = links[n];
      const bool share = (moves[a.body1] && (a.body1 == b.body1 || a.body1 == b.body2)) ||
                         (moves[a.body2] && (a.body2 == b.body1 || a.body2 == b.body2));
      if (share && colours[n] == colour) ++colour, n = std::size_t(-1);
    }
    colours.push_back(colour);
  }
  return colours;
// mistake "a new colour after the last one that the bodies have: a smaller one may be free":
  std::vector<int> next(moves.size(), 0), colours;
  for (const BodyPair& link : links) {
    int colour = 0;
    for (const int body : {link.body1, link.body2})
      if (moves[body]) colour = std::max(colour, next[body]);
    for (const int body : {link.body1, link.body2}) next[body] = colour + 1;
    colours.push_back(colour);
  }
  return colours;
// mistake "the number of joints that a body has so far is not a colour: find the colours that are
//         taken":
// expects: Holds in
  std::vector<int> count(moves.size(), 0), colours;
  for (const BodyPair& link : links) {
    int colour = 0;
    for (const int body : {link.body1, link.body2})
      if (moves[body]) colour = std::max(colour, count[body]++);
    colours.push_back(colour);
  }
  return colours;
// mistake "from the last joint to the first: the first one chooses first":
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
// mistake "only the last colour of a body is kept: it needs all that its joints have taken":
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
// wrong "there is a greatest colour, 63: a body may need any number of them":
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
// wrong "there is a greatest colour, 31: a body may need any number of them":
// expects: Holds in 19 of 21 scenes
  std::vector<unsigned> taken(moves.size(), 0);
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    int colour = 0;
    const auto has = [&](int body) { return moves[body] && (taken[body] & (1u << colour)); };
    while (colour < 31 && (has(link.body1) || has(link.body2))) ++colour;
    taken[link.body1] |= 1u << colour;
    taken[link.body2] |= 1u << colour;
    colours.push_back(colour);
  }
  return colours;
// from right again from the first where a neighbour has it
// mistake "body 1 is compared with the bodies 1 of other joints, body 2 with their bodies 2: a body
//         may be either": body1 || a.body1 == b.body2 ==> body1 ;; body1 || a.body2 == b. ==>
// from right a table that is wide enough
// wrong "an index outside a vector": moves ==> links ;; + 1 ==> ;; int colour ==> std::size_t
//         colour ;; taken[link.body1][colour] = taken[link.body2] ==> for (int body : {link.body1,
//         link.body2}) taken[body] ;; (colour) ==> (int(colour))
// wrong four-spare-colours: links ==> moves ;; + 1 ==>
// mistake "body 1 is not tested again after the colour has gone up for body 2: go on until neither
//         of them has it": = taken ==> = true; taken ;; ) ++colour ==> ++colour ;; || ==> ++colour;
//         while ;; ((moves ==> (moves
// mistake "body 2 is not tested again after the colour has gone up for body 1: go on until neither
//         of them has it": while ( ==> while (moves[link.body2] && taken[link.body2][colour])
//         ++colour; while ;; || (moves[link.body2] && taken[link.body2][colour])) ==> ;; = taken
//         ==> = true; taken
// wrong body-that-not-there: 1 ==> 2 ;; body1 ==> body1 + 1
// mistake "the colour of the last joint is where the next one begins: begin with 0 for each": int
//         colour = 0; ==> ;; for ==> int colour = 0; for ;; 1 ==> 2
// wrong "there is a greatest colour, 7": links.size() + 1 ==> 8 ;; while ==> while (colour < 7 &&
//         ;; ++colour ==> ) ++colour
// wrong four-spare-colours: links.size() + 1 ==> 4 ;; int colour ==> std::size_t colour ;;
//         taken[link.body1][colour] = taken[link.body2] ==> for (int body : {link.body1,
//         link.body2}) taken[body] ;; (colour) ==> (int(colour))
// mistake "the greater one of two colours, each free at one of the bodies: it must be free at
//         both": colour = 0; while ( ==> a = 0, b = 0; while ;; colour]) || ==> a]) ++a; while ;;
//         colour])) ++colour ==> b]) ++b; const int colour = std::max(a, b) ;; = taken ==> = true;
//         taken
// mistake "the colour goes up once at most: go on while one of the bodies has it, while and not
//         if": 1 ==> 2 ;; while ==> if
// wrong joints-static-body-left: int colour = 0; while ((moves[link.body1] &&
//         taken[link.body1][colour]) || (moves[link.body2] && taken[link.body2][colour])) ==> if
//         (!moves[link.body1] || !moves[link.body2]) continue; int colour = 0; while
//         (taken[link.body1][colour] || taken[link.body2][colour])
// mistake "all have one colour: a joint must not have that of another one at the same body. Is
//         nothing stored, or is `moves` inverted where it is used?": ((moves ==> ((!moves ;; ||
//         (moves ==> || (!moves ;; taken[link.body1][colour] = taken[link.body2] ==> for (int body
//         : {link.body1, link.body2}) if (moves[body]) taken[body]
// mistake "beside a static body nothing is tested: the other one moves, and its colour must be
//         free": (moves[link.body1] && ==> moves[link.body1] && moves[link.body2] && ( ;; ) ||
//         (moves[link.body2] && ==> ||
// mistake "a joint with a static body blocks no colour at all: its static body alone blocks none,
//         the other one moves": while ((moves[link.body1] && taken[link.body1][colour]) ||
//         (moves[link.body2] && taken[link.body2][colour])) ==> if (moves[link.body1] &&
//         moves[link.body2]) { while (taken[link.body1][colour] || taken[link.body2][colour]) ;;
//         true; ==> true; }
// wrong "the vector has its size already and is pushed to as well": 1 ==> 2 ;; colours ==>
//         colours(links.size())
// expects: There are 8 colours for 4 joints
// from right again from the first where a neighbour has it
// mistake "the joints before are gone through once: after the colour has gone up compare all of
//         them again": , n = std::size_t(-1) ==>
// mistake "one more than the joint before: the least that is free, and all joints count": for
//         (std::size_t n = 0; n < k; ++n) ==> if (k > 0) ;; [n] ==> [k - 1] ;; (share && colours[n]
//         == colour) ++colour, n = std::size_t(-1) ==> (share) colour = colours[k - 1] + 1
// mistake "one more than the last neighbour has: the least that none of them has": (share &&
//         colours[n] == colour) ++colour, n = std::size_t(-1) ==> (share) colour = colours[n] + 1
// mistake "only the joint before is compared: all joints of both bodies count": for (std::size_t n
//         = 0; n < k; ++n) ==> if (k > 0) ;; [n] ==> [k - 1] ;; n] == colour) ++colour, n =
//         std::size_t(-1) ==> k - 1] == 0) colour = 1
