// Experiments that the text of chapter 8 and its answers quote, beyond the chapter's program. They
// run on the solution.
#pragma once

#include "chapters/08_ground/program/program.h"

namespace joints::chapter8 {

/// Writes a row of machines.csv, which contains the rows of all machines that ran: the gaps of the
/// machine's joints with this number of iterations per step, and the largest penetration [m].
void machine_row(const Choice& choice, const std::string& machine, int iterations,
                 const Summary& line, double penetration);

/// The numbers of iterations of each machine for that table: 10, 30, and the chosen one.
inline std::vector<int> iterations_to_compare(const Choice& choice) {
  std::vector<int> out{10, 30};
  if (std::find(out.begin(), out.end(), choice.iterations) == out.end())
    out.push_back(choice.iterations);
  return out;
}

/// A box that rests for a minute.
void rest(const Choice& choice, std::vector<Summary>& lines);
/// A box that slides, by the functions of the exercises alone.
void by_hand(const Choice& choice);
/// Thesis fig. 3.2: a hinge without correction, with impacts.
void drift(const Choice& choice, std::vector<Summary>& lines);
/// The numbers of the chapter's questions and answers.
void questions(const Choice& choice);
/// The machines, one function each.
void ragdoll(const Choice& choice, std::vector<Summary>& lines);
void wheels(const Choice& choice, std::vector<Summary>& lines);
void cannon(const Choice& choice, std::vector<Summary>& lines);
void bridge(const Choice& choice, std::vector<Summary>& lines);
void curl(const Choice& choice, std::vector<Summary>& lines);

}  // namespace joints::chapter8
