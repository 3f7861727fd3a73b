// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/hdapi/hdapi_session.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "sim/core/time_units.h"
#include "sim/device/hdapi/hdapi_border.h"

namespace torsio {

/// What the library's callback is given: it outlives the servo, as a late callback does.
struct ServoEntry {
  std::atomic<HdapiServo*> servo{nullptr};
  std::atomic<int> inside{0};
};

namespace {

// After a failed initialisation the library may return a handle without meaning and no error. The first
// valid handle is 0; nobody has a thousand devices.
constexpr hd::Handle kLargestHandle = 1024;
constexpr int kInitTries = 3;
constexpr hd::ULong kWantedRate_Hz = 1'000'000 / kTickPeriod_us;
constexpr double kPerMillimetre_per_m = 1e3;
// Nominal box of the Omni and the Touch about the device's origin: 160 x 120 x 70 mm.
constexpr std::array<double, 6> kNominalBox_mm{-80.0, -60.0, -35.0, 80.0, 60.0, 35.0};

// The library keeps one device stack a process: a session that still lets go excludes another one.
std::atomic<bool> sessionOpen{false};
// Time since the servo's last call within which it lets go by itself: its callback comes each millisecond.
constexpr std::int64_t kServoLetsGo_us = 15'000;
// Time that it is given between two frames in any case.
constexpr std::int64_t kServoMayCall_us = 2'000;
// Time for a callback that was under way when the task was taken out.
constexpr auto kCallbackEnds = std::chrono::milliseconds(100);
constexpr std::size_t kLongestText = 120;

hd::CallbackCode TORSIO_HD_CALL servoCallback(void* context) {
  auto& entry = *static_cast<ServoEntry*>(context);
  entry.inside.fetch_add(1);
  HdapiServo* const servo = entry.servo.load();
  const hd::CallbackCode answer = servo != nullptr ? servo->frame() : hd::kCallbackDone;
  entry.inside.fetch_sub(1);
  return answer;
}

hd::CallbackCode TORSIO_HD_CALL letGoCallback(void* context) {
  auto& entry = *static_cast<ServoEntry*>(context);
  entry.inside.fetch_add(1);
  if (HdapiServo* const servo = entry.servo.load()) {
    servo->letGo();
  }
  entry.inside.fetch_sub(1);
  return hd::kCallbackDone;
}

/// A vendor's text, which may be none.
std::string textOf(const char* vendor) {
  return vendor != nullptr ? plainLine(vendor, kLongestText) : "";
}

/// Largest force that a model renders, N; by the vendor's data sheets. A model that is not known is a Touch.
double modelForce_N(const std::string& model) {
  constexpr std::array<std::pair<const char*, double>, 4> kForces{
      {{"Touch X", 7.9}, {"Desktop", 7.9}, {"Premium", 8.5}, {"", 3.3}}};
  return std::find_if(kForces.begin(), kForces.end(),
                      [&](const auto& known) { return model.find(known.first) != std::string::npos; })
      ->second;
}

std::string hex(hd::ErrorCode code) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "0x";
  for (int shift = 12; shift >= 0; shift -= 4) {
    text += kDigits[(code >> static_cast<unsigned>(shift)) & 15U];
  }
  return text;
}

Text described(const hd::Api& api, hd::ErrorCode code) {
  const char* const vendor = api.hdGetErrorString(code);
  if (vendor == nullptr) {
    return Text::tr("%1 (%2)", hdapiErrorText(code), hex(code));
  }
  return Text::verbatim("%1 (%2, %3)", hdapiErrorText(code), hex(code), textOf(vendor));
}

Text remedyFor(hd::ErrorCode code) {
  switch (code) {
    case hd::kInvalidLicense:
      return Text::tr(
          "Install the licence of OpenHaptics for this computer, or set OH_SDK_LICENSE_PATH to its folder");
    case hd::kDeviceAlreadyInitiated:
      return Text::tr("Close every other program that uses the device, then try again");
    case hd::kCommConfigError:
      return Text::tr(
          "Unplug the device, wait ten seconds, plug it in again and run the vendor's set-up tool");
    case hd::kTimerError:
    case hd::kSchedulerFull:
    case hd::kInvalidPriority:
      return Text::tr("Close every other program that uses the device; restart Torsio");
    default:
      return Text::tr(
          "Check power and cable, run the vendor's set-up tool once as this user, and check the rights on "
          "the device file (docs/devices.md)");
  }
}

std::vector<const char*> namesToTry(const std::string& configured) {
  if (!configured.empty()) {
    return {configured.c_str(), nullptr};
  }
  return {nullptr, "Default Device", "Default PHANToM"};
}

}  // namespace

