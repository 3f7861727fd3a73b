// SPDX-License-Identifier: GPL-3.0-or-later
// The whole library in one file, like the one it stands for. State that callbacks reach is behind a spin
// lock, so that the servo path of the fake itself never takes a system lock.
#include "tests/support/fakehd/fakehd.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "sim/device/hdapi_abi.h"

#ifdef FAKEHD_WRONG_DEPENDENCY
extern "C" int fakehd_absent();
#endif

namespace {

namespace hd = torsio::hd;

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix multiplied(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}
Matrix turnX(double a) {
  return {{{1, 0, 0}, {0, std::cos(a), -std::sin(a)}, {0, std::sin(a), std::cos(a)}}};
}
Matrix turnY(double a) {
  return {{{std::cos(a), 0, std::sin(a)}, {0, 1, 0}, {-std::sin(a), 0, std::cos(a)}}};
}
Matrix turnZ(double a) {
  return {{{std::cos(a), -std::sin(a), 0}, {std::sin(a), std::cos(a), 0}, {0, 0, 1}}};
}

class SpinLock {
 public:
  void lock() noexcept {
    while (flag_.test_and_set(std::memory_order_acquire)) std::this_thread::yield();
  }
  void unlock() noexcept { flag_.clear(std::memory_order_release); }

 private:
  std::atomic_flag flag_ = ATOMIC_FLAG_INIT;
};
using Guard = std::lock_guard<SpinLock>;

struct Fault {
  std::string function;
  int skip = 0;
  int times = 0;
  hd::ErrorInfo error;
};

struct Task {
  hd::SchedulerHandle handle = 0;
  hd::SchedulerCallback callback = nullptr;
  void* userData = nullptr;
  hd::UShort priority = 0;
  bool once = false;
};

struct Latched {
  std::array<double, 16> transform{};
  std::array<double, 3> joints{};
  std::array<double, 3> gimbal{};
  std::int32_t buttons = 0;
};

// Joint and gimbal angles of a Touch whose stylus rests in the inkwell, as published in a recording.
constexpr FakePose kInkwellPose{{0.0, 0.26889, -0.370813}, {0.000108409, 0.797273, -1.94046}, 0, {}};
constexpr int kMostErrors = 64;
constexpr int kMostCalls = 1 << 16;
constexpr int kMostTasks = 16;

/// What a Touch answers.
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

struct Fake {
  SpinLock spin;  // everything below, unless said otherwise

  // Story.
  bool present = true;
  std::int64_t garbageHandle = -1;
  bool anyName = true;
  std::string onlyName;
  std::string model = "Touch";
  std::array<double, 3> gimbalScale{1, 1, 1};
  std::array<double, 3> gimbalOffset{};
  std::map<hd::Enum, std::vector<double>> numbers = usualNumbers();
  FakePose pose = kInkwellPose;
  FakePoseFunction poseFunction = nullptr;
  void* poseContext = nullptr;
  std::int32_t buttons = 0;
  std::vector<double> temperature{0.1, 0.1, 0.1};
  hd::Enum calibration = hd::kCalibrationOk;
  bool docked = true;
  bool licence = true;
  std::vector<Fault> faults;
  FakeHook hook = nullptr;
  void* hookContext = nullptr;
  int dockAtTick = -1;
  int unplugAtTick = -1;
  std::string logFile;

  // Library.
  std::array<hd::ErrorInfo, kMostErrors> errors{};
  int errorCount = 0;
  bool initiated = false;
  bool forceEnabled = false;
  bool stuckForce = false;
  std::map<hd::Enum, bool> enabled;
  bool inFrame = false;
  int framesThisTick = 0;
  Latched now;
  Latched latched;
  std::array<double, 3> frameForce{};
  std::array<double, 3> commanded{};
  std::array<Task, kMostTasks> tasks{};
  int taskCount = 0;
  hd::SchedulerHandle nextTask = 1;
  std::array<FakeCall, kMostCalls> log{};
  int logCount = 0;
  std::map<std::string, int, std::less<>> counts;
  int offThread = 0;
  int ruleBreaks = 0;
  std::atomic<std::int64_t> tick{0};
  std::atomic<std::int64_t> now_us{0};
  std::atomic<std::int64_t> period_us{1000};
  std::atomic<bool> unplugged{false};
  std::atomic<bool> running{false};
  std::atomic<bool> real{true};
  std::atomic<std::thread::id> servo{};

