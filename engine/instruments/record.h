// Recording: tables as CSV, and a motion that a page can play. The engine does not include it.
#pragma once

#include <array>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

#include "engine/body.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// A table on disk: a header line, then one line a row. Figures are drawn from these.
class CsvFile {
 public:
  /// \param path made together with its folder \throws std::invalid_argument if it cannot be made
  CsvFile(const std::string& path, std::initializer_list<const char*> columns);
  /// One row of numbers. \throws std::invalid_argument unless there is one for each column
  void row(std::initializer_list<double> numbers);
  /// One row that begins with words. Together they must fill the columns.
  void row(std::initializer_list<std::string> words, std::initializer_list<double> numbers);

 private:
  std::ofstream file_;
  std::string path_;
  std::size_t columns_;
};

/// How a body looks.
struct Shape {
  std::string kind = "box";                ///< "box" or "ball"
  std::array<double, 3> size{1, 1, 1};     ///< edges [m]; a ball's diameter in all three
  std::string label{};                     ///< written beside it, if it is not empty
};
/// A line drawn from a point of one body to a point of another: rods, ropes, joints.
struct Segment {
  int body1 = 0, body2 = 0;                             ///< places in the array
  std::array<double, 3> anchor1{}, anchor2{};           ///< [m, body space]
};

/// What is shown beside a picture of bodies: how well it holds at this moment.
struct Reading {
  std::string of{};       ///< which of several scenes side by side; empty where there is one
  double gap = 0;         ///< the largest of its joints [m]
  double energy = 0;      ///< of motion and of position [J]
};

/// A recorded run: shapes once, then a pose of every body for each frame, and readings. Written as
/// JSON, which tools/pictures/motion.py puts into a page that plays it.
class Motion {
 public:
  /// \param title shown on the page \param h time between two calls of frame() [s]
  /// \param every keep one frame of so many; all are kept if a body turns by more than half a
  /// radian from one that is kept to the next
  Motion(std::string title, double h, int every = 2);
  void body(const Shape& shape);  ///< the next body of the array
  void line(const Segment& segment);    ///< one more line to draw
  /// Remembers the poses of the first n bodies, n = how many shapes there are.
  /// \param readings of this moment, as many in every frame
  void frame(const Body* bodies, const std::vector<Reading>& readings = {});
  /// \throws std::invalid_argument if the file cannot be made
  void write(const std::string& path) const;

 private:
  std::string title_;
  double h_;
  int every_;
  bool turns_fast() const;
  std::vector<Shape> shapes_;
  std::vector<Segment> segments_;
  std::vector<std::vector<float>> poses_;  // 7 numbers a body
  std::vector<std::vector<Reading>> readings_;
};

}  // namespace joints
/// @}