HdapiSession::HdapiSession(const hd::Api& api, const HdapiOptions& options)
    : api_(api), clock_(options.clock ? options.clock : std::make_shared<const MonotonicClock>()) {
  if (sessionOpen.exchange(true)) {
    throw Error(ErrorCode::kDevice, Text::tr("the device is still being released"), Text::tr("haptic device"),
                Text::tr("Wait a moment and try again; if it stays so, plug the device in again and restart "
                         "Torsio"));
  }
  claimed_ = true;
  try {
    open(options.deviceName);
    api_.hdMakeCurrentDevice(handle_);
    api_.hdDisable(hd::kForceOutput);
    // The vendor's own safeguards stay on behind ours.
    for (const hd::Enum safeguard : {hd::kMaxForceClamping, hd::kForceRamping, hd::kOneFrameLimit}) {
      api_.hdEnable(safeguard);
    }
    (void)drainHdapiErrors(api_);
    if (api_.hdIsEnabled(hd::kForceOutput) != 0) {
      throw Error(ErrorCode::kDevice, Text::tr("the device's force cannot be switched off"),
                  identity_.openedAs,
                  Text::tr("Unplug the device, plug it in again and run the vendor's set-up tool"));
    }
    readIdentity();
    readCapabilities(options);
    servo_ = std::make_unique<HdapiServo>(api_, setup(), *clock_);
    calibrateBeforeStart();
  } catch (...) {
    tearDown();
    throw;
  }
}

HdapiSession::~HdapiSession() {
  tearDown();
}

void HdapiSession::open(const std::string& deviceName) {
  hd::ErrorCode firstError = hd::kSuccess;
  (void)drainHdapiErrors(api_);
  for (const char* const name : namesToTry(deviceName)) {
    for (int attempt = 0; attempt < kInitTries; ++attempt) {
      const hd::Handle handle = api_.hdInitDevice(name);
      const HdapiErrors errors = drainHdapiErrors(api_);
      const bool sound = handle <= kLargestHandle;
      if (sound && errors.worst < HdapiErrorClass::kLicence) {
        handle_ = handle;
        identity_.openedAs = name != nullptr ? name : "default device";
        return;
      }
      const hd::ErrorCode error = errors.count > 0 ? errors.worstCode() : hd::kDeviceFault;
      if (firstError == hd::kSuccess) {
        firstError = error;
      }
      if (error != hd::kDeviceAlreadyInitiated) {
        break;
      }
      api_.hdDisableDevice(sound ? handle : api_.hdGetCurrentDevice());
      (void)drainHdapiErrors(api_);
    }
    if (firstError == hd::kInvalidLicense) {
      break;
    }
  }
  throw Error(ErrorCode::kDevice,
              Text::tr("no haptic device could be opened: %1", described(api_, firstError)),
              deviceName.empty() ? Text::tr("default device") : Text::tr("device \"%1\"", deviceName),
              remedyFor(firstError));
}

std::string HdapiSession::text(hd::Enum name) {
  const char* const value = api_.hdGetString(name);
  const HdapiErrors errors = drainHdapiErrors(api_);
  return errors.count == 0 ? textOf(value) : "";
}

void HdapiSession::readIdentity() {
  identity_.model = text(hd::kDeviceModelType);
  identity_.vendor = text(hd::kDeviceVendor);
  identity_.serial = text(hd::kDeviceSerialNumber);
  identity_.driverVersion = text(hd::kDeviceDriverVersion);
  identity_.libraryVersion = text(hd::kVersion);
  hd::Int dof = 0;
  api_.hdGetIntegerv(hd::kInputDof, &dof);
  identity_.inputDof = dof;
  dof = 0;
  api_.hdGetIntegerv(hd::kOutputDof, &dof);
  identity_.outputDof = dof;
  (void)drainHdapiErrors(api_);
  if (identity_.outputDof != 3) {
    identity_.assumed.emplace_back(Text::tr("three force axes"));
    identity_.notes.push_back(
        Text::tr("The device says that it renders %1 {axis|axes}; an Omni or Touch renders 3. Forces are "
                 "rendered along "
                 "three axes, with cautious limits",
                 identity_.outputDof));
  }
  const bool known =
      identity_.model.find("Omni") != std::string::npos || identity_.model.find("Touch") != std::string::npos;
  if (!known) {
    identity_.notes.push_back(
        Text::tr("Model \"%1\" is not an Omni or Touch; it is treated like a Touch", identity_.model));
  }
}