  // Hand-over between the test and the servo thread, never taken within a callback.
  std::mutex mutex;
  std::condition_variable changed;
  std::thread thread;
  bool stop = false;
  int pendingTicks = 0;
  int pendingOnce = 0;
};

Fake& fake() {
  // Never destroyed: a blocked scheduler may outlive the program's static objects.
  static Fake* const instance = new Fake;
  return *instance;
}

std::atomic<int> loads{0};
[[maybe_unused]] const int kLoaded = ++loads;

void push(Fake& f, hd::ErrorCode error, std::int32_t internal) {
  if (f.errorCount < kMostErrors) f.errors[static_cast<std::size_t>(f.errorCount++)] = {error, internal, 0};
}

void breakRule(Fake& f, hd::ErrorCode error) {
  ++f.ruleBreaks;
  push(f, error, 0);
}

bool onServoThread(const Fake& f) {
  return f.servo.load() == std::this_thread::get_id();
}

void writeLog(const Fake& f, const char* line) {
  if (f.logFile.empty()) return;
  if (std::FILE* const file = std::fopen(f.logFile.c_str(), "a")) {
    std::fprintf(file, "%s\n", line);
    std::fclose(file);
  }
}

/// Bookkeeping of one call. False when a fault was scripted for it, or the cable is out: it then does
/// nothing.
bool enter(Fake& f, const char* function, bool deviceCall = true) {
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
  if (deviceCall && f.running && !servo) ++f.offThread;
  bool works = true;
  for (Fault& fault : f.faults) {
    if (fault.function != function || fault.times == 0) continue;
    if (fault.skip > 0) {
      --fault.skip;
      continue;
    }
    if (fault.times > 0) --fault.times;
    push(f, fault.error.error, fault.error.internalError);
    works = false;
  }
  if (f.unplugged && deviceCall) {
    push(f, hd::kCommError, -28);
    works = false;
  }
  return works;
}

void place(Fake& f) {
  const FakePose& p = f.pose;
  const auto [q1, q2, q3] = std::to_array(p.joints_rad);
  constexpr double kLink_mm = 133.35;
  const double reach = kLink_mm * (std::cos(q2) + std::sin(q3));
  std::array<double, 3> position{-std::sin(q1) * reach, kLink_mm * (std::sin(q2) - std::cos(q3)) + 23.35,
                                 std::cos(q1) * reach - 168.35};
  if (p.usePosition != 0) position = std::to_array(p.position_mm);
  const Matrix r = multiplied(
      multiplied(turnY(-q1), turnX(-q3)),
      multiplied(turnY(p.gimbal_rad[0]), multiplied(turnX(-p.gimbal_rad[1]), turnZ(-p.gimbal_rad[2]))));
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < 3; ++i) f.now.transform[4 * c + i] = r[i][c];
    f.now.transform[12 + c] = position[c];
    f.now.joints[c] = p.joints_rad[c];
    f.now.gimbal[c] = (p.gimbal_rad[c] - f.gimbalOffset[c]) / f.gimbalScale[c];
  }
  f.now.transform[15] = 1.0;
  f.now.buttons = f.buttons;
}

std::array<double, 3> rendered(const Fake& f) {
  return f.running && f.forceEnabled && !f.unplugged ? f.commanded : std::array<double, 3>{};
}

