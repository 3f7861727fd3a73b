// SPDX-License-Identifier: GPL-3.0-or-later
// Reviewing a recording of 40 minutes: how much memory it takes while it is open, and how long the window
// takes to answer when somebody scrubs: the moment decoded, the organ and the instrument in their pose, the
// traces with their cursor. A scripted hand twists the arm; the first argument is the number of minutes.
// With a display (xvfb-run) the picture is drawn too and timed apart. Fails when a scrub takes more work than
// what a hand feels, or the memory is more than a small machine has to spare. Judged by processor time, so
// that a machine that is busy with something else does not decide; the time on the wall is told beside it.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <vector>

#include <QApplication>

#include "app/gui/review/replay_panel.h"
#include "app/session/pipeline.h"
#include "sim/base/random.h"
#include "sim/record/memory_trial_sink.h"

namespace {

using namespace torsio;
using SteadyClock = std::chrono::steady_clock;

constexpr int kMinutes = 40;
constexpr double kAnswer_ms = 50.0;
constexpr double kOpen_MB = 150.0;
constexpr double kPatience_ms = 2000.0;
constexpr int kScrubs = 400;

double since_ms(SteadyClock::time_point start) {
  return std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
}

double worked_ms(std::clock_t since) {
  return 1e3 * static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC;
}

/// What the program holds in memory; 0 where the system does not tell.
double resident_MB() {
  constexpr double kPage_MB = 4096.0 / 1e6;
  std::ifstream file("/proc/self/statm");
  double whole = 0.0;
  double resident = 0.0;
  file >> whole >> resident;
  return resident * kPage_MB;
}

Trial recorded(const std::filesystem::path& assets, int minutes) {
  SceneRequest request;
  request.assets = assets;
  request.id = "arm";
  ScriptedTrial script;
  script.trialId = "bench";
  script.phaseLabel = "bench";
  script.duration_s = 60.0 * minutes;
  MemoryTrialSink sink;
  recordScriptedTrial(loadScene(request), script, sink);
  return sink.trial();
}

void tell(const char* what, std::vector<double> times_ms) {
  std::sort(times_ms.begin(), times_ms.end());
  const std::size_t last = times_ms.size() - 1;
  std::printf("%-28s median %.2f ms, 99 %% %.2f ms, worst %.2f ms\n", what, times_ms[last / 2],
              times_ms[last * 99 / 100], times_ms[last]);
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const int minutes = argc > 1 ? std::max(1, std::atoi(argv[1])) : kMinutes;
  gui::SceneView::prepareGraphics();
  const QApplication application(argc, argv);
  const std::filesystem::path assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  auto start = SteadyClock::now();
  BlindedRecording recording{"7F", recorded(assets, minutes), "00000000"};
  double packed_MB = 0.0;
  for (const TrialChunk& chunk : recording.trial.chunks)
    packed_MB += static_cast<double>(chunk.bytes.size()) / 1e6;
  std::printf("recorded %d min in %.1f s, packed %.1f MB\n", minutes, since_ms(start) * 1e-3, packed_MB);

  const double before_MB = resident_MB() - packed_MB;
  start = SteadyClock::now();
  const auto loaded = gui::loadForShowing(std::move(recording), assets);
  std::printf("opened in a worker thread in %.0f ms\n", since_ms(start));
  gui::ReplayPanel panel(assets);
  panel.retranslate();
  panel.resize(680, 600);
  panel.setVisible(true);
  panel.show(loaded);
  QApplication::processEvents();
  auto* view = panel.findChild<gui::SceneView*>();

  Random random(1);
  std::vector<double> work_ms;
  std::vector<double> answers_ms;
  std::vector<double> pictures_ms;
  for (int i = 0; i < kScrubs; ++i) {
    const auto to_us =
        static_cast<std::int64_t>(random.uniform() * static_cast<double>(loaded->playback.duration_us()));
    const std::int64_t frames = view->framesDrawn();
    const std::clock_t begun = std::clock();
    start = SteadyClock::now();
    panel.seek_us(to_us);
    panel.findChild<gui::TraceView*>()->repaint();
    answers_ms.push_back(since_ms(start));
    work_ms.push_back(worked_ms(begun));
    if (!gui::SceneView::platformCanRender()) continue;
    while (view->framesDrawn() == frames && since_ms(start) < kPatience_ms) QApplication::processEvents();
    pictures_ms.push_back(since_ms(start));
  }
  const double open_MB = resident_MB() - before_MB;
  std::printf("memory while it is open: %.0f MB (limit %.0f MB)\n", open_MB, kOpen_MB);
  tell("pose and traces, work", work_ms);
  tell("pose and traces, wall", answers_ms);
  if (!pictures_ms.empty()) tell("picture drawn as well, wall", pictures_ms);
  const double worst_ms = *std::max_element(work_ms.begin(), work_ms.end());
  return worst_ms <= kAnswer_ms && open_MB <= kOpen_MB ? 0 : 1;
}
