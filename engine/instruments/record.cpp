// Writing tables and motions.
#include "engine/instruments/record.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace joints {

namespace {

std::ofstream open(const std::string& path) {
  std::error_code ignored;
  const auto folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  std::ofstream file(path);
  if (!file) refuse("out: cannot write " + path);
  return file;
}

std::string text(double number, const char* format = "%.10g") {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, format, number);
  return buffer;
}

// A word of a table; quoted where it holds a comma.
std::string field(const std::string& word) {
  return word.find(',') == std::string::npos ? word : '"' + word + '"';
}

// A text of a JSON file.
std::string json(const std::string& words) {
  std::string out = "\"";
  for (char c : words) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + '"';
}

std::string triple(const std::array<double, 3>& a) {
  return "[" + text(a[0]) + "," + text(a[1]) + "," + text(a[2]) + "]";
}

}  // namespace

CsvFile::CsvFile(const std::string& path, std::initializer_list<const char*> columns)
    : file_(std::make_shared<std::ofstream>(open(path))), path_(path), columns_(columns.size()) {
  const char* comma = "";
  for (const char* column : columns) {
    *file_ << comma << column;
    comma = ",";
  }
  *file_ << '\n';
}

void CsvFile::row(std::initializer_list<double> numbers) { row({}, numbers); }

void CsvFile::row(std::initializer_list<std::string> words,
                  std::initializer_list<double> numbers) {
  if (words.size() + numbers.size() != columns_)
    refuse("row: " + path_ + " has " + std::to_string(columns_) + " columns");
  const char* comma = "";
  for (const std::string& word : words) {
    *file_ << comma << field(word);
    comma = ",";
  }
  for (double number : numbers) {
    *file_ << comma << text(number);
    comma = ",";
  }
  *file_ << '\n';
}

Motion::Motion(std::string title, double h, int every)
    : title_(std::move(title)), h_(h), every_(every) {
  require(std::isfinite(h) && h > 0, "h: the time between two frames must be positive [s]");
  require(every > 0, "every: one frame of how many, at least 1");
}

void Motion::body(const Shape& shape) { shapes_.push_back(shape); }
void Motion::line(const Segment& segment) { segments_.push_back(segment); }

void Motion::frame(const Body* bodies, const std::vector<Reading>& readings) {
  require(readings_.empty() || readings.size() == readings_[0].size(),
          "readings: every frame has as many");
  readings_.push_back(readings);
  std::vector<float>& pose = poses_.emplace_back();
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Body& b = bodies[i];
    for (real number : {b.x.x, b.x.y, b.x.z, b.q.w, b.q.x, b.q.y, b.q.z})
      pose.push_back(float(number));
  }
}

bool Motion::turns_fast() const {
  const float most = std::cos(0.25f);  // of half the angle between two frames that are kept
  for (std::size_t n = std::size_t(every_); n < poses_.size(); n += std::size_t(every_))
    for (std::size_t k = 3; k < poses_[n].size(); k += 7) {
      const auto q = poses_[n].begin() + long(k), before = poses_[n - every_].begin() + long(k);
      if (std::abs(std::inner_product(q, q + 4, before, 0.0f)) < most) return true;
    }
  return false;
}

void Motion::write(const std::string& path) const {
  std::ofstream file = open(path);
  const int every = turns_fast() ? 1 : every_;
  file << "{\"title\":" << json(title_) << ",\"dt\":" << text(h_ * every) << ",\"bodies\":[";
  for (std::size_t i = 0; i < shapes_.size(); ++i)
    file << (i ? "," : "") << "{\"kind\":\"" << shapes_[i].kind
         << "\",\"size\":" << triple(shapes_[i].size)
         << (shapes_[i].label.empty() ? "" : ",\"label\":" + json(shapes_[i].label)) << "}";
  file << "],\"lines\":[";
  for (std::size_t i = 0; i < segments_.size(); ++i)
    file << (i ? "," : "") << "[" << segments_[i].body1 << "," << triple(segments_[i].anchor1)
         << "," << segments_[i].body2 << "," << triple(segments_[i].anchor2) << "]";
  // A row of numbers for each frame that is kept.
  const auto rows = [&](const auto& write_row) {
    for (std::size_t n = 0; n < poses_.size(); n += std::size_t(every)) {
      file << (n ? ",\n[" : "\n[");
      write_row(n);
      file << "]";
    }
  };
  file << "],\"frames\":[";
  rows([&](std::size_t n) {
    for (std::size_t i = 0; i < poses_[n].size(); ++i)
      file << (i ? "," : "") << text(poses_[n][i], "%.6g");
  });
  file << "],\"readings\":[";
  rows([&](std::size_t n) {
    for (const Reading& one : readings_[n])
      file << (&one == readings_[n].data() ? "" : ",") << "[" << json(one.of) << ","
           << text(one.gap, "%.3g") << "," << text(one.energy, "%.6g") << "]";
  });
  file << "]}\n";
}

}  // namespace joints
