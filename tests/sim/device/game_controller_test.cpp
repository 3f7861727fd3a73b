// SPDX-License-Identifier: GPL-3.0-or-later
// SDL2 itself with a virtual joystick of its own in place of a controller.
#include "sim/device/steering/game_controller.h"

#include <SDL.h>
#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "tests/support/eventually.h"

namespace torsio {
namespace {

constexpr Sint16 kAxisMost = 32'767;
constexpr Sint16 kAxisLeast = -32'768;
constexpr const char* kName = "Torsio test controller";

class VirtualController : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER), 0) << SDL_GetError();
    SDL_VirtualJoystickDesc virtualOne{};
    virtualOne.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    virtualOne.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
    virtualOne.naxes = SDL_CONTROLLER_AXIS_MAX;
    virtualOne.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
    virtualOne.name = kName;
    index_ = SDL_JoystickAttachVirtualEx(&virtualOne);
    ASSERT_GE(index_, 0) << SDL_GetError();
    joystick_ = SDL_JoystickOpen(index_);
    ASSERT_NE(joystick_, nullptr) << SDL_GetError();
    // At rest a real trigger says the least, not the middle.
    axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, kAxisLeast);
    axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, kAxisLeast);
  }
  void TearDown() override {
    device_.reset();
    unplug();
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  }
  void axis(int which, Sint16 value) { SDL_JoystickSetVirtualAxis(joystick_, which, value); }
  void button(int which, bool down) {
    SDL_JoystickSetVirtualButton(joystick_, which, down ? SDL_PRESSED : SDL_RELEASED);
  }
  void unplug() {
    if (joystick_ == nullptr) {
      return;
    }
    // The index moves with what else is plugged in.
    for (int i = 0; i < SDL_NumJoysticks(); ++i) {
      if (SDL_JoystickIsVirtual(i) == SDL_TRUE) {
        SDL_JoystickDetachVirtual(i);
        break;
      }
    }
    SDL_JoystickClose(joystick_);
    joystick_ = nullptr;
  }
  static DeviceRequest request() {
    DeviceRequest request;
    request.name = kName;
    request.start.position_m = {0.0, 0.0, 0.2};
    request.workspaceCentre_m = {0.0, 0.0, 0.2};
    return request;
  }
  void open() {
    device_ = gameControllerDriver().open(request());
    device_->serve();
    ASSERT_TRUE(testing::eventually([this] { return device_->read(0).status == kDeviceOk; }));
  }
  [[nodiscard]] ToolState tool() { return toolState(device_->read(0)); }

  int index_ = -1;
  SDL_Joystick* joystick_ = nullptr;
  std::unique_ptr<HapticDevice> device_;
};

TEST_F(VirtualController, IsFoundByItsNameAndSaysThatItGivesNoForce) {
  const DriverFinding found = gameControllerDriver().look(request());

  open();

  EXPECT_TRUE(found.available);
  EXPECT_NE(found.sentence.str().find(kName), std::string::npos);
  EXPECT_EQ(device_->capabilities().model, kName);
  EXPECT_FALSE(device_->capabilities().rendersForce);
  EXPECT_EQ(device_->identity().libraryVersion.rfind("SDL 2.", 0), 0U);
  EXPECT_NE(found.sentence.str().find("not confirmed on hardware"), std::string::npos);
}

TEST_F(VirtualController, AnotherNameIsNotFoundAndTheOneThereIsIsNamed) {
  DeviceRequest other = request();
  other.name = "Another controller";

  const DriverFinding found = gameControllerDriver().look(other);

  EXPECT_FALSE(found.available);
  EXPECT_NE(found.remedy.str().find(kName), std::string::npos);
  EXPECT_THROW(static_cast<void>(gameControllerDriver().open(other)), Error);
}

TEST_F(VirtualController, TheLeftStickMovesTheTipSidewaysAndUp) {
  open();

  axis(SDL_CONTROLLER_AXIS_LEFTX, kAxisMost);
  EXPECT_TRUE(testing::eventually([this] { return tool().pose.position_m.x > 0.01; }));
  axis(SDL_CONTROLLER_AXIS_LEFTX, 0);
  axis(SDL_CONTROLLER_AXIS_LEFTY, kAxisLeast);  // SDL counts downwards

  EXPECT_TRUE(testing::eventually([this] { return tool().pose.position_m.z > 0.21; }));
  EXPECT_NEAR(tool().pose.position_m.y, 0.0, 1e-6);
}

TEST_F(VirtualController, TheRightStickTurnsTheJawAndMovesItAway) {
  open();

  axis(SDL_CONTROLLER_AXIS_RIGHTX, kAxisLeast);
  EXPECT_TRUE(testing::eventually([this] { return tool().roll_rad > 0.1; }));
  axis(SDL_CONTROLLER_AXIS_RIGHTX, 0);
  axis(SDL_CONTROLLER_AXIS_RIGHTY, kAxisLeast);  // pushed away

  EXPECT_TRUE(testing::eventually([this] { return tool().pose.position_m.y > 0.01; }));
}

TEST_F(VirtualController, TheRightTriggerClosesTheJawAsFarAsItIsPulled) {
  open();
  EXPECT_NEAR(tool().grip, 0.0, 1e-4);

  // Half of the way: (0.5 - 0.03) / (1 - 0.03) = 0.4845; SDL's own rounding adds up to 1 / 32767.
  axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 0);
  EXPECT_TRUE(testing::eventually([this] { return std::abs(tool().grip - 0.4845) < 1e-3; })) << tool().grip;
  EXPECT_EQ(tool().buttons & kButtonGrip, 0U);
  axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, kAxisMost);

  EXPECT_TRUE(testing::eventually([this] { return tool().grip > 0.999; }));
  EXPECT_NE(tool().buttons & kButtonGrip, 0U);
}

TEST_F(VirtualController, ButtonsReachTheSimulation) {
  open();

  button(SDL_CONTROLLER_BUTTON_A, true);
  button(SDL_CONTROLLER_BUTTON_Y, true);

  EXPECT_TRUE(testing::eventually([this] { return tool().buttons == (kButtonSecond | kButtonBookmark); }));
}

TEST_F(VirtualController, IsLostWhenUnplugged) {
  open();

  unplug();

  EXPECT_TRUE(testing::eventually([this] { return (device_->read(0).status & kDeviceLost) != 0; }));
  EXPECT_TRUE(testing::eventually([this] { return device_->snapshot().state == DeviceState::kLost; }));
  EXPECT_TRUE(device_->close());
}

}  // namespace
}  // namespace torsio
