// SPDX-License-Identifier: GPL-3.0-or-later
// Every way in which the device process may end while the motors push: the force at the motors, as the fake
// library keeps it over the end of a process, is zero in the end.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/deadline.h"
#include "sim/device/process/device_process.h"
#include "tests/support/eventually.h"
#include "tests/support/fakehd/record_file.h"

namespace torsio {
namespace {

using namespace std::chrono_literals;
using fakehd::Seen;

class DeviceEnd : public ::testing::Test {
 protected:
  DeviceEnd() {
    (void)requestRealTime();  // a force that is renewed late ends
    setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1);
    setenv("FAKEHD_POSE", "centre", 1);
    setenv("FAKEHD_RECORD", path_.c_str(), 1);
    setenv("FAKEHD_AFTER_PUSH", "1", 1);
    setenv("FAKEHD_HANG_AT_TICK", "30", 1);
    unsetenv("FAKEHD_LOG");
  }
  ~DeviceEnd() override {
    for (const char* const name :
         {"FAKEHD_RECORD", "FAKEHD_AFTER_PUSH", "FAKEHD_HANG_AT_TICK", "FAKEHD_CRASH", "FAKEHD_CRASH_BY",
          "FAKEHD_HANG_LOCKED", "FAKEHD_ONCE", "FAKEHD_FORKS", "FAKEHD_PRINTS"}) {
      unsetenv(name);
    }
    device_.reset();
    std::filesystem::remove(path_);
  }

  void open() {
    StylusRequest request;
    request.library = TORSIO_FAKEHD;
    device_ = openStylus(request).driver;
    ASSERT_NE(device_, nullptr);
    opened_ns_ = deadlineNow_ns();
    device_->enableForce(true);
    device_->serve();
  }
  /// Renews a force, as a servo does, until `over` or for ten seconds.
  template <typename Condition>
  bool pushUntil(const Condition& over) {
    return testing::eventually(
        [&] {
          device_->write({{0.5, 0.0, 0.0}, 0});
          return over();
        },
        10s);
  }
  /// Pushes until the fault, and on until the motors have no force; how long that took. Negative when a
  /// machine under test held the hand up so long that there was none at the fault.
  double restAfter_ms() {
    EXPECT_TRUE(pushUntil([this] { return record_.first(Seen::kFault, opened_ns_) != nullptr; }));
    EXPECT_TRUE(pushUntil([this] { return record_->motors_uN == 0; }));
    const fakehd::SeenEvent* const fault = record_.first(Seen::kFault, opened_ns_);
    const fakehd::SeenEvent* const rest =
        fault != nullptr ? record_.first(Seen::kRest, fault->time_ns) : nullptr;
    return rest != nullptr ? 1e-6 * static_cast<double>(rest->time_ns - fault->time_ns) : -1.0;
  }
  /// The motors push, and somebody sends the device process a signal.
  double restAfterSignal_ms(int signal) {
    EXPECT_TRUE(pushUntil([this] { return record_->motors_uN > 0; }));
    const std::int64_t sent_ns = deadlineNow_ns();
    kill(static_cast<pid_t>(record_->process), signal);
    EXPECT_TRUE(pushUntil([this] { return record_->motors_uN == 0; }));
    const fakehd::SeenEvent* const rest = record_.last(Seen::kRest);
    return rest != nullptr ? 1e-6 * static_cast<double>(rest->time_ns - sent_ns) : -1.0;
  }
  void expectLost() {
    EXPECT_TRUE(testing::eventually([this] { return device_->snapshot().state == DeviceState::kLost; }, 5s));
    EXPECT_NE(device_->read(0).status & kDeviceLost, 0U);
  }

