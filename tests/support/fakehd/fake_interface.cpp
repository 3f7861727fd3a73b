// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the vendor's library.
#include <cstring>

#include "tests/support/fakehd/fake_state.h"

using namespace fakehd;

namespace {

bool nameOpens(const Fake& f, const char* name) {
  if (f.anyName) {
    return true;
  }
  return f.onlyName.empty() ? name == nullptr : name != nullptr && f.onlyName == name;
}

/// Imitates a library that unschedules too late: calls a removed task, which uses its device. Called with the
/// lock, which the task also needs.
void callLate(Fake& f) {
  const Task task = f.kept;
  f.spin.unlock();
  for (int i = 0; i < 5 && task.callback != nullptr; ++i) {
    (void)task.callback(task.userData);
  }
  f.spin.lock();
}

template <typename T>
void give(Fake& f, hd::Enum name, T* values) {
  const auto number = f.numbers.find(name);
  if (number == f.numbers.end()) {
    push(f, hd::kInvalidEnum, 0);
    return;
  }
  for (std::size_t i = 0; i < number->second.size(); ++i) {
    values[i] = static_cast<T>(number->second[i]);
  }
}

}  // namespace

extern "C" {

hd::Handle hdInitDevice(const char* configName) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (f.real && f.tick == 0) {
    readEnvironment(f);
  }
  writeLog(f, "hdInitDevice");
  see(f, Seen::kInit);
  if (!enter(f, __func__)) {
    return hd::kInvalidHandle;
  }
  if (f.garbageHandle >= 0) {
    return static_cast<hd::Handle>(f.garbageHandle);
  }
  if (!f.licence) {
    push(f, hd::kInvalidLicense, 0);
    return hd::kInvalidHandle;
  }
  if (f.onlyOnce) {
    push(f, hd::kDeviceAlreadyInitiated, 0);
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
  see(f, Seen::kDisable);
  if (!enter(f, __func__)) {
    return;
  }
  if (device != 0) {
    push(f, hd::kBadHandle, 0);
  }
  f.initiated = false;
  f.forceEnabled = false;
  seeMotors(f);
  if (f.lateCallbacks) {
    callLate(f);
  }
}

void hdMakeCurrentDevice(hd::Handle device) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (enter(f, __func__) && device != 0) {
    push(f, hd::kBadHandle, 0);
  }
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
    // A broken connection still opens the frame; only a frame error does not.
    const hd::ErrorCode last =
        f.errorCount > 0 ? f.errors[static_cast<std::size_t>(f.errorCount - 1)].error : 0;
    if (last == hd::kIllegalBegin || last == hd::kFrameError) {
      return;
    }
  }
  if (device != 0) {
    breakRule(f, hd::kBadHandle);
    return;
  }
  if (f.inFrame || (f.framesThisTick > 0 && f.enabled[hd::kOneFrameLimit])) {
    breakRule(f, hd::kIllegalBegin);
    return;
  }
  f.inFrame = true;
  ++f.framesThisTick;
  f.frameForce = {};
  if (!f.unplugged) {
    f.latched = f.now;
  }
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
  if (!works) {
    return;
  }
  const bool was = f.commanded != std::array<double, 3>{};
  f.commanded = f.frameForce;
  const bool is = f.commanded != std::array<double, 3>{};
  if (was && !is) {
    see(f, Seen::kZeroFrame);
  }
  seeMotors(f);
  if (was != is) {
    writeLog(f, is ? "force" : "zero force");
  }
}

hd::ErrorInfo hdGetError() {
  Fake& f = fake();
  const Guard guard(f.spin);
  (void)enter(f, __func__, false);
  if (f.errorCount == 0) {
    return {};
  }
  return f.errors[static_cast<std::size_t>(--f.errorCount)];
}

const char* hdGetErrorString(hd::ErrorCode) {
  return "said by the library";
}

