// The reports of a J and of a K: the table, the map, at which poses it holds, the likely mistakes.
#include <algorithm>

#include "checker/guess.h"
#include "checker/report.h"

namespace joints::testing {

namespace {

// The pose's name and its purpose.
PoseWords pose_of(const Sample& s) {
  return s.pose == 3 ? s.broken : PoseWords{pose_names[s.pose], pose_words[s.pose]};
}

std::vector<std::string> poses_of(const std::vector<const Sample*>& samples) {
  std::vector<std::string> names;
  for (const Sample* s : samples)
    if (const char* name = pose_of(*s).name; names.empty() || names.back() != name)
      names.push_back(name);
  return names;
}

// The fewest mistakes that explain all samples, each with its poses. The pose of the text has many
// zeros, so that a mistake may fit there by chance: it must be one that shows elsewhere, too.
std::string likely_mistakes(std::vector<const Sample*> open) {
  std::string out;
  const auto names = [](const Sample* s, const std::string& words) {
    return std::find(s->mistakes.begin(), s->mistakes.end(), words) != s->mistakes.end();
  };
  const auto by_hand = [](const Sample* s) { return s->pose == pencil_and_paper; };
  const bool only_by_hand = std::all_of(open.begin(), open.end(), by_hand);
  while (only_by_hand ? !open.empty() : !std::all_of(open.begin(), open.end(), by_hand)) {
    std::string best;
    std::vector<const Sample*> explained;
    for (const Sample* s : open) {
      if (by_hand(s) && !only_by_hand) continue;
      for (const std::string& words : s->mistakes) {
        std::vector<const Sample*> also;
        std::copy_if(open.begin(), open.end(), std::back_inserter(also),
                     [&](const Sample* other) { return names(other, words); });
        if (also.size() <= explained.size()) continue;
        best = words;
        explained = also;
      }
    }
    if (explained.empty())
      return out + "None of the usual mistakes explains it (" + joined(poses_of(open)) +
             "): compare it with the equation, entry by entry.\n";
    std::string poses;
    for (const std::string& pose : poses_of(explained)) poses += (poses.empty() ? "" : ", ") + pose;
    out += likely(best + " (" + poses + ")");
    std::erase_if(open, [&](const Sample* s) { return names(s, best); });
  }
  return out;
}

// Zero at some of the wrong poses alone: these are the ones where nothing moves.
void tell_zeros_apart(const std::vector<const Sample*>& wrong, std::vector<Sample>& samples) {
  const auto zero = [](const Sample* s) {
    return std::find(s->mistakes.begin(), s->mistakes.end(), told_all_zero) != s->mistakes.end();
  };
  if (std::none_of(wrong.begin(), wrong.end(), zero) ||
      std::all_of(wrong.begin(), wrong.end(), zero))
    return;
  for (Sample& s : samples)
    if (std::find(wrong.begin(), wrong.end(), &s) != wrong.end()) {
      std::erase(s.mistakes, told_all_zero);
      s.mistakes.push_back("#zero-at-some it is zero at some poses alone: does a velocity stand "
                           "where a place belongs, v for x?");
    }
}

// The first that all of the samples tell; "" where there is none.
std::string told_by_all(const std::vector<Sample*>& samples,
                        std::vector<std::string> Sample::* told) {
  for (const std::string& words : samples.front()->*told)
    if (std::all_of(samples.begin(), samples.end(), [&](const Sample* s) {
          return std::find((s->*told).begin(), (s->*told).end(), words) != (s->*told).end();
        }))
      return words;
  return "";
}

// A slip that explains all samples stands in the place of mistakes none of which does.
void ask_slips(const std::vector<Sample*>& wrong) {
  if (!told_by_all(wrong, &Sample::mistakes).empty()) return;
  if (const std::string words = told_by_all(wrong, &Sample::slips); !words.empty())
    for (Sample* s : wrong) s->mistakes = {words};
}

// The poses at which it holds, and the likely mistake at the others.
std::string verdict(std::vector<Sample>& samples, double tolerance,
                    const std::vector<std::string>& rows, decltype(guess_J) guess) {
  std::vector<const Sample*> right, wrong;
  std::vector<Sample*> to_tell;
  for (Sample& s : samples) {
    const bool holds = close(s.yours, s.right, tolerance);
    (holds ? right : wrong).push_back(&s);
    if (holds) continue;
    guess(s, tolerance, rows);
    to_tell.push_back(&s);
  }
  tell_zeros_apart(wrong, samples);
  ask_slips(to_tell);
  std::vector<std::string> holds = poses_of(right);
  const std::vector<std::string> fails = poses_of(wrong);
  std::erase_if(holds, [&](const std::string& pose) {
    return std::find(fails.begin(), fails.end(), pose) != fails.end();
  });
  // the pose of the text stands in a report of its own where it holds
  const bool by_hand = samples.front().pose == pencil_and_paper;
  return "\n" +
         (right.empty() && (by_hand || fails.size() == 1) ? "Fails at all poses.\n"
          : right.empty() ? "Fails at " + joined(fails) + ".\n"
          : holds.empty() ? "Fails at " + std::to_string(wrong.size()) + " of " +
                                std::to_string(samples.size()) + " poses" +
                                (fails.size() > 1 ? ", of all kinds.\n" : ".\n")
                          : "Fails at " + joined(fails) + "; holds at " + joined(holds) + ".\n") +
         likely_mistakes(wrong);
}

const Sample* first_wrong(const std::vector<Sample>& samples, double tolerance) {
  for (const Sample& s : samples)
    if (!close(s.yours, s.right, tolerance)) return &s;
  return nullptr;
}

// The pose, and the meaning of the numbers beside yours.
std::string heading(const Sample& s, const std::string& numeric) {
  return std::string("Pose: ") + pose_of(s).name + " (" + pose_of(s).words + ")." +
         (s.pose == pencil_and_paper ? "" : " Numeric: " + numeric) + "\n\n";
}
Table table_for(const Sample& s) {
  return Table(s.pose == pencil_and_paper ? "by hand " : "numeric ");
}

}  // namespace

std::string jacobian_report(const std::vector<std::string>& rows, std::vector<Sample> samples,
                            double tolerance) {
  const Sample* wrong = first_wrong(samples, tolerance);
  if (!wrong) return "";
  Table table = table_for(*wrong);
  std::string map = "\n        v1   w1   v2   w2     (x wrong, . right)\n";
  for (std::size_t row = 0; row < rows.size(); ++row) {
    map += "  " + rows[row] + std::string(6 - rows[row].size(), ' ');
    for (std::size_t c = 0; c < 12; ++c) {
      const double yours = wrong->yours[row * 12 + c], numeric = wrong->right[row * 12 + c];
      const bool right = near(yours, numeric, tolerance);
      map += std::string(right ? "." : "x") + (c % 3 == 2 && c < 11 ? "  " : "");
      if (!right)
        table.entry(rows[row] + ", " + block_names[c / 3] + "." + "xyz"[c % 3], yours, numeric,
                    tolerance);
    }
    map += "\n";
  }
  return heading(*wrong, "how fast C really changes.") + table.words() + map +
         verdict(samples, tolerance, rows, guess_J);
}

std::string K_report(const std::vector<std::string>& rows, std::vector<Sample> samples,
                     double tolerance) {
  const Sample* wrong = first_wrong(samples, tolerance);
  if (!wrong) return "";
  Table table = table_for(*wrong);
  const std::size_t n = rows.size();
  for (std::size_t i = 0; i < n * n; ++i)
    if (!near(wrong->yours[i], wrong->right[i], tolerance))
      table.entry(n == 1 ? "K" : "K[" + rows[i / n] + ", " + rows[i % n] + "]", wrong->yours[i],
                  wrong->right[i], tolerance);
  return heading(*wrong, "J M^-1 J^T, J by differences.") + table.words() +
         verdict(samples, tolerance, rows, guess_K);
}

}  // namespace joints::testing
