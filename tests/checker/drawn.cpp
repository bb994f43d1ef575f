#include "tests/checker/drawn.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "checker/patterns.h"
#include "checker/report.h"
#include "tests/checker/cases.h"

namespace joints::testing {

// ---- choices ------------------------------------------------------------------------------------

double Draw::pick() {
  if (at_ == tape_.size()) tape_.push_back(double(random_.uniform(0, 1)));
  return tape_[at_++];
}
int Draw::whole(int least, int most) {
  const double choice = pick();  // now and then the largest
  return choice > 0.96 ? most : least - 1 + int(std::pow(most - least + 1, choice / 0.96));
}
double Draw::scale(int decades) {
  const double sign = pick() < 0.5 ? -1 : 1;
  return std::pow(10, sign * pick() * (is_float ? std::min(decades, 3) : decades));
}
double Draw::number() {
  const double sign = pick() < 0.5 ? 1 : -1;
  return sign * std::exp2(2 * many().uniform(0, 1) - 1);
}
double Draw::any_size(int decades) {
  const double unit = scale(decades);
  return unit * number();
}
vec3 Draw::vector(double size) {
  const double x = number(), y = number(), z = number();
  return {real(size * x), real(size * y), real(size * z)};
}
double Draw::length(const Units& u) {
  const double decades = is_float ? 4 : 7;
  return u.m * std::pow(10, pick() < 0.5 ? -3 * pick() : (decades - 3) * pick());
}
std::array<vec3, 2> Draw::levers(const Units& u) {
  const double one = size("lever 1", length(u), "m"), two = size("lever 2", length(u), "m");
  size("the shorter lever", std::min(one, two), "m");
  size("the longer lever", std::max(one, two), "m");
  const vec3 first = vector(one);
  return {first, vector(two)};
}
double Draw::angle() {
  const double choice = pick(), nearest = std::numbers::pi / 2 * std::floor(5 * choice * choice);
  const double sign = pick() < 0.5 ? 1 : -1;
  return nearest + sign * (pick() < 0.3 ? pick() : std::pow(10, -10 * pick()));
}
quat Draw::turn() {
  const real by = real(angle());
  return rotation(by * normalize(vector()));
}
bool Draw::chance(const std::string& words) { return side(words, pick() > 0.7); }
double Draw::old_sum(double bound, double size) {
  const double sum = (pick() > 0.7 ? 3 : 0.5) * (bound > 0 ? bound : size);
  side("the old sum is beyond the bound", sum > bound);
  return chance("the old sum is negative") ? -sum : sum;
}
Draw::Units Draw::units(int decades) {
  const double kg = scale(std::max(9, decades)), m = scale(decades);  // a mass may come alone
  const Units u{kg, m, scale(decades)};
  size("mass", u.kg, "kg");
  size("length", u.m, "m");
  size("time", u.s, "s");
  size("speed", u.m / u.s, "m/s");
  size("impulse", u.kg * u.m / u.s, "N s");
  return u;
}
Body Draw::body(const Units& u) {
  const double square = u.kg * u.m * u.m;
  const vec3 inertia(real(0.3 * square), real(0.5 * square), real(0.6 * square));
  const real mass = real(u.kg * std::abs(number()));
  const vec3 x = vector(u.m);
  Body out = body_with(mass, inertia, x, turn());
  out.v = vector(u.m / u.s);
  out.w = vector(1 / u.s);
  return out;
}
Pair Draw::pair(const Units& u) {
  Pair out{body(u), body(u)};
  if (chance("body 1 is static")) out.body1 = static_body(out.body1.x, out.body1.q);
  if (chance("body 2 is static")) out.body2 = static_body(out.body2.x, out.body2.q);
  return out;
}
Random Draw::many() { return Random(unsigned(pick() * 4e9)); }

int Draw::count(const std::string& words, int n) {
  traits.push_back({Trait::Kind::count, words, double(n)});
  return n;
}
double Draw::size(const std::string& words, double x, const std::string& unit) {
  traits.push_back({Trait::Kind::size, words, std::abs(x), unit});
  return x;
}
bool Draw::side(const std::string& words, bool yes) {
  traits.push_back({Trait::Kind::side, words, double(yes)});
  return yes;
}

Drawn drawn_vectors(const std::vector<std::string>& names, const Numbers& yours,
                    const Numbers& right, const Numbers& units) {
  Drawn out{{}, {}, {}, {20}};
  for (std::size_t i = 0; i < 3 * names.size(); ++i) {
    out.entries.push_back(names[i / 3] + "." + "xyz"[i % 3]);
    out.yours.push_back(yours[i] / units[i / 3 % units.size()]);
    out.right.push_back(right[i] / units[i / 3 % units.size()]);
  }
  return out;
}

namespace {

// ---- right or wrong, and why --------------------------------------------------------------------

struct Trial {
  std::vector<double> tape;
  std::vector<Trait> traits;
  Drawn drawn;
  bool wrong = false;
};

double size_of(const Drawn& drawn, std::size_t i) {
  return drawn.sizes.empty() ? std::abs(drawn.right[i]) : drawn.sizes[i % drawn.sizes.size()];
}
bool is_wrong(const Drawn& drawn, std::size_t i, double tolerance) {
  return !near(drawn.yours[i], drawn.right[i], tolerance * size_of(drawn, i));
}

std::string short_size(double a) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.3g", a);
  return buffer;
}
std::string in_words(const Trait& t, double value) {
  if (t.kind == Trait::Kind::side) return t.words;
  return t.kind == Trait::Kind::count ? short_number(value) + " " + t.words
                                      : t.words + " " + short_size(value) +
                                            (t.unit.empty() ? "" : " " + t.unit);
}

// What the wrong numbers of all wrong trials have in common, beside the right ones.
std::string seen(const std::vector<Trial>& all, double tolerance) {
  bool zero = true, small = true, large = true, negative = true;
  for (const Trial& trial : all)
    for (std::size_t i = 0; trial.wrong && i < trial.drawn.right.size(); ++i) {
      if (!is_wrong(trial.drawn, i, tolerance)) continue;
      const double a = trial.drawn.yours[i], b = trial.drawn.right[i];
      zero = zero && a == 0;
      small = small && std::abs(a) < std::abs(b) && a * b >= 0;
      large = large && std::abs(a) > std::abs(b) && a * b >= 0;
      negative = negative && a * b < 0;
    }
  return zero       ? "0"
         : small    ? "too small"
         : large    ? "too large"
         : negative ? "of the other sign"
                    : "";
}

// Where all trials lie that are wrong: beyond a value of one trait. Few of the cases that are right
// lie there.
struct Side {
  std::string words;
  int right_here = 0, right_elsewhere = 0;
  bool all_wrong = true;
  bool several = false;  ///< of a count: two are right, too
  bool sharp = false;  ///< right and wrong ones are neighbours
  bool round = false;  ///< and a number of one digit lies between them
  std::size_t trait = 0;
};

Side side_of(const std::vector<Trial>& all, std::size_t cases, const Trait& t, std::size_t k,
             bool above, const std::string& yours) {
  double nearest = above ? INFINITY : -INFINITY;  // of the wrong ones, to the right ones
  bool zero_is_right = true;
  const auto beyond = [&](double a, double b) { return above ? a > b : a < b; };
  for (const Trial& trial : all)
    if (const double a = trial.traits[k].value; trial.wrong) {
      if (beyond(nearest, a)) nearest = a;
      zero_is_right = zero_is_right && a != 0;
    }
  double next = above ? -INFINITY : INFINITY;  // the right one beside it
  Side out;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (all[n].wrong) continue;
    const double a = all[n].traits[k].value;
    if (!above && t.kind == Trait::Kind::size && a == 0 && zero_is_right) continue;
    const bool here = !beyond(nearest, a);
    if (n < cases) ++(here ? out.right_here : out.right_elsewhere);
    if (here) out.all_wrong = false;
    if (!here && beyond(a, next)) next = a;
  }
  const double least = std::min(nearest, next), most = std::max(nearest, next);
  out.several = above && next >= 2;
  const double digit = std::pow(10, std::floor(std::log10(std::max(1.001 * most, 1e-300))));
  out.round = 0.999 * least <= digit * std::floor(1.001 * most / digit);
  out.sharp = t.kind == Trait::Kind::count ? above && most > 8 && most - least <= 2 + 0.02 * least
                                           : most <= 1.03 * least;
  const std::string wrong = out.all_wrong ? "all are wrong" : "some are wrong";
  const std::string there = yours.empty() ? "" : ", and yours are " + yours + " there";
  const auto only_where = [](const std::string& what) {
    return "#drawn-side wrong only where " + what;
  };
  if (t.kind == Trait::Kind::side) {
    out.words = only_where(t.words);
  } else if (t.kind == Trait::Kind::count && above) {
    const bool few = next < 2;
    out.words = next < 1 ? only_where("there are " + t.words)
                         : "#drawn-stops right with up to " + in_words(t, next) + ", from " +
                            short_number(few ? 2 : nearest) + " on " + wrong +
                            (few ? ": is their order another one, or each treated like the first?"
                                 : ": does a loop stop there, or is an array or a type too small?");
  } else if (t.kind == Trait::Kind::count) {
    out.words = "right with " + in_words(t, next) + " or more, with fewer " + wrong;
  } else if (above && next > 0) {
    out.words = "#drawn-cut right up to a case with " + in_words(t, next) + ", above " + wrong +
                there + (yours == "too small" ? ": is a number cut off, or a small one left out?"
                                              : "");
  } else if (!above && nearest == 0) {
    out.words = only_where(t.words + " is 0" + there);
  } else if (!above && std::isfinite(next)) {
    out.words = "#drawn-threshold right down to a case with " + in_words(t, next) + ", below " +
                wrong + there +
                (yours == "0"           ? ": no threshold belongs here"
                 : yours == "too large" ? ": no least value belongs here, and no added constant"
                                        : "");
  }
  if (t.kind == Trait::Kind::count && above && next < 1 && out.right_here) out.words = "";
  return out;
}

