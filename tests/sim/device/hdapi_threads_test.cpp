// SPDX-License-Identifier: GPL-3.0-or-later
// Cases T1 to T3 of the haptics plan: who calls what from which thread, and at what cost.
#include <atomic>
#include <thread>

#include "sim/core/latest_value.h"
#include "tests/sim/device/hdapi_bench.h"
#include "tests/support/allocation_count.h"
#include "tests/support/lock_count.h"

namespace torsio {
namespace {

class HdapiThreads : public testing::HdapiBench {};

TEST_F(HdapiThreads, T1_MakesNoDeviceCallOffTheServoThreadInAFullSession) {
  fake.set_calibration(hd::kCalibrationNeedsUpdate);
  start();
  fake.run(1'200);
  loop.wanted_N = {0.5, 0.0, 0.0};
  fake.run(800);
  device->enableForce(false);
  (void)device->snapshot();
  device->retryCalibration();
  fake.run(800);
  device->enableForce(true);
  fake.run(100);
  EXPECT_TRUE(device->close());

  EXPECT_EQ(fake.off_thread(), 0);
  EXPECT_EQ(fake.rule_breaks(), 0);
  EXPECT_GT(fake.log_count(), 10'000);
}

TEST_F(HdapiThreads, T1_HoldsWithAServoThreadOfOurOwnOverMailboxes) {
  open();
  device->enableForce(true);
  device->serve();
  std::atomic<bool> stop{false};
  std::atomic<std::int64_t> reads{0};
  std::thread own([&] {
    for (std::int64_t time_us = 0; !stop; time_us += 10) {
      const DeviceSample sample = device->read(time_us);
      device->write({{sample.status == kDeviceOk ? 0.5 : 0.0, 0.0, 0.0}, 0});
      ++reads;
    }
  });
  fake.run(2'000);
  while (reads < 100) {
    std::this_thread::yield();
  }
  stop = true;
  own.join();
  EXPECT_TRUE(device->close());

  EXPECT_EQ(fake.off_thread(), 0);
  EXPECT_EQ(fake.rule_breaks(), 0);
}

TEST(HdapiMailbox, T2_HandsOverAMillionReadingsWithoutTearingOne) {
  constexpr std::int64_t kExchanges = 1'000'000;
  LatestValue<MailedReading> mailbox;
  std::thread writer([&mailbox] {
    MailedReading reading;
    for (std::int64_t i = 1; i <= kExchanges; ++i) {
      reading.number = static_cast<std::uint64_t>(i);
      reading.sample.time_us = i;
      reading.sample.roll = static_cast<std::int32_t>(i);
      reading.sample.position = {static_cast<std::int32_t>(i), static_cast<std::int32_t>(i),
                                 static_cast<std::int32_t>(i)};
      mailbox.publish(reading);
    }
  });

  std::uint64_t last = 0;
  std::int64_t torn = 0;
  std::int64_t backwards = 0;
  while (last < static_cast<std::uint64_t>(kExchanges)) {
    const MailedReading reading = mailbox.latest();
    const auto i = static_cast<std::int64_t>(reading.number);
    const auto short32 = static_cast<std::int32_t>(i);
    if (reading.sample.time_us != i || reading.sample.roll != short32 ||
        reading.sample.position[2] != short32) {
      ++torn;
    }
    if (reading.number < last) {
      ++backwards;
    }
    last = reading.number;
  }
  writer.join();

  EXPECT_EQ(torn, 0);
  EXPECT_EQ(backwards, 0);
}

/// What one callback cost; filled by the fake's hook around it, in the servo thread.
struct Cost {
  std::int64_t allocationsBefore = 0;
  std::int64_t allocations = 0;
  std::int64_t locksBefore = 0;
  std::int64_t locked = 0;
  std::int64_t callbacks = 0;

  static void hook(void* context, int before) {
    auto& cost = *static_cast<Cost*>(context);
    if (before != 0) {
      cost.allocationsBefore = testing::allocationCount();
      cost.locksBefore = testing::lockCount();
      return;
    }
    cost.allocations += testing::allocationCount() - cost.allocationsBefore;
    cost.locked += testing::lockCount() - cost.locksBefore;
    ++cost.callbacks;
  }
};

TEST_F(HdapiThreads, T3_AllocatesAndLocksNothingInTheCallback) {
  Cost cost;
  open();
  device->enableForce(true);
  loop.wanted_N = {0.5, 0.0, 0.0};
  fake.set_hook(&Cost::hook, &cost);
  device->start({&testing::FakeLoop::tick, &loop});

  fake.run(1'500);
  fake.push_error(hd::kExceededMaxForce, 0);
  fake.set_buttons(3);
  fake.run(10);
  fake.set_calibration(hd::kCalibrationNeedsUpdate);
  fake.run(2'500);
  fake.unplug();
  fake.run(1);
  fake.replug();

  EXPECT_EQ(cost.callbacks, 1'500 + 10 + 2'500 + 1);
  EXPECT_EQ(cost.allocations, 0);
  EXPECT_EQ(cost.locked, 0);
  EXPECT_EQ(testing::lockCount() > 0, testing::lockCountWorks()) << "the count does not count";
}

}  // namespace
}  // namespace torsio
