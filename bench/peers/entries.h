// The scenes on which peers are measured.
#pragma once

#include "bench/runner.h"

/// \addtogroup peers
/// @{
namespace joints::bench {

/// A scene, how long it runs, and our methods on it.
struct PeerEntry {
  std::string name{};   ///< in the table
  MakeScene make{};
  Span span{.steps = 300, .timed = 80};
  std::string ours{};   ///< words of setting_named(), but for tree_methods()
  bool quick = true;    ///< also in the short form
  bool basic = false;   ///< only the basic settings of the engines
  bool falls = false;   ///< its steps are not alike: all are timed, in one round
  bool slow = false;    ///< also solvers of which a step takes a tenth of a second here
};
/// All of them. \param quick those of the short form alone
std::vector<PeerEntry> peer_entries(bool quick);

}  // namespace joints::bench
/// @}