double HdapiSession::reported(hd::Enum name, double least, double most, double assumed, Phrase what) {
  // Six elements: some values are arrays on some models.
  std::array<double, 6> values{};
  api_.hdGetDoublev(name, values.data());
  const bool good = drainHdapiErrors(api_).count == 0 && values[0] >= least && values[0] <= most;
  // A model that claims six force axes is another machine: its figures are not those of a stylus.
  if (good && identity_.outputDof == 3) {
    return values[0];
  }
  identity_.assumed.emplace_back(what);
  return assumed;
}

void HdapiSession::readCapabilities(const HdapiOptions& options) {
  const DeviceCapabilities nominal;
  capabilities_.model = identity_.model.empty() ? "unknown model" : identity_.model;
  capabilities_.rendersForce = true;
  capabilities_.realTime = true;
  capabilities_.maxForce_N =
      std::min(modelForce_N(identity_.model),
               reported(hd::kNominalMaxForce, 0.1, 40.0, nominal.maxForce_N, Text::tr("maximum force")));
  capabilities_.continuousForce_N =
      reported(hd::kNominalMaxContinuousForce, 0.05, capabilities_.maxForce_N,
               std::min(nominal.continuousForce_N, capabilities_.maxForce_N), Text::tr("continuous force"));
  capabilities_.maxStiffness_N_per_m =
      kPerMillimetre_per_m * reported(hd::kNominalMaxStiffness, 0.01, 10.0,
                                      nominal.maxStiffness_N_per_m / kPerMillimetre_per_m,
                                      Text::tr("stiffness"));

  std::array<double, 6> box_mm{};
  api_.hdGetDoublev(hd::kUsableWorkspaceDimensions, box_mm.data());
  const bool good = drainHdapiErrors(api_).count == 0 && box_mm[0] < box_mm[3] && box_mm[1] < box_mm[4] &&
                    box_mm[2] < box_mm[5] &&
                    std::all_of(box_mm.begin(), box_mm.end(), [](double x) { return std::abs(x) < 1e3; });
  if (!good) {
    box_mm = kNominalBox_mm;
    identity_.assumed.emplace_back(Text::tr("usable workspace"));
  }
  placement_.deviceToWorld = normalized(options.deviceToWorld);
  placement_.worldOrigin_m = options.workspaceCentre_m;
  placement_.deviceCentre_m =
      Vec3{box_mm[0] + box_mm[3], box_mm[1] + box_mm[4], box_mm[2] + box_mm[5]} * (0.5 * kMillimetre_m);
  placement_.stylusTip_m = options.stylusTip_m;
  const WorldBox box = worldBox(box_mm, placement_);
  capabilities_.workspaceMin_m = box.min_m;
  capabilities_.workspaceMax_m = box.max_m;
}

HdapiSetup HdapiSession::setup() {
  HdapiSetup setup;
  setup.handle = handle_;
  setup.placement = placement_;
  setup.gimbal = gimbalProfile(identity_.model);
  setup.maxForce_N = capabilities_.maxForce_N;
  // A device may offer several styles; the vendor's order of preference.
  hd::Int styles = 0;
  api_.hdGetIntegerv(hd::kCalibrationStyle, &styles);
  (void)drainHdapiErrors(api_);
  const auto offers = [styles](hd::Enum style) { return (static_cast<hd::Enum>(styles) & style) != 0; };
  setup.calibrationStyle = offers(hd::kCalibrationAuto)           ? hd::kCalibrationAuto
                           : offers(hd::kCalibrationInkwell)      ? hd::kCalibrationInkwell
                           : offers(hd::kCalibrationEncoderReset) ? hd::kCalibrationEncoderReset
                                                                  : hd::kCalibrationInkwell;
  // Asked once here: a channel that the library refuses would bring an error in every tick.
  std::array<double, 6> motors{};
  api_.hdGetDoublev(hd::kMotorTemperature, motors.data());
  setup.hasTemperature = drainHdapiErrors(api_).count == 0;
  hd::Boolean inkwell = 0;
  api_.hdGetBooleanv(hd::kCurrentInkwellSwitch, &inkwell);
  setup.hasInkwellSwitch = drainHdapiErrors(api_).count == 0;
  if (!setup.hasTemperature) {
    identity_.notes.push_back(Text::tr("The device does not report motor temperatures"));
  }
  return setup;
}

