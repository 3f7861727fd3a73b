// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// Controls of the fake vendor library: a shared object with the interface of libHD (global error stack,
/// frames, priorities, handle 0 first, type checks, thread checks) and these further exports. One process,
/// one fake; fakehd_reset() before each test. Calls of the controls belong to the test's thread.
///
/// Without fakehd_reset() the fake runs in real time and takes its story from the environment, for tests of
/// the whole program: FAKEHD_NO_DEVICE, FAKEHD_NO_LICENCE, FAKEHD_MODEL, FAKEHD_CALIBRATION=ok|update|dock,
/// FAKEHD_HANG=hdEndFrame and FAKEHD_HANG_AT_TICK (that function never returns from then on),
/// FAKEHD_DOCK_AT_TICK, FAKEHD_UNPLUG_AT_TICK, FAKEHD_TICK_US, FAKEHD_POSE=centre, FAKEHD_LOG (file that gets
/// a line for each call that matters for the order of teardown). Also
///
/// FAKEHD_RECORD        file of a FakeRecord: what the motors had, and when
/// FAKEHD_AFTER_PUSH    all ticks of the story count from the first force at the motors
/// FAKEHD_PRESS         six numbers, mm: where the tip comes from and where it presses
/// FAKEHD_HANG_LOCKED   what hangs holds the library's lock: every other call hangs, too
/// FAKEHD_CRASH         function that ends the process at FAKEHD_HANG_AT_TICK, by FAKEHD_CRASH_SIGNAL or
/// exit(0) FAKEHD_FAULT         FUNCTION:TICK:TIMES:ERROR (times -1: for ever; the error in hexadecimal
/// digits) FAKEHD_DIE_AT_TICK   the servo thread calls nobody any more FAKEHD_LIE           nan, zero,
/// mirrored, huge, frozen: of the pose, from FAKEHD_LIE_AT_TICK on FAKEHD_MAX_FORCE     what the device
/// claims to render, N FAKEHD_LATE_CALLBACKS  calls a task that was taken out, and the device with it
extern "C" {

/// What the fake's hand does in one tick.
struct FakePose {
  double joints_rad[3];
  double gimbal_rad[3];  ///< as a Touch has them; FakeGimbal distorts what is reported
  int usePosition;       ///< 1: `position_mm` replaces the position that the joints mean
  double position_mm[3];
};
/// Called in the servo thread before each tick with the force that the device now renders (N, device frame).
using FakePoseFunction = void (*)(void* context, std::int64_t tick, const double* force_N, FakePose* pose);
/// Called in the servo thread immediately before (1) and after (0) each callback.
using FakeHook = void (*)(void* context, int before);

/// One entry of the call log.
struct FakeCall {
  const char* function;
  std::int64_t tick;  ///< ticks that have begun
  int onServoThread;  ///< 1: within the fake's servo thread
};

/// Back to a calibrated Touch with a manual clock; forgets faults, logs and errors. Not while a servo runs.
void fakehd_reset();
/// Whether there is a device (default 1).
void fakehd_set_present(int present);
/// hdInitDevice returns this handle without pushing any error (default -1: handles count from 0).
void fakehd_set_garbage_handle(std::int64_t handle);
/// Only this name opens the device; "" for the default device only; null for every name (default).
void fakehd_set_only_name(const char* name);
void fakehd_set_model(const char* model);
/// reported = (true - offset) / scale for each gimbal angle.
void fakehd_set_gimbal(const double* scale, const double* offset_rad);
/// A number that hdGetDoublev or hdGetIntegerv gives.
void fakehd_set_number(std::uint32_t name, const double* values, int count);

void fakehd_set_pose(const FakePose* pose);
void fakehd_set_pose_function(FakePoseFunction function, void* context);
/// 1: the force output is on and hdDisable does not change it.
void fakehd_set_stuck_force(int stuck);
void fakehd_set_buttons(std::int32_t mask);
void fakehd_set_temperature(const double* values, int count);
/// HD_CALIBRATION_OK ... ; the stylus in the inkwell turns "manual input" into "update".
void fakehd_set_calibration(std::uint32_t state);
void fakehd_dock(int docked);

/// The next calls of `function`, after `skip` more, push `error`, `times` times (-1: for ever).
void fakehd_fault(const char* function, int skip, int times, std::uint32_t error, std::int32_t internal);
/// Pushes an error as if it had happened just now.
void fakehd_push_error(std::uint32_t error, std::int32_t internal);
/// From now on every call fails with a communication error, the state is frozen and hdStopScheduler blocks.
void fakehd_unplug();
/// From now on the servo thread calls no callback, without any error.
void fakehd_die();
/// Remembers the first task; call_kept() calls its callback, as a library does that unschedules too late.
void fakehd_keep_task();
void fakehd_call_kept();
/// Ends the blocking of hdStopScheduler and plugs the device in again.
void fakehd_replug();

/// Runs ticks in the fake's servo thread and returns after them.
void fakehd_run(int ticks);
/// Manual clock: what a tick advances it by (default 1000), and the clock itself.
void fakehd_set_tick_us(std::int64_t period_us);
void fakehd_advance_us(std::int64_t step_us);
std::int64_t fakehd_now_us();
void fakehd_set_hook(FakeHook hook, void* context);
/// 1: real time at 1 kHz from the next hdStartScheduler on.
void fakehd_set_real_time(int real);

int fakehd_log_count();
FakeCall fakehd_log_entry(int index);
int fakehd_calls(const char* function);
/// Device calls that came from another thread than the servo's while the scheduler ran.
int fakehd_off_thread();
/// Rules of the frame that were broken: unpaired ends, second frames, setters outside, unknown types.
int fakehd_rule_breaks();
int fakehd_callbacks();
int fakehd_running();
int fakehd_errors_pending();
/// How often the library was loaded into this process.
int fakehd_loads();
/// The force that the motors render now, device frame, N: zero unless scheduler and output are on.
void fakehd_force(double* force_N);
/// The force that the last complete frame carried, whether rendered or not.
void fakehd_commanded(double* force_N);
int fakehd_force_enabled();
}
