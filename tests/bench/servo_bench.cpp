// SPDX-License-Identifier: GPL-3.0-or-later
// One whole tick of the servo, by stage of the exercise: device, collision with the deformed organ, model,
// passivity, governor, recording into the ring, publishing. Prints p50, p99 and p99.9 in wall and processor
// time (other load only affects the former), each phase in processor time, the ratio to one STREAM triad over
// the organ's vertices, allocations, locks, and a histogram. Then the time that the device process adds
// between a sample and its force. Options: seconds of exercise (20).
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "sim/core/random.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"
#include "sim/servo/timing_histogram.h"
#include "sim/servo/tool_touch.h"
#include "tests/bench/relay_bench.h"
#include "tests/bench/times.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/support/allocation_count.h"
#include "tests/support/lock_count.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr double kMedianTarget_us = 100.0;
constexpr double kP999Target_us = 200.0;
constexpr double kRelayTarget_us = 100.0;
constexpr int kExchanges = 100'000;

struct Quantiles {
  double median_us = 0.0;
  double p99_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0;
};

Quantiles quantiles(std::vector<double> values_us) {
  if (values_us.empty()) {
    return {};
  }
  std::sort(values_us.begin(), values_us.end());
  return {quantile(values_us, 0.5), quantile(values_us, 0.99), quantile(values_us, 0.999), values_us.back()};
}

double clock_us() {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void print(const char* name, const std::vector<double>& values_us) {
  const Quantiles q = quantiles(values_us);
  std::printf("  %-28s %8.1f %8.1f %8.1f %8.1f us  (%zu ticks)\n", name, q.median_us, q.p99_us, q.p999_us,
              q.max_us, values_us.size());
}

void measure(const Scene& scene, double seconds) {
  ScriptedHand hand({.seed = 3,
                     .task = handTask(scene),
                     .profile = {.initialSkill = 0.6, .finalSkill = 0.6},
                     .duration_s = seconds});
  const int ticks = static_cast<int>(seconds * 1e3);
  SpscRing<Sample> ring(static_cast<std::size_t>(ticks) + 1);
  LatestValue<LiveState> live;
  ServoLoop loop({.device = &hand, .scene = &scene, .recording = &ring, .live = &live}, {});
  std::vector<double> wall_us(static_cast<std::size_t>(ticks));
  std::vector<double> processor(wall_us.size());
  std::array<std::vector<double>, 4> byPhase_us;
  for (auto& phase : byPhase_us) {
    phase.reserve(wall_us.size());
  }
  TimingHistogram histogram;

  const std::int64_t allocations = testing::allocationCount();
  const std::int64_t locks = testing::lockCount();
  for (int i = 0; i < ticks; ++i) {
    const double before_us = processor_us();
    const auto begun = std::chrono::steady_clock::now();
    loop.tick(1000LL * i);
    const auto took = std::chrono::steady_clock::now() - begun;
    const auto at = static_cast<std::size_t>(i);
    wall_us[at] = std::chrono::duration<double, std::micro>(took).count();
    processor[at] = processor_us() - before_us;
    byPhase_us[static_cast<std::size_t>(loop.lastSample().phase)].push_back(processor[at]);
    histogram.add_ns(std::chrono::duration_cast<std::chrono::nanoseconds>(took).count());
  }
  const std::int64_t taken = testing::allocationCount() - allocations;
  const std::int64_t locked = testing::lockCount() - locks;

  std::printf("\n%s: %zu triangles, %zu patches\n  %-28s %8s %8s %8s %8s\n", scene.title.c_str(),
              scene.mesh.triangles.size(), scene.collision.patches().patches().size(), "tick", "p50", "p99",
              "p99.9", "longest");
  print("wall time", wall_us);
  print("processor time", processor);
  constexpr std::array kPhases{"tracking", "contact", "twisting, organ deformed", "released, organ deformed"};
  for (std::size_t p = 0; p < kPhases.size(); ++p) {
    print(kPhases[p], byPhase_us[p]);
  }
  const double triad = triad_us(3 * scene.mesh.vertices_m.size(), 401, clock_us);
  const Quantiles q = quantiles(wall_us);
  const Quantiles deformed = quantiles(byPhase_us[2]);
  const Quantiles spent = quantiles(processor);
  std::printf("  triad over the vertices %.1f us: p50 is %.2f of it, deformed %.2f\n", triad,
              q.median_us / triad, deformed.median_us / triad);
  std::printf("  allocations %lld, locks %lld%s\n", static_cast<long long>(taken),
              static_cast<long long>(locked),
              testing::lockCountWorks() ? "" : " (not counted on this platform)");
  std::printf("  p50 of a deformed organ at most %.0f us: %s; p99.9 at most %.0f us: %s\n", kMedianTarget_us,
              deformed.median_us <= kMedianTarget_us ? "met" : "MISSED", kP999Target_us,
              spent.p999_us <= kP999Target_us ? "met" : "MISSED");
  histogram.forEach([](double from_us, double to_us, std::int64_t count) {
    std::printf("    %8.1f .. %8.1f us %8lld\n", from_us, to_us, static_cast<long long>(count));
  });
}

/// Measures collision alone, with the tool from 20 mm outside to 20 mm inside the organ at its target.
void measureAnywhere(const Scene& scene) {
  constexpr int kPlaces = 20'000;
  const OrganState organ = scene.stateAt(scene.pattern.targetAngle_rad);
  TriangleMesh mesh = scene.mesh;
  scene.deform(organ, mesh.vertices_m);
  Random random(5);
  std::vector<double> processor;
  processor.reserve(kPlaces);
  double sum = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    ToolState tool;
    tool.pose.position_m = mesh.vertices_m[random.bounded(mesh.vertices_m.size())];
    const Vec3 way{random.normal(), random.normal(), random.normal()};
    tool.pose.position_m += normalized(way) * (0.020 * random.uniform());
    tool.pose.orientation =
        normalized(Quat{random.normal(), random.normal(), random.normal(), random.normal()});
    const ToolShape shape = toolShape(tool, scene.instrument);
    TouchMemory nothing;
    const double before_us = processor_us();
    const ToolTouch touch = touchTool(shape, scene, organ, false, nothing);
    processor.push_back(processor_us() - before_us);
    sum += std::min(touch.jaw.gap_m, 1.0);
  }
  print("collision, tool anywhere", processor);
  std::printf("  mean gap %.2f mm\n", 1e3 * sum / kPlaces);
}