void HdapiSession::calibrateBeforeStart() {
  hd::Int styles = 0;
  api_.hdGetIntegerv(hd::kCalibrationStyle, &styles);
  (void)drainHdapiErrors(api_);
  // Only this style runs with the scheduler stopped; all others are the servo's.
  if (static_cast<hd::Enum>(styles) != hd::kCalibrationEncoderReset) {
    return;
  }
  if (api_.hdCheckCalibration() != hd::kCalibrationOk) {
    api_.hdUpdateCalibration(hd::kCalibrationEncoderReset);
  }
  if (drainHdapiErrors(api_).count > 0) {
    identity_.notes.push_back(Text::tr("The device refused to take its present position as the reference"));
  }
}

void HdapiSession::start(const DeviceTick& tick) {
  servo_->setTick(tick);
  const auto refuse = [this](Phrase what, const HdapiErrors& errors) {
    const hd::ErrorCode code = errors.worstCode();
    const Text sentence = Text::verbatim("%1: %2", what, described(api_, code));
    tearDown();
    throw Error(ErrorCode::kDevice, sentence, identity_.openedAs, remedyFor(code));
  };
  entry_ = new ServoEntry;  // given away
  entry_->servo.store(servo_.get());
  callback_ = api_.hdScheduleAsynchronous(servoCallback, entry_, hd::kDefaultPriority);
  const HdapiErrors scheduling = drainHdapiErrors(api_);
  scheduled_ = scheduling.worst < HdapiErrorClass::kLicence;
  if (!scheduled_) {
    refuse(Text::tr("the library did not take the servo's task"), scheduling);
  }
  if (api_.hdSetSchedulerRate != nullptr) {
    api_.hdSetSchedulerRate(kWantedRate_Hz);
    // Refused in different ways by different versions, always meaning "rate unchanged".
    if (drainHdapiErrors(api_).count > 0) {
      identity_.notes.push_back(Text::tr("The library keeps its own servo rate"));
    }
  }
  api_.hdStartScheduler();
  running_ = true;
  const HdapiErrors starting = drainHdapiErrors(api_);
  if (starting.worst >= HdapiErrorClass::kLicence) {
    refuse(Text::tr("the servo loop did not start"), starting);
  }
  served_ = true;
}

void HdapiSession::letGo() noexcept {
  if (servo_ == nullptr) {
    api_.hdDisable(hd::kForceOutput);
    return;
  }
  servo_->revokeTick();
  if (served_ && !servo_->silent()) {
    // Before anything else in the servo's next tick, even when the frame's own task is gone. Does not wait.
    (void)api_.hdScheduleAsynchronous(letGoCallback, entry_, hd::kMaxPriority);
  }
  const std::int64_t silent_us = clock_->now_us() - servo_->called_us();
  const std::int64_t least_us = servo_->inFrame() ? 0 : kServoMayCall_us;  // a frame that hangs calls nobody
  const auto until = std::chrono::steady_clock::now() +
                     std::chrono::microseconds(std::max(kServoLetsGo_us - silent_us, least_us));
  while (served_ && !servo_->silent() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  servo_->letGo(true);
  silent_.store(servo_->silent());
}

void HdapiSession::switchOff() noexcept {
  api_.hdDisable(hd::kForceOutput);
  if (servo_ != nullptr) {
    servo_->wishForce(false);
    servo_->letGo(true);
  }
}

void HdapiSession::tearDown() noexcept {
  if (handle_ != hd::kInvalidHandle) {
    letGo();
    if (running_) {
      api_.hdStopScheduler();
    }
    if (scheduled_) {
      api_.hdUnschedule(callback_);
    }
    if (entry_ != nullptr) {
      entry_->servo.store(nullptr);
      const auto until = std::chrono::steady_clock::now() + kCallbackEnds;
      while (entry_->inside.load() > 0 && std::chrono::steady_clock::now() < until) {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      }
      if (entry_->inside.load() > 0) {
        (void)servo_.release();  // a callback that hangs still uses it
      }
    }
    api_.hdDisableDevice(handle_);
    (void)drainHdapiErrors(api_);
    served_ = false;
    running_ = false;
    scheduled_ = false;
    handle_ = hd::kInvalidHandle;
  }
  if (std::exchange(claimed_, false)) {
    sessionOpen.store(false);
  }
}

}  // namespace torsio
