// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio {

struct TissueBenchOptions {
  int repeats = 41;        ///< of each measurement, interleaved with its yardstick
  int vertices = 100'000;  ///< of the mesh, about
  int ridges = 360;
  int sections = 360;
};

/// One measured number with its target.
struct TissueBenchRow {
  std::string name;  ///< "lattice_over_triad" ...
  double value = 0.0;
  std::string unit;     ///< "1", "us", "ns", "s"
  double target = 0.0;  ///< 0: told for information
  bool atLeast = true;  ///< value >= target is wanted; false: value <= target
  [[nodiscard]] bool met() const noexcept {
    return target == 0.0 || (atLeast ? value >= target : value <= target);
  }
};

struct TissueBenchResult {
  std::string isa;          ///< instruction set of the view kernels
  int core = -1;            ///< pinned to this core; -1: not pinned (the platform cannot, or forbids it)
  double loadAverage = -1;  ///< of the machine over the last minute; -1: unknown
  std::vector<TissueBenchRow> rows;
};

/// Measures the twist model in this process, on this thread, pinned to one core: kernels as ratios to the
/// STREAM triad over the same working set (what the memory can do at best), median of pairs measured in turn;
/// the haptic query; the set-up of lattice and model. Some seconds. Restores the thread's core afterwards.
[[nodiscard]] TissueBenchResult runTissueBench(const TissueBenchOptions& options = {});

}  // namespace torsio
