// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of the views separately, for every instruction set of this processor; then the ratios printed
// by `torsio bench`. Options: those of Google Benchmark.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>

#include <benchmark/benchmark.h>

#include "sim/tissue/twist/twist_bench.h"
#include "sim/tissue/view/cpu_features.h"
#include "sim/tissue/view/twist_kernels.h"
#include "sim/tissue/view/twist_kernels_buffer.h"

namespace torsio {
namespace {

constexpr int kVertices = 100'000;
constexpr int kBlocks = (kVertices + kKernelBlock - 1) / kKernelBlock;

/// Reads `in` floats and writes `out` floats per vertex.
using Kernel = std::function<void(const TwistKernels&, const float*, float*)>;

void measure(benchmark::State& state, Isa isa, int in, int out, const Kernel& kernel) {
  const std::size_t lanes = static_cast<std::size_t>(kBlocks) * kKernelBlock;
  KernelBuffer<float> input(lanes * static_cast<std::size_t>(in));
  KernelBuffer<float> output(lanes * static_cast<std::size_t>(out), 32);
  for (std::size_t i = 0; i < input.size(); ++i) {
    input[i] = static_cast<float>(i % 97) * 0.01F;
  }
  const TwistKernels& kernels = twistKernels(isa);
  for (auto _ : state) {
    kernel(kernels, input.data(), output.data());
    benchmark::DoNotOptimize(output.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kVertices);
  state.SetBytesProcessed(state.iterations() * kVertices * (in + out) *
                          static_cast<std::int64_t>(sizeof(float)));
}

void add(const std::string& name, int in, int out, const Kernel& kernel) {
  for (const Isa isa : usableIsas()) {
    benchmark::RegisterBenchmark((name + "/" + std::string(isaName(isa))).c_str(),
                                 [=](benchmark::State& state) { measure(state, isa, in, out, kernel); });
  }
}

void addAll() {
  TwistFrame twist{
      .torque = 1.3F, .farBase = 0.5F, .graspCompliance = 0.5F, .inverseBlend = 10.0F, .nearRate = 1.3F};
  add("triad", 2, 1, [](const TwistKernels& k, const float* in, float* out) {
    const int count = kBlocks * kKernelBlock;
    k.triad(in, in + count, 0.5F, count, out);
  });
  add("curved_warp", 11, 3,
      [=](const TwistKernels& k, const float* in, float* out) { k.curvedWarp(in, kBlocks, twist, out); });
  add("curved", 10, 3,
      [=](const TwistKernels& k, const float* in, float* out) { k.curved(in, kBlocks, twist, out); });
  PaperFrame paper{.torque = 1.3F, .graspArc = 0.5F};
  add("paper_linear", 11, 3,
      [=](const TwistKernels& k, const float* in, float* out) { k.paperLinear(in, kBlocks, paper, out); });
  add("interleave", 3, 3,
      [](const TwistKernels& k, const float* in, float* out) { k.interleave(in, kVertices, out, 3); });
}

void printRatios() {
  const TissueBenchResult result = runTissueBench();
  std::printf("\n%s, core %d, load average %.2f\n", result.isa.c_str(), result.core, result.loadAverage);
  for (const TissueBenchRow& row : result.rows) {
    std::printf("%-32s %10.3f %-3s", row.name.c_str(), row.value, row.unit == "1" ? "" : row.unit.c_str());
    if (row.target != 0.0) {
      std::printf("  %s %g: %s", row.atLeast ? "at least" : "at most", row.target,
                  row.met() ? "met" : "MISSED");
    }
    std::printf("\n");
  }
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  torsio::addAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  torsio::printRatios();
  return 0;
}
