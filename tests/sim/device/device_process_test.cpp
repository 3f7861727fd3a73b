// SPDX-License-Identifier: GPL-3.0-or-later
// The driver in a process of its own against the fake library, which runs in real time there and writes what
// matters into a file. The program under test is torsio-device itself.
#include "sim/device/process/device_process.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/deadline.h"
#include "sim/core/error.h"
#include "sim/device/drivers/device_list.h"
#include "sim/device/hdapi/hdapi_device.h"
#include "sim/device/process/device_channel.h"
#include "tests/support/eventually.h"
#include "tests/support/fakehd/record_file.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class DeviceProcess : public ::testing::Test {
 protected:
  DeviceProcess() {
    std::ofstream(log_).flush();
    setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1);
    setenv("FAKEHD_LOG", log_.c_str(), 1);
    setenv("FAKEHD_POSE", "centre", 1);
    unsetenv("FAKEHD_HANG");
  }
  ~DeviceProcess() override {
    unsetenv("FAKEHD_HANG");
    unsetenv("FAKEHD_RECORD");
    std::filesystem::remove(record_);
  }

  static StylusRequest request() {
    StylusRequest request;
    request.library = TORSIO_FAKEHD;
    return request;
  }
  [[nodiscard]] std::string calls() const {
    std::ifstream file(log_);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Renews a force of 0.5 N until the motors have it.
  void push(HapticDevice& device) const {
    const auto until = Clock::now() + 10s;
    while (calls().find("\nforce\n") == std::string::npos && Clock::now() < until) {
      device.write({{0.5, 0.0, 0.0}, 0});
      std::this_thread::sleep_for(1ms);
    }
  }
  void expectOrder() const {
    const std::string all = calls();
    const std::vector<std::size_t> places{all.rfind("zero force"), all.rfind("force output off"),
                                          all.rfind("hdStopScheduler"), all.rfind("hdDisableDevice")};
    EXPECT_EQ(std::count(places.begin(), places.end(), std::string::npos), 0) << all;
    EXPECT_TRUE(std::is_sorted(places.begin(), places.end())) << all;
  }

  std::chrono::nanoseconds killed(std::chrono::microseconds after);

  std::string record_ = ::testing::TempDir() + "device_process_record_" + std::to_string(getpid());
  std::string log_ = ::testing::TempDir() + "device_process_calls_" + std::to_string(getpid());
};

TEST_F(DeviceProcess, ServesReadingsAndForcesAndLetsGoInOrder) {
  const StylusOpening opening = openStylus(request());
  ASSERT_NE(opening.driver, nullptr) << opening.library.sentence;
  EXPECT_EQ(opening.driver->identity().serial, "000123");
  EXPECT_EQ(opening.driver->capabilities().maxForce_N, 3.3);
  opening.driver->enableForce(true);
  opening.driver->serve();

  push(*opening.driver);
  const auto since = Clock::now();
  while (!opening.driver->snapshot().forceOn && Clock::now() - since < 2s) {
    std::this_thread::sleep_for(1ms);  // a frame of the library publishes what it did after it was done
  }
  EXPECT_TRUE(opening.driver->snapshot().forceOn);
  EXPECT_EQ(opening.driver->read(0).status & kDeviceLost, 0U);

  EXPECT_TRUE(opening.driver->close());
  expectOrder();
}

/// Kills a program that renders force, `after` the first force; how long the motors kept it, without what the
/// threads of the device process waited for a processor: a machine under test may hold them up.
std::chrono::nanoseconds DeviceProcess::killed(std::chrono::microseconds after) {
  std::ofstream(log_).flush();
  std::filesystem::remove(record_);
  const fakehd::RecordFile record(record_);
  setenv("FAKEHD_RECORD", record_.c_str(), 1);
  const pid_t program = fork();
  if (program == 0) {
    (void)requestRealTime();  // a force that is renewed late ends
    const StylusOpening opening = openStylus(request());
    opening.driver->enableForce(true);
    opening.driver->serve();
    for (;;) {
      opening.driver->write({{0.5, 0.0, 0.0}, 0});
      std::this_thread::sleep_for(1ms);
    }
  }
  if (program < 0) {
    ADD_FAILURE() << "no process";  // kill() takes -1 for all of them
    return std::chrono::nanoseconds(0);
  }
  const auto waited = [&record] {
    const std::int64_t device = record->process;
    return fakehd::waited_ns(device, device) + fakehd::waited_ns(device, record->servo);
  };
  EXPECT_TRUE(testing::eventually([&record] { return record->motors_uN > 0; }, 10s));
  std::this_thread::sleep_for(after);
  const std::int64_t waitedBefore_ns = waited();
  const std::int64_t killed_ns = deadlineNow_ns();
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  EXPECT_TRUE(testing::eventually([&record] { return record.last(fakehd::Seen::kDisable) != nullptr; }, 2s));
  const fakehd::SeenEvent* const rest = record.first(fakehd::Seen::kRest, killed_ns);
  EXPECT_NE(rest, nullptr) << "it stopped pushing before it was killed, or never";
  return std::chrono::nanoseconds(
      rest == nullptr ? 0 : (rest->time_ns - killed_ns) - (rest->waited_ns - waitedBefore_ns));
}

