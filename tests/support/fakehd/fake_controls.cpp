// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that control the fake.
#include <cstring>

#include "tests/support/fakehd/fake_state.h"

#ifdef FAKEHD_WRONG_DEPENDENCY
extern "C" int fakehd_absent();
#endif

using namespace fakehd;

extern "C" {

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
    f.counts[name] = 0;  // so that counting does not allocate in the servo thread
  }
  f.enabled[hd::kForceOutput] = false;
  f.offThread = 0;
  f.ruleBreaks = 0;
  f.tick = 0;
  f.now_us = 1'000'000;
  f.period_us = 1000;
  f.unplugged = false;
  f.dead = false;
  f.kept = {};
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
  if (state == hd::kCalibrationNeedsManualInput) {
    f.docked = false;
  }
}
void fakehd_dock(int docked) {
  FAKEHD_GUARDED
  f.docked = docked != 0;
  if (f.docked) {
    f.pose = kInkwellPose;
  }
  if (f.docked && f.calibration == hd::kCalibrationNeedsManualInput) {
    f.calibration = hd::kCalibrationNeedsUpdate;
  }
}
void fakehd_fault(const char* function, int skip, int times, std::uint32_t error, std::int32_t internal) {
  FAKEHD_GUARDED
  f.faults.push_back({function, skip, times, {error, internal, 0}});
}
void fakehd_push_error(std::uint32_t error, std::int32_t internal) {
  FAKEHD_GUARDED
  push(f, error, internal);
}
void fakehd_die() {
  fake().dead = true;
}
void fakehd_keep_task() {
  FAKEHD_GUARDED
  f.kept = f.tasks[0];
}
void fakehd_call_kept() {
  const Task kept = fake().kept;
  if (kept.callback != nullptr) {
    (void)kept.callback(kept.userData);
  }
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
  if (!f.running) {
    return;
  }
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
  return loads();
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
