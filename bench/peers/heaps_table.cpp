// Our contacts and the published engines on the same heaps: `./wb bench --contacts`.
#include <cstdio>

#include "bench/named.h"
#include "bench/peers/heaps.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Our contacts and the published engines on the same heaps",
                    {{"csv", "out/contacts.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"scene", "", "one scene alone, by its name in the table"},
                     {"engine", "", "one engine alone, by its name in the table"}});
    if (!options.read(argc, argv)) return;
    std::vector<PeerSetting> all{our_contacts(), our_contacts(8), our_contacts(4, false),
                                 our_contacts(4, true, false)};
    const auto add = [&](const std::vector<PeerSetting>& some) {
      all.insert(all.end(), some.begin(), some.end());
    };
    add(bullet_heap_settings());
#ifdef PEER_ODE
    add(ode_heap_settings());
#endif
    std::vector<Heap> list = heaps();
    keep_named(list, options.text("scene"), &Heap::name);
    FILE* file = open_table(options.text("csv"), options.flag("append"),
                            "engine,version,scene,setting,drift_m,gap_max_m,deepest_m,depth_m,"
                            "fastest_m_s,moving,fallen,us_per_step");
    for (const Heap& heap : list)
      for (const PeerSetting& who : all) {
        if (!options.text("engine").empty() && who.engine != options.text("engine")) continue;
        const Heaped out = run_heap(heap, who);
        std::printf("%-18s %-6s %-40s drift %9.3g mm, gap %6.1f mm, deepest %7.1f, %6.2f mm, "
                    "%6.3f m/s, %3d moving, %3d fallen\n",
                    heap.name.c_str(), who.engine.c_str(), who.name.c_str(), 1000 * out.drift,
                    1000 * out.gap, 1000 * out.deepest, 1000 * out.depth, out.fastest, out.moving,
                    out.fallen);
        std::fflush(stdout);
        std::fprintf(file, "%s,%s,%s,%s%s%s%s%s%s,%d,%d%s\n", who.engine.c_str(),
                     who.version.c_str(), heap.name.c_str(), who.name.c_str(),
                     cell(out.drift).c_str(), cell(out.gap).c_str(), cell(out.deepest).c_str(),
                     cell(out.depth).c_str(), cell(out.fastest).c_str(), out.moving, out.fallen,
                     cell(1e6 * out.seconds / (60 * heap.seconds)).c_str());
        std::fflush(file);
      }
    std::fclose(file);
  });
}