void tellStory(Fake& f) {
  const std::int64_t tick = f.tick.load();
  if (f.dockAtTick >= 0 && tick >= f.dockAtTick) {
    f.docked = true;
    f.pose = kInkwellPose;
    if (f.calibration == hd::kCalibrationNeedsManualInput) f.calibration = hd::kCalibrationNeedsUpdate;
  }
  if (f.unplugAtTick >= 0 && tick >= f.unplugAtTick) f.unplugged = true;
}

/// One tick: the hand moves, then every task runs in decreasing priority.
void runTick(Fake& f) {
  std::array<Task, kMostTasks> tasks;
  int count = 0;
  FakePoseFunction move = nullptr;
  {
    const Guard guard(f.spin);
    ++f.tick;
    if (!f.real) f.now_us += f.period_us.load();
    f.framesThisTick = 0;
    tellStory(f);
    move = f.unplugged ? nullptr : f.poseFunction;
    tasks = f.tasks;
    count = f.taskCount;
  }
  if (move != nullptr) {
    FakePose pose = f.pose;
    move(f.poseContext, f.tick.load(), rendered(f).data(), &pose);
    const Guard guard(f.spin);
    f.pose = pose;
  }
  {
    const Guard guard(f.spin);
    if (!f.unplugged) place(f);
  }
  for (int i = 0; i < count; ++i) {
    const Task& task = tasks[static_cast<std::size_t>(i)];
    if (f.hook != nullptr) f.hook(f.hookContext, 1);
    const hd::CallbackCode answer = task.callback(task.userData);
    if (f.hook != nullptr) f.hook(f.hookContext, 0);
    if (answer == hd::kCallbackContinue && !task.once) continue;
    const Guard guard(f.spin);
    for (int k = 0; k < f.taskCount; ++k) {
      if (f.tasks[static_cast<std::size_t>(k)].handle != task.handle) continue;
      for (int m = k; m + 1 < f.taskCount; ++m) {
        f.tasks[static_cast<std::size_t>(m)] = f.tasks[static_cast<std::size_t>(m + 1)];
      }
      --f.taskCount;
      break;
    }
  }
}

/// Tasks of hdScheduleSynchronous that nobody has served yet.
int waitingTasks(Fake& f) {
  const Guard guard(f.spin);
  int waiting = 0;
  for (int k = 0; k < f.taskCount; ++k) waiting += f.tasks[static_cast<std::size_t>(k)].once ? 1 : 0;
  return waiting;
}

void servoLoop(Fake& f) {
  f.servo = std::this_thread::get_id();
  auto deadline = std::chrono::steady_clock::now();
  std::unique_lock lock(f.mutex);
  while (!f.stop) {
    if (f.real) {
      lock.unlock();
      deadline += std::chrono::microseconds(f.period_us.load());
      std::this_thread::sleep_until(deadline);
      runTick(f);
      lock.lock();
      f.pendingOnce = waitingTasks(f);
      f.changed.notify_all();
      continue;
    }
    f.changed.wait(lock, [&f] { return f.stop || f.pendingTicks > 0 || f.pendingOnce > 0; });
    if (f.stop) break;
    lock.unlock();
    runTick(f);
    lock.lock();
    if (f.pendingTicks > 0) --f.pendingTicks;
    f.pendingOnce = waitingTasks(f);
    f.changed.notify_all();
  }
  f.servo = std::thread::id{};
}

hd::SchedulerHandle schedule(Fake& f, hd::SchedulerCallback callback, void* userData, hd::UShort priority,
                             bool once) {
  if (f.taskCount == kMostTasks) {
    push(f, hd::kSchedulerFull, 0);
    return 0;
  }
  int at = 0;
  while (at < f.taskCount && f.tasks[static_cast<std::size_t>(at)].priority >= priority) ++at;
  for (int k = f.taskCount; k > at; --k) {
    f.tasks[static_cast<std::size_t>(k)] = f.tasks[static_cast<std::size_t>(k - 1)];
  }
  f.tasks[static_cast<std::size_t>(at)] = {f.nextTask, callback, userData, priority, once};
  ++f.taskCount;
  return f.nextTask++;
}

