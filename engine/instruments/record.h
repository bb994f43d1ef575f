// Recording: tables as CSV, and a motion that a page can play. The engine does not include this
// file.
#pragma once

#include <array>
#include <initializer_list>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "engine/body.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// A table on disk: a header line, then one line per row. Figures are drawn from these.
class CsvFile {
 public:
  /// Opens it. \param path the file; created together with its folder \throws std::invalid_argument
  /// if it cannot be created
  CsvFile(const std::string& path, std::initializer_list<const char*> columns);
  /// One row of numbers. \throws std::invalid_argument unless there is one for each column
  void row(std::initializer_list<double> numbers);
  /// One row that begins with words. Together they must fill the columns.
  void row(std::initializer_list<std::string> words, std::initializer_list<double> numbers);

 private:
  std::shared_ptr<std::ostream> file_;  // a file; libc++ in a browser has no std::ofstream
  std::string path_;
  std::size_t columns_;
};

/// The appearance of a body.
struct Shape {
  std::string kind = "box";                ///< "box" or "ball"
  std::array<double, 3> size{1, 1, 1};     ///< edges [m]; a ball's diameter in all three
  std::string label{};                     ///< text beside it, if not empty
};
/// A line drawn from a point of one body to a point of another: rods, ropes, joints.
struct Segment {
  int body1 = 0, body2 = 0;                             ///< indices in the array
  std::array<double, 3> anchor1{}, anchor2{};           ///< [m, body space]
};

/// The numbers shown beside a picture of bodies: its errors at this moment.
struct Reading {
  std::string of{};       ///< name of one of several scenes side by side; empty if there is one
  double gap = 0;         ///< the largest of its joints [m]
  double energy = 0;      ///< kinetic and potential [J]
};

/// A recorded run: shapes once, then a pose of every body for each frame, and readings. Written as
/// JSON, which tools/pictures/motion.py puts into a page that plays it.
class Motion {
 public:
  /// An empty one. \param title shown on the page \param h time between two calls of frame() [s]
  /// \param every keep one frame of this number; all are kept if a body rotates by more than half a
  /// radian between two kept frames
  Motion(std::string title, double h, int every = 2);
  void body(const Shape& shape);  ///< the next body of the array
  void line(const Segment& segment);    ///< one more line to draw
  /// Stores the poses of the first n bodies, n = number of shapes.
  /// \param readings of this moment, the same number in every frame
  void frame(const Body* bodies, const std::vector<Reading>& readings = {});
  /// Writes the file. \throws std::invalid_argument if the file cannot be created
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