TEST_F(DeviceProcess, LetsGoWithinTwentyMillisecondsWhenTheProgramIsKilledAtAnyInstant) {
  constexpr int kInstants = 10;
  std::chrono::nanoseconds slowest{0};
  for (int i = 0; i < kInstants; ++i) {
    const std::chrono::nanoseconds took = killed(std::chrono::microseconds(137 * i));
    EXPECT_LE(took, 20ms) << i;
    slowest = std::max(slowest, took);
    expectOrder();
  }
  RecordProperty("slowest_us", static_cast<int>(slowest.count() / 1000));
}

TEST(SharedValues, AreExchangedWithinAHundredMicrosecondsOfProcessorTime) {
  const auto processor_ns = [] {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1'000'000'000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec;
  };
  SharedValue<MailedReading> readings;
  SharedValue<MailedForce> forces;
  std::vector<std::int64_t> costs_ns;
  for (std::uint64_t i = 1; i <= 10'000; ++i) {
    const std::int64_t begun_ns = processor_ns();
    readings.publish({{}, i});
    const auto reading = readings.latest();
    forces.publish({{1.0, 2.0, 3.0}, reading ? reading->number : 0});
    const auto force = forces.latest();
    costs_ns.push_back(processor_ns() - begun_ns);
    ASSERT_TRUE(force && force->number == i && force->force_N.z == 3.0);
  }

  std::sort(costs_ns.begin(), costs_ns.end());
  EXPECT_LE(costs_ns[9'990], 100'000);
  RecordProperty("p999_ns", static_cast<int>(costs_ns[9'990]));
}

TEST(SharedValues, KeepTheReaderFreeWhenTheWriterDiedWhileWriting) {
  SharedValue<MailedForce> forces;
  EXPECT_FALSE(forces.latest());
  forces.publish({{1.0, 0.0, 0.0}, 1});
  *reinterpret_cast<std::uint64_t*>(&forces) += 1;  // the sequence stands first: odd while writing

  EXPECT_FALSE(forces.latest());
}

TEST(ChannelReports, ComeBackAsTheyWereSentAndNeverReadPastTheirEnd) {
  ChannelReport sent;
  sent.library.status = HdapiLoadStatus::kSymbolMissing;
  sent.library.missingSymbols = {"hdInitDevice", "hdEnable"};
  sent.happened = Text::tr("no haptic device could be opened: %1", Text::tr("the motors are warm"));
  sent.identity.notes = {Text::verbatim("a note")};
  const std::string bytes = packed(sent);

  const ChannelReport got = unpacked(bytes);

  EXPECT_EQ(got.library.status, HdapiLoadStatus::kSymbolMissing);
  EXPECT_EQ(got.library.missingSymbols, sent.library.missingSymbols);
  EXPECT_EQ(got.happened, sent.happened);
  EXPECT_EQ(got.happened.arguments().size(), 1U);
  EXPECT_EQ(got.identity.notes, sent.identity.notes);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_LE(unpacked(bytes.substr(0, length)).library.missingSymbols.size(), 2U);
  }
}

TEST_F(DeviceProcess, EndsALibraryThatHangsInAFrameAndReportsTheDeviceLost) {
  setenv("FAKEHD_HANG", "hdEndFrame", 1);
  setenv("FAKEHD_HANG_AT_TICK", "300", 1);
  const StylusOpening opening = openStylus(request());
  opening.driver->serve();
  const auto begun = Clock::now();
  while (opening.driver->snapshot().state != DeviceState::kLost && Clock::now() - begun < 5s) {
    std::this_thread::sleep_for(1ms);
  }

  EXPECT_EQ(opening.driver->snapshot().state, DeviceState::kLost);
  EXPECT_FALSE(opening.driver->snapshot().forceOn);
  EXPECT_NE(opening.driver->read(0).status & kDeviceLost, 0U);
  EXPECT_FALSE(opening.driver->close());
}

TEST_F(DeviceProcess, CanBeCancelledWhileTheLibraryHangsInOpening) {
  setenv("FAKEHD_HANG", "hdInitDevice", 1);
  setenv("FAKEHD_HANG_AT_TICK", "0", 1);
  StylusRequest hanging = request();
  const auto begun = Clock::now();
  hanging.cancelled = [begun] { return Clock::now() - begun > 200ms; };

  EXPECT_THROW((void)openStylus(hanging), Error);

  EXPECT_LT(Clock::now() - begun, 2s);
}

TEST_F(DeviceProcess, AnotherOpenWorksAfterALibraryThatDidNotLetGo) {
  setenv("FAKEHD_HANG", "hdStopScheduler", 1);
  setenv("FAKEHD_HANG_AT_TICK", "0", 1);
  StylusRequest stuck = request();
  stuck.options.patience_us = 200'000;
  const StylusOpening first = openStylus(stuck);
  first.driver->serve();
  EXPECT_FALSE(first.driver->close());
  unsetenv("FAKEHD_HANG");

  const StylusOpening second = openStylus(request());

  EXPECT_TRUE(second.driver->close());
}

TEST_F(DeviceProcess, SaysThatALibraryIsMissingInTheWordsOfTheLoader) {
  StylusRequest missing = request();
  missing.library = "/nowhere/libHD.so";

  const StylusOpening opening = openStylus(missing);

  EXPECT_EQ(opening.driver, nullptr);
  EXPECT_EQ(opening.library.status, HdapiLoadStatus::kNotFound);
  EXPECT_NE(opening.library.sentence.str().find("/nowhere/libHD.so"), std::string::npos);
  EXPECT_FALSE(opening.library.remedy.empty());
}

DeviceRequest anyRequest(const std::string& library) {
  DeviceRequest request;
  request.start.position_m = {0.14, 0.0, 0.2};
  request.workspaceCentre_m = {0.04, 0.0, 0.2};
  request.library = library;
  request.recorded.resize(1);
  return request;
}

/// The device process that was built beside the tests.
class DeviceDrivers : public ::testing::Test {
 protected:
  DeviceDrivers() { setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1); }
};

TEST_F(DeviceDrivers, L1_WhatNeedsNothingIsThereWithoutAnyHardware) {
  const DeviceRequest request = anyRequest("/nowhere/libHD.so");

  for (const DeviceDriver& driver : deviceDrivers()) {
    const DriverFinding found = driver.look(request);

    EXPECT_FALSE(driver.name.empty() || found.sentence.empty()) << driver.id;
    if (driver.use == DriverUse::kStation) {
      EXPECT_EQ(found.available, found.remedy.empty()) << driver.id;
      continue;
    }
    EXPECT_TRUE(found.available) << driver.id;
    const auto device = driver.open(request);
    device->serve();
    EXPECT_EQ(device->read(0).status & ~static_cast<std::uint32_t>(kDeviceEnded), 0U) << driver.id;
    if (driver.use == DriverUse::kPointer) {
      // Recordings know by the drive whether the force was felt (assessment/attempt/force_felt.h).
      EXPECT_EQ(device->capabilities().drive, TwistDrive::kRoll);
    }
    EXPECT_EQ(device->snapshot().state, DeviceState::kReady) << driver.id;
    EXPECT_TRUE(device->close()) << driver.id;
  }
}

TEST_F(DeviceDrivers, L1_TheStylusIsMissedByTheNameOfItsLibrary) {
  const DeviceRequest request = anyRequest("/nowhere/libHD.so");
  const DeviceDriver& stylus = deviceDriver("hdapi");

  const DriverFinding found = stylus.look(request);

  EXPECT_FALSE(found.available);
  EXPECT_NE(found.sentence.str().find("/nowhere/libHD.so"), std::string::npos);
  const Error error = testing::refusal([&] { return stylus.open(request); });
  EXPECT_EQ(error.code(), ErrorCode::kDevice);
  EXPECT_NE(error.remedy().find("docs/devices.md"), std::string::npos);
}

TEST_F(DeviceDrivers, OpensTheStylusOnTheLibraryThatIsNamed) {
  const DeviceRequest request = anyRequest(TORSIO_FAKEHD);
  const DeviceDriver& stylus = deviceDriver("hdapi");

  const auto device = stylus.open(request);

  EXPECT_TRUE(stylus.look(request).available);
  EXPECT_EQ(device->capabilities().model, "Touch");
  EXPECT_TRUE(device->capabilities().rendersForce && stylus.rendersForce);
}

TEST_F(DeviceDrivers, AnUnknownNameIsRefusedWithThoseThatThereAre) {
  const Error error = testing::refusal([&] { return deviceDriver("hand"); });
  EXPECT_NE(error.remedy().find("hdapi, "), std::string::npos);
  EXPECT_NE(error.remedy().find("pointer"), std::string::npos);
}

}  // namespace
}  // namespace torsio
