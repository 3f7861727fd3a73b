// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/steering/game_controller.h"

#include <SDL.h>
#include <algorithm>
#include <string>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "sim/device/steering/steered_device.h"

namespace torsio {

namespace {

constexpr double kStickMost = 32'767.0;
constexpr double kStickDead = 0.12;    // of the deflection: worn sticks do not come back to the middle
constexpr double kTriggerDead = 0.03;  // the same
constexpr double kSlowest = 0.25;      // share of the speed with the left trigger pulled through

/// SDL's controllers, as long as somebody uses them. SDL counts; its events and signals stay untouched.
class Controllers {
 public:
  Controllers() {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");  // the window is not SDL's
    ready_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    SDL_GameControllerEventState(SDL_IGNORE);  // state is polled; nobody empties the queue
    SDL_JoystickEventState(SDL_IGNORE);
    if (ready_) {
      SDL_GameControllerUpdate();
    }
  }
  ~Controllers() {
    if (ready_) {
      SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }
  }
  Controllers(const Controllers&) = delete;
  Controllers& operator=(const Controllers&) = delete;

  /// Index of the controller of this name, of the first one for ""; -1: none.
  [[nodiscard]] int find(const std::string& name) const {
    for (int i = 0; ready_ && i < SDL_NumJoysticks(); ++i) {
      if (SDL_IsGameController(i) == SDL_TRUE && (name.empty() || nameOf(i) == name)) {
        return i;
      }
    }
    return -1;
  }
  [[nodiscard]] std::string names() const {
    std::string all;
    for (int i = 0; ready_ && i < SDL_NumJoysticks(); ++i) {
      if (SDL_IsGameController(i) == SDL_TRUE) {
        all.append(all.empty() ? "" : ", ").append(nameOf(i));
      }
    }
    return all;
  }

 private:
  static std::string nameOf(int index) {
    const char* const name = SDL_GameControllerNameForIndex(index);
    return name != nullptr ? plainLine(name) : "";
  }

  bool ready_ = false;
};

class ControllerSource final : public SteeringSource {
 public:
  /// Throws Error{kDevice}.
  explicit ControllerSource(const std::string& name) {
    const int index = controllers_.find(name);
    controller_ = index < 0 ? nullptr : SDL_GameControllerOpen(index);
    if (controller_ == nullptr) {
      throw Error(
          ErrorCode::kDevice, Text::tr("no game controller could be opened"), Text::tr("game controller"),
          Text::tr("Plug it in or pair it, and give the user access to /dev/input (docs/devices.md)"));
    }
  }
  ~ControllerSource() override { SDL_GameControllerClose(controller_); }
  ControllerSource(const ControllerSource&) = delete;
  ControllerSource& operator=(const ControllerSource&) = delete;

  [[nodiscard]] std::optional<SteeringInput> poll() override {
    SDL_GameControllerUpdate();
    if (SDL_GameControllerGetAttached(controller_) == SDL_FALSE) {
      return std::nullopt;
    }
    const double pace = 1.0 - (1.0 - kSlowest) * trigger(SDL_CONTROLLER_AXIS_TRIGGERLEFT);
    SteeringInput input;
    input.move = Vec3{stick(SDL_CONTROLLER_AXIS_LEFTX), -stick(SDL_CONTROLLER_AXIS_LEFTY),
                      stick(SDL_CONTROLLER_AXIS_RIGHTY)} *
                 pace;
    input.roll = -stick(SDL_CONTROLLER_AXIS_RIGHTX) * pace;  // to the right is with the clock
    input.yaw = pace * (pressed(SDL_CONTROLLER_BUTTON_DPAD_LEFT) - pressed(SDL_CONTROLLER_BUTTON_DPAD_RIGHT));
    input.pitch = pace * (pressed(SDL_CONTROLLER_BUTTON_DPAD_UP) - pressed(SDL_CONTROLLER_BUTTON_DPAD_DOWN));
    input.grip = trigger(SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
    if (pressed(SDL_CONTROLLER_BUTTON_A) > 0.0) {
      input.buttons |= kButtonSecond;
    }
    if (pressed(SDL_CONTROLLER_BUTTON_Y) > 0.0) {
      input.buttons |= kButtonBookmark;
    }
    return input;
  }

  [[nodiscard]] DeviceIdentity identity() const {
    const auto text = [](const char* value) { return value != nullptr ? plainLine(value) : std::string(); };
    DeviceIdentity identity;
    identity.model = text(SDL_GameControllerName(controller_));
    identity.serial = text(SDL_GameControllerGetSerial(controller_));
    SDL_version version;
    SDL_GetVersion(&version);
    identity.libraryVersion = "SDL " + std::to_string(version.major) + "." + std::to_string(version.minor) +
                              "." + std::to_string(version.patch);
    identity.openedAs = identity.model;
    identity.inputDof = 6;
    return identity;
  }

 private:
  [[nodiscard]] double stick(SDL_GameControllerAxis axis) const {
    return steeringCurve(SDL_GameControllerGetAxis(controller_, axis) / kStickMost, kStickDead);
  }
  [[nodiscard]] double trigger(SDL_GameControllerAxis axis) const {
    const double pulled = SDL_GameControllerGetAxis(controller_, axis) / kStickMost;
    return std::clamp((pulled - kTriggerDead) / (1.0 - kTriggerDead), 0.0, 1.0);
  }
  [[nodiscard]] double pressed(SDL_GameControllerButton button) const {
    return SDL_GameControllerGetButton(controller_, button) != 0 ? 1.0 : 0.0;
  }

  Controllers controllers_;
  SDL_GameController* controller_ = nullptr;
};

DriverFinding lookForControllers(const DeviceRequest& request) {
  const Controllers controllers;
  const std::string names = controllers.names();
  if (controllers.find(request.name) >= 0) {
    return {
        true, Text::tr("found: %1; this kind of device was not confirmed on hardware yet", names), "", {}};
  }
  const Text remedy =
      Text::tr("Plug it in or pair it, and give the user access to /dev/input (docs/devices.md)");
  return names.empty() ? DriverFinding{false, Text::tr("no game controller is connected"), remedy, {}}
                       : DriverFinding{false,
                                       Text::tr("no game controller is called \"%1\"", request.name),
                                       Text::tr("Choose one of: %1", names),
                                       {}};
}

std::unique_ptr<HapticDevice> openController(const DeviceRequest& request) {
  auto source = std::make_unique<ControllerSource>(request.name);
  DeviceIdentity identity = source->identity();
  return std::make_unique<SteeredDevice>(std::move(source), std::move(identity), request);
}

}  // namespace

DeviceDriver gameControllerDriver() {
  DeviceDriver driver;
  driver.id = "controller";
  driver.name = "Game controller";
  driver.needs = Text::tr("a controller that SDL knows; not confirmed on hardware");
  driver.look = lookForControllers;
  driver.open = openController;
  return driver;
}

}  // namespace torsio
