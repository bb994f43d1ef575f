// Which version of an exercise file a test was linked with, so that a report can name the line.
#pragma once

#include <string>

namespace joints::testing {

/// The file, from the root of the workbook; "" for tests that belong to no exercise.
const char* exercise_file();
/// "chapters/01_distance/distance.cpp:14", the first line of the exercise; "" where there is none.
std::string exercise_place(const std::string& id);

}  // namespace joints::testing
