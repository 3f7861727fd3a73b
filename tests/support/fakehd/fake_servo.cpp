// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <pthread.h>
#include <sched.h>
#include <unistd.h>
#include <utility>

#include "tests/support/fakehd/fake_state.h"

namespace fakehd {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix multiplied(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        c[i][j] += a[i][k] * b[k][j];
      }
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

/// Joint angles of a Touch whose gimbal is at this position; those of the pose where it cannot be.
std::array<double, 3> jointsAt(const std::array<double, 3>& position_mm, const FakePose& pose) {
  constexpr double kLink_mm = 133.35;
  constexpr double kHalfTurn_rad = 1.5707963267948966;
  const auto [x, y, z] = position_mm;
  const double u = std::hypot(x, z + 168.35) / kLink_mm;
  const double v = (y - 23.35) / kLink_mm;
  const double reach = std::hypot(u, v);
  if (!(reach < 2.0)) {
    return std::to_array(pose.joints_rad);
  }
  const double middle = std::atan2(v, u);
  const double half = std::acos(0.5 * reach);
  return {std::atan2(-x, z + 168.35), middle + half, middle - half + kHalfTurn_rad};
}

void place(Fake& f) {
  const FakePose& p = f.pose;
  const auto [q1, q2, q3] = std::to_array(p.joints_rad);
  constexpr double kLink_mm = 133.35;
  const double reach = kLink_mm * (std::cos(q2) + std::sin(q3));
  std::array<double, 3> position{-std::sin(q1) * reach, kLink_mm * (std::sin(q2) - std::cos(q3)) + 23.35,
                                 std::cos(q1) * reach - 168.35};
  if (p.usePosition != 0) {
    position = std::to_array(p.position_mm);
  }
  const std::array<double, 3> joints =
      p.usePosition != 0 ? jointsAt(position, p) : std::to_array(p.joints_rad);
  const Matrix r = multiplied(
      multiplied(turnY(-q1), turnX(-q3)),
      multiplied(turnY(p.gimbal_rad[0]), multiplied(turnX(-p.gimbal_rad[1]), turnZ(-p.gimbal_rad[2]))));
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      f.now.transform[4 * c + i] = r[i][c];
    }
    f.now.transform[12 + c] = position[c];
    f.now.joints[c] = joints[c];
    f.now.gimbal[c] = (p.gimbal_rad[c] - f.gimbalOffset[c]) / f.gimbalScale[c];
  }
  f.now.transform[15] = 1.0;
  const bool pressed = f.pressTicks <= 0 || (f.tick / f.pressTicks) % 2 == 1;
  f.now.buttons = pressed ? f.buttons : 0;
}