// What the wrong trials have in common; "" where it is nothing that the others have not.
Side explained(const std::vector<Trial>& all, std::size_t cases, const std::string& yours,
               bool counts_alone = false) {
  Side best;
  const auto wrong = std::count_if(all.begin(), all.begin() + long(cases),
                                   [](const Trial& trial) { return trial.wrong; });
  const auto is_plain = [&](const Side& side, Trait::Kind kind) {
    const double here = double(side.right_here + wrong);  // all that are wrong lie there by chance?
    const double chance = std::pow(here / (here + side.right_elsewhere), wrong);
    if (kind == Trait::Kind::side) return chance < 0.03;
    const bool mixed = !side.sharp && 4 * side.right_here > wrong;
    if (kind == Trait::Kind::size && (chance > 0.02 || mixed)) return false;  // not of it
    if (side.sharp && (kind == Trait::Kind::count || side.round)) return true;
    const bool few = kind == Trait::Kind::count ? !side.several : yours == "of the other sign";
    return side.sharp || !few ? chance < 0.003 && side.right_here <= 3 * wrong
                              : chance < 0.003 && 2 * side.right_here <= wrong;
  };
  for (const bool above : {false, true})
    for (std::size_t k = 0; k < all.front().traits.size(); ++k) {
      const Trait::Kind kind = all.front().traits[k].kind;
      if (!above && kind == Trait::Kind::side) continue;
      if (counts_alone && kind != Trait::Kind::count) continue;
      const Side side = side_of(all, cases, all.front().traits[k], k, above, yours);
      if (side.words.empty() || side.right_elsewhere < 5) continue;
      const int trials = side.right_here + side.right_elsewhere + int(wrong);
      if (kind == Trait::Kind::size && 100 * side.right_elsewhere < 15 * trials) continue;
      if (!is_plain(side, kind)) continue;
      const bool plainer = side.right_here < best.right_here ||
                           (side.right_here == best.right_here && side.all_wrong > best.all_wrong);
      if (best.words.empty() || plainer) best = side, best.trait = k;
    }
  return best;
}

