// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fakehd/fake_state.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <sstream>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

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
  if (f.errorCount < kMaxErrors) {
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

std::int64_t storyTick(const Fake& f) {
  return !f.afterPush ? f.tick.load() : (f.pushTick < 0 ? -1 : f.tick - f.pushTick);
}

void see(Fake& f, Seen what) {
  FakeRecord* const record = f.record;
  if (record == nullptr) {
    return;
  }
  const std::int64_t number = record->count.fetch_add(1);
  if (number >= static_cast<std::int64_t>(FakeRecord::kMost)) {
    return;
  }
  SeenEvent& event = record->events[static_cast<std::size_t>(number)];
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  event.what = what;
  event.waited_ns = waited_ns(record->process, record->process) + waited_ns(record->process, record->servo);
  event.time_ns = 1'000'000'000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec;  // last: now complete
}

void seeFault(Fake& f) {
  if (!f.faultSeen) {
    f.faultSeen = true;
    see(f, Seen::kFault);
  }
}

void seeMotors(Fake& f) {
  if (f.record == nullptr) {
    return;
  }
  const auto [x, y, z] = rendered(f);
  const double size_N = std::sqrt(x * x + y * y + z * z);
  const auto size_uN = std::isfinite(size_N) ? static_cast<std::int64_t>(1e6 * std::min(size_N, 1e6))
                                             : std::int64_t{1'000'000'000'000};
  f.record->motors_uN = size_uN;
  f.record->most_uN = std::max(f.record->most_uN.load(), size_uN);
  if (f.pushed != (size_uN > 0)) {
    f.pushed = size_uN > 0;
    f.pushTick = f.pushed && f.pushTick < 0 ? f.tick.load() : f.pushTick;
    see(f, f.pushed ? Seen::kPush : Seen::kRest);
  }
}

namespace {

int signalOf(const std::string& name) {
  constexpr std::array<std::pair<const char*, int>, 9> kSignals{{{"SIGALRM", SIGALRM},
                                                                 {"SIGSTOP", SIGSTOP},
                                                                 {"SIGQUIT", SIGQUIT},
                                                                 {"SIGUSR1", SIGUSR1},
                                                                 {"SIGKILL", SIGKILL},
                                                                 {"SIGBUS", SIGBUS},
                                                                 {"SIGILL", SIGILL},
                                                                 {"SIGTSTP", SIGTSTP},
                                                                 {"SIGIO", SIGIO}}};
  const auto* const found = std::find_if(kSignals.begin(), kSignals.end(),
                                         [&name](const auto& known) { return name == known.first; });
  return found != kSignals.end() ? found->second : SIGKILL;
}

// NOLINTNEXTLINE(misc-no-recursion): until the stack is full
int fillStack(volatile const char* above) {
  volatile char room[4096];
  room[0] = above != nullptr ? above[0] : 'x';
  return room[0] != 'x' ? 0 : fillStack(room) + room[0];
}

/// Ends the process.
void crash(const std::string& by) {
  if (by == "exit") {
    std::exit(0);
  } else if (by == "quick_exit") {
    std::quick_exit(0);
  } else if (by == "_exit") {
    _exit(0);
  } else if (by == "abort") {
    std::abort();
  } else if (by == "throw") {
    throw std::runtime_error("nobody catches this");
  } else if (by == "segv") {
    volatile int* volatile nowhere = nullptr;
    *nowhere = 1;
  } else if (by == "overflow") {
    (void)fillStack(nullptr);
  } else if (by == "fpe") {
    std::raise(SIGFPE);
  } else {
    kill(getpid(), signalOf(by));
  }
}

/// Hangs or ends the process, if the story says so.
void misbehave(Fake& f, const char* function) {
  if (storyTick(f) < f.hangAtTick) {
    return;
  }
  if (f.crashIn == function) {
    seeFault(f);
    if (!f.crashBy.empty()) {
      if (!f.hangLocked) {
        f.spin.unlock();  // held by the caller
      }
      crash(f.crashBy);
      if (!f.hangLocked) {
        f.spin.lock();
      }
      f.crashIn.clear();
      return;
    }
    if (f.crashSignal == 0) {
      std::exit(0);
    }
    std::signal(f.crashSignal, SIG_DFL);
    std::raise(f.crashSignal);
  }
  if (f.hangIn == function) {
    seeFault(f);
    if (!f.hangLocked) {
      f.spin.unlock();  // held by the caller
    }
    for (;;) {
      std::this_thread::sleep_for(std::chrono::hours(1));
    }
  }
}

}  // namespace

void misbehaveElsewhere(Fake& f) {
  if (f.crashIn == "thread" && !f.crashed && storyTick(f) >= f.hangAtTick) {
    f.crashed = true;
    seeFault(f);
    std::thread([&f] { crash(f.crashBy); }).detach();
  }
}

bool enter(Fake& f, const char* function, bool deviceCall) {
  misbehave(f, function);
  const bool servo = onServoThread(f);
  if (f.logCount < kMaxCalls) {
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
    if (fault.function != function || fault.times == 0 || storyTick(f) < fault.fromTick) {
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
    seeFault(f);
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

namespace {

int numberIn(const char* name, int otherwise) {
  return *environment(name) != '\0' ? std::atoi(environment(name)) : otherwise;
}

/// FUNCTION:TICK:TIMES:ERROR, the error in hexadecimal digits.
void readFault(Fake& f) {
  std::istringstream words(environment("FAKEHD_FAULT"));
  Fault fault;
  char colon = 0;
  if (std::getline(words, fault.function, ':') &&
      words >> fault.fromTick >> colon >> fault.times >> colon >> std::hex >> fault.error.error) {
    f.faults.push_back(fault);
  }
}

void readPress(Fake& f) {
  std::istringstream numbers(environment("FAKEHD_PRESS"));
  f.presses = true;
  for (double& number : f.press_mm) {
    f.presses = f.presses && static_cast<bool>(numbers >> number);
  }
}

void openRecord(Fake& f) {
  const int file = ::open(environment("FAKEHD_RECORD"), O_RDWR);
  if (file < 0) {
    return;
  }
  void* const place = mmap(nullptr, sizeof(FakeRecord), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (place != MAP_FAILED) {
    f.record = static_cast<FakeRecord*>(place);
    f.onlyOnce = f.record->process != 0 && *environment("FAKEHD_ONCE") != '\0';
    // The motors of the device go on with what the process before sent.
    f.pushed = f.record->motors_uN > 0;
    if (!f.pushed) {  // a second hand is not the process that tests look at
      f.record->process = getpid();
      f.record->servo = getpid();
    }
    f.commanded[0] = 1e-6 * static_cast<double>(f.record->motors_uN);
  }
}

void leaveProcess(Fake& f) {
  if (*environment("FAKEHD_FORKS") == '\0' || f.record == nullptr) {
    return;
  }
  const pid_t orphan = fork();
  if (orphan == 0) {
    (void)setsid();
    for (;;) {
      sleep(3600);
    }
  }
  f.record->orphan = orphan;
}

void printMuch() {
  const std::string line(1023, 'x');
  for (int left = numberIn("FAKEHD_PRINTS", 0); left > 0; left -= 2048) {
    std::fprintf(stdout, "%s\n", line.c_str());
    std::fprintf(stderr, "%s\n", line.c_str());
  }
}

}  // namespace

void readEnvironment(Fake& f) {
  openRecord(f);
  leaveProcess(f);
  printMuch();
  readFault(f);
  readPress(f);
  f.afterPush = *environment("FAKEHD_AFTER_PUSH") != '\0';
  f.hangLocked = *environment("FAKEHD_HANG_LOCKED") != '\0';
  f.crashIn = environment("FAKEHD_CRASH");
  f.crashBy = environment("FAKEHD_CRASH_BY");
  f.crashSignal = numberIn("FAKEHD_CRASH_SIGNAL", 0);
  f.dieAtTick = numberIn("FAKEHD_DIE_AT_TICK", -1);
  f.buttons = numberIn("FAKEHD_BUTTONS", f.buttons);
  f.pressTicks = numberIn("FAKEHD_PRESS_TICKS", 0);
  f.lie = environment("FAKEHD_LIE");
  f.lieAtTick = numberIn("FAKEHD_LIE_AT_TICK", 0);
  f.lateCallbacks = *environment("FAKEHD_LATE_CALLBACKS") != '\0';
  if (*environment("FAKEHD_MAX_FORCE") != '\0') {
    f.numbers[hd::kNominalMaxForce] = {std::atof(environment("FAKEHD_MAX_FORCE"))};
    f.numbers[hd::kNominalMaxContinuousForce] = {std::atof(environment("FAKEHD_MAX_FORCE"))};
  }
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
  f.dockAtTick = numberIn("FAKEHD_DOCK_AT_TICK", f.dockAtTick);
  f.unplugAtTick = numberIn("FAKEHD_UNPLUG_AT_TICK", f.unplugAtTick);
  f.period_us = numberIn("FAKEHD_TICK_US", static_cast<int>(f.period_us));
  if (std::string(environment("FAKEHD_POSE")) == "centre") {
    f.pose = {{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  }
  f.hangIn = environment("FAKEHD_HANG");
  f.hangAtTick = numberIn("FAKEHD_HANG_AT_TICK", 0);
  f.logFile = environment("FAKEHD_LOG");
}

}  // namespace fakehd
