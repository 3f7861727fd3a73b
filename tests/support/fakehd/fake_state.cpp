// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fakehd/fake_state.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace fakehd {

namespace {

std::atomic<int> loaded{0};
[[maybe_unused]] const int kLoaded = ++loaded;

}  // namespace

std::map<hd::Enum, std::vector<double>> usualNumbers() {
  return {{hd::kNominalMaxForce, {3.3}},
          {hd::kNominalMaxContinuousForce, {0.88}},
          {hd::kNominalMaxStiffness, {0.5}},
          {hd::kUsableWorkspaceDimensions, {-80, -60, -35, 80, 60, 35}},
          {hd::kMaxWorkspaceDimensions, {-210, -110, -85, 210, 205, 130}},
          {hd::kInputDof, {6}},
          {hd::kOutputDof, {3}},
          {hd::kCalibrationStyle, {hd::kCalibrationInkwell}},
          {hd::kUpdateRate, {1000}},
          {hd::kInstantaneousUpdateRate, {1000}}};
}

Fake& fake() {
  // Never destroyed: a blocked scheduler may outlive the program's static objects.
  static Fake* const instance = new Fake;
  return *instance;
}

int loads() {
  return loaded;
}

void push(Fake& f, hd::ErrorCode error, std::int32_t internal) {
  if (f.errorCount < kMostErrors) {
    f.errors[static_cast<std::size_t>(f.errorCount++)] = {error, internal, 0};
  }
}

void breakRule(Fake& f, hd::ErrorCode error) {
  ++f.ruleBreaks;
  push(f, error, 0);
}

bool onServoThread(const Fake& f) {
  return f.servo.load() == std::this_thread::get_id();
}

void writeLog(const Fake& f, const char* line) {
  if (f.logFile.empty()) {
    return;
  }
  if (std::FILE* const file = std::fopen(f.logFile.c_str(), "a")) {
    std::fprintf(file, "%s\n", line);
    std::fclose(file);
  }
}

bool enter(Fake& f, const char* function, bool deviceCall) {
  if (!f.hangIn.empty() && f.hangIn == function && f.tick >= f.hangAtTick) {
    for (;;) {
      std::this_thread::sleep_for(std::chrono::hours(1));
    }
  }
  const bool servo = onServoThread(f);
  if (f.logCount < kMostCalls) {
    f.log[static_cast<std::size_t>(f.logCount++)] = {function, f.tick.load(), servo ? 1 : 0};
  }
  const auto count = f.counts.find(std::string_view(function));
  if (count != f.counts.end()) {
    ++count->second;
  } else {
    f.counts.emplace(function, 1);
  }
  if (deviceCall && f.running && !servo) {
    ++f.offThread;
  }
  bool works = true;
  for (Fault& fault : f.faults) {
    if (fault.function != function || fault.times == 0) {
      continue;
    }
    if (fault.skip > 0) {
      --fault.skip;
      continue;
    }
    if (fault.times > 0) {
      --fault.times;
    }
    push(f, fault.error.error, fault.error.internalError);
    works = false;
  }
  if (f.unplugged && deviceCall) {
    push(f, hd::kCommError, -28);
    works = false;
  }
  return works;
}

namespace {

const char* environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

}  // namespace

void readEnvironment(Fake& f) {
  if (*environment("FAKEHD_NO_DEVICE") != '\0') {
    f.present = false;
  }
  if (*environment("FAKEHD_NO_LICENCE") != '\0') {
    f.licence = false;
  }
  if (*environment("FAKEHD_MODEL") != '\0') {
    f.model = environment("FAKEHD_MODEL");
  }
  const std::string calibration = environment("FAKEHD_CALIBRATION");
  if (calibration == "update") {
    f.calibration = hd::kCalibrationNeedsUpdate;
  }
  if (calibration == "dock") {
    f.calibration = hd::kCalibrationNeedsManualInput;
  }
  if (*environment("FAKEHD_DOCK_AT_TICK") != '\0') {
    f.dockAtTick = std::atoi(environment("FAKEHD_DOCK_AT_TICK"));
  }
  if (*environment("FAKEHD_UNPLUG_AT_TICK") != '\0') {
    f.unplugAtTick = std::atoi(environment("FAKEHD_UNPLUG_AT_TICK"));
  }
  if (*environment("FAKEHD_TICK_US") != '\0') {
    f.period_us = std::atoi(environment("FAKEHD_TICK_US"));
  }
  if (std::string(environment("FAKEHD_POSE")) == "centre") {
    f.pose = {{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  }
  f.hangIn = environment("FAKEHD_HANG");
  f.hangAtTick = std::atoi(environment("FAKEHD_HANG_AT_TICK"));
  f.logFile = environment("FAKEHD_LOG");
}

}  // namespace fakehd
