// Exercise 7.3: yours in all scenes, and the report.
#pragma once

#include "checker/report.h"
#include "tests/07_performance/colour_scenes.h"
#include "tests/07_performance/guarded_memory.h"

namespace joints::testing {

/// A body that moves and that both joints hold.
inline bool share_a_body(const ColourScene& scene, const BodyPair& a, const BodyPair& b) {
  const auto both = [&](int body) {
    return scene.moves[std::size_t(body)] && (body == b.body1 || body == b.body2);
  };
  return both(a.body1) || both(a.body2);
}

/// First fit, asked of every joint before. \param most no colour is greater
inline Colours right_colours(const ColourScene& scene,
                             int most = std::numeric_limits<int>::max()) {
  Colours out;
  for (std::size_t k = 0; k < scene.links.size(); ++k) {
    const auto free = [&](int colour) {
      for (std::size_t before = 0; before < k; ++before)
        if (out[before] == colour && share_a_body(scene, scene.links[k], scene.links[before]))
          return false;
      return true;
    };
    int colour = 0;
    while (colour < most && !free(colour)) ++colour;
    out.push_back(colour);
  }
  return out;
}

inline Colours your_colours(const ColourScene& scene) {
  return colours_of(scene.links, scene.moves);
}

/// What of a scene's colours comes from outside a vector, in words; "" where nothing does. A
/// std::vector<bool> does not check its index: so they are asked twice, with other bits behind the
/// ends of all vectors.
inline std::string outside(const ColourScene& scene) {
  Colours of[2];
  memory_is_broken = false;
  for (const bool bit : {false, true}) {
    memory_fill = bit ? 0xff : 0;
    of[bit] = your_colours(scene);
  }
  memory_fill = 0;
  if (memory_is_broken || of[0] != of[1])
    return "#four-spare-colours an index outside a vector: std::vector<bool> does not check it, "
           "and reads or writes beyond its end. Is the colour below size() wherever you read and "
           "store it?";
  for (const bool bit : {false, true}) {
    ColourScene with_more = scene;
    with_more.moves.resize(scene.moves.size() + 64, bit);
    with_more.moves.resize(scene.moves.size());
    of[bit] = your_colours(with_more);
  }
  return of[0] == of[1] ? "" : "#body-that-not-there `moves` is read for a body that does not "
                               "exist: they are numbered from 0 to moves.size() - 1";
}

/// Colours that are right but for a greatest one: which that is, in words; "" where there is none.
inline std::string greatest_colour(const std::vector<ColourScene>& scenes,
                                   const std::vector<Colours>& yours) {
  int most = 0;
  for (const Colours& of : yours)
    for (const int colour : of) most = std::max(most, colour);
  for (std::size_t k = 0; k < scenes.size(); ++k)
    if (right_colours(scenes[k], most) != yours[k]) return "";
  return "there is a greatest colour, " + std::to_string(most) +
         ": a body may need any number of them, more than an integer has bits";
}

/// Why there are not as many colours as joints, in words; "" where that is not known.
inline std::string explain_size(const ColourScene& scene, const Colours& yours) {
  const std::size_t joints = scene.links.size();
  if (yours.empty()) return "nothing is returned";
  if (yours.size() == 2 * joints)
    return "the vector has its size already and is pushed to as well: either [k] = or push_back";
  if (yours.size() == scene.moves.size()) return "this is one colour per body: each joint has one";
  const auto both_move = [&](const BodyPair& link) {
    return scene.moves[std::size_t(link.body1)] && scene.moves[std::size_t(link.body2)];
  };
  const auto moving = std::count_if(scene.links.begin(), scene.links.end(), both_move);
  if (yours.size() == std::size_t(moving))
    return "#joints-static-body-left joints with a static body are left out: they have a colour, "
           "too";
  return "";
}

/// In how many scenes they hold, and the mistake that gives your colours in all of them.
inline std::string explain_colours() {
  const std::vector<ColourScene> scenes = colour_scenes();
  std::vector<Colours> yours;
  std::vector<std::string> holds;
  std::string size;
  for (const ColourScene& scene : scenes) {
    if (const std::string words = outside(scene); !words.empty()) return likely(words);
    yours.push_back(your_colours(scene));
    if (yours.back() == right_colours(scene)) holds.push_back(scene.words);
    if (yours.back().size() != scene.links.size() && size.empty())
      size = explain_size(scene, yours.back());
  }
  const std::string out = "Holds in " + std::to_string(holds.size()) + " of " +
                          std::to_string(scenes.size()) + " scenes" +
                          (holds.empty() ? "" : ", such as " + holds.back()) + ".\n";
  if (!size.empty()) return out + likely(size);
  using ColoursOf = Colours(const std::vector<BodyPair>&, const std::vector<bool>&);
  for (const auto& [words, wrong] : known_mistakes<ColoursOf>("7.3", 1)) {
    bool fits = true;
    for (std::size_t k = 0; fits && k < scenes.size(); ++k)
      fits = wrong(scenes[k].links, scenes[k].moves) == yours[k];
    if (fits) return out + likely(words);
  }
  if (const std::string words = greatest_colour(scenes, yours); !words.empty())
    return out + likely(words);
  return out + "None of the usual mistakes explains it: follow the joints one by one.\n";
}

inline std::string joint_words(const ColourScene& scene, std::size_t k) {
  const BodyPair& link = scene.links[k];
  const auto body = [&](int number) {
    return std::to_string(number) + (scene.moves[std::size_t(number)] ? "" : " (static)");
  };
  return "joint " + std::to_string(k) + " (bodies " + body(link.body1) + " and " +
         body(link.body2) + ")";
}

/// Fails with the wrong colours of a scene, and with the mistake that explains them.
[[noreturn]] inline void fail_colours(const ColourScene& scene, const std::string& what) {
  fail(colours_subject, "Scene: " + scene.words + ".\n\n" + what + "\n" + explain_colours());
}

/// A colour for each joint, and each the expected one. Fails with all those that are not.
inline void check_colours(const ColourScene& scene, const Colours& expected) {
  const Colours yours = your_colours(scene);
  if (yours == expected) return check(colours_subject, "");
  if (yours.size() != expected.size())
    fail_colours(scene, "There are " + std::to_string(yours.size()) + " colours for " +
                            std::to_string(expected.size()) + " joints.\n");
  std::string lines;
  int wrong = 0;
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (yours[k] != expected[k] && ++wrong <= 8)
      lines += "  " + joint_words(scene, k) + ": yours " + std::to_string(yours[k]) +
               ", expected " + std::to_string(expected[k]) + "\n";
  if (wrong > 8) lines += "  and " + std::to_string(wrong - 8) + " more\n";
  fail_colours(scene, lines);
}

}  // namespace joints::testing
