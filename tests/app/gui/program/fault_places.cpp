// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/program/fault_places.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/services/devices/haptic_station.h"
#include "tests/app/gui/support/bar_view.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/support/fakehd/record_file.h"

namespace torsio::gui::testing {

namespace {

using Time = std::chrono::steady_clock;
using fakehd::RecordFile;

// How long the window is observed after a fault or a refused device.
constexpr double kWatchOn_s = 0.7;
// Duration in ticks of a story without a fault in use.
constexpr std::int64_t kStoryTicks = 1800;

double since_s(Time::time_point begun) {
  return std::chrono::duration<double>(Time::now() - begun).count();
}

/// Runs the window until the story is over; returns its longest unresponsive time, s.
template <typename Frame, typename Refused>
double live(double seconds, const Frame& frame, const Refused& refused) {
  const RecordFile record(RecordFile::fromEnvironment());
  const bool impatient = std::getenv("FAULT_IMPATIENT") != nullptr;
  const auto begun = Time::now();
  double longest_s = 0.0;
  double over_s = 0.0;  // since the end of the story
  for (auto before = begun; since_s(begun) < seconds;) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    frame();
    longest_s = std::max(longest_s, since_s(before));
    before = Time::now();
    const bool fault = record.first(fakehd::Seen::kFault) != nullptr && (record->ticks > 0 || impatient);
    const bool over = record->ticks > kStoryTicks || fault || refused();
    if (over && over_s == 0.0) {
      over_s = since_s(begun);
    }
    if (over && since_s(begun) > over_s + kWatchOn_s) {
      break;
    }
  }
  return longest_s;
}

int print(const QStringList& words, double longest_s, double closed_s) {
  nlohmann::json out{{"longest_ms", 1e3 * longest_s}, {"closed_ms", 1e3 * closed_s}};
  out["words"] = nlohmann::json::array();
  for (const QString& word : words) {
    out["words"].push_back(word.toStdString());
  }
  std::puts(out.dump().c_str());
  return 0;
}

int practise(const DeviceChoice& choice, double seconds) {
  QStringList words;
  auto controller = std::make_unique<SimulationController>(loadBar, TrialRecording{});
  QObject::connect(controller.get(), &SimulationController::noticed, controller.get(),
                   [&words](const QString& sentence) { words << sentence; });
  controller->useHapticDevice([choice](const Scene& scene) { return openHapticDevice(scene, choice); });
  controller->load(requestFor("bar"));
  const double longest_s = live(
      seconds, [&] { controller->advance(0.01); },
      [&] { return !words.isEmpty() && controller->hapticModel().isEmpty(); });
  const auto closing = Time::now();
  controller->shutDown();
  controller.reset();
  return print(words, longest_s, since_s(closing));
}

int train(const DeviceChoice& choice, double seconds) {
  torsio::testing::TrainingCentre centre;
  auto station = std::make_unique<Station>(centre);
  station->desk().realTime = true;
  station->desk().clock = std::make_shared<MonotonicClock>();
  station->openRun(true, [choice](const Scene& scene, double) { return openHapticDevice(scene, choice); });
  const double longest_s = live(
      seconds,
      [&] {
        child<LiveScene>(station->run(), "scene").frame(0.01);
        station->run().tick();
      },
      [&] { return !station->problems.isEmpty(); });
  QStringList words = station->problems + station->notices;
  words << station->allText();
  const auto closing = Time::now();
  station.reset();
  return print(words, longest_s, since_s(closing));
}

}  // namespace

int beAPlace(const std::string& place, const std::string& library, double seconds) {
  const DeviceChoice choice{.driver = "hdapi", .library = library};
  return place == "graded" ? train(choice, seconds) : practise(choice, seconds);
}

}  // namespace torsio::gui::testing
