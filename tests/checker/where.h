// Which version of an exercise file a test was linked with, so that a report can name the line.
#pragma once

#include <fstream>
#include <string>

namespace joints::testing {

/// The file, from the root of the workbook; "" for tests that belong to no exercise.
extern const char* const exercise_file;

/// "chapters/01_distance/distance.cpp:14", the line where the exercise begins; "" where there is
/// none. \param region which of the regions that share the id, from 1
inline std::string exercise_place(const std::string& id, int region) {
  const std::string name = exercise_file;
  if (name.empty() || id.empty()) return "";
  std::ifstream file(name);  // as ./wb calls it; from elsewhere:
  if (!file) file.open(std::string(WORKBOOK_ROOT) + "/" + name);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number)
    if (line.find("// begin [exercise " + id + "]") != std::string::npos && --region == 0)
      return name + ":" + std::to_string(number);
  return name;
}

}  // namespace joints::testing
