// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/program/fault_scenarios.h"

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

std::vector<FaultScenario> hangs() {
  std::vector<FaultScenario> all;
  for (const char* const opening : {"hdInitDevice", "hdMakeCurrentDevice", "hdGetString", "hdGetDoublev",
                                    "hdScheduleAsynchronous", "hdStartScheduler"}) {
    all.push_back({std::string("hangs at once in ") + opening,
                   std::string("FAKEHD_HANG=") + opening,
                   Course::kRefused,
                   "does not answer",
                   {},
                   true});
  }
  all.push_back({"is given up while it hangs in hdInitDevice",
                 "FAKEHD_HANG=hdInitDevice FAULT_IMPATIENT=1",
                 Course::kRefused,
                 "",
                 {},
                 true,
                 20.0,
                 true});
  for (const char* const frame : {"hdBeginFrame", "hdGetDoublev", "hdGetIntegerv", "hdGetBooleanv",
                                  "hdGetError", "hdCheckCalibration", "hdSetDoublev", "hdEndFrame"}) {
    const std::string story = std::string("FAKEHD_HANG=") + frame + " FAKEHD_HANG_AT_TICK=@";
    all.push_back({std::string("hangs in ") + frame, story, Course::kLost, "does not answer"});
    all.push_back({std::string("hangs with its lock in ") + frame, story + " FAKEHD_HANG_LOCKED=1",
                   Course::kEnded, "does not answer"});
  }
  for (const char* const closing : {"hdStopScheduler", "hdUnschedule", "hdDisableDevice"}) {
    all.push_back({std::string("hangs in ") + closing, std::string("FAKEHD_HANG=") + closing, Course::kStuck,
                   "does not release"});
  }
  return all;
}

std::vector<FaultScenario> refusals() {
  return {
      {"no device", "FAKEHD_NO_DEVICE=1", Course::kRefused, "could be opened"},
      {"no licence", "FAKEHD_NO_LICENCE=1", Course::kRefused, "licence"},
      {"refuses the task", "FAKEHD_FAULT=hdScheduleAsynchronous:0:1:501", Course::kRefused, "did not take"},
      {"refuses to start", "FAKEHD_FAULT=hdStartScheduler:0:1:304", Course::kRefused, "did not start"},
      {"refuses every frame", "FAKEHD_FAULT=hdBeginFrame:@:-1:402", Course::kLost, "could not be opened"},
      {"refuses one frame", "FAKEHD_FAULT=hdBeginFrame:@:1:402", Course::kForceOff, "refused 1"},
      {"refuses the end of every frame", "FAKEHD_FAULT=hdEndFrame:@:-1:402", Course::kLost,
       "could not be opened or closed"},
      {"refuses the end of one frame", "FAKEHD_FAULT=hdEndFrame:@:1:402", Course::kForceOff, "refused 1"},
      {"refuses every force", "FAKEHD_FAULT=hdSetDoublev:@:-1:101", Course::kForceOff, "refused"},
      {"refuses the output", "FAKEHD_FAULT=hdEnable:1:-1:102", Course::kNeverOn, "did not switch on"},
      {"fatal at the end of a frame", "FAKEHD_FAULT=hdEndFrame:@:-1:302", Course::kLost, "broke off"},
      {"fatal in the middle of a frame", "FAKEHD_FAULT=hdGetDoublev:@:-1:300", Course::kLost,
       "does not answer"},
      {"its own protection trips", "FAKEHD_FAULT=hdEndFrame:@:1:201", Course::kForceOff, "protection"},
      {"its motors are warm", "FAKEHD_FAULT=hdEndFrame:@:1:200", Course::kForceOff, ""},
  };
}