const char* environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

void readEnvironment(Fake& f) {
  if (*environment("FAKEHD_NO_DEVICE") != '\0') f.present = false;
  if (*environment("FAKEHD_NO_LICENCE") != '\0') f.licence = false;
  if (*environment("FAKEHD_MODEL") != '\0') f.model = environment("FAKEHD_MODEL");
  const std::string calibration = environment("FAKEHD_CALIBRATION");
  if (calibration == "update") f.calibration = hd::kCalibrationNeedsUpdate;
  if (calibration == "dock") f.calibration = hd::kCalibrationNeedsManualInput;
  if (*environment("FAKEHD_DOCK_AT_TICK") != '\0')
    f.dockAtTick = std::atoi(environment("FAKEHD_DOCK_AT_TICK"));
  if (*environment("FAKEHD_UNPLUG_AT_TICK") != '\0') {
    f.unplugAtTick = std::atoi(environment("FAKEHD_UNPLUG_AT_TICK"));
  }
  if (*environment("FAKEHD_TICK_US") != '\0') f.period_us = std::atoi(environment("FAKEHD_TICK_US"));
  if (std::string(environment("FAKEHD_POSE")) == "centre") f.pose = {{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  f.logFile = environment("FAKEHD_LOG");
}

bool nameOpens(const Fake& f, const char* name) {
  if (f.anyName) return true;
  return f.onlyName.empty() ? name == nullptr : name != nullptr && f.onlyName == name;
}

template <typename T>
void give(Fake& f, hd::Enum name, T* values) {
  const auto number = f.numbers.find(name);
  if (number == f.numbers.end()) {
    push(f, hd::kInvalidEnum, 0);
    return;
  }
  for (std::size_t i = 0; i < number->second.size(); ++i) values[i] = static_cast<T>(number->second[i]);
}

}  // namespace

extern "C" {

hd::Handle hdInitDevice(const char* configName) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (f.real && f.tick == 0) readEnvironment(f);
  writeLog(f, "hdInitDevice");
  if (!enter(f, __func__)) return hd::kInvalidHandle;
  if (f.garbageHandle >= 0) return static_cast<hd::Handle>(f.garbageHandle);
  if (!f.licence) {
    push(f, hd::kInvalidLicense, 0);
    return hd::kInvalidHandle;
  }
  if (!f.present || !nameOpens(f, configName)) {
    push(f, hd::kDeviceFault, -1);
    return hd::kInvalidHandle;
  }
  if (f.initiated) {
    push(f, hd::kDeviceAlreadyInitiated, 0);
    return hd::kInvalidHandle;
  }
  f.initiated = true;
  return 0;
}

void hdDisableDevice(hd::Handle device) {
  Fake& f = fake();
  const Guard guard(f.spin);
  writeLog(f, "hdDisableDevice");
  if (!enter(f, __func__)) return;
  if (device != 0) push(f, hd::kBadHandle, 0);
  f.initiated = false;
  f.forceEnabled = false;
}

void hdMakeCurrentDevice(hd::Handle device) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (enter(f, __func__) && device != 0) push(f, hd::kBadHandle, 0);
}

hd::Handle hdGetCurrentDevice() {
  Fake& f = fake();
  const Guard guard(f.spin);
  (void)enter(f, __func__);
  return 0;
}

void hdBeginFrame(hd::Handle device) {
  Fake& f = fake();
  const Guard guard(f.spin);
  const bool works = enter(f, __func__);
  if (!works) {
    // A broken connection opens the frame all the same; only a frame error does not.
    const hd::ErrorCode last =
        f.errorCount > 0 ? f.errors[static_cast<std::size_t>(f.errorCount - 1)].error : 0;
    if (last == hd::kIllegalBegin || last == hd::kFrameError) return;
  }
  if (device != 0) {
    breakRule(f, hd::kBadHandle);
    return;
  }
  if (f.inFrame || f.framesThisTick > 0) {
    breakRule(f, hd::kIllegalBegin);
    return;
  }
  f.inFrame = true;
  ++f.framesThisTick;
  f.frameForce = {};
  if (!f.unplugged) f.latched = f.now;
}

