// What every chapter's program shares: its options, and how it answers bad ones.
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
    std::string value;  ///< its default, then what the command line said
    std::string help;   ///< one line; with "1: ..." the option may stand alone and means 1
  };
  /// Declares the options that a program knows. Every program knows `--out` and `--help`.
  Options(std::string program, std::vector<Option> known);
  /// Reads the command line. \return false when --help was asked for (and printed)
  /// \throws std::invalid_argument for an option that the program does not know, or no value
  bool read(int argc, const char* const* argv);

  std::string text(const std::string& name) const;  ///< the value as it was written
  /// \throws std::invalid_argument unless it is a finite number of at least `least`
  double number(const std::string& name, double least) const;
  /// \throws std::invalid_argument unless it is a whole number from `least` to a million
  int count(const std::string& name, int least) const;
  /// \throws std::invalid_argument unless it is 0 or 1
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
