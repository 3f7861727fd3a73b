// SPDX-License-Identifier: GPL-3.0-or-later
// A hollow organ that is wrung: set-up of its table, and one query in processor time of this thread, as the
// median over batches of 64 queries at angles and pressures in no order. Targets: 1 s and 300 ns. Then the
// kernel that draws it, with the memory traffic of the triad over its 14 streams: target half of the triad.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "sim/tissue/hollow/wrung_organ.h"
#include "sim/tissue/view/cpu_features.h"
#include "sim/tissue/view/twist_kernels.h"
#include "sim/tissue/view/twist_kernels_buffer.h"

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

double median(std::vector<double>& values) {
  std::nth_element(values.begin(), values.begin() + std::ssize(values) / 2, values.end());
  return values[values.size() / 2];
}

/// A tube with folds, its vertices ring by ring along one span.
KernelBuffer<float> tubeVertices(std::size_t blocks) {
  KernelBuffer<float> in(blocks * 11 * 16);
  for (std::size_t v = 0; v < blocks * 16; ++v) {
    float* lane = &in[v / 16 * 11 * 16 + v % 16];
    const auto angle = static_cast<float>(v % 320) * 0.0196F;
    lane[0] = lane[3 * 16] = 0.04F - 0.001F * angle;
    lane[8 * 16] = 1.0F;
    lane[9 * 16] = 512.0F * static_cast<float>(v) / static_cast<float>(blocks * 16);
    lane[10 * 16] = angle;
  }
  return in;
}

void draw(Isa isa) {
  constexpr std::size_t kBlocks = 6250;  // 100,000 vertices
  constexpr int kRepeats = 301;
  constexpr std::size_t kCount = kBlocks * 14 * 16 / 3;
  const KernelBuffer<float> in = tubeVertices(kBlocks);
  KernelBuffer<float> out(kBlocks * 3 * 16, 32);
  const KernelBuffer<float> a(kCount);
  const KernelBuffer<float> b(kCount, 32);
  KernelBuffer<float> c(kCount, 64);
  const std::vector<float> turn(516, 1.2F);
  const std::vector<float> radius(516, 0.8F);
  const std::vector<float> amplitude(516, 0.2F);
  const std::vector<float> crest(516, 0.7F);
  const HollowFrame frame{turn.data(), radius.data(), amplitude.data(), crest.data(), 3.0F, 5.0F};
  const TwistKernels& kernels = twistKernels(isa);
  std::vector<double> ratios;
  std::vector<double> times_ns;
  for (int i = 0; i < kRepeats; ++i) {
    const double begun = now_ns();
    kernels.triad(a.data(), b.data(), 0.5F, static_cast<int>(kCount), c.data());
    const double between = now_ns();
    kernels.hollow(in.data(), static_cast<int>(kBlocks), frame, out.data());
    const double done = now_ns();
    ratios.push_back((between - begun) / (done - between));
    times_ns.push_back(done - between);
  }
  std::printf("%-20s hollow_over_triad %5.2f   100,000 vertices %6.1f us\n", isaName(isa).data(),
              median(ratios), 1e-3 * median(times_ns));
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
  for (const torsio::Isa isa : torsio::usableIsas()) {
    torsio::draw(isa);
  }
  return 0;
}