void hdEndFrame(hd::Handle) {
  Fake& f = fake();
  const Guard guard(f.spin);
  const bool works = enter(f, __func__);
  if (!f.inFrame) {
    breakRule(f, hd::kIllegalEnd);
    return;
  }
  f.inFrame = false;
  if (!works) return;
  const bool was = f.commanded != std::array<double, 3>{};
  f.commanded = f.frameForce;
  const bool is = f.commanded != std::array<double, 3>{};
  if (was != is) writeLog(f, is ? "force" : "zero force");
}

hd::ErrorInfo hdGetError() {
  Fake& f = fake();
  const Guard guard(f.spin);
  (void)enter(f, __func__, false);
  if (f.errorCount == 0) return {};
  return f.errors[static_cast<std::size_t>(--f.errorCount)];
}

const char* hdGetErrorString(hd::ErrorCode) {
  return "said by the library";
}

void hdEnable(hd::Enum capability) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) return;
  f.enabled[capability] = true;
  if (capability == hd::kForceOutput) {
    f.forceEnabled = true;
    writeLog(f, "force output on");
  }
}

void hdDisable(hd::Enum capability) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__) || (f.stuckForce && capability == hd::kForceOutput)) return;
  f.enabled[capability] = false;
  if (capability == hd::kForceOutput) {
    f.forceEnabled = false;
    writeLog(f, "force output off");
  }
}

hd::Boolean hdIsEnabled(hd::Enum capability) {
  Fake& f = fake();
  const Guard guard(f.spin);
  return enter(f, __func__) && f.enabled[capability] ? 1 : 0;
}

void hdGetIntegerv(hd::Enum name, hd::Int* values) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) return;
  switch (name) {
    case hd::kCurrentButtons:
      *values = f.latched.buttons;
      return;
    case hd::kInputDof:
    case hd::kOutputDof:
    case hd::kCalibrationStyle:
    case hd::kUpdateRate:
    case hd::kInstantaneousUpdateRate:
      give(f, name, values);
      return;
    default:
      breakRule(f, hd::kInvalidInputType);
  }
}

void hdGetDoublev(hd::Enum name, double* values) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) return;
  const auto copy = [values](const auto& from) { std::memcpy(values, from.data(), sizeof(from)); };
  switch (name) {
    case hd::kCurrentTransform:
      return copy(f.latched.transform);
    case hd::kCurrentPosition:
      std::memcpy(values, f.latched.transform.data() + 12, 3 * sizeof(double));
      return;
    case hd::kCurrentJointAngles:
      return copy(f.latched.joints);
    case hd::kCurrentGimbalAngles:
      return copy(f.latched.gimbal);
    case hd::kMotorTemperature:
      std::memcpy(values, f.temperature.data(), f.temperature.size() * sizeof(double));
      return;
    case hd::kCurrentButtons:
    case hd::kInputDof:
    case hd::kOutputDof:
    case hd::kCalibrationStyle:
    case hd::kCurrentInkwellSwitch:
      breakRule(f, hd::kInvalidInputType);
      return;
    default:
      give(f, name, values);
  }
}

void hdGetBooleanv(hd::Enum name, hd::Boolean* values) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) return;
  if (name != hd::kCurrentInkwellSwitch) {
    breakRule(f, hd::kInvalidInputType);
    return;
  }
  *values = f.docked ? 0 : 1;  // false while the stylus is in the inkwell, as reported from the field
}

