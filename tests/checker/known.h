// The known mistakes of the exercises as functions, made of tests/NN_name/answers by
// tools/check/answers.py. A check that finds an answer wrong runs them on its cases: the one that
// gives the reader's numbers is named by its sentence.
#pragma once

#include <stdexcept>
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

  template <class Function>
  Known(const char* id, int region, const char* words, Function* function)
      : id(id), region(region), words(words), function(reinterpret_cast<void (*)()>(function)),
        type(&typeid(Function)) {
    remember(*this);
  }
  static void remember(const Known& one);
  /// All that are linked with the program.
  static const std::vector<Known>& all();
};

/// Those of a region. \tparam Function the type of its function
template <class Function>
struct KnownAs {
  const char* words;
  Function* does;
};
template <class Function>
std::vector<KnownAs<Function>> known_mistakes(const std::string& id, int region) {
  std::vector<KnownAs<Function>> out;
  for (const Known& one : Known::all()) {
    if (one.id != id || one.region != region) continue;
    if (*one.type != typeid(Function)) throw std::logic_error("a mistake of another type");
    out.push_back({one.words, reinterpret_cast<Function*>(one.function)});
  }
  return out;
}

}  // namespace joints::testing