/// Moves from its start within 0.3 s, then presses and slackens slightly, twice per second.
void press(Fake& f) {
  constexpr double kComes_ticks = 300.0;
  constexpr double kPi = 3.141592653589793;
  const double t = static_cast<double>(f.tick.load());
  const double way = t < kComes_ticks ? t / kComes_ticks
                                      : 1.0 - 0.01 * (1.0 - std::cos(2.0 * kPi * (t - kComes_ticks) / 500.0));
  f.pose = {{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  for (std::size_t c = 0; c < 3; ++c) {
    f.pose.position_mm[c] = f.press_mm[c] + way * (f.press_mm[3 + c] - f.press_mm[c]);
  }
}

void lieAboutPose(Fake& f) {
  auto& transform = f.now.transform;
  if (f.lie == "nan") {
    transform[12] = std::nan("");
  } else if (f.lie == "zero") {
    transform = {};
  } else if (f.lie == "mirrored") {
    for (std::size_t i = 0; i < 3; ++i) {
      transform[i] = -transform[i];
    }
  } else if (f.lie == "huge") {
    transform[12] = transform[13] = transform[14] = 1e300;
  } else if (f.lie == "inches") {
    for (std::size_t i = 12; i < 15; ++i) {
      transform[i] /= 25.4;
    }
  } else if (f.lie == "swapped") {
    std::swap(transform[13], transform[14]);
  } else if (f.lie == "frozen") {
    f.now.gimbal[2] = 0.001 * static_cast<double>(storyTick(f) - f.lieAtTick);
    std::copy(f.latched.transform.begin() + 12, f.latched.transform.begin() + 15, transform.begin() + 12);
  }
}

void tellStory(Fake& f) {
  const std::int64_t tick = storyTick(f);
  if (f.dockAtTick >= 0 && tick >= f.dockAtTick) {
    f.docked = true;
    f.pose = kInkwellPose;
    if (f.calibration == hd::kCalibrationNeedsManualInput) {
      f.calibration = hd::kCalibrationNeedsUpdate;
    }
  }
  if (f.unplugAtTick >= 0 && tick >= f.unplugAtTick) {
    f.unplugged = true;
    seeFault(f);
    seeMotors(f);
  }
  if (f.dieAtTick >= 0 && tick >= f.dieAtTick) {
    f.dead = true;
    seeFault(f);
  }
  if (f.presses) {
    press(f);
  }
  misbehaveElsewhere(f);
}

}  // namespace

std::array<double, 3> rendered(const Fake& f) {
  return f.running && f.forceEnabled && !f.unplugged ? f.commanded : std::array<double, 3>{};
}

bool unschedule(Fake& f, hd::SchedulerHandle handle) {
  for (int k = 0; k < f.taskCount; ++k) {
    if (f.tasks[static_cast<std::size_t>(k)].handle != handle) {
      continue;
    }
    for (int m = k; m + 1 < f.taskCount; ++m) {
      f.tasks[static_cast<std::size_t>(m)] = f.tasks[static_cast<std::size_t>(m + 1)];
    }
    --f.taskCount;
    return true;
  }
  return false;
}

hd::SchedulerHandle schedule(Fake& f, hd::SchedulerCallback callback, void* userData, hd::UShort priority,
                             bool once) {
  if (f.taskCount == kMaxTasks) {
    push(f, hd::kSchedulerFull, 0);
    return 0;
  }
  int at = 0;
  while (at < f.taskCount && f.tasks[static_cast<std::size_t>(at)].priority >= priority) {
    ++at;
  }
  for (int k = f.taskCount; k > at; --k) {
    f.tasks[static_cast<std::size_t>(k)] = f.tasks[static_cast<std::size_t>(k - 1)];
  }
  f.tasks[static_cast<std::size_t>(at)] = {f.nextTask, callback, userData, priority, once};
  ++f.taskCount;
  return f.nextTask++;
}

namespace {

/// One tick: the hand moves, then every task runs in decreasing priority.
void runTick(Fake& f) {
  if (f.dead) {
    return;
  }
  std::array<Task, kMaxTasks> tasks;
  int count = 0;
  FakePoseFunction move = nullptr;
  {
    const Guard guard(f.spin);
    ++f.tick;
    if (f.record != nullptr) {
      f.record->ticks = f.tick.load();
    }
    if (!f.real) {
      f.now_us += f.period_us.load();
    }
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
    if (!f.unplugged) {
      place(f);
      if (!f.lie.empty() && storyTick(f) >= f.lieAtTick) {
        seeFault(f);
        lieAboutPose(f);
      }
    }
    if (f.dead) {
      return;
    }
  }
  for (int i = 0; i < count; ++i) {
    const Task& task = tasks[static_cast<std::size_t>(i)];
    if (f.hook != nullptr) {
      f.hook(f.hookContext, 1);
    }
    const hd::CallbackCode answer = task.callback(task.userData);
    if (f.hook != nullptr) {
      f.hook(f.hookContext, 0);
    }
    if (answer == hd::kCallbackContinue && !task.once) {
      continue;
    }
    const Guard guard(f.spin);
    (void)unschedule(f, task.handle);
  }
}

/// Returns the number of unserved tasks of hdScheduleSynchronous.
int waitingTasks(Fake& f) {
  const Guard guard(f.spin);
  int waiting = 0;
  for (int k = 0; k < f.taskCount; ++k) {
    waiting += f.tasks[static_cast<std::size_t>(k)].once ? 1 : 0;
  }
  return waiting;
}

}  // namespace

void servoLoop(Fake& f) {
  f.servo = std::this_thread::get_id();
  if (f.real) {
    // Like the vendor's own thread: higher priority if the system permits it.
    sched_param rank{};
    rank.sched_priority = 70;
    (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &rank);
  }
  if (f.record != nullptr) {
    f.record->servo = gettid();
  }
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
    if (f.stop) {
      break;
    }
    lock.unlock();
    runTick(f);
    lock.lock();
    if (f.pendingTicks > 0) {
      --f.pendingTicks;
    }
    f.pendingOnce = waitingTasks(f);
    f.changed.notify_all();
  }
  f.servo = std::thread::id{};
}

}  // namespace fakehd
