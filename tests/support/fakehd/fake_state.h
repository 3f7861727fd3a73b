// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "sim/device/hdapi/hdapi_abi.h"
#include "tests/support/fakehd/fake_record.h"
#include "tests/support/fakehd/fakehd.h"

/// The internals of the fake vendor library: state, servo thread and bookkeeping of calls. State used by
/// callbacks is protected by a spin lock, so that the fake's servo path never takes a system lock.
namespace fakehd {

namespace hd = torsio::hd;

class SpinLock {
 public:
  void lock() noexcept {
    // Not only a yield: the holder may have to wait for a thread of higher priority.
    while (flag_.test_and_set(std::memory_order_acquire)) {
      std::this_thread::sleep_for(std::chrono::microseconds(20));
    }
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
  std::int64_t fromTick = 0;
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

// Joint and gimbal angles of a Touch with its stylus in the inkwell, from a published recording.
constexpr FakePose kInkwellPose{{0.0, 0.26889, -0.370813}, {0.000108409, 0.797273, -1.94046}, 0, {}};
constexpr int kMaxErrors = 64;
constexpr int kMaxCalls = 1 << 16;
constexpr int kMaxTasks = 16;

/// Returns the answers of a Touch.
std::map<hd::Enum, std::vector<double>> usualNumbers();

struct Fake {
  SpinLock spin;  // protects everything below, unless stated otherwise

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
  int pressTicks = 0;
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
  std::string hangIn;       // function that hangs
  int hangAtTick = 0;       // from this tick on
  bool hangLocked = false;  // while holding the library's lock
  std::string crashIn;      // function that ends the process at that tick
  int crashSignal = 0;      // by this signal; 0: by exit()
  std::string crashBy;      // in this way instead
  bool crashed = false;     // by another thread
  bool onlyOnce = false;    // another process opened it
  int dieAtTick = -1;       // the servo thread stops calling
  std::string lie;          // falsified pose
  int lieAtTick = 0;        // from this tick on
  bool lateCallbacks = false;
  std::array<double, 6> press_mm{};  // start of the tip and where it presses
  bool presses = false;
  FakeRecord* record = nullptr;  // null: not recording
  bool faultSeen = false;
  bool pushed = false;
  bool afterPush = false;  // the story's ticks count from the first force
  std::int64_t pushTick = -1;

  // Library.
  std::array<hd::ErrorInfo, kMaxErrors> errors{};
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
  std::array<Task, kMaxTasks> tasks{};
  int taskCount = 0;
  Task kept;
  hd::SchedulerHandle nextTask = 1;
  std::array<FakeCall, kMaxCalls> log{};
  int logCount = 0;
  std::map<std::string, int, std::less<>> counts;
  int offThread = 0;
  int ruleBreaks = 0;
  std::atomic<std::int64_t> tick{0};
  std::atomic<std::int64_t> now_us{0};
  std::atomic<std::int64_t> period_us{1000};
  std::atomic<bool> unplugged{false};
  std::atomic<bool> running{false};
  std::atomic<bool> dead{false};  // the servo thread stops calling
  std::atomic<bool> real{true};
  std::atomic<std::thread::id> servo{};

  // Synchronises test and servo thread; never taken in a callback.
  std::mutex mutex;
  std::condition_variable changed;
  std::thread thread;
  bool stop = false;
  int pendingTicks = 0;
  int pendingOnce = 0;
};

Fake& fake();
int loads();

void push(Fake& f, hd::ErrorCode error, std::int32_t internal);
/// Pushes an error and counts a broken rule.
void breakRule(Fake& f, hd::ErrorCode error);
bool onServoThread(const Fake& f);
/// Writes a line to the file named by FAKEHD_LOG.
void writeLog(const Fake& f, const char* line);
/// Returns the tick of the story; negative: not started.
std::int64_t storyTick(const Fake& f);
/// Adds an event with its time to the record.
void see(Fake& f, Seen what);
/// Records the start of the story's fault.
void seeFault(Fake& f);
/// Updates whether the motors have a force; call after any change.
void seeMotors(Fake& f);
/// Records a call. False if a fault is scripted for it or the cable is unplugged: it must then do nothing.
bool enter(Fake& f, const char* function, bool deviceCall = true);
/// Returns the force rendered by the motors.
std::array<double, 3> rendered(const Fake& f);
void readEnvironment(Fake& f);
/// Ends the process in another thread, if the story says so. Call with the lock.
void misbehaveElsewhere(Fake& f);

/// Runs the servo thread.
void servoLoop(Fake& f);
hd::SchedulerHandle schedule(Fake& f, hd::SchedulerCallback callback, void* userData, hd::UShort priority,
                             bool once);
bool unschedule(Fake& f, hd::SchedulerHandle handle);

}  // namespace fakehd
