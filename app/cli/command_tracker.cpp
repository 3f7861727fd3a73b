// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/connectors/tracker/instrument_outlet.h"
#include "app/connectors/tracker/tracker_choice.h"
#include "app/connectors/tracker/tracker_link.h"
#include "app/services/devices/device_choice.h"
#include "app/services/recording/trial_playback.h"
#include "assessment/results/number_format.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/live_types.h"
#include "sim/record/sample_codec.h"

namespace torsio::cli {

namespace {

constexpr double kLongestWatch_s = 86'400.0;
constexpr double kLookEvery_s = 0.1;
constexpr std::int64_t kSendEvery_us = 16'000;
constexpr double kMillimetres = 1e3;

struct TrackerArguments {
  TrackerPlace place;
  double seconds = 5.0;
  std::int64_t poses = 0;  // stop after so many; 0: never
  bool json = false;
  bool none = false;
  std::uint16_t outletPort = kIgtlPort;
  std::string outletAddress = "127.0.0.1";
  std::string run;
  DatabaseOption database;
};

constexpr std::array kStages{"no connection", "connected, no pose yet", "tracking", "silent"};

nlohmann::ordered_json placeJson(const Vec3& place_m) {
  return {place_m.x * kMillimetres, place_m.y * kMillimetres, place_m.z * kMillimetres};
}

nlohmann::ordered_json trackerJson(const TrackerView& view) {
  nlohmann::ordered_json out{{"stage", wordOf(view.stage, kStages)},
                             {"trouble", view.trouble.str()},
                             {"instrument", view.instrument},
                             {"instruments", view.instruments},
                             {"received", view.counts.received},
                             {"missing", nullptr},
                             {"late", view.counts.late},
                             {"refused", view.counts.refused},
                             {"times", view.stamped ? "of the tracker" : "of the arrival"},
                             {"period_us", nullptr},
                             {"position_mm", nullptr},
                             {"orientation_wxyz", nullptr}};
  if (view.stamped) {
    out["missing"] = view.counts.missing;
  }
  if (view.period_us) {
    out["period_us"] = *view.period_us;
  }
  if (view.counts.received > 0) {
    const Quat& q = view.pose.orientation;
    out["position_mm"] = placeJson(view.pose.position_m);
    out["orientation_wxyz"] = {q.w, q.x, q.y, q.z};
  }
  return out;
}

void printTracker(const TrackerView& view) {
  std::cout << wordOf(view.stage, kStages);
  if (!view.trouble.empty()) {
    std::cout << ": " << view.trouble.str();
  }
  std::cout << "\n";
  if (view.counts.received == 0) {
    return;
  }
  const Vec3 mm = view.pose.position_m * kMillimetres;
  std::cout << "Instrument: " << view.instrument << " at " << formatFixed(mm.x, 1) << " "
            << formatFixed(mm.y, 1) << " " << formatFixed(mm.z, 1) << " mm\nPoses: " << view.counts.received
            << ", missing " << (view.stamped ? std::to_string(view.counts.missing) : "not known") << ", late "
            << view.counts.late << ", refused " << view.counts.refused << "\n";
}

void watch(const TrackerArguments& given) {
  requireTime(given.seconds, kLongestWatch_s, Text::verbatim("the time to watch"));
  const TrackerLink link(given.place);
  const MonotonicClock clock;
  const std::int64_t end_us = clock.now_us() + static_cast<std::int64_t>(given.seconds * 1e6);
  while (clock.now_us() < end_us && (given.poses == 0 || link.view().counts.received < given.poses)) {
    pause_s(kLookEvery_s);
  }
  const TrackerView view = link.view();
  if (given.json) {
    printJson(trackerJson(view));
  } else {
    printTracker(view);
  }
  if (view.counts.received == 0) {
    throw Error(ErrorCode::kDevice,
                view.trouble.empty() ? Text::verbatim("no pose of an instrument arrived") : view.trouble,
                given.place.address + ":" + std::to_string(given.place.port),
                Text::verbatim("Check that the tracker runs, and check address, port and instrument"));
  }
}

void remember(const TrackerArguments& given, bool outlet) {
  TrackerChoice choice = rememberedTracker();
  if (outlet) {
    choice.outletPort = given.none ? std::uint16_t{0} : given.outletPort;
    choice.outletAddress = given.outletAddress;
  } else {
    choice.tracker = given.none ? std::nullopt : std::optional(given.place);
  }
  rememberTracker(choice);
  const TrackerChoice kept = rememberedTracker();
  std::cout << "Tracker of the real arm: "
            << (kept.tracker ? kept.tracker->address + ":" + std::to_string(kept.tracker->port)
                             : std::string("none"))
            << "\nThe simulator's instrument is offered: "
            << (kept.outletPort != 0 ? "at " + kept.outletAddress + ":" + std::to_string(kept.outletPort)
                                     : std::string("nowhere"))
            << "\n";
}

/// Sends at the recorded speed.
void send(const TrackerArguments& given) {
  requireTime(given.seconds, kLongestWatch_s, Text::verbatim("the time to wait"));
  const std::vector<Sample> samples = decodeTrial(loadStoredTrial(given.database.locator(), given.run));
  InstrumentOutlet outlet(given.outletAddress, given.outletPort);
  const MonotonicClock clock;
  const std::int64_t patience_us = clock.now_us() + static_cast<std::int64_t>(given.seconds * 1e6);
  while (outlet.view().watchers == 0) {
    if (clock.now_us() > patience_us) {
      const OutletView view = outlet.view();
      throw Error(ErrorCode::kDevice,
                  view.trouble.empty() ? Text::verbatim("nobody has connected") : view.trouble,
                  given.outletAddress + ":" + std::to_string(given.outletPort),
                  Text::verbatim("Connect the other program within --wait seconds"));
    }
    pause_s(kLookEvery_s);
  }
  const std::int64_t began_us = clock.now_us();
  const std::int64_t first_us = samples.empty() ? 0 : samples.front().device.time_us;
  std::int64_t due_us = 0;
  ExercisePhase phase = ExercisePhase::kTracking;
  for (const Sample& sample : samples) {
    const std::int64_t at_us = sample.device.time_us - first_us;
    if (at_us < due_us && sample.phase == phase) {
      continue;
    }
    phase = sample.phase;
    due_us = at_us + kSendEvery_us;
    std::this_thread::sleep_for(std::chrono::microseconds(began_us + at_us - clock.now_us()));
    outlet.show(liveStateOf(sample));
  }
  pause_s(kLookEvery_s);
  const OutletView view = outlet.view();
  if (given.json) {
    printJson(nlohmann::ordered_json{{"sent", view.sent}, {"left_out", view.left}});
  } else {
    std::cout << "Sent " << view.sent << " poses, left out " << view.left << "\n";
  }
}

void addPlace(CLI::App& command, TrackerArguments& given) {
  addDefaulted(command, "--address", given.place.address,
               "Address of the tracker; with --listen, of this computer");
  addDefaulted(command, "--port", given.place.port, "Its port", CLI::Range(1, 65535));
  command.add_option("--instrument", given.place.instrument,
                     "Name of the instrument in the tracker; default: the first one");
  command.add_flag("--listen", given.place.listens, "Wait for the tracker to call");
}

void addOutlet(CLI::App& command, TrackerArguments& given) {
  addDefaulted(command, "--port", given.outletPort, "Port for other programs", CLI::Range(1, 65535));
  addDefaulted(command, "--address", given.outletAddress,
               "Address of this computer; 0.0.0.0 offers it to the whole network");
}

}  // namespace

void addTracker(CLI::App& program) {
  auto given = std::make_shared<TrackerArguments>();
  CLI::App* tracker = program.add_subcommand("tracker", "OpenIGTLink: a tracker on the real arm, and Slicer");
  tracker->require_subcommand(1);

  CLI::App* command = tracker->add_subcommand(
      "watch", "Shows what a tracker sends; exit code 12 if no pose of the instrument arrives");
  addPlace(*command, *given);
  addDefaulted(*command, "--seconds", given->seconds, "How long");
  command->add_option("--poses", given->poses, "Stop after this many poses")->check(CLI::PositiveNumber);
  command->add_flag("--json", given->json, "Print JSON");
  command->callback([given] { watch(*given); });

  command = tracker->add_subcommand("choose", "Remembers the tracker of this station's real arm");
  addPlace(*command, *given);
  command->add_flag("--none", given->none, "Forget the tracker");
  command->callback([given] { remember(*given, false); });

  command =
      tracker->add_subcommand("offer", "Offers the simulator's instrument to other programs from now on");
  addOutlet(*command, *given);
  command->add_flag("--none", given->none, "Stop offering it");
  command->callback([given] { remember(*given, true); });

  command = tracker->add_subcommand("send", "Sends the instrument of a recorded run once, as a test");
  command->add_option("RUN", given->run, "Id of the run, or its first characters")->required();
  addDatabaseOption(*command, given->database);
  addOutlet(*command, *given);
  addDefaulted(*command, "--wait", given->seconds, "Seconds to wait for the other program");
  command->add_flag("--json", given->json, "Print JSON");
  command->callback([given] { send(*given); });
}

}  // namespace torsio::cli