  std::string path_ = ::testing::TempDir() + "device_end_record_" + std::to_string(getpid());
  fakehd::RecordFile record_{path_};
  std::int64_t opened_ns_ = 0;
  std::unique_ptr<HapticDevice> device_;
};

/// How it ends, and where: in a frame of the servo, there with the library's lock, in another thread.
struct Ending {
  const char* by;
  const char* where;
  bool locked;
};

class DeviceEndsBy : public DeviceEnd, public ::testing::WithParamInterface<Ending> {};

TEST_P(DeviceEndsBy, ItselfAndTheLastForceBecomesZero) {
  setenv("FAKEHD_CRASH", GetParam().where, 1);
  setenv("FAKEHD_CRASH_BY", GetParam().by, 1);
  if (GetParam().locked) {
    setenv("FAKEHD_HANG_LOCKED", "1", 1);
  }
  double took_ms = -1.0;
  for (int attempt = 0; attempt < 5 && took_ms < 0.0; ++attempt) {
    device_.reset();
    open();
    took_ms = restAfter_ms();
  }

  EXPECT_GE(took_ms, 0.0) << "the motors never pushed";
  EXPECT_LT(took_ms, 5000.0);
  RecordProperty("rest_ms", static_cast<int>(took_ms));
  EXPECT_EQ(record_->motors_uN, 0);
  expectLost();
  EXPECT_NE(device_->lossText(device_->snapshot().lostBecause).str().find("switched its force off"),
            std::string::npos)
      << device_->lossText(device_->snapshot().lostBecause).str();
  EXPECT_FALSE(device_->snapshot().forceOn);
}

std::vector<Ending> endings() {
  std::vector<Ending> all;
  for (const char* const by :
       {"exit", "quick_exit", "_exit", "abort", "throw", "segv", "overflow", "fpe", "SIGALRM", "SIGSTOP",
        "SIGQUIT", "SIGUSR1", "SIGKILL", "SIGBUS", "SIGILL", "SIGIO"}) {
    all.push_back({by, "hdEndFrame", false});
    all.push_back({by, "hdEndFrame", true});
    all.push_back({by, "thread", false});
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Endings, DeviceEndsBy, ::testing::ValuesIn(endings()), [](const auto& ending) {
  return std::string(ending.param.by) + "_" + ending.param.where + (ending.param.locked ? "_locked" : "");
});

TEST_F(DeviceEnd, WhenAnybodySendsItASignalTheLastForceBecomesZero) {
  for (const int signal : {SIGKILL, SIGSTOP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGABRT, SIGRTMIN}) {
    open();
    const double took_ms = restAfterSignal_ms(signal);
    EXPECT_GE(took_ms, 0.0) << signal;
    RecordProperty("rest_ms_" + std::to_string(signal), static_cast<int>(took_ms));
    expectLost();
    device_.reset();
  }
}

TEST_F(DeviceEnd, SignalsOfATerminalEndNothing) {
  open();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGTTOU}) {
    EXPECT_TRUE(pushUntil([this] { return record_->motors_uN > 0; }));
    kill(static_cast<pid_t>(record_->process), signal);
  }
  EXPECT_FALSE(pushUntil([this, since = std::chrono::steady_clock::now()] {
                 return device_->snapshot().state == DeviceState::kLost ||
                        std::chrono::steady_clock::now() - since > 300ms;
               }) &&
               device_->snapshot().state == DeviceState::kLost);
  EXPECT_TRUE(device_->close());
}

TEST_F(DeviceEnd, ALibraryThatCannotBeOpenedTwiceIsSaidInWordsWithWhatToDo) {
  setenv("FAKEHD_ONCE", "1", 1);
  setenv("FAKEHD_CRASH", "hdEndFrame", 1);
  setenv("FAKEHD_CRASH_BY", "SIGKILL", 1);
  open();
  ASSERT_TRUE(pushUntil([this] { return device_->snapshot().state == DeviceState::kLost; }));

  const std::string said = device_->lossText(device_->snapshot().lostBecause).str();

  EXPECT_NE(said.find("in use already"), std::string::npos) << said;
  EXPECT_NE(said.find("let go of the stylus and switch the device off"), std::string::npos) << said;
  EXPECT_TRUE(device_->snapshot().forceOn) << "nobody knows that it is off";
}

TEST_F(DeviceEnd, TheLastGaspAloneIsEnoughWhereTheLibraryCannotBeOpenedTwice) {
  setenv("FAKEHD_ONCE", "1", 1);
  for (const char* const by :
       {"exit", "quick_exit", "abort", "throw", "segv", "overflow", "fpe", "SIGALRM", "SIGQUIT", "SIGUSR1"}) {
    std::filesystem::remove(path_);
    const fakehd::RecordFile fresh(path_);
    setenv("FAKEHD_CRASH", "hdEndFrame", 1);
    setenv("FAKEHD_CRASH_BY", by, 1);
    open();
    EXPECT_TRUE(pushUntil([&] { return fresh.first(Seen::kFault) != nullptr; })) << by;
    EXPECT_TRUE(pushUntil([&] { return fresh->motors_uN == 0; })) << by;
    device_.reset();
  }
}

TEST_F(DeviceEnd, WhatALibraryLeavesBehindIsEnded) {
  setenv("FAKEHD_FORKS", "1", 1);
  for (const bool crashes : {false, true}) {
    setenv("FAKEHD_CRASH", crashes ? "hdEndFrame" : "", 1);
    setenv("FAKEHD_CRASH_BY", "SIGKILL", 1);
    open();
    const auto orphan = static_cast<pid_t>(record_->orphan);
    ASSERT_GT(orphan, 0);
    ASSERT_EQ(kill(orphan, 0), 0);
    if (crashes) {
      (void)restAfter_ms();
    }
    device_.reset();

    const std::string state = "/proc/" + std::to_string(orphan) + "/stat";
    EXPECT_TRUE(testing::eventually(
        [&] {
          std::ifstream file(state);
          const std::string all{std::istreambuf_iterator<char>(file), {}};
          return all.empty() || all.find(") Z") != std::string::npos;
        },
        2s));
  }
}

TEST_F(DeviceEnd, HundredMegabytesThatALibraryPrintsDoNotReachTheTerminal) {
  setenv("FAKEHD_PRINTS", "100000000", 1);
  const std::string heard = path_ + "_output";
  const int file = ::open(heard.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  ASSERT_GE(file, 0);
  const int out = dup(STDOUT_FILENO);
  const int err = dup(STDERR_FILENO);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  open();
  const bool closed = device_->close();
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  for (const int number : {file, out, err}) {
    ::close(number);
  }

  EXPECT_TRUE(closed);
  EXPECT_EQ(std::filesystem::file_size(heard), 0U);
  std::filesystem::remove(heard);
}

}  // namespace
}  // namespace torsio