void hdEnable(hd::Enum capability) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) {
    return;
  }
  f.enabled[capability] = true;
  if (capability == hd::kForceOutput) {
    f.forceEnabled = true;
    see(f, Seen::kOutputOn);
    seeMotors(f);
    writeLog(f, "force output on");
  }
}

void hdDisable(hd::Enum capability) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__) || (f.stuckForce && capability == hd::kForceOutput)) {
    return;
  }
  f.enabled[capability] = false;
  if (capability == hd::kForceOutput) {
    f.forceEnabled = false;
    see(f, Seen::kOutputOff);
    seeMotors(f);
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
  if (!enter(f, __func__)) {
    return;
  }
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
  if (!enter(f, __func__)) {
    return;
  }
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
  if (!enter(f, __func__)) {
    return;
  }
  if (name != hd::kCurrentInkwellSwitch) {
    breakRule(f, hd::kInvalidInputType);
    return;
  }
  *values = f.docked ? 0 : 1;  // false while the stylus is in the inkwell, as reported from the field
}

const char* hdGetString(hd::Enum name) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) {
    return nullptr;
  }
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
  if (!enter(f, __func__)) {
    return;
  }
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
  if (!enter(f, __func__)) {
    return hd::kCalibrationNeedsManualInput;
  }
  if (!f.inFrame && f.running) {
    ++f.ruleBreaks;
  }
  return f.calibration;
}

void hdUpdateCalibration(hd::Enum style) {
  Fake& f = fake();
  const Guard guard(f.spin);
  if (!enter(f, __func__)) {
    return;
  }
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
    see(f, Seen::kStart);
    if (!enter(f, __func__, false)) {
      return;
    }
  }
  const std::lock_guard lock(f.mutex);
  if (f.running) {
    return;
  }
  f.stop = false;
  f.running = true;
  f.thread = std::thread([&f] { servoLoop(f); });
}

void hdStopScheduler() {
  Fake& f = fake();
  {
    const Guard guard(f.spin);
    writeLog(f, "hdStopScheduler");
    see(f, Seen::kStop);
    if (!enter(f, __func__, false)) {
      return;
    }
  }
  std::unique_lock lock(f.mutex);
  f.changed.wait(lock, [&f] { return !f.unplugged; });
  if (!f.running) {
    return;
  }
  f.stop = true;
  f.changed.notify_all();
  lock.unlock();
  f.thread.join();
  f.running = false;
  const Guard guard(f.spin);
  seeMotors(f);
}

hd::SchedulerHandle hdScheduleAsynchronous(hd::SchedulerCallback callback, void* userData,
                                           hd::UShort priority) {
  Fake& f = fake();
  hd::SchedulerHandle handle = 0;
  {
    const Guard guard(f.spin);
    writeLog(f, "hdScheduleAsynchronous");
    if (!enter(f, __func__, false)) {
      return 0;
    }
    handle = schedule(f, callback, userData, priority, false);
  }
  if (f.running && !f.real && !f.dead) {
    // With the manual clock, nobody else would serve a task left over by a teardown.
    const std::lock_guard lock(f.mutex);
    f.pendingOnce = 1;
    f.changed.notify_all();
  }
  return handle;
}

#ifndef FAKEHD_WITHOUT_UNSCHEDULE
void hdUnschedule(hd::SchedulerHandle callback) {
  Fake& f = fake();
  const Guard guard(f.spin);
  writeLog(f, "hdUnschedule");
  see(f, Seen::kUnschedule);
  if (f.lateCallbacks && f.taskCount > 0) {
    f.kept = f.tasks[0];
  }
  if (!enter(f, __func__, false)) {
    return;
  }
  if (!unschedule(f, callback)) {
    push(f, hd::kInvalidValue, 0);
  }
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
    if (!enter(f, __func__, false)) {
      return;
    }
    inlineCall = !f.running || onServoThread(f);
    if (!inlineCall) {
      handle = schedule(f, callback, userData, priority, true);
    }
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
      if (f.tasks[static_cast<std::size_t>(k)].handle == handle) {
        return false;
      }
    }
    return true;
  });
}

}  // extern "C"
