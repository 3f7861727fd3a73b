// SPDX-License-Identifier: GPL-3.0-or-later
// Scrubbing through a recording of 40 minutes: how long the window takes to answer. Prints one line a step
// and fails when a scrub takes longer than what a hand feels.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include <QApplication>
#include <QPixmap>

#include "app/gui/review/trace_view.h"
#include "app/gui/trial_playback.h"
#include "sim/base/random.h"
#include "sim/record/sample_codec.h"

namespace {

using namespace torsio;
using SteadyClock = std::chrono::steady_clock;

constexpr std::int64_t kMinutes = 40;
constexpr std::int64_t kTick_us = 1000;
constexpr double kAnswer_ms = 50.0;
constexpr int kScrubs = 400;

Sample sampleAt(std::int64_t tick) {
  const double time_s = static_cast<double>(tick) * 1e-3;
  Sample sample;
  sample.tick = tick;
  sample.device.time_us = tick * kTick_us;
  sample.response.angle_rad = 0.8 * std::sin(0.7 * time_s) * std::sin(0.7 * time_s);
  sample.response.torque_Nm = 0.3 * sample.response.angle_rad;
  sample.response.graspArc_m = 0.2;
  sample.force_N = {0.0, 0.0, 1.0 + 0.4 * std::sin(31.0 * time_s)};
  return sample;
}

Trial longTrial() {
  Trial trial;
  trial.header.trialId = "bench";
  std::vector<Sample> second(static_cast<std::size_t>(kSamplesPerChunk));
  for (std::int64_t index = 0; index < kMinutes * 60; ++index) {
    for (std::int64_t i = 0; i < kSamplesPerChunk; ++i)
      second[static_cast<std::size_t>(i)] = sampleAt(index * kSamplesPerChunk + i);
    trial.chunks.push_back(encodeChunk(index, second));
  }
  trial.summary.samples = kMinutes * 60 * kSamplesPerChunk;
  return trial;
}

double since_ms(SteadyClock::time_point start) {
  return std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  auto start = SteadyClock::now();
  const Trial trial = longTrial();
  std::printf("encode %lld min: %.0f ms\n", static_cast<long long>(kMinutes), since_ms(start));

  start = SteadyClock::now();
  gui::TrialPlayback playback(trial);
  std::printf("decode (worker thread): %.0f ms\n", since_ms(start));
  start = SteadyClock::now();
  const gui::TraceData traces = gui::traceData(playback);
  std::printf("traces (worker thread): %.0f ms\n", since_ms(start));

  gui::TraceView view;
  view.resize(1100, 240);
  view.setData(&traces);
  QPixmap target(view.size());
  start = SteadyClock::now();
  view.render(&target);
  const double first_ms = since_ms(start);
  std::printf("first drawing of the traces: %.2f ms\n", first_ms);

  Random random(1);
  std::vector<double> scrubs_ms;
  for (int i = 0; i < kScrubs; ++i) {
    const auto to_us =
        static_cast<std::int64_t>(random.uniform() * static_cast<double>(playback.duration_us()));
    start = SteadyClock::now();
    playback.seek_us(to_us);
    const LiveState state = playback.state();
    view.setPosition_us(state.time_us);
    view.render(&target);
    scrubs_ms.push_back(since_ms(start));
  }
  std::sort(scrubs_ms.begin(), scrubs_ms.end());
  const double median_ms = scrubs_ms[scrubs_ms.size() / 2];
  const double worst_ms = scrubs_ms.back();
  std::printf("scrub of %d random places: median %.2f ms, worst %.2f ms (limit %.0f ms)\n", kScrubs,
              median_ms, worst_ms, kAnswer_ms);
  return std::max(first_ms, worst_ms) <= kAnswer_ms ? 0 : 1;
}
