// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// Controls of the fake vendor library: a shared object with the interface of libHD (global error stack,
/// frames, priorities, handle 0 first, type checks, thread checks) and these further exports. One fake per
/// process; call fakehd_reset() before each test. Call the controls only from the test's thread.
///
/// Without fakehd_reset() the fake runs in real time and reads its story from the environment, for tests of
/// the whole program: FAKEHD_NO_DEVICE, FAKEHD_NO_LICENCE, FAKEHD_MODEL, FAKEHD_CALIBRATION=ok|update|dock,
/// FAKEHD_HANG=hdEndFrame and FAKEHD_HANG_AT_TICK (that function hangs from then on), FAKEHD_DOCK_AT_TICK,
/// FAKEHD_UNPLUG_AT_TICK, FAKEHD_TICK_US, FAKEHD_POSE=centre, FAKEHD_LOG (file with a line for each call that
/// matters for the order of teardown). Also:
///
/// - FAKEHD_RECORD: file of a FakeRecord, with the force at the motors over time
/// - FAKEHD_AFTER_PUSH: all ticks of the story count from the first force at the motors
/// - FAKEHD_PRESS: six numbers, mm: start of the tip, and where it presses
/// - FAKEHD_HANG_LOCKED: the hanging function holds the library's lock, so that every other call hangs, too
/// - FAKEHD_CRASH: function that ends the process at FAKEHD_HANG_AT_TICK, by FAKEHD_CRASH_SIGNAL or exit(0)
/// - FAKEHD_CRASH_BY: ... in another way: exit, quick_exit, _exit, abort, throw, segv, overflow, fpe, or the
///   name of a signal; without the library's lock, unless FAKEHD_HANG_LOCKED. FAKEHD_CRASH=thread: in another
///   thread of the library
/// - FAKEHD_BUTTONS: mask of the buttons that are pressed; FAKEHD_PRESS_TICKS: only in these ticks of every
///   twice as many
/// - FAKEHD_ONCE: no other process can open the device after the first
/// - FAKEHD_FORKS: a process with a session of its own is left behind
/// - FAKEHD_PRINTS: prints this number of bytes when the device is opened
/// - FAKEHD_FAULT: FUNCTION:TICK:TIMES:ERROR (times -1: forever; the error in hexadecimal digits)
/// - FAKEHD_DIE_AT_TICK: the servo thread stops calling
/// - FAKEHD_LIE: pose from FAKEHD_LIE_AT_TICK on: nan, zero, mirrored, huge, frozen, inches or swapped (axes)
/// - FAKEHD_MAX_FORCE: force that the device claims to render, N
/// - FAKEHD_LATE_CALLBACKS: calls a task after its removal, which uses its device
extern "C" {

/// The fake hand's pose in a tick.
struct FakePose {
  double joints_rad[3];
  double gimbal_rad[3];  ///< true angles; FakeGimbal distorts the reported ones
  int usePosition;       ///< 1: `position_mm` replaces the position from the joints
  double position_mm[3];
};
/// Called in the servo thread before each tick with the force being rendered (N, device frame).
using FakePoseFunction = void (*)(void* context, std::int64_t tick, const double* force_N, FakePose* pose);
/// Called in the servo thread immediately before (1) and after (0) each callback.
using FakeHook = void (*)(void* context, int before);

/// An entry of the call log.
struct FakeCall {
  const char* function;
  std::int64_t tick;  ///< ticks started
  int onServoThread;  ///< 1: in the fake's servo thread
};

/// Resets to a calibrated Touch with a manual clock; clears faults, logs and errors. Not while a servo is
/// running.
void fakehd_reset();
/// Sets whether there is a device (default 1).
void fakehd_set_present(int present);
/// Makes hdInitDevice return this handle without an error (default -1: handles start at 0).
void fakehd_set_garbage_handle(std::int64_t handle);
/// Accepts only this name; "" for the default device only; null for every name (default).
void fakehd_set_only_name(const char* name);
void fakehd_set_model(const char* model);
/// reported = (true - offset) / scale for each gimbal angle.
void fakehd_set_gimbal(const double* scale, const double* offset_rad);
/// Sets a number returned by hdGetDoublev or hdGetIntegerv.
void fakehd_set_number(std::uint32_t name, const double* values, int count);

void fakehd_set_pose(const FakePose* pose);
void fakehd_set_pose_function(FakePoseFunction function, void* context);
/// 1: the force output is on, and hdDisable has no effect.
void fakehd_set_stuck_force(int stuck);
void fakehd_set_buttons(std::int32_t mask);
void fakehd_set_temperature(const double* values, int count);
/// Sets HD_CALIBRATION_OK ... ; a stylus in the inkwell turns "manual input" into "update".
void fakehd_set_calibration(std::uint32_t state);
void fakehd_dock(int docked);

/// Makes calls of `function`, after `skip` more, push `error`, `times` times (-1: forever).
void fakehd_fault(const char* function, int skip, int times, std::uint32_t error, std::int32_t internal);
/// Pushes an error as if it had just occurred.
void fakehd_push_error(std::uint32_t error, std::int32_t internal);
/// Makes every further call fail with a communication error; the state is frozen and hdStopScheduler blocks.
void fakehd_unplug();
/// Stops callbacks of the servo thread without an error.
void fakehd_die();
/// Remembers the first task; call_kept() calls its callback, like a library that unschedules too late.
void fakehd_keep_task();
void fakehd_call_kept();
/// Unblocks hdStopScheduler and plugs the device in again.
void fakehd_replug();

/// Runs ticks in the fake's servo thread and waits for them.
void fakehd_run(int ticks);
/// Manual clock: sets the advance per tick, us (default 1000); advances the clock.
void fakehd_set_tick_us(std::int64_t period_us);
void fakehd_advance_us(std::int64_t step_us);
std::int64_t fakehd_now_us();
void fakehd_set_hook(FakeHook hook, void* context);
/// 1: real time at 1 kHz from the next hdStartScheduler on.
void fakehd_set_real_time(int real);

int fakehd_log_count();
FakeCall fakehd_log_entry(int index);
int fakehd_calls(const char* function);
/// Returns the number of device calls from other threads than the servo's while the scheduler was running.
int fakehd_off_thread();
/// Returns the number of broken frame rules: unpaired ends, second frames, setters outside, unknown types.
int fakehd_rule_breaks();
int fakehd_callbacks();
int fakehd_running();
int fakehd_errors_pending();
/// Returns how often the library was loaded into this process.
int fakehd_loads();
/// Returns the force rendered by the motors, device frame, N: zero unless scheduler and output are on.
void fakehd_force(double* force_N);
/// Returns the force of the last complete frame, rendered or not.
void fakehd_commanded(double* force_N);
int fakehd_force_enabled();
}
