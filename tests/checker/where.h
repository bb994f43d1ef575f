// Which version of an exercise file a test was linked with, so that a report can name the line.
#pragma once

#include <cstdio>
#include <string>

namespace joints::testing {

/// The file, from the root of the workbook; "" for tests that belong to no exercise.
extern const char* const exercise_file;

/// "chapters/01_distance/distance.cpp:14", the line where the exercise begins; "" where there is
/// none. \param region which of the regions that share the id, from 1
inline std::string exercise_place(const std::string& id, int region) {
  const std::string name = exercise_file;
  if (name.empty() || id.empty()) return "";
  // C's files: libc++ in a browser has no others.
  std::FILE* file = std::fopen(name.c_str(), "r");  // as ./wb calls it; from elsewhere:
  if (!file) file = std::fopen((std::string(WORKBOOK_ROOT) + "/" + name).c_str(), "r");
  if (!file) return name;
  std::string line, place = name;
  int number = 1;
  for (int c; (c = std::fgetc(file)) != EOF;) {
    line += char(c);
    if (c != '\n') continue;
    if (line.find("// begin [exercise " + id + "]") != std::string::npos && --region == 0) {
      place += ":" + std::to_string(number);
      break;
    }
    line.clear();
    ++number;
  }
  std::fclose(file);
  return place;
}

}  // namespace joints::testing
