// Exercise 7.2 as a table of poses with its usual mistakes. The three parts of K are explained one
// by one, so that a mistake in each of them is found.
#pragma once

#include "tests/07_performance/whole_K_axis.h"

namespace joints::testing {

inline constexpr Subject whole_K_subject{"7.2", "K of a hinge's five rows"};
inline const std::vector<std::string> five_rows{"C.x", "C.y", "C.z", "a1.b", "a1.c"};

/// Yours, for the hinge's numbers as they should be.
inline Matrix<5> your_K(const HingeCase& c) {
  return whole_K(reference_numbers(c), c.pair.body1.inverse_mass, c.pair.body2.inverse_mass);
}
/// J M^-1 J^T, with J by differences of the five errors.
inline Matrix<5> right_K(const HingeCase& c) {
  return dense_K(numeric_jacobian(c.hinge, c.pair.body1, c.pair.body2), c.pair.body1,
                 c.pair.body2);
}

/// 0 where an entry belongs to the point, 1 where it stands between, 2 of the axis.
inline int part_of(int i, int j) { return i < 3 && j < 3 ? 0 : i >= 3 && j >= 3 ? 2 : 1; }
inline Numbers numbers_of(const Matrix<5>& K, int part) {
  Numbers out;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      if (part < 0 || part_of(i, j) == part) out.push_back(double(K[i][j]));
  return out;
}
inline std::vector<std::string> names_of(int part) {
  std::vector<std::string> out;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      if (part < 0 || part_of(i, j) == part)
        out.push_back("K[" + five_rows[std::size_t(i)] + ", " + five_rows[std::size_t(j)] + "]");
  return out;
}

/// The words for a part: of body 1, 2 or (3) both.
inline std::string words_of(const Share& share, int which) {
  std::string out;
  for (const char letter : which == 3 ? share.both : share.one)
    out += letter == '%' ? std::to_string(which)
         : letter == '@' ? std::to_string(3 - which) : std::string(1, letter);
  return out;
}

/// One part of K with its usual mistakes: of one body, of both, of how it is written; then two of
/// them at once.
inline CaseTable<HingeCase> K_part_table(int number) {
  using Case = HingeCase;
  const KPart part = number == 0 ? point_part() : number == 1 ? cross_part() : axis_part();
  CaseTable<Case> table{whole_K_subject, names_of(number), {}, {}, {}, hinge_cases()};
  table.yours = [=](const Case& c) { return numbers_of(your_K(c), number); };
  table.right = [=](const Case& c) { return numbers_of(right_K(c), number); };
  table.tolerance = K_tolerance;
  const auto answer = [=](const Share& one, const Share& two, const Frame& frame) {
    return [=](const Case& c) {
      const KSource s(c);
      return numbers_of(frame.of(one.of(s, 0) + two.of(s, 1), s), number);
    };
  };
  const auto with = [=](const Share& share, int which, const Frame& frame) {
    return answer(which & 1 ? share : part.shares[0], which & 2 ? share : part.shares[0], frame);
  };
  const auto add = [&](const std::string& words, const CaseTable<Case>::Answer& mistake) {
    if (!words.empty() && !table.knows(mistake)) table.mistakes.push_back({words, mistake});
  };
  const auto named = [=](const Share& share, int which) {
    const std::string words = words_of(share, which);
    return words.empty() ? "" : words + part.where;
  };
  for (const int which : {3, 1, 2})
    for (std::size_t k = 1; k < part.shares.size(); ++k)
      add(named(part.shares[k], which), with(part.shares[k], which, part.frames[0]));
  for (std::size_t k = 1; k < part.frames.size(); ++k)
    add(part.frames[k].words + part.where,
        answer(part.shares[0], part.shares[0], part.frames[k]));
  table.pairs = [=] {
    CaseTable<Case>::Mistakes out;
    for (std::size_t k = 1; k < part.shares.size(); ++k) {
      for (std::size_t n = 1; n < part.shares.size(); ++n)
        if (n != k)
          out.push_back({named(part.shares[k], 1) + "; and " + words_of(part.shares[n], 2),
                         answer(part.shares[k], part.shares[n], part.frames[0])});
      for (const int which : {3, 1, 2})
        for (std::size_t n = 1; n < part.frames.size(); ++n)
          if (const std::string words = named(part.shares[k], which); !words.empty())
            out.push_back({words + "; and " + part.frames[n].words,
                           with(part.shares[k], which, part.frames[n])});
    }
    return out;
  };
  return table;
}

/// What all of K would be if a body, or its numbers, were taken wrongly everywhere.
inline CaseTable<HingeCase>::Mistakes wrong_wholes() {
  using Case = HingeCase;
  const auto changed = [](auto change) {
    return [=](const Case& c) {
      KSource s(c);
      change(s);
      return numbers_of(s.K(), -1);
    };
  };
  return {
      {"body 1 is missing", changed([](KSource& s) { s.m[0] = 0, s.I[0] = mat3(0); })},
      {"#sum-that-thrown-away body 2 is missing",
       changed([](KSource& s) { s.m[1] = 0, s.I[1] = mat3(0); })},
      {"beside a static body K is zero: the other one moves", [](const Case& c) {
         const KSource s(c);
         return numbers_of(s.m[0] > 0 && s.m[1] > 0 ? s.K() : Matrix<5>{}, -1);
       }},
      {"#levers-or-inverse-inertias the levers, or the inverse inertias, are exchanged: r1 and I1 "
       "belong to body 1",
       changed([](KSource& s) { std::swap(s.r[0], s.r[1]); })},
      {"I1 is taken for both bodies", changed([](KSource& s) { s.I[1] = s.I[0]; })},
      {"I2 is taken for both bodies", changed([](KSource& s) { s.I[0] = s.I[1]; })},
      {"r1 is taken for both bodies", changed([](KSource& s) { s.r[1] = s.r[0]; })},
      {"r2 is taken for both bodies", changed([](KSource& s) { s.r[0] = s.r[1]; })},
      {"the levers are missing", changed([](KSource& s) { s.r.fill(vec3(0)); })},
      {"the inverse inertias are missing: I1 and I2",
       changed([](KSource& s) { s.I.fill(mat3(1)); })},
      {"the second row takes the first axis row again",
       changed([](KSource& s) { s.a[1] = s.a[0]; })},
      {"nothing is written yet", [](const Case&) { return Numbers(25, 0); }},
      {"#inverse-k-k-itself the inverse of K: compute K itself, the loop inverts it",
       [](const Case& c) {
         Matrix<5> K = KSource(c).K();
         invert_symmetric(K[0].data(), 5);
         return numbers_of(K, -1);
       }}};
}

/// All of K, and its parts one by one where no mistake explains it as a whole.
inline CaseTable<HingeCase> whole_K_table() {
  CaseTable<HingeCase> table{whole_K_subject, names_of(-1), {}, {}, wrong_wholes(), hinge_cases()};
  table.yours = [](const HingeCase& c) { return numbers_of(your_K(c), -1); };
  table.right = [](const HingeCase& c) { return numbers_of(right_K(c), -1); };
  table.tolerance = K_tolerance;
  table.pairs = [yours = table.yours]() -> CaseTable<HingeCase>::Mistakes {
    std::string words, wrong;
    int count = 0, explained = 0;
    for (int number = 0; number < 3; ++number) {
      const CaseTable<HingeCase> part = K_part_table(number);
      if (part.holds()) continue;
      const char* const what[] = {"the point's 3x3", "the part between the point and the axis",
                                  "the axis' 2x2"};
      const std::vector<std::string> likely = part.likely();
      std::string one = likely.empty() ? std::string(what[number]) + " in another way" : likely[0];
      if (const std::size_t at = one.find("all of it"); at != one.npos)
        one.replace(at, 9, what[number]);
      words += (words.empty() ? "" : "; and ") + one;
      wrong += (wrong.empty() ? "" : " and ") + std::string(what[number]);
      explained += !likely.empty();
      ++count;
    }
    if (explained > 0) return {{words, yours}};
    if (count == 3) return {};
    return {{"none of the usual ones, but it is in " + wrong + " alone", yours}};
  };
  return table;
}

}  // namespace joints::testing
