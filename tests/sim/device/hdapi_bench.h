// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/device/hdapi/hdapi_device.h"
#include "sim/device/hdapi/hdapi_library.h"
#include "sim/device/safety/force_governor.h"
#include "tests/support/fakehd/fakehd_control.h"

namespace torsio::testing {

/// The fake's manual clock as the driver's.
class FakeClock final : public Clock {
 public:
  explicit FakeClock(const FakeHd& fake) : fake_(fake) {}
  [[nodiscard]] std::int64_t now_us() const noexcept override { return fake_.now_us(); }

 private:
  const FakeHd& fake_;
};

/// A loop as the servo has it: read, wish a force, govern, write. The vendor's servo thread calls tick().
struct FakeLoop {
  HdapiDevice* device = nullptr;
  ForceGovernor governor{GovernorLimits{}};
  Vec3 wanted_N;
  DeviceSample sample;
  ForceCommand sent;
  std::int64_t ticks = 0;
  std::int64_t time_us = 0;
  std::int64_t workEach_us = 0;  ///< how much of the fake's time the tick takes
  const FakeHd* fake = nullptr;

  static void tick(void* context, std::int64_t time_us) {
    auto& loop = *static_cast<FakeLoop*>(context);
    ++loop.ticks;
    loop.time_us = time_us;
    loop.sample = loop.device->read(time_us);
    loop.sent = loop.governor.govern(
        {time_us, time_us, loop.wanted_N, toolState(loop.sample).pose.position_m, loop.sample.status});
    loop.device->write(loop.sent);
    if (loop.workEach_us > 0) {
      loop.fake->advance_us(loop.workEach_us);
    }
  }
};

/// A device opened on the fake, driven by the fake's servo thread on its manual clock.
class HdapiBench : public ::testing::Test {
 protected:
  HdapiBench() {
    fake.reset();
    options.clock = std::make_shared<FakeClock>(fake);
    options.patience_us = 5'000'000;
    loop.fake = &fake;
  }
  ~HdapiBench() override {
    fake.replug();
    device.reset();
  }

  void open() {
    device = std::make_unique<HdapiDevice>(library.api, options);
    loop.device = device.get();
    loop.governor = ForceGovernor(limits());
  }
  /// Opens, starts and lets the user wish a force.
  void start() {
    open();
    device->enableForce(true);
    device->start({&FakeLoop::tick, &loop});
  }
  /// Runs until governor and gate have opened.
  void engage() {
    start();
    fake.run(1'500);
  }
  /// Serves the device over mailboxes until it renders half a newton.
  void serveHalfNewton() {
    open();
    device->enableForce(true);
    device->serve();
    for (int i = 0; i < 700; ++i) {
      device->write({{0.5, 0.0, 0.0}, 0});
      fake.run(1);
    }
    ASSERT_NEAR(rendered_N().x, 0.5, 1e-9);
  }
  void engageAtOneNewton() {
    const FakePose pose{{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
    fake.set_pose(&pose);
    loop.wanted_N = {1.0, 0.0, 0.0};
    engage();
    ASSERT_NEAR(rendered_N().x, 1.0, 1e-9);
  }
  GovernorLimits limits() {
    const DeviceCapabilities& c = device->capabilities();
    return {c.maxForce_N, c.continuousForce_N, c.workspaceMin_m, c.workspaceMax_m, 1000};
  }
  /// What the motors render, device frame.
  Vec3 rendered_N() {
    std::array<double, 3> force{};
    fake.force(force.data());
    return {force[0], force[1], force[2]};
  }
  std::vector<DeviceEvent> events(DeviceEvent::Kind kind) {
    std::vector<DeviceEvent> found;
    for (DeviceEvent event; device->nextEvent(event);) {
      if (event.kind == kind) {
        found.push_back(event);
      }
    }
    return found;
  }
  /// Indices in the call log at which `function` appears, from `begin` on.
  std::vector<int> logged(const std::string& function, int begin = 0) {
    std::vector<int> found;
    for (int i = begin; i < fake.log_count(); ++i) {
      if (fake.log_entry(i).function == function) {
        found.push_back(i);
      }
    }
    return found;
  }

  FakeHd fake{TORSIO_FAKEHD};
  HdapiLibrary library = loadHdapi(TORSIO_FAKEHD);
  HdapiOptions options;
  FakeLoop loop;
  std::unique_ptr<HdapiDevice> device;
};

inline constexpr FakePose kDockedPose{{0.0, 0.26889, -0.370813}, {0.000108409, 0.797273, -1.94046}, 0, {}};

}  // namespace torsio::testing