const char* hdGetString(hd::Enum name) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) return nullptr;
  switch (name) {
    case hd::kDeviceModelType:
      return f.model.c_str();
    case hd::kDeviceVendor:
      return "Fake vendor";
    case hd::kDeviceSerialNumber:
      return "000123";
    case hd::kDeviceDriverVersion:
      return "4.3";
    case hd::kVersion:
      return "3.4.0";
    default:
      breakRule(f, hd::kInvalidInputType);
      return nullptr;
  }
}

void hdSetDoublev(hd::Enum name, const double* values) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) return;
  if (name != hd::kCurrentForce) {
    breakRule(f, hd::kInvalidEnum);
    return;
  }
  if (!f.inFrame) {
    breakRule(f, hd::kFrameError);
    return;
  }
  f.frameForce = {values[0], values[1], values[2]};
}

hd::Enum hdCheckCalibration() {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) return hd::kCalibrationNeedsManualInput;
  if (!f.inFrame && f.running) ++f.ruleBreaks;
  return f.calibration;
}

void hdUpdateCalibration(hd::Enum style) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) return;
  const auto styles = static_cast<hd::Enum>(f.numbers[hd::kCalibrationStyle].at(0));
  if ((style & styles) == 0) {
    push(f, hd::kInvalidValue, 0);
  } else if (f.calibration == hd::kCalibrationNeedsUpdate) {
    f.calibration = hd::kCalibrationOk;
  }
}

void hdStartScheduler() {
  Fake& f = fake();
  {
    const Guard guard(f.spin);
    writeLog(f, "hdStartScheduler");
    if (!enter(f, __func__, false)) return;
  }
  const std::lock_guard lock(f.mutex);
  if (f.running) return;
  f.stop = false;
  f.running = true;
  f.thread = std::thread([&f] { servoLoop(f); });
}

void hdStopScheduler() {
  Fake& f = fake();
  {
    const Guard guard(f.spin);
    writeLog(f, "hdStopScheduler");
    if (!enter(f, __func__, false)) return;
  }
  std::unique_lock lock(f.mutex);
  f.changed.wait(lock, [&f] { return !f.unplugged; });
  if (!f.running) return;
  f.stop = true;
  f.changed.notify_all();
  lock.unlock();
  f.thread.join();
  f.running = false;
}

hd::SchedulerHandle hdScheduleAsynchronous(hd::SchedulerCallback callback, void* userData,
                                           hd::UShort priority) {
  Fake& f = fake();
  const Guard guard(f.spin);
  writeLog(f, "hdScheduleAsynchronous");
  if (!enter(f, __func__, false)) return 0;
  return schedule(f, callback, userData, priority, false);
}

#ifndef FAKEHD_WITHOUT_UNSCHEDULE
void hdUnschedule(hd::SchedulerHandle callback) {
  Fake& f = fake();
  const Guard guard(f.spin);
  writeLog(f, "hdUnschedule");
  if (!enter(f, __func__, false)) return;
  for (int k = 0; k < f.taskCount; ++k) {
    if (f.tasks[static_cast<std::size_t>(k)].handle != callback) continue;
    for (int m = k; m + 1 < f.taskCount; ++m) {
      f.tasks[static_cast<std::size_t>(m)] = f.tasks[static_cast<std::size_t>(m + 1)];
    }
    --f.taskCount;
    return;
  }
  push(f, hd::kInvalidValue, 0);
}
#endif

void hdSetSchedulerRate(hd::ULong) {
  Fake& f = fake();
  const Guard guard(f.spin);
  (void)enter(f, __func__, false);
}

