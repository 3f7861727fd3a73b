// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/device/drivers/device_list.h"

namespace torsio {
namespace {

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
  try {
    (void)stylus.open(request);
    FAIL() << "opened";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kDevice);
    EXPECT_NE(error.remedy().find("docs/devices.md"), std::string::npos);
  }
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
  try {
    (void)deviceDriver("hand");
    FAIL() << "found";
  } catch (const Error& error) {
    EXPECT_NE(error.remedy().find("hdapi, "), std::string::npos);
    EXPECT_NE(error.remedy().find("pointer"), std::string::npos);
  }
}

}  // namespace
}  // namespace torsio