void printRelay() {
  const RelayTimes times = measureRelay(kExchanges);
  std::printf("\nthe way through the device process\n  %-28s %8s %8s %8s %8s\n", "", "p50", "p99", "p99.9",
              "longest");
  print("device process, processor", times.device_us);
  print("program, processor", times.program_us);
  print("sample to force, processor", times.both_us);
  print("sample to force, wall", times.wall_us);
  const double p999_us = quantiles(times.both_us).p999_us;
  std::printf("  p99.9 of the processor time at most %.0f us: %s\n", kRelayTarget_us,
              p999_us <= kRelayTarget_us ? "met" : "MISSED");
}

Scene shipped(const std::string& id, const std::string& pattern = {}) {
  return testing::shippedScene(id, pattern);
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::strtod(argv[1], nullptr) : 20.0;
  if (!(seconds >= 1.0 && seconds <= 3600.0)) {
    std::fputs("usage: torsio_bench_servo [SECONDS of exercise, 1 to 3600]\n", stderr);
    return 2;
  }
  using namespace torsio;
  const TriangleMesh bar =
      torsio::testing::prism(torsio::testing::circleOutline(kBarRadius_m, 100), kBarLength_m, 104);
  const Scene scenes[] = {barScene(bar), shipped("forearm"), shipped("stomach"), shipped("intestine")};
  for (const Scene& scene : scenes) {
    measure(scene, seconds);
    measureAnywhere(scene);
  }
  for (const char* id : {"small-bowel-loop", "gastric-organo-axial", "gastric-mesentero-axial", "sigmoid",
                         "midgut", "testis"}) {
    measure(shipped(id, "detorse"), seconds);
  }
  printRelay();
  return 0;
}
