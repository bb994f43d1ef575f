// The known mistakes of the exercises as functions, made of tests/NN_name/answers by
// tools/check/answers.py. A check that finds an answer wrong runs them on its cases: the one that
// gives the reader's numbers is named by its sentence.
#pragma once

#include <string>
#include <typeinfo>
#include <vector>

namespace joints::testing {

/// A mistake in a function of whatever type. One that is made is remembered.
struct Known {
  const char* id;      ///< of the exercise
  int region;          ///< which of those that share the id
  const char* words;   ///< what the reader is told
  void (*function)();  ///< the reader's function with the mistake
  const std::type_info* type;
  bool slip;           ///< made by tools/check/slips.py: told only where nothing else is

  template <class Function>
  Known(const char* id, int region, const char* words, Function* function, bool slip)
      : id(id), region(region), words(words), function(reinterpret_cast<void (*)()>(function)),
        type(&typeid(Function)), slip(slip) {
    remember(*this);
  }
  template <class Function>
  Function* as() const { return reinterpret_cast<Function*>(function); }
  static void remember(const Known& one);
  /// Those of a region, all of them of one type.
  static std::vector<const Known*> of(const std::string& id, int region,
                                      const std::type_info& type, bool slip);
};
/// \tparam Function the type of the region's function
template <class Function>
std::vector<const Known*> known_of_type(const std::string& id, int region, bool slip = false) {
  return Known::of(id, region, typeid(Function), slip);
}

/// The same with their words.
template <class Function>
struct KnownAs {
  const char* words;
  Function* does;
};
template <class Function>
std::vector<KnownAs<Function>> known_mistakes(const std::string& id, int region,
                                              bool slip = false) {
  std::vector<KnownAs<Function>> out;
  for (const Known* one : known_of_type<Function>(id, region, slip))
    out.push_back({one->words, one->as<Function>()});
  return out;
}

}  // namespace joints::testing
