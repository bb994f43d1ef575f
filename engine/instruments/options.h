// Options of the chapters' programs, and the handling of errors in them.
#pragma once

#include <functional>
#include <string>
#include <vector>

/// \addtogroup measuring
/// @{
namespace joints {

/// The options of a program: `--name value`, each with a default and one line of help.
class Options {
 public:
  /// One option. \see Options
  struct Option {
    std::string name;   ///< without the two dashes
    std::string value;  ///< its default, then the value of the command line
    std::string help;   ///< one line; if it begins with "1: ", the option without a value means 1
  };
  /// Declares the options of a program. Every program also accepts `--out` and `--help`.
  Options(std::string program, std::vector<Option> known);
  /// Reads the command line. \return false if --help was given (and printed)
  /// \throws std::invalid_argument for an unknown option or a missing value
  bool read(int argc, const char* const* argv);

  std::string text(const std::string& name) const;  ///< the value as text
  /// Reads a number. \throws std::invalid_argument unless it is a finite number of at least `least`
  double number(const std::string& name, double least) const;
  /// Reads a count. \throws std::invalid_argument unless it is whole, from `least` to a million
  int count(const std::string& name, int least) const;
  /// Reads a switch. \throws std::invalid_argument unless it is 0 or 1
  bool flag(const std::string& name) const;

 private:
  std::string program_;
  std::vector<Option> known_;
};

/// Runs the body of a program. An error becomes one line on standard error.
/// \return 0, 2 for bad input, 3 for an exercise that is not written yet
int run_program(const std::function<void()>& body);

}  // namespace joints
/// @}