// The entries that are wrong in some trial; "" where there are others in other trials, or all are.
std::string alone(const std::vector<Trial>& all, double tolerance) {
  const std::vector<std::string>& entries = all.front().drawn.entries;
  std::vector<std::string> wrong;
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (const Trial& trial : all) {
      if (trial.drawn.entries != entries || trial.drawn.right.size() != entries.size()) return "";
      if (!is_wrong(trial.drawn, i, tolerance)) continue;
      wrong.push_back(entries[i]);
      break;
    }
  const bool few = wrong.size() <= 6 && 2 * wrong.size() <= entries.size();
  return few ? listed(wrong) : "";
}

// A loop may stop too early where a side is such and such.
std::string in_common(const std::vector<Trial>& all, std::size_t cases, double tolerance) {
  const std::string yours = seen(all, tolerance), where = alone(all, tolerance);
  const Side best = explained(all, cases, yours);
  const auto placed = [&](const std::string& words) {
    return where.empty() ? words : words.empty() ? "#drawn-alone " + where + " can be wrong, and "
                                                       "everything else is right in every case" +
                                                       (yours.empty() ? "" : ". Yours are " + yours)
                                                 : words + " (in " + where + " alone)";
  };
  if (best.words.empty() || best.right_here == 0) return placed(best.words);
  const Trait& t = all.front().traits[best.trait];
  if (t.kind != Trait::Kind::side) return placed(best.words);
  std::vector<Trial> there;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (all[n].traits[best.trait].value > 0) there.push_back(all[n]);
    if (n + 1 == cases) cases = there.size();
  }
  const Side part = explained(there, cases, yours, true);
  return placed(part.words.empty() ? best.words : part.words + " (only where " + t.words + ")");
}

