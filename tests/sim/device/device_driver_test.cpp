// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/drivers/device_driver.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace torsio {
namespace {

DeviceRequest anyRequest() {
  DeviceRequest request;
  request.start.position_m = {0.0, 0.0, 0.2};
  request.hand.task.graspPoint_m = {0.04, 0.0, 0.2};
  request.hand.task.start_m = {0.14, 0.0, 0.2};
  request.recorded.resize(1);
  return request;
}

/// The device process that was built beside the tests.
class DeviceDrivers : public testing::Test {
 protected:
  DeviceDrivers() { setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1); }
};

TEST_F(DeviceDrivers, L1_OffersEveryDriverButTheHapticOneWithoutTheVendorsLibrary) {
  const std::vector<DeviceDriver> drivers = deviceDrivers("/nowhere/libHD.so");

  ASSERT_EQ(drivers.size(), 5U);
  for (const DeviceDriver& driver : drivers) {
    EXPECT_EQ(driver.available, driver.id != "hdapi") << driver.id;
    EXPECT_FALSE(driver.name.empty() || driver.finding.empty());
    if (!driver.available) {
      continue;
    }
    const auto device = driver.open(anyRequest());
    EXPECT_EQ(device->read(0).status & ~static_cast<std::uint32_t>(kDeviceEnded), 0U) << driver.id;
  }
  EXPECT_NE(drivers[0].finding.str().find("/nowhere/libHD.so"), std::string::npos);
  try {
    (void)drivers[0].open(anyRequest());
    FAIL() << "opened";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kDevice);
    EXPECT_NE(error.remedy().find("docs/devices.md"), std::string::npos);
  }
}

TEST_F(DeviceDrivers, OpensTheHapticDeviceOnTheLibraryThatIsNamed) {
  const std::vector<DeviceDriver> drivers = deviceDrivers(TORSIO_FAKEHD);
  const auto device = drivers[0].open(anyRequest());

  EXPECT_TRUE(drivers[0].available);
  EXPECT_EQ(device->capabilities().model, "Touch");
  EXPECT_TRUE(device->capabilities().rendersForce);
}

}  // namespace
}  // namespace torsio
