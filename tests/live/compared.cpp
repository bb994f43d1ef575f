// Every method on the scene with which a chapter's live page begins: `./wb run 3 --compare`.
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "comparison/compare.h"
#include "docs/live/scenes.h"

using namespace joints;

int main(int argc, char** argv) {
  const std::string chapter = argc > 1 ? argv[1] : "";
  const std::string like = chapter == "11" ? "7" : chapter;  // both have a chain on hinges
  for (const live::Entry& entry : live::entries())
    if (std::count(entry.opens.begin(), entry.opens.end(), like))
      return compare_main(
          [&entry] {
            const live::LiveScene scene = entry.make();
            if (scene.drive) scene.drive(scene.speed, scene.strength);
            if (scene.before) scene.before(0);
            return std::move(scene.scene->world);
          },
          argc - 1, argv + 1);
  std::fprintf(stderr, "chapter %s: no scene begins with it\n", chapter.c_str());
  return 2;
}