void hdScheduleSynchronous(hd::SchedulerCallback callback, void* userData, hd::UShort priority) {
  Fake& f = fake();
  bool inlineCall = false;
  hd::SchedulerHandle handle = 0;
  {
    const Guard guard(f.spin);
    if (!enter(f, __func__, false)) return;
    inlineCall = !f.running || onServoThread(f);
    if (!inlineCall) handle = schedule(f, callback, userData, priority, true);
  }
  if (inlineCall) {
    (void)callback(userData);
    return;
  }
  std::unique_lock lock(f.mutex);
  f.pendingOnce = 1;
  f.changed.notify_all();
  f.changed.wait(lock, [&f, handle] {
    const Guard guard(f.spin);
    for (int k = 0; k < f.taskCount; ++k) {
      if (f.tasks[static_cast<std::size_t>(k)].handle == handle) return false;
    }
    return true;
  });
}

// --- controls
// -------------------------------------------------------------------------------------------------

void fakehd_reset() {
  Fake& f = fake();
  {
    const std::lock_guard lock(f.mutex);
    f.pendingTicks = 0;
    f.pendingOnce = 0;
  }
  const Guard guard(f.spin);
  f.present = true;
  f.garbageHandle = -1;
  f.anyName = true;
  f.onlyName.clear();
  f.model = "Touch";
  f.gimbalScale = {1, 1, 1};
  f.gimbalOffset = {};
  f.numbers = usualNumbers();
  f.pose = kInkwellPose;
  f.poseFunction = nullptr;
  f.buttons = 0;
  f.temperature = {0.1, 0.1, 0.1};
  f.calibration = hd::kCalibrationOk;
  f.docked = true;
  f.licence = true;
  f.faults.clear();
  f.hook = nullptr;
  f.errorCount = 0;
  f.initiated = false;
  f.forceEnabled = false;
  f.stuckForce = false;
  f.enabled.clear();
  f.inFrame = false;
  f.framesThisTick = 0;
  f.latched = {};
  f.now = {};
  f.commanded = {};
  f.taskCount = 0;
  f.logCount = 0;
  f.counts.clear();
  for (const char* name :
       {"hdBeginFrame", "hdEndFrame", "hdGetDoublev", "hdGetIntegerv", "hdGetBooleanv", "hdSetDoublev",
        "hdGetError", "hdCheckCalibration", "hdUpdateCalibration", "hdEnable", "hdDisable"}) {
    f.counts[name] = 0;  // so that counting them allocates nothing in the servo thread
  }
  f.enabled[hd::kForceOutput] = false;
  f.offThread = 0;
  f.ruleBreaks = 0;
  f.tick = 0;
  f.now_us = 1'000'000;
  f.period_us = 1000;
  f.unplugged = false;
  f.real = false;
  f.dockAtTick = -1;
  f.unplugAtTick = -1;
  f.logFile.clear();
}

#define FAKEHD_GUARDED \
  Fake& f = fake();    \
  const Guard guard(f.spin);

