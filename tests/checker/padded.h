// Tables whose cases have different numbers of numbers: filled up with zeros to one length.
#pragma once

#include "tests/checker/cases.h"

namespace joints::testing {

/// The numbers, and zeros behind them.
inline Numbers padded(Numbers numbers, std::size_t size) {
  if (numbers.size() > size) throw std::logic_error("a case with more numbers than the table has");
  numbers.resize(size, 0);
  return numbers;
}

/// Makes a table of such cases. \param names of a case's numbers, without those that fill up
template <class Case>
CaseTable<Case> padded_table(const Subject& subject, std::size_t size,
                             Call<std::vector<std::string>(const Case&)> names) {
  CaseTable<Case> table{subject, std::vector<std::string>(size), {}, {}, {}, {}};
  for (std::size_t i = 0; i < size; ++i) table.entries[i] = "number " + std::to_string(i);
  table.whole = true;
  table.tolerance = 1e-10;  // all of it is in double, whatever a real is
  table.entries_of = [=](const Case& c) {
    std::vector<std::string> out = names(c);
    while (out.size() < size) out.push_back("nothing, place " + std::to_string(out.size()));
    return out;
  };
  return table;
}

/// The report says in how many cases yours holds, below what is given of the case. Call it last.
template <class Case>
void tell_where_it_holds(CaseTable<Case>& table) {
  table.given = [copy = table](const Case& c) {
    return (copy.given ? copy.given(c) + "\n" : "") + copy.holds_in();
  };
}

}  // namespace joints::testing
