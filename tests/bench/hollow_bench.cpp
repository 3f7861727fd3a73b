// SPDX-License-Identifier: GPL-3.0-or-later
// A hollow organ that is wrung: set-up of its table, and one query in processor time of this thread, as the
// median over batches of 64 queries at angles and pressures in no order. Targets: 1 s and 300 ns.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "sim/tissue/hollow/wrung_organ.h"

namespace torsio {
namespace {

double now_ns() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<double>(std::chrono::duration_cast<std::chrono::nanoseconds>(time).count());
}

void run(const char* name, double radius_m, double wall_m, double length_m, const HollowContent& content) {
  constexpr int kBatches = 20'001;
  constexpr int kQueries = 64;
  const std::vector<WallPlace> places(41, WallPlace{radius_m, wall_m});
  const double begun = now_ns();
  const WrungOrgan organ(places, length_m, content);
  const double setUp_ms = 1e-6 * (now_ns() - begun);
  std::vector<double> times_ns;
  double sum = 0.0;
  unsigned state = 1;
  for (int batch = 0; batch < kBatches; ++batch) {
    const double start = now_ns();
    for (int k = 0; k < kQueries; ++k) {
      state = state * 1664525U + 1013904223U;
      const double share = static_cast<double>(state >> 8U) / 16777216.0;
      const WrungState there = organ.at(4.0 * share, content.highestPressure_Pa * (1.0 - share));
      sum += there.torque + there.patency;
    }
    times_ns.push_back((now_ns() - start) / kQueries);
  }
  std::nth_element(times_ns.begin(), times_ns.begin() + kBatches / 2, times_ns.end());
  std::printf("%-20s set-up %6.1f ms   query median %5.1f ns   (%g)\n", name, setUp_ms,
              times_ns[kBatches / 2], sum);
}

}  // namespace
}  // namespace torsio

int main() {
  torsio::run("empty stomach", 0.040, 0.003, 0.25, {.shearModulus_Pa = 5e3});
  torsio::run("stomach 4 mmHg", 0.040, 0.003, 0.25,
              {.shearModulus_Pa = 5e3, .restPressure_Pa = 550.0, .highestPressure_Pa = 550.0});
  torsio::run(
      "sigmoid 10 mmHg", 0.035, 0.002, 0.2,
      {.shearModulus_Pa = 1e4, .gentLimit = 0.6, .restPressure_Pa = 1333.0, .highestPressure_Pa = 1333.0});
  return 0;
}