void fakehd_set_present(int present) {
  FAKEHD_GUARDED
  f.present = present != 0;
}
void fakehd_set_garbage_handle(std::int64_t handle) {
  FAKEHD_GUARDED
  f.garbageHandle = handle;
}
void fakehd_set_only_name(const char* name) {
  FAKEHD_GUARDED
  f.anyName = name == nullptr;
  f.onlyName = name != nullptr ? name : "";
}
void fakehd_set_model(const char* model) {
  FAKEHD_GUARDED
  f.model = model;
}
void fakehd_set_gimbal(const double* scale, const double* offset_rad) {
  FAKEHD_GUARDED
  for (std::size_t i = 0; i < 3; ++i) {
    f.gimbalScale[i] = scale[i];
    f.gimbalOffset[i] = offset_rad[i];
  }
}
void fakehd_set_number(std::uint32_t name, const double* values, int count) {
  FAKEHD_GUARDED
  f.numbers[name].assign(values, values + count);
}
void fakehd_set_pose(const FakePose* pose) {
  FAKEHD_GUARDED
  f.pose = *pose;
}
void fakehd_set_pose_function(FakePoseFunction function, void* context) {
  FAKEHD_GUARDED
  f.poseFunction = function;
  f.poseContext = context;
}
void fakehd_set_stuck_force(int stuck) {
  FAKEHD_GUARDED
  f.stuckForce = stuck != 0;
  f.enabled[hd::kForceOutput] = f.stuckForce;
}
void fakehd_set_buttons(std::int32_t mask) {
  FAKEHD_GUARDED
  f.buttons = mask;
}
void fakehd_set_temperature(const double* values, int count) {
  FAKEHD_GUARDED
  f.temperature.assign(values, values + count);
}
void fakehd_set_calibration(std::uint32_t state) {
  FAKEHD_GUARDED
  f.calibration = state;
  if (state == hd::kCalibrationNeedsManualInput) f.docked = false;
}
void fakehd_dock(int docked) {
  FAKEHD_GUARDED
  f.docked = docked != 0;
  if (f.docked) f.pose = kInkwellPose;
  if (f.docked && f.calibration == hd::kCalibrationNeedsManualInput)
    f.calibration = hd::kCalibrationNeedsUpdate;
}
void fakehd_fault(const char* function, int skip, int times, std::uint32_t error, std::int32_t internal) {
  FAKEHD_GUARDED
  f.faults.push_back({function, skip, times, {error, internal, 0}});
}
void fakehd_push_error(std::uint32_t error, std::int32_t internal) {
  FAKEHD_GUARDED
  push(f, error, internal);
}
void fakehd_unplug() {
  fake().unplugged = true;
}
void fakehd_replug() {
  Fake& f = fake();
  const std::lock_guard lock(f.mutex);
  f.unplugged = false;
  f.changed.notify_all();
}
void fakehd_run(int ticks) {
  Fake& f = fake();
  std::unique_lock lock(f.mutex);
  if (!f.running) return;
  f.pendingTicks = ticks;
  f.changed.notify_all();
  f.changed.wait(lock, [&f] { return f.pendingTicks == 0 || f.stop; });
  f.pendingTicks = 0;
}
void fakehd_set_tick_us(std::int64_t period_us) {
  fake().period_us = period_us;
}
void fakehd_advance_us(std::int64_t step_us) {
  fake().now_us += step_us;
}
std::int64_t fakehd_now_us() {
  return fake().now_us;
}
void fakehd_set_hook(FakeHook hook, void* context) {
  FAKEHD_GUARDED
  f.hook = hook;
  f.hookContext = context;
}
void fakehd_set_real_time(int real) {
  fake().real = real != 0;
}
int fakehd_log_count() {
  FAKEHD_GUARDED
  return f.logCount;
}
FakeCall fakehd_log_entry(int index) {
  FAKEHD_GUARDED
  return f.log.at(static_cast<std::size_t>(index));
}
int fakehd_calls(const char* function) {
  FAKEHD_GUARDED
  const auto count = f.counts.find(std::string_view(function));
  return count != f.counts.end() ? count->second : 0;
}
int fakehd_off_thread() {
  FAKEHD_GUARDED
  return f.offThread;
}
int fakehd_rule_breaks() {
  FAKEHD_GUARDED
  return f.ruleBreaks;
}
int fakehd_callbacks() {
  FAKEHD_GUARDED
  return f.taskCount;
}
int fakehd_running() {
  return fake().running ? 1 : 0;
}
int fakehd_errors_pending() {
  FAKEHD_GUARDED
  return f.errorCount;
}
int fakehd_loads() {
#ifdef FAKEHD_WRONG_DEPENDENCY
  return fakehd_absent();
#else
  return loads;
#endif
}
void fakehd_force(double* force_N) {
  FAKEHD_GUARDED
  const std::array<double, 3> force = rendered(f);
  std::memcpy(force_N, force.data(), sizeof(force));
}
void fakehd_commanded(double* force_N) {
  FAKEHD_GUARDED
  std::memcpy(force_N, f.commanded.data(), sizeof(f.commanded));
}
int fakehd_force_enabled() {
  FAKEHD_GUARDED
  return f.forceEnabled ? 1 : 0;
}

}  // extern "C"