std::vector<FaultScenario> deaths() {
  return {
      {"its servo never calls", "FAKEHD_DIE_AT_TICK=0", Course::kNeverOn, "never called"},
      {"its servo dies", "FAKEHD_DIE_AT_TICK=@", Course::kLost, ""},
      {"unplugged", "FAKEHD_UNPLUG_AT_TICK=@", Course::kLost, "broke off"},
      {"falls in a frame", "FAKEHD_CRASH=hdEndFrame FAKEHD_CRASH_SIGNAL=11 FAKEHD_HANG_AT_TICK=@",
       Course::kEnded, "does not answer"},
      {"SIGBUS in a frame", "FAKEHD_CRASH=hdGetDoublev FAKEHD_CRASH_SIGNAL=7 FAKEHD_HANG_AT_TICK=@",
       Course::kEnded, "does not answer"},
      {"aborts in a frame", "FAKEHD_CRASH=hdSetDoublev FAKEHD_CRASH_SIGNAL=6 FAKEHD_HANG_AT_TICK=@",
       Course::kEnded, "does not answer"},
      {"ends the process in a frame", "FAKEHD_CRASH=hdBeginFrame FAKEHD_HANG_AT_TICK=@", Course::kEnded,
       "does not answer"},
      {"leaves in a frame", "FAKEHD_CRASH=hdEndFrame FAKEHD_CRASH_BY=_exit FAKEHD_HANG_AT_TICK=@",
       Course::kEnded, "does not answer"},
      {"throws in a frame", "FAKEHD_CRASH=hdEndFrame FAKEHD_CRASH_BY=throw FAKEHD_HANG_AT_TICK=@",
       Course::kEnded, "does not answer"},
      {"fills the stack", "FAKEHD_CRASH=hdEndFrame FAKEHD_CRASH_BY=overflow FAKEHD_HANG_AT_TICK=@",
       Course::kEnded, "does not answer"},
      {"stops in a thread of its own", "FAKEHD_CRASH=thread FAKEHD_CRASH_BY=SIGSTOP FAKEHD_HANG_AT_TICK=@",
       Course::kEnded, "does not answer"},
      {"falls when it is opened", "FAKEHD_CRASH=hdInitDevice FAKEHD_CRASH_SIGNAL=11", Course::kRefused,
       "ended before"},
      {"ends the process when it is opened", "FAKEHD_CRASH=hdInitDevice", Course::kRefused, "ended before"},
      {"falls when it is started", "FAKEHD_CRASH=hdStartScheduler FAKEHD_CRASH_SIGNAL=7", Course::kRefused,
       "ended before"},
      {"falls when it is let go of", "FAKEHD_CRASH=hdStopScheduler FAKEHD_CRASH_SIGNAL=11", Course::kStuck,
       "does not release"},
  };
}

std::vector<FaultScenario> lies() {
  std::vector<FaultScenario> all;
  for (const char* const lie : {"nan", "zero", "mirrored", "huge"}) {
    const std::string what = std::string("FAKEHD_LIE=") + lie;
    all.push_back({what.substr(7) + " from the start", what, Course::kNeverOn, "valid position"});
    all.push_back(
        {what.substr(7) + " in use", what + " FAKEHD_LIE_AT_TICK=@", Course::kForceOff, "valid position"});
  }
  // Detected once the gimbal has turned by 0.1 rad: here after 100 ms.
  all.push_back({"LIE=frozen in use",
                 "FAKEHD_LIE=frozen FAKEHD_LIE_AT_TICK=@",
                 Course::kForceOff,
                 "stands still",
                 {},
                 false,
                 120.0});
  all.push_back({"claims 40 N", "FAKEHD_MAX_FORCE=40", Course::kWorks, "3.30 N"});
  all.push_back({"says what is no UTF-8", "FAKEHD_MODEL=Tou\xff\xfe", Course::kWorks, "Tou"});
  all.push_back({"calls after it was taken out", "FAKEHD_LATE_CALLBACKS=1", Course::kWorks, ""});
  all.push_back({"ticks at 400 Hz", "FAKEHD_TICK_US=2500", Course::kNeverOn, "no force is rendered"});
  all.push_back({"does what it should", "", Course::kWorks, "without an error"});
  return all;
}

std::vector<FaultScenario> libraries() {
  return {
      {"is not there", "", Course::kRefused, "not installed", "absent"},
      {"is cut off", "", Course::kRefused, "", "truncated"},
      {"is of another machine", "", Course::kRefused, "", "other machine"},
      {"is no library", "", Course::kRefused, "", "no library"},
  };
}

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

const std::vector<FaultScenario>& faultScenarios() {
  static const std::vector<FaultScenario> kAll = [] {
    std::vector<FaultScenario> all = hangs();
    for (const auto& more : {refusals(), deaths(), lies(), libraries()}) {
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }();
  return kAll;
}

int beAPlace(const std::string& place, const std::string& library, double seconds) {
  const DeviceChoice choice{.driver = "hdapi", .library = library};
  return place == "graded" ? train(choice, seconds) : practise(choice, seconds);
}

}  // namespace torsio::gui::testing
