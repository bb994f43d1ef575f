// Compiled once for every version of an exercise file, with its name. Light, because it is many.
namespace joints::testing {
extern const char* const exercise_file;
const char* const exercise_file = EXERCISE_FILE;
}  // namespace joints::testing
