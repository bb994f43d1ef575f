#include "tests/checker/drawn.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <numbers>

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
double Draw::old_sum() {
  const double size = chance("the old sum is beyond the bound") ? 3 : 0.5;
  return chance("the old sum is negative") ? -size : size;
}
Draw::Units Draw::units(int decades) {
  const Units u{scale(decades), scale(decades), scale(decades)};
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
                                      : t.words + " " + short_size(value) + " " + t.unit;
}

// Where all trials lie that are wrong: beyond a value of one trait. Few that are right lie there.
struct Side {
  std::string words;
  int right_here = 0, right_elsewhere = 0;
  std::size_t trait = 0;
};

Side side_of(const std::vector<Trial>& all, const Trait& t, std::size_t k, bool above) {
  double nearest = above ? INFINITY : -INFINITY;  // of the wrong ones, to the right ones
  const auto beyond = [&](double a, double b) { return above ? a > b : a < b; };
  for (const Trial& trial : all)
    if (const double a = trial.traits[k].value; trial.wrong && beyond(nearest, a)) nearest = a;
  double next = above ? -INFINITY : INFINITY;  // the right one beside it
  Side out;
  for (const Trial& trial : all) {
    if (trial.wrong) continue;
    const double a = trial.traits[k].value;
    const bool here = !beyond(nearest, a);
    ++(here ? out.right_here : out.right_elsewhere);
    if (!here && beyond(a, next)) next = a;
  }
  const std::string wrong = out.right_here == 0 ? "all are wrong" : "some are wrong";
  switch (t.kind) {
    case Trait::Kind::side:
      out.words = std::string("#drawn-side wrong only where ") + t.words;
      break;
    case Trait::Kind::count:
      out.words = above ? "#drawn-stops right with up to " + in_words(t, next) + ", from " +
                              short_number(nearest) + " on " + wrong +
                              ": does a loop stop there, or is an array or a type too small?"
                        : "right with " + in_words(t, next) + " or more, with fewer " + wrong;
      break;
    default:
      out.words = above ? "#drawn-cut right up to a case with " + in_words(t, next) + ", above " +
                              wrong + ": is a number cut off, or a constant added?"
                        : "#drawn-threshold right down to a case with " + in_words(t, next) +
                              ", below " + wrong +
                              ": no threshold belongs here, and no added constant";
  }
  return out;
}

// What the wrong trials have in common; "" where it is nothing that the others have not.
Side explained(const std::vector<Trial>& all, bool counts_alone = false) {
  Side best;
  for (const bool above : {false, true})
    for (std::size_t k = 0; k < all.front().traits.size(); ++k) {
      const Trait::Kind kind = all.front().traits[k].kind;
      if (!above && kind == Trait::Kind::side) continue;
      if (counts_alone && kind != Trait::Kind::count) continue;
      const Side side = side_of(all, all.front().traits[k], k, above);
      if (side.right_elsewhere < std::max(5, counts_alone ? 0 : side.right_here)) continue;
      if (best.words.empty() || side.right_here < best.right_here) best = side, best.trait = k;
    }
  return best;
}
// A loop may stop too early where a side is such and such.
std::string in_common(const std::vector<Trial>& all) {
  const Side best = explained(all);
  if (best.right_here == 0) return best.words;
  const Trait& t = all.front().traits[best.trait];
  if (t.kind != Trait::Kind::side) return best.words;
  std::vector<Trial> there;
  for (const Trial& trial : all)
    if (trial.traits[best.trait].value > 0) there.push_back(trial);
  const Side part = explained(there, true);
  return part.words.empty() ? best.words : part.words + " (only where " + t.words + ")";
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
    for (std::size_t i = 0; i < simplest.tape.size() && all.size() < 1500; ++i) {
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
  if (words.empty()) words = in_common(all);
  fail(about, table.words() + (words.empty() ? "" : "\n" + likely(words)));
}

}  // namespace joints::testing
