// The memory of the direct solver as a list of numbers: how many bodies, islands and rows, then
// all of theirs.
#include "direct/solver_memory.h"

namespace joints {

// The sum of the numbers of rows.
static std::size_t rows_of(const std::vector<int>& patterns) {
  std::size_t rows = 0;
  for (std::size_t k = 1; k < patterns.size(); k += 2) rows += std::size_t(patterns[k]);
  return rows;
}

void SolverMemory::read(const std::vector<real>& from, int slots) {
  inertia.clear(), patterns.clear(), last.clear(), expected.clear();
  if (from.size() < 2) return;
  const real left = real(from.size() - 2);
  if (!(from[0] >= 0 && from[0] <= real(slots) && from[1] >= 0 &&
        3 * from[0] + 2 * from[1] <= left))
    return;
  const std::size_t bodies = std::size_t(from[0]), islands = std::size_t(from[1]);
  auto at = from.begin() + 2;
  inertia.assign(bodies, vec3(0));
  for (vec3& of : inertia)
    for (int i = 0; i < 3; ++i, ++at) of[i] = finite(*at) && *at >= 0 ? *at : real(0);
  for (std::size_t k = 0; k < 2 * islands; ++k, ++at)
    patterns.push_back(*at >= 0 && *at < real(1 << 24) ? int(*at) : 0);
  const std::size_t rows = rows_of(patterns);
  if (std::size_t(from.end() - at) == 2 * rows) {
    last.reserve(from.capacity()), expected.reserve(from.capacity());
    last.assign(at, at + long(rows));
    expected.assign(at + long(rows), from.end());
  } else {
    patterns.clear();
  }
}

void SolverMemory::write(std::vector<real>& to) const {
  to.assign({real(inertia.size()), real(patterns.size() / 2)});
  for (const vec3& of : inertia) to.insert(to.end(), {of.x, of.y, of.z});
  for (const int number : patterns) to.push_back(real(number));
  to.insert(to.end(), last.begin(), last.end());
  to.insert(to.end(), expected.begin(), expected.end());
}

}  // namespace joints
