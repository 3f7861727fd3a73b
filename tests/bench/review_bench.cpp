// SPDX-License-Identifier: GPL-3.0-or-later
// Reviewing a recording of 40 minutes: its memory while open, and the response time of the window while
// scrubbing: decoding the moment, placing organ and instrument, drawing the traces with their cursor. A
// scripted hand twists the arm; arguments: minutes, width and height of the panel. With a display (xvfb-run),
// the picture is also drawn and timed separately, and the memory includes that of the graphics driver, but
// not the code of a software renderer; a recording of a few seconds, opened first, shows how much of it is
// due to the 40 minutes. Fails if scrubbing is noticeably slow, or if the memory exceeds that of a small
// machine. Judged by processor time of all threads, which is independent of other load; wall time is printed
// as well.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <QApplication>
#include <QSize>

#include "app/gui/physician/replay_panel.h"
#include "app/services/recording/recorded_run.h"
#include "sim/core/random.h"
#include "sim/record/trial.h"
#include "tests/support/shipped_scene.h"

namespace {

using namespace torsio;
using SteadyClock = std::chrono::steady_clock;

constexpr int kMinutes = 40;
constexpr double kShort_s = 10.0;
const QSize kPanel{680, 600};
constexpr double kAnswer_ms = 50.0;
constexpr double kPictureWork_ms = 2.0 * kAnswer_ms;  // of the two cores of the smallest machine
constexpr double kOpen_MB = 200.0;
constexpr double kPatience_ms = 2000.0;
constexpr int kScrubs = 400;
constexpr int kWarmUp = 20;

double since_ms(SteadyClock::time_point start) {
  return std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
}

double worked_ms(std::clock_t since) {
  return 1e3 * static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC;
}

/// Returns the program's resident memory; 0 if unknown.
double resident_MB() {
  constexpr double kPage_MB = 4096.0 / 1e6;
  std::ifstream file("/proc/self/statm");
  double whole = 0.0;
  double resident = 0.0;
  file >> whole >> resident;
  return resident * kPage_MB;
}

/// Returns the part of it used by the libraries of a software renderer, which a machine with a graphics card
/// does not load; 0 if unknown.
double renderer_MB() {
  std::ifstream file("/proc/self/smaps");
  std::string line;
  bool its = false;
  double sum_kB = 0.0;
  while (std::getline(file, line)) {
    if (line.find('-') < line.find(' ') && line.find(':') > line.find(' ')) {
      its = line.find("/libLLVM") != std::string::npos || line.find("swrast_dri") != std::string::npos;
    } else if (its && line.starts_with("Rss:")) {
      sum_kB += std::atof(line.c_str() + 4);
    }
  }
  return sum_kB * 1024.0 / 1e6;
}

Trial recorded(double duration_s) {
  ScriptedTrial script;
  script.recording = {.trialId = "bench", .phaseLabel = "bench"};
  script.duration_s = duration_s;
  MemoryTrialSink sink;
  recordScriptedTrial(torsio::testing::shippedScene("forearm"), script, sink);
  return sink.trial();
}

double packed_MB(const Trial& trial) {
  double sum_MB = 0.0;
  for (const TrialChunk& chunk : trial.chunks) {
    sum_MB += static_cast<double>(chunk.bytes.size()) / 1e6;
  }
  return sum_MB;
}

/// Sorted; empty without a display.
struct Times {
  std::vector<double> work_ms;
  std::vector<double> answers_ms;
  std::vector<double> pictureWork_ms;
  std::vector<double> pictures_ms;
};

double quantile(const std::vector<double>& sorted, std::size_t percent) {
  return sorted.empty() ? 0.0 : sorted[(sorted.size() - 1) * percent / 100];
}

void tell(const char* what, const std::vector<double>& sorted_ms) {
  if (sorted_ms.empty()) {
    return;
  }
  std::printf("%-28s median %.2f ms, 99 %% %.2f ms, worst %.2f ms\n", what, quantile(sorted_ms, 50),
              quantile(sorted_ms, 99), sorted_ms.back());
}

/// Seeks to and fro at random.
Times scrub(gui::ReplayPanel& panel, int jumps) {
  const auto* view = panel.findChild<gui::SceneView*>();
  auto* traces = panel.findChild<gui::TraceView*>();
  const auto duration_us = static_cast<double>(panel.recording()->playback.duration_us());
  Random random(1);
  Times into;
  for (int i = 0; i < jumps; ++i) {
    const auto to_us = static_cast<std::int64_t>(random.uniform() * duration_us);
    const std::int64_t frames = view->framesDrawn();
    const std::clock_t begun = std::clock();
    const auto start = SteadyClock::now();
    panel.seek_us(to_us);
    // With a picture, the window is composed once, for organ and traces.
    if (!gui::SceneView::platformCanRender()) {
      traces->repaint();
    }
    into.answers_ms.push_back(since_ms(start));
    into.work_ms.push_back(worked_ms(begun));
    if (!gui::SceneView::platformCanRender()) {
      continue;
    }
    while (view->framesDrawn() == frames && since_ms(start) < kPatience_ms) {
      QApplication::processEvents();
    }
    QApplication::processEvents();
    into.pictures_ms.push_back(since_ms(start));
    into.pictureWork_ms.push_back(worked_ms(begun));
  }
  for (auto* list : {&into.work_ms, &into.answers_ms, &into.pictureWork_ms, &into.pictures_ms}) {
    std::sort(list->begin(), list->end());
  }
  return into;
}

/// Loads like a worker thread, shows, and draws once; consumes the trial.
void open(gui::ReplayPanel& panel, Trial trial, const std::filesystem::path& assets) {
  panel.show(nullptr);
  const auto start = SteadyClock::now();
  auto loaded = gui::loadForShowing({"7F", std::move(trial), "00000000"}, assets);
  std::printf("opened in a worker thread in %.0f ms\n", since_ms(start));
  panel.show(std::move(loaded));
  QApplication::processEvents();
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("DISPLAY")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  const int minutes = argc > 1 ? std::max(1, std::atoi(argv[1])) : kMinutes;
  const QSize size = argc > 3 ? QSize(std::atoi(argv[2]), std::atoi(argv[3])) : kPanel;
  gui::SceneView::prepareGraphics();
  const QApplication application(argc, argv);
  const std::filesystem::path assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  const auto start = SteadyClock::now();
  Trial shortTrial = recorded(kShort_s);
  Trial longTrial = recorded(60.0 * minutes);
  const double long_MB = packed_MB(longTrial);
  std::printf("recorded %d min in %.1f s, packed %.1f MB\n", minutes, since_ms(start) * 1e-3, long_MB);

  const double before_MB = resident_MB() - long_MB - renderer_MB();
  gui::ReplayPanel panel(assets);
  panel.retranslate();
  panel.resize(size);
  panel.setVisible(true);
  open(panel, std::move(shortTrial), assets);
  static_cast<void>(scrub(panel, kWarmUp));
  const double short_MB = resident_MB() - long_MB - renderer_MB();
  open(panel, std::move(longTrial), assets);
  const Times times = scrub(panel, kScrubs);
  const double open_MB = resident_MB() - renderer_MB();

  const auto* view = panel.findChild<gui::SceneView*>();
  std::printf("panel %d x %d, renderer: %s\n", size.width(), size.height(),
              view->renderer().isEmpty() ? "none" : view->renderer().toUtf8().constData());
  std::printf("memory while it is open: %.0f MB (limit %.0f MB), of these %.0f MB for its %d min; ",
              open_MB - before_MB, kOpen_MB, open_MB - short_MB, minutes);
  std::printf("besides %.0f MB of libraries of a software renderer\n", renderer_MB());
  const bool drawn = !times.pictures_ms.empty();
  tell(drawn ? "pose, work" : "pose and traces, work", times.work_ms);
  tell(drawn ? "pose, wall" : "pose and traces, wall", times.answers_ms);
  tell("picture drawn as well, work", times.pictureWork_ms);
  tell("picture drawn as well, wall", times.pictures_ms);
  const bool quick =
      times.work_ms.back() <= kAnswer_ms && quantile(times.pictureWork_ms, 99) <= kPictureWork_ms;
  return quick && open_MB - before_MB <= kOpen_MB ? 0 : 1;
}