unsigned seed_of_run() {
  if (const char* seed = std::getenv("WORKBOOK_SEED")) return unsigned(std::atol(seed));
  const char* ci = std::getenv("CI");
  if (!ci || std::string(ci) != "true" || std::getenv("WORKBOOK_ANSWER")) return 1;
  static const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  return unsigned(now / 1000 % 100000);
}

// A number that changes with any number of the cases, and hardly with a rounding error.
double digest(const std::vector<Trial>& all) {
  double sum = 0;
  int place = 0;
  const auto add = [&](double a) {
    sum += std::copysign((1 + place++ % 7) * std::log1p(std::abs(a)), a);
  };
  for (const Trial& trial : all) {
    for (const Trait& t : trial.traits) add(t.value);
    for (const double a : trial.drawn.right) add(a);
  }
  return sum;
}

}  // namespace

void check_drawn(const Subject& subject, const Call<Drawn(Draw&)>& draw, double tolerance,
                 int cases) {
  const unsigned seed = seed_of_run();
  std::vector<Trial> all;
  const auto tried = [&](unsigned from, std::vector<double> tape) -> const Trial& {
    Draw choices(from, std::move(tape));
    Trial sample;
    sample.drawn = draw(choices);
    for (std::size_t i = 0; i < sample.drawn.right.size(); ++i)
      sample.wrong = sample.wrong || is_wrong(sample.drawn, i, tolerance);
    sample.tape = choices.tape();
    sample.traits = choices.traits;
    all.push_back(std::move(sample));
    return all.back();
  };
  for (int n = 0; n < cases; ++n) tried(seed * 1000 + unsigned(n), {});
  if (std::getenv("WORKBOOK_DRAWN")) std::printf("drawn %.9g\n", digest(all));
  const auto first = std::find_if(all.begin(), all.end(),
                                  [](const Trial& trial) { return trial.wrong; });
  if (first == all.end()) return check(subject, "");

  Trial simplest = *first;
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < simplest.tape.size() && all.size() < 700; ++i) {
      double passes = 0;
      for (int halving = 0; halving < 12 && simplest.tape[i] > 0; ++halving) {
        std::vector<double> tape = simplest.tape;
        tape[i] = halving == 0 ? 0 : (passes + tape[i]) / 2;
        if (const Trial& s = tried(seed, tape); s.wrong) simplest = s;
        else passes = tape[i];
      }
    }
  const Drawn& drawn = simplest.drawn;
  std::string given;
  for (const Trait& t : simplest.traits)
    if (t.value != (t.kind == Trait::Kind::size ? 1 : 0))
      given += (given.empty() ? "" : ", ") + in_words(t, t.value);
  const auto wrong = std::count_if(all.begin(), all.begin() + cases,
                                   [](const Trial& trial) { return trial.wrong; });
  given = std::to_string(wrong) + " of " + std::to_string(cases) + " cases drawn with seed " +
          std::to_string(seed) + " are wrong.\nThe simplest: " +
          (given.empty() ? "all numbers are of order 1" : given) + ".";
  Subject about = subject;
  about.given = given.c_str();
  Table table("expected");
  for (std::size_t i = 0; i < drawn.right.size(); ++i)
    if (is_wrong(drawn, i, tolerance))
      table.entry(drawn.entries[i % drawn.entries.size()], drawn.yours[i], drawn.right[i], 0);
  std::string words = no_number(drawn.yours);
  const bool digits = std::all_of(all.begin(), all.end(), [&](const Trial& trial) {
    return !trial.wrong || five_digits(trial.drawn.yours, trial.drawn.right,
                                       tolerance * size_of(trial.drawn, 0));
  });
  if (words.empty() && digits && 2 * wrong > cases) words = few_digits;  // a float spoils most
  if (words.empty()) words = in_common(all, std::size_t(cases), tolerance);
  if (words.empty() && digits) words = few_digits;
  fail(about, table.words() + (words.empty() ? "" : "\n" + likely(words)));
}

}  // namespace joints::testing
