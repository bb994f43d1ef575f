// Chapter 9's program, scenes side by side in one recording. Read it; nothing to edit here.
#include "chapters/09_direct/program/program.h"

namespace joints::chapter9 {

void record(const std::string& title, const std::vector<Shown>& shown, const vec3& apart,
            double seconds, const std::string& path) {
  Motion motion(title, double(shown[0].scene.h));
  int first = 0;
  for (const Shown& one : shown) {
    for (std::size_t k = 0; k < one.scene.shapes.size(); ++k) {
      Shape shape = one.scene.shapes[k];
      if (k == 0) shape.label = one.name;
      motion.body(shape);
    }
    draw(motion, one.scene.marks, first);
    first += one.scene.world.bodies.slots();
  }
  std::vector<Body> frame;
  std::vector<Reading> readings;
  for (int n = 0; n <= steps_in(seconds, shown[0].scene.h); ++n) {
    frame.clear();
    readings.clear();
    for (std::size_t k = 0; k < shown.size(); ++k) {
      if (n > 0) shown[k].step();
      for (Body body : all_of(shown[k].scene.world.bodies)) {
        body.x += real(k) * apart;
        frame.push_back(body);
      }
      readings.push_back(reading_of(experiment_of(shown[k].scene, 0), shown[k].name));
    }
    motion.frame(frame.data(), readings);
  }
  motion.write(path);
}

}  // namespace joints::chapter9
