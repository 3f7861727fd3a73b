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

/// The inside of the fake vendor library: its state, its servo thread and the bookkeeping of its calls. State
/// that callbacks reach is behind a spin lock, so that the servo path of the fake itself never takes a system
/// lock.
namespace fakehd {

namespace hd = torsio::hd;

class SpinLock {
 public:
  void lock() noexcept {
    // Not a yield alone: whoever holds it may have to let a thread of higher rank go first.
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

// Joint and gimbal angles of a Touch whose stylus rests in the inkwell, as published in a recording.
constexpr FakePose kInkwellPose{{0.0, 0.26889, -0.370813}, {0.000108409, 0.797273, -1.94046}, 0, {}};
constexpr int kMaxErrors = 64;
constexpr int kMaxCalls = 1 << 16;
constexpr int kMaxTasks = 16;

/// What a Touch answers.
std::map<hd::Enum, std::vector<double>> usualNumbers();

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
  std::string hangIn;       // the function that never returns ...
  int hangAtTick = 0;       // ... from this tick on
  bool hangLocked = false;  // ... and holds the library's lock
  std::string crashIn;      // the function that ends the process at that tick ...
  int crashSignal = 0;      // ... by this signal; 0: by exit()
  int dieAtTick = -1;       // the servo thread calls nobody any more
  std::string lie;          // what it says of the pose ...
  int lieAtTick = 0;        // ... from this tick on
  bool lateCallbacks = false;
  std::array<double, 6> press_mm{};  // where the tip comes from and where it presses
  bool presses = false;
  FakeRecord* record = nullptr;  // null: nobody asks
  bool faultSeen = false;
  bool pushed = false;
  bool afterPush = false;  // the story's ticks count from the first force on
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
  std::atomic<bool> dead{false};  // the servo thread calls nobody any more
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

Fake& fake();
int loads();

void push(Fake& f, hd::ErrorCode error, std::int32_t internal);
/// Pushes an error and counts that a rule was broken.
void breakRule(Fake& f, hd::ErrorCode error);
bool onServoThread(const Fake& f);
/// One line into the file that FAKEHD_LOG names.
void writeLog(const Fake& f, const char* line);
/// The tick of the story; negative: it has not begun.
std::int64_t storyTick(const Fake& f);
/// What the record is told, with the time.
void see(Fake& f, Seen what);
/// The story's fault has begun.
void seeFault(Fake& f);
/// Whether the motors have a force, after whatever may have changed that.
void seeMotors(Fake& f);
/// Bookkeeping of one call. False when a fault was scripted for it, or the cable is out: it then does
/// nothing.
bool enter(Fake& f, const char* function, bool deviceCall = true);
/// The force that the motors render.
std::array<double, 3> rendered(const Fake& f);
void readEnvironment(Fake& f);

/// The servo thread.
void servoLoop(Fake& f);
hd::SchedulerHandle schedule(Fake& f, hd::SchedulerCallback callback, void* userData, hd::UShort priority,
                             bool once);
bool unschedule(Fake& f, hd::SchedulerHandle handle);

}  // namespace fakehd
