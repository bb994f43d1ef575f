// What all wrong numbers of a table have in common.
#include "checker/patterns.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "checker/report.h"

namespace joints::testing {

namespace {

// One entry in all cases.
struct Column {
  Numbers yours, right;
};

Column column(const std::vector<Compared>& cases, std::size_t entry) {
  Column out;
  for (const Compared& c : cases) {
    out.yours.push_back(c.yours[entry]);
    out.right.push_back(c.right[entry]);
  }
  return out;
}

bool times(const Column& one, double factor, const Numbers& right, double tolerance) {
  for (std::size_t k = 0; k < right.size(); ++k)
    if (!near(one.yours[k], factor * right[k], tolerance * (1 + std::abs(factor)))) return false;
  return true;
}

// The number that what is right was multiplied by in every case; 1 where there is none.
double factor_of(const Column& one, double tolerance) {
  std::size_t largest = 0;
  for (std::size_t k = 0; k < one.right.size(); ++k)
    if (std::abs(one.right[k]) > std::abs(one.right[largest])) largest = k;
  if (std::abs(one.right[largest]) <= 1e3 * tolerance) return 1;
  const double factor = one.yours[largest] / one.right[largest];
  if (!times(one, factor, one.right, tolerance)) return 1;
  for (const double simple : {-1.0, 0.0, 2.0, 0.5, std::round(1e4 * factor) / 1e4})
    if (near(factor, simple, 1e-6) && times(one, simple, one.right, tolerance)) return simple;
  return std::round(1e6 * factor) / 1e6;
}

// What belongs elsewhere.
struct Moved {
  std::string to, sign, from;
};
// Three entries of a vector that belong to another vector become one.
void as_vectors(std::vector<Moved>& moved) {
  const auto end = [](const std::string& name, const char* part) { return name.ends_with(part); };
  for (std::size_t k = 0; k + 2 < moved.size(); ++k) {
    const Moved &x = moved[k], &y = moved[k + 1], &z = moved[k + 2];
    const bool same = x.sign == y.sign && y.sign == z.sign && end(x.to, ".x") && end(y.to, ".y") &&
                      end(z.to, ".z") && end(x.from, ".x") && end(y.from, ".y") &&
                      end(z.from, ".z");
    const auto base = [](const std::string& name) { return name.substr(0, name.size() - 2); };
    if (!same || base(x.to) != base(y.to) || base(y.to) != base(z.to) ||
        base(x.from) != base(y.from) || base(y.from) != base(z.from))
      continue;
    moved[k] = {base(x.to), x.sign, base(x.from)};
    moved.erase(moved.begin() + long(k) + 1, moved.begin() + long(k) + 3);
  }
}

std::string number(double a) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.4g", a);
  return buffer;
}

}  // namespace

std::string seven_digits(const std::vector<Compared>& cases) {
  double size = 0, error = 0;
  for (const Compared& c : cases)
    for (std::size_t i = 0; i < c.right.size(); ++i) {
      size = std::max(size, std::abs(c.right[i]));
      error = std::max(error, std::abs(c.yours[i] - c.right[i]));
      if (c.yours[i] == 0 && std::abs(c.right[i]) > 1e-12) return "";  // a threshold
    }
  return is_float || !(error <= 1e-6 * size) ? "" : few_digits;
}

std::string listed(const std::vector<std::string>& names) {
  std::vector<std::string> out;
  const auto has = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& name : names) {
    const std::string base = name.size() > 2 ? name.substr(0, name.size() - 2) : "";
    if (!base.empty() && has(base + ".x") && has(base + ".y") && has(base + ".z")) {
      if (name.ends_with(".x")) out.push_back(base);
    } else {
      out.push_back(name);
    }
  }
  constexpr std::size_t most = 6;
  if (out.size() > most + 1) {
    const std::size_t more = out.size() - most;
    out.resize(most);
    out.push_back(std::to_string(more) + " more");
  }
  return joined(out);
}

std::string common_pattern(const std::vector<std::string>& entries,
                           const std::vector<Compared>& cases, double tolerance, bool whole) {
  for (const Compared& c : cases)
    if (!no_number(c.yours).empty()) return "";
  if (cases.empty()) return "";
  if (const std::string words = seven_digits(cases); !words.empty()) return words;
  std::vector<Column> columns;
  for (std::size_t i = 0; i < entries.size(); ++i) columns.push_back(column(cases, i));
  std::map<double, std::vector<std::string>> scaled;  // by their factor
  std::vector<Moved> moved;
  std::size_t wrong = 0, silent = 0;                  // silent: right whatever the mistake
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Column& one = columns[i];
    if (times(one, 1, one.right, tolerance)) {
      silent += times(one, 0, one.right, tolerance);
      continue;
    }
    ++wrong;
    if (const double factor = factor_of(one, tolerance); factor != 1) {
      scaled[factor].push_back(entries[i]);
      continue;
    }
    Moved from{entries[i], "", ""};
    for (const double sign : {1.0, -1.0})
      for (std::size_t j = 0; j < entries.size() && from.from.empty(); ++j)
        if (j != i && times(one, sign, columns[j].right, tolerance) &&
            !times(one, 0, columns[j].right, tolerance))
          from = {entries[i], sign < 0 ? "minus " : "", entries[j]};
    if (from.from.empty()) return "";
    moved.push_back(from);
  }
  as_vectors(moved);
  if (wrong == 0) return "";
  const bool all = wrong + silent == entries.size();
  if (whole && !(all && moved.empty() && scaled.size() == 1)) return "";
  if (scaled.size() + moved.size() > 4) return "";

  std::vector<std::string> words;
  for (const auto& [factor, names] : scaled) {
    const std::string which = all && scaled.size() == 1 && moved.empty()
                                  ? names.size() == 1 ? "" : "all of it" : listed(names);
    if (factor == 0)
      words.push_back((which.empty() ? "it" : which) +
                      (which.find(" and ") == which.npos ? " is" : " are") +
                      " zero in every case");
    else if (factor == -1) words.push_back("#sign the "
                                           "sign" + (which.empty() ? "" : " of " + which));
    else
      words.push_back("a factor of " + number(factor) + (which.empty() ? "" : " in " + which) +
                      ", in every case");
  }
  for (const Moved& one : moved)
    words.push_back(one.to + " holds " + one.sign + "the value of " + one.from);
  std::string out;
  for (const std::string& one : words) out += (out.empty() ? "" : "; ") + one;
  return out;
}

}  // namespace joints::testing
