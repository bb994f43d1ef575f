// Exercise 7.4: what can go wrong with any row, any entry or any term of a solve.
#pragma once

#include "tests/07_performance/solve_cases.h"

namespace joints::testing {

/// The mistakes that any row, any entry or any term can have.
inline Pieces<SolveReference> any_pieces() {
  using T = SolveReference;
  Pieces<T> out;
  const auto name = [](const char* of, std::size_t i) {
    return of + ("[" + std::to_string(i) + "]");
  };
  // a term of e, or of the effect of lambda: of the point's rows, of the axis rows
  struct Term {
    Jacobian<5> T::*rows;
    int from, to;
    std::array<std::string, 4> words;  // of v1, w1, v2, w2
    const char* where;
  };
  const Term terms[] = {
      {&T::read, 0, 3, {"v1", "w1 x r1", "v2", "w2 x r2"}, " in the gap's rate"},
      {&T::read, 3, 5, {"", "w1", "", "w2"}, " in the axis rows of e"},
      {&T::push, 0, 3, {"P", "r1 x P", "P", "r2 x P"}, " in the line of "},
      {&T::push, 3, 5, {"", "T", "", "T"}, " in the line of "}};
  const char* const lines[] = {"v1", "w1", "v2", "w2"};
  for (const Term& term : terms)
    for (std::size_t k = 0; k < 4; ++k) {
      if (term.words[k].empty()) continue;
      const bool line = std::string(term.where).ends_with("of ");
      const std::string where = term.words[k] + term.where + (line ? lines[k] : "");
      const auto add = [&](const std::string& words, real factor) {
        std::array<real, 4> all{1, 1, 1, 1};
        all[k] = factor;
        out.push_back({words, [=, rows = term.rows, from = term.from, to = term.to](T& t) {
                         t.*rows = T::scaled(t.*rows, from, to, all[0], all[1], all[2], all[3]);
                       }});
      };
      add(where + " is missing", 0);
      add("the sign of " + where, -1);
      add(where + " is doubled", 2);
    }
  // the lever of the other body in one place
  for (const bool read : {true, false})
    for (const int body : {1, 2})
      out.push_back({std::string(body == 1 ? "r2 in the place of r1" : "r1 in the place of r2") +
                         (read ? " in the gap's rate" : body == 1 ? " in w1" : " in w2"),
                     [=](T& t) {
                       Jacobian<5>& rows = read ? t.read : t.push;
                       for (int i = 0; i < 3; ++i)
                         if (body == 1) rows[i].w1 = -cross(t.r2, unit_vector(i));
                         else rows[i].w2 = cross(t.r1, unit_vector(i));
                     }});
  for (const int body : {1, 2}) {
    const std::string own = std::to_string(body), other = std::to_string(3 - body);
    out.push_back({"w" + other + " in the place of w" + own + " in the gap's rate", [=](T& t) {
                     for (int i = 0; i < 3; ++i) {
                       Row& J = t.read[i];
                       if (body == 1) J.w2 += J.w1, J.w1 = vec3(0);
                       else J.w1 += J.w2, J.w2 = vec3(0);
                     }
                   }});
    out.push_back({"P in the place of r" + own + " x P in w" + own, [=](T& t) {
                     for (int i = 0; i < 3; ++i)
                       (body == 1 ? t.push[i].w1 : t.push[i].w2) =
                           real(body == 1 ? -1 : 1) * unit_vector(i);
                   }});
  }
  for (const int which : {3, 1, 2})
    out.push_back({"T is not multiplied by " +
                       std::string(which == 3 ? "I1 and I2" : which == 1 ? "I1" : "I2") +
                       ": I (r x P + T), with brackets",
                   [=](T& t) {
                     for (int i = 3; i < 5; ++i) {
                       if (which & 1) t.push[i].w1 = vec3(0);
                       if (which & 2) t.push[i].w2 = vec3(0);
                     }
                     t.after.push_back([=](T& t, Vector<5>& lambda) {
                       const vec3 turn = lambda[3] * t.a[0] + lambda[4] * t.a[1];
                       if (which & 1) t.V[1] -= turn;
                       if (which & 2) t.V[3] += turn;
                     });
                   }});
  for (const int body : {1, 2})  // as it comes out where the brackets are forgotten
    out.push_back({"T is not multiplied by I" + std::to_string(body) +
                       ", and has the other sign: I (r x P + T), with brackets",
                   [=](T& t) {
                     for (int i = 3; i < 5; ++i)
                       (body == 1 ? t.push[i].w1 : t.push[i].w2) = vec3(0);
                     t.after.push_back([=](T& t, Vector<5>& lambda) {
                       const vec3 turn = lambda[3] * t.a[0] + lambda[4] * t.a[1];
                       if (body == 1) t.V[1] += turn;
                       else t.V[3] -= turn;
                     });
                   }});
  // entries of e and of lambda
  for (std::size_t i = 0; i < 5; ++i) {
    out.push_back({"the bias is forgotten in " + name("e", i), [=](T& t) { t.bias[i] = 0; }});
    out.push_back({"the sign of the bias in " + name("e", i),
                   [=](T& t) { t.bias[i] = -t.bias[i]; }});
    out.push_back({name("e", i) + " is zero",
                   [=](T& t) { t.on_e.push_back([=](T&, Vector<5>& e) { e[i] = 0; }); }});
    out.push_back({"the sign of " + name("lambda", i), [=](T& t) {
                     t.on_lambda.push_back([=](T&, Vector<5>& l) { l[i] = -l[i]; });
                   }});
    out.push_back({name("lambda", i) + " is zero", [=](T& t) {
                     t.on_lambda.push_back([=](T&, Vector<5>& l) { l[i] = 0; });
                   }});
    for (std::size_t j = 0; j < 5; ++j) {
      if (i == j) continue;
      out.push_back({name("bias", j) + " in " + name("e", i) + ": it belongs to " + name("e", j),
                     [=](T& t) { t.on_e.push_back([=](T& t, Vector<5>& e) {
                       e[i] += t.bias[j] - t.bias[i];
                     }); }});
      if ((i < 3) == (j < 3))
        out.push_back({"the rate of " + name("e", j) + " stands in " + name("e", i) + ", too",
                       [=](T& t) { t.read[int(i)] = t.read[int(j)]; }});
      out.push_back({name("lambda", j) + " in the place of " + name("lambda", i), [=](T& t) {
                       t.on_lambda.push_back([=](T&, Vector<5>& l) { l[i] = l[j]; });
                     }});
      if (j < i)
        out.push_back({name("lambda", j) + " and " + name("lambda", i) + " are exchanged",
                       [=](T& t) {
                         t.on_lambda.push_back([=](T&, Vector<5>& l) { std::swap(l[i], l[j]); });
                       }});
    }
  }
  const auto impulses = [&](const char* words, std::array<std::size_t, 5> from) {
    out.push_back({words, [=](T& t) {
                     t.on_lambda.push_back([=](T&, Vector<5>& l) {
                       const Vector<5> all = l;
                       for (std::size_t i = 0; i < 5; ++i) l[i] = all[from[i]];
                     });
                   }});
  };
  impulses("#push-begins-too-late the push begins with lambda[1]: it is lambda[0] to lambda[2]",
           {1, 2, 3, 3, 4});
  impulses("the turn begins with lambda[2]: it is made of lambda[3] and lambda[4]",
           {0, 1, 2, 2, 3});
  impulses("the turn begins with lambda[0]: it is made of lambda[3] and lambda[4]",
           {0, 1, 2, 0, 1});
  return out;
}

}  // namespace joints::testing
