// How many scenes of every family each setting holds. `./wb bench --families` calls it.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>

#include "bench/families.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers.empty() ? none : numbers[numbers.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("How many scenes of every family each setting holds",
                    {{"csv", "out/families.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"family", "", "one family alone, by its name in the table"},
                     {"settings", "shake inertia", "the settings, with blanks between"},
                     {"seed", "1", "of the first scene of every family"},
                     {"draws", "0", "scenes of every family; 0: as many as it has"},
                     {"hertz", "60", "steps per second [Hz]"},
                     {"each", "0", "1: tell every scene that is not held or kept"}});
    if (!options.read(argc, argv)) return;
    std::vector<Family> list = families();
    keep_named(list, options.text("family"), &Family::name);
    FILE* file = open_table(options.text("csv"), options.flag("append"),
                            "family,real,setting,first_seed,held,of,lost,kept,gap_max_m,past_max,"
                            "gain_max,loss_median,loss_max,momentum_max,seconds");
    const int first = options.count("seed", 0), draws = options.count("draws", 0);
    const double hertz = options.number("hertz", 1);
    const std::string at = hertz == 60 ? "" : " at " + options.text("hertz") + " Hz";
    std::printf("%-18s %-11s %11s %5s %5s %9s %9s %8s %13s %8s %6s\n", "family", "setting", "held",
                "lost", "kept", "gap [mm]", "past", "gain [%]", "loss [%]", "momentum", "t [s]");
    for (const Family& family : list)
      for (const std::string& setting : words(options.text("settings"))) {
        const auto began = std::chrono::steady_clock::now();
        const int count = draws > 0 ? draws : family.draws;
        int held = 0, lost = 0, kept = 0;
        double gap = 0, past = 0, gain = 0, momentum = 0;
        std::vector<double> losses;
        for (int k = 0; k < count; ++k) {
          Drawn scene = family.draw(unsigned(first + k));
          const bool keeps_energy = scene.keeps_energy;
          const Outcome out = run_drawn(std::move(scene), setting, 1 / hertz);
          held += out.held();
          lost += !out.held(0.02);
          gap = std::max(gap, out.finite ? out.gap : 1 / 0.0);
          past = std::max(past, out.past);
          gain = std::max(gain, out.gain);
          momentum = std::max(momentum, out.momentum);
          if (keeps_energy) {
            kept += out.kept();
            losses.push_back(out.loss);
          }
          if (options.flag("each") && !(out.held() && (!keeps_energy || out.kept())))
            std::printf("  seed %d: gap %.3g mm, gain %.3g %%, loss %.3g %%\n", first + k,
                        1000 * out.gap, 100 * out.gain, 100 * out.loss);
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                                             began).count();
        const double middle = median(losses);
        const double most = losses.empty() ? none : *std::max_element(losses.begin(), losses.end());
        std::printf("%-18s %-11s %4d of %4d %5d %5d %9.3g %9.3g %8.3g %6.3g %6.3g %8.2g %6.1f\n",
                    family.name.c_str(), setting.c_str(), held, count, lost, kept, 1000 * gap, past,
                    100 * gain, 100 * middle, 100 * most, momentum, seconds);
        std::fflush(stdout);
        std::fprintf(file, "%s,%s,%s,%d,%d,%d,%d,%d%s%s%s%s%s%s%s\n", (family.name + at).c_str(),
                     sizeof(real) == 8 ? "double" : "float", setting.c_str(), first, held, count,
                     lost, kept, cell(gap).c_str(), cell(past).c_str(), cell(gain).c_str(),
                     cell(middle).c_str(), cell(most).c_str(), cell(momentum).c_str(),
                     cell(seconds).c_str());
        std::fflush(file);
      }
    std::fclose(file);
  });
}
