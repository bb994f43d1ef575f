// Cases drawn by a seed, over sizes, scales, signs and sides. Each draw reads its choices from a
// tape of numbers from 0, the simplest, to 1. A case that fails is made simpler, choice by choice,
// as long as it still fails; the mistake depends on the choices that cannot be made simpler. A
// statement draws once, or in braces: the order of operands and of arguments differs between
// compilers.
//
// The seed of a reader is always the same. With CI=true in the environment it is another one in
// each run; a report prints it, and WORKBOOK_SEED repeats the run. With WORKBOOK_DRAWN set a
// digest of the cases is printed, which a test compares with a kept one.
#pragma once

#include <array>

#include "tests/checker/call.h"
#include "tests/checker/check.h"

namespace joints::testing {

/// A property of a drawn case: a number of things, a size with its unit, or a side (0 or 1).
struct Trait {
  enum class Kind { count, size, side } kind;
  std::string words;
  double value;
  std::string unit = "";
};

class Draw {
 public:
  struct Units {
    double kg, m, s;
  };
  Draw(unsigned seed, std::vector<double> tape = {}) : random_(seed), tape_(std::move(tape)) {}

  double pick();                         ///< the next choice, 0 to 1
  int whole(int least, int most);        ///< small numbers are as likely as large ones
  double scale(int decades = 9);         ///< 1, or a power of ten below or above
  double number();                       ///< 0.5 to 2 with a sign: no case is special by chance
  double any_size(int decades = 9);      ///< such a number times a scale
  double length(const Units& units);     ///< from a thousandth of the unit to ten thousand
  vec3 vector(double size = 1);          ///< three such numbers times a size
  std::array<vec3, 2> levers(const Units& units);  ///< of any such length. Noted
  double angle();                        ///< any, or near a multiple of pi/2 [rad]
  quat turn();                           ///< about any axis
  bool chance(const std::string& side);  ///< simplest: no. Noted
  /// Of impulses, with the sign they may have; `size` is another bound where it is 0. Noted
  double old_sum(double bound, double size = 1);
  Units units(int decades = 9);          ///< a case is of order 1 in these. Noted
  Body body(const Units& units);         ///< anywhere, turned and moving
  /// Two of them, one of which or both may be static. Noted
  Pair pair(const Units& units);
  Random many();                         ///< for numbers that need not become simpler

  /// What the report may say of the case, in the same order in every case.
  int count(const std::string& words, int n);
  double size(const std::string& words, double x, const std::string& unit);
  bool side(const std::string& words, bool yes);

  const std::vector<double>& tape() const { return tape_; }
  std::vector<Trait> traits;

 private:
  Random random_;
  std::vector<double> tape_;
  std::size_t at_ = 0;
};

/// What came of a drawn case.
struct Drawn {
  std::vector<std::string> entries;
  Numbers yours, right;
  Numbers sizes = {};  ///< of which the tolerance is a fraction; where it is empty, |right|
};

/// Vectors "v1.x", ... each in a unit of its own, so that they are of order 1.
Drawn drawn_vectors(const std::vector<std::string>& names, const Numbers& yours,
                    const Numbers& right, const Numbers& units);

/// Draws cases and fails with the simplest one that is wrong. \param tolerance relative
void check_drawn(const Subject& subject, const Call<Drawn(Draw&)>& draw,
                 double tolerance = is_float ? 1e-3 : 1e-9, int cases = 100);

}  // namespace joints::testing
