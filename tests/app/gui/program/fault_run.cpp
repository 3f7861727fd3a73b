// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/program/fault_run.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "sim/core/file_io.h"
#include "sim/device/hdapi/hdapi_border.h"
#include "sim/servo/hand_task.h"
#include "tests/app/gui/program/fault_scenarios.h"
#include "tests/sim/servo/bar_scene.h"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace torsio::gui::testing {

namespace {

using fakehd::Seen;

constexpr double kPlaceTakes_s = 40.0;
constexpr auto kProgramTakes = std::chrono::seconds(60);
// A poll and its sleep on an idle machine.
constexpr std::int64_t kLook_ns = 1'200'000;
constexpr double kComesFrom_m = 0.012;
constexpr double kDeep_m = 0.0015;

/// Returns the FAKEHD_PRESS with which the fake's tip presses into the bar.
std::string pressOnTheBar() {
  const Scene scene = barScene();
  const HandTask task = handTask(scene);
  DevicePlacement placement;
  placement.worldOrigin_m = task.graspPoint_m;
  placement.stylusTip_m = kStylusTip_m;
  HdapiFrame middle;
  middle.transform_mm = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const Vec3 tip_m = worldPose(middle, placement).value().position_m;
  const Vec3 outwards = normalized(task.start_m - task.graspPoint_m);
  std::ostringstream numbers;
  for (const double way_m : {kComesFrom_m, scene.instrument.tipRadius_m - kDeep_m}) {
    const Vec3 wanted_m = task.graspPoint_m + outwards * way_m;
    const Vec3 device_m = rotate(conjugate(placement.deviceToWorld), wanted_m - tip_m);
    for (const double x_m : {device_m.x, device_m.y, device_m.z}) {
      numbers << 1e3 * x_m << ' ';
    }
  }
  return numbers.str();
}

/// Returns a scenario's library; creates a damaged one in `folder`.
std::string libraryOf(const FaultScenario& scenario, const std::string& folder) {
  const std::string damaged = folder + "/libHD.so";
  std::string bytes = readFile(TORSIO_FAKEHD);
  if (scenario.library.empty()) {
    return TORSIO_FAKEHD;
  }
  if (scenario.library == "absent") {
    return "/nowhere/libHD.so";
  }
  if (scenario.library == "truncated") {
    bytes.resize(bytes.size() / 2);
  } else if (scenario.library == "other machine") {
    bytes.at(18) = static_cast<char>(0xb7);  // e_machine: AArch64
  } else {
    bytes = "INPUT ( libHD.so.3.4 )\n";
  }
  std::ofstream(damaged, std::ios::binary) << bytes;
  return damaged;
}

/// Returns this environment without other stories, and with the scenario's.
std::vector<std::string> environmentOf(const std::string& place, const FaultScenario& scenario,
                                       const std::string& folder) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (text.rfind("FAKEHD_", 0) != 0 && text.rfind("DISPLAY=", 0) != 0) {
      all.push_back(text);
    }
  }
  const bool pushes = place != "monitor";
  std::istringstream story(scenario.story);
  for (std::string word; story >> word;) {
    if (const std::size_t at = word.find('@'); at != std::string::npos) {
      word.replace(at, 1, pushes ? "300" : "600");
      if (pushes) {
        all.emplace_back("FAKEHD_AFTER_PUSH=1");
      }
    }
    all.push_back(word);
  }
  static const std::string kPress = pressOnTheBar();
  all.push_back("FAKEHD_PRESS=" + kPress);
  all.push_back("FAKEHD_RECORD=" + folder + "/record");
  all.push_back("XDG_CONFIG_HOME=" + folder);
  all.emplace_back("QT_QPA_PLATFORM=offscreen");
  all.emplace_back("TORSIO_DEVICE_PROGRAM=" TORSIO_DEVICE_PROGRAM);
  return all;
}

std::vector<std::string> commandOf(const std::string& place, const std::string& library) {
  if (place == "check") {
    return {TORSIO_PROGRAM, "device", "check",        "--json",    "--seconds", "0.4", "--wait", "3",
            "--device",     "hdapi",  "--force-test", "--library", library};
  }
  if (place == "monitor") {
    return {TORSIO_PROGRAM, "device", "monitor",  "--json", "--seconds", "2",
            "--interval",   "0.05",   "--device", "hdapi",  "--library", library};
  }
  return {std::filesystem::read_symlink("/proc/self/exe").string(), kBeAPlace, place, library,
          std::to_string(kPlaceTakes_s)};
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) {
    all.push_back(text.data());
  }
  all.push_back(nullptr);
  return all;
}

}  // namespace

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1'000'000'000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec;
}

FaultRun::FaultRun(const std::string& place, const FaultScenario& scenario, const std::string& folder)
    : output_(folder + "/output") {
  std::filesystem::create_directories(folder);
  record_ = std::make_unique<fakehd::RecordFile>(folder + "/record");
  std::vector<std::string> command = commandOf(place, libraryOf(scenario, folder));
  std::vector<std::string> environment = environmentOf(place, scenario, folder);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&files, 1, 2);
  if (posix_spawn(&program_, command.front().c_str(), &files, nullptr, pointers(command).data(),
                  pointers(environment).data()) != 0) {
    program_ = -1;
  }
  posix_spawn_file_actions_destroy(&files);
}

FaultRun::~FaultRun() {
  if (program_ > 0) {
    kill(program_, SIGKILL);
    waitpid(program_, nullptr, 0);
  }
}

void FaultRun::lookAtDevice() {
  const std::int64_t device = (*record_)->process;
  if (gone_ || device <= 0) {
    return;
  }
  const std::int64_t looked_ns = now_ns();  // before polling, so that a late poll does not prolong it
  if (looked_ns_ > 0 && record_->first(Seen::kFault) != nullptr) {
    heldUp_ns_ += std::max<std::int64_t>(0, looked_ns - looked_ns_ - kLook_ns);
  }
  looked_ns_ = looked_ns;
  gone_ = kill(static_cast<pid_t>(device), 0) != 0;
  seen_ns_ = gone_ ? seen_ns_ : looked_ns;
}

bool FaultRun::watch() {
  const auto until = std::chrono::steady_clock::now() + kProgramTakes;
  bool ended = program_ < 0;
  while (!ended && std::chrono::steady_clock::now() < until) {
    lookAtDevice();
    int status = 0;
    if (waitpid(program_, &status, WNOHANG) == program_) {
      code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
      program_ = -1;
      ended = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  // Child processes of a program have two seconds to end.
  for (int i = 0; i < 2500 && !gone_ && (*record_)->process > 0; ++i) {
    lookAtDevice();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  said_ = readFile(output_);
  return ended;
}

bool FaultRun::pushedAt(std::int64_t time_ns) const {
  bool pushes = false;
  for (std::int64_t i = 0; i < record_->size(); ++i) {
    const fakehd::SeenEvent& event = (*record_)->events[static_cast<std::size_t>(i)];
    if (event.time_ns <= time_ns && (event.what == Seen::kPush || event.what == Seen::kRest)) {
      pushes = event.what == Seen::kPush;
    }
  }
  return pushes;
}

double FaultRun::restAfter_ms(std::int64_t from_ns, std::int64_t waited_ns) const {
  if (!pushedAt(from_ns)) {
    return 0.0;
  }
  const fakehd::SeenEvent* const rest = record_->first(Seen::kRest, from_ns);
  if (rest == nullptr) {
    return -1.0;
  }
  return 1e-6 * static_cast<double>((rest->time_ns - from_ns) - (rest->waited_ns - waited_ns));
}

}  // namespace torsio::gui::testing
