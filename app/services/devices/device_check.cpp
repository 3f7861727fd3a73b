// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/device_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/devices/device_readiness.h"
#include "app/services/devices/held_up.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/load_decimals.h"
#include "sim/core/text.h"
#include "sim/servo/servo_thread.h"

namespace torsio {

namespace {

constexpr double kPollEvery_s = 0.01;
constexpr double kWriteEvery_s = 0.001;
// The vendor asks for 1000 Hz and discourages 500 Hz.
constexpr double kGoodRate_Hz = 950.0;
constexpr double kGoodRegularShare = 0.95;
// A hand moves at less than 10 Hz; readings slower than this look like steps.
constexpr double kGoodReadings_Hz = 60.0;
constexpr double kGeometryTolerance_m = 0.005;
// No calibration is that wrong: positions in another unit, or along other axes.
constexpr double kGeometryWrong_m = 0.025;
constexpr double kRollNoise_deg = 2.0;
// Share of frames that may lack a position: the device occasionally skips one.
constexpr double kPosesForgiven = 0.01;
// Frames with force in two seconds below which the force test was not felt.
constexpr std::int64_t kForcesSeen = 100;
// Time for taking the stylus out of the inkwell before the force test.
constexpr double kUndockWait_s = 15.0;
// Time for pressing the buttons when asked to.
constexpr double kButtonWait_s = 15.0;

/// The stylus's buttons by their bits, as people count them.
struct StylusButton {
  std::uint32_t bit;
  int number;
};
constexpr std::array<StylusButton, 2> kStylusButtons{{{kButtonGrip, 1}, {kButtonSecond, 2}}};

Text orNotReported(const std::string& value) {
  return value.empty() ? Text::tr("not reported") : Text(value);
}

/// One check, step by step; each step returns false if the next ones make no sense.
class Check {
 public:
  explicit Check(const DeviceCheckRequest& request) : request_(request) {}

  DeviceCheckResult run() {
    if (openDevice() && startServo()) {
      if (waitForCalibration() && measure()) {
        judgeServo();
        if (judgePosition() && judgeButtons() && request_.forceTest && rendersForce()) {
          testForce();
        }
      }
      close();
    }
    return std::move(result_);
  }

 private:
  void add(FindingGrade grade, Phrase subject, const Text& sentence, const Text& remedy = "") {
    result_.findings.push_back({std::string(subject.english()), grade, sentence, remedy});
  }
  void say(const Text& sentence) const {
    if (request_.say) {
      request_.say(sentence);
    }
  }
  [[nodiscard]] bool cancelled() const { return request_.cancelled && request_.cancelled(); }
  [[nodiscard]] double elapsed_s(std::int64_t from_us) const {
    return 1e-6 * static_cast<double>(clock_.now_us() - from_us);
  }

  bool openDevice() {
    const DeviceRequest request = deviceRequest(request_.choice, request_.cancelled);
    const DeviceDriver& driver = chosenDriver(request_.choice);
    const Phrase subject = driver.takesLibrary ? Text::tr("Library") : Text::tr("Driver");
    vendorLibrary_ = driver.takesLibrary;
    const DriverFinding found = driver.look(request);
    add(found.available ? FindingGrade::kGood : FindingGrade::kBad, subject, found.sentence, found.remedy);
    for (const Text& note : found.notes) {
      add(FindingGrade::kNote, subject, note);
    }
    if (!found.available) {
      return false;
    }
    try {
      device_ = driver.open(request);
    } catch (const Error& error) {
      add(FindingGrade::kBad, Text::tr("Device"), error.happenedText(), error.remedyText());
      return false;
    }
    describeDevice();
    return true;
  }

  void describeDevice() {
    result_.capabilities = device_->capabilities();
    result_.identity = device_->identity();
    const DeviceIdentity& id = result_.identity;
    add(FindingGrade::kGood, Text::tr("Device"),
        Text::tr("%1, serial number %2, driver %3, library %4, opened as %5", result_.capabilities.model,
                 orNotReported(id.serial), orNotReported(id.driverVersion), orNotReported(id.libraryVersion),
                 id.openedAs));
    for (const Text& note : id.notes) {
      add(FindingGrade::kNote, Text::tr("Device"), note);
    }
    if (!id.assumed.empty()) {
      add(FindingGrade::kNote, Text::tr("Device"),
          Text::tr("not reported in a form that makes sense, so a cautious value is assumed: %1",
                   listed(id.assumed)));
    }
    if (!rendersForce()) {
      add(FindingGrade::kNote, Text::tr("Force"),
          Text::tr("this device gives no force: it is shown, not felt"),
          Text::tr("Measures of force are marked in every run with it"));
      return;
    }
    if (vendorLibrary_) {
      add(FindingGrade::kGood, Text::tr("Licence"), Text::tr("the library works on this computer"));
    }
    add(FindingGrade::kGood, Text::tr("Limits"),
        Text::tr("force up to %1 N, sustained %2 N, three axes, no torque about the stylus",
                 formatFixed(result_.capabilities.maxForce_N, kForceDecimals),
                 formatFixed(result_.capabilities.continuousForce_N, kForceDecimals)));
  }
  [[nodiscard]] bool rendersForce() const { return result_.capabilities.rendersForce; }
  bool startServo() {
    try {
      device_->serve();
    } catch (const Error& error) {
      add(FindingGrade::kBad, Text::tr("Servo"), error.happenedText(), error.remedyText());
      device_.reset();
      return false;
    }
    begun_us_ = clock_.now_us();
    return true;
  }

  /// Returns false, with a finding, if the device was lost or the user cancelled.
  bool stillThere(const DeviceSnapshot& now) {
    const bool fellSilent = now.state == DeviceState::kSilent && now.timing.ticks > 0;
    const bool starved = heldUp_.starved();
    if (starved && (fellSilent || now.state == DeviceState::kLost)) {
      add(FindingGrade::kBad, Text::tr("Computer"), heldUp_.sentence(), HeldUp::remedy());
    }
    if (fellSilent && starved) {
      return false;
    }
    if (fellSilent) {
      add(FindingGrade::kBad, Text::tr("Connection"),
          Text::tr("the library's servo stopped calling after %1 s", formatFixed(elapsed_s(begun_us_), 1)),
          Text::tr("Check cable and power, then plug the device in again and repeat the check"));
      return false;
    }
    if (now.state == DeviceState::kLost) {
      add(FindingGrade::kBad, Text::tr("Connection"),
          Text::tr("%1 after %2 s", device_->lossText(now.lostBecause), formatFixed(elapsed_s(begun_us_), 1)),
          starved ? HeldUp::remedy()
                  : Text::tr("Check cable and power, then plug the device in again and repeat the check"));
      return false;
    }
    if (cancelled()) {
      add(FindingGrade::kBad, Text::tr("Check"), Text::tr("stopped before its end"),
          Text::tr("Repeat the check"));
      return false;
    }
    return true;
  }

  bool waitForCalibration() {
    const std::int64_t from_us = clock_.now_us();
    bool asked = false;
    for (;;) {
      const DeviceSnapshot now = device_->snapshot();
      if (!stillThere(now)) {
        return false;
      }
      if (now.timing.ticks > 0 && now.calibration == CalibrationState::kCalibrated) {
        break;
      }
      if (now.calibration == CalibrationState::kFailed) {
        add(FindingGrade::kBad, Text::tr("Calibration"),
            Text::tr("the device refused to be calibrated several times"),
            Text::tr("Put the stylus firmly into the inkwell and repeat the check"));
        return false;
      }
      if (now.calibration == CalibrationState::kDockStylus && !asked) {
        say(Text::tr("Put the stylus into the inkwell and leave it there"));
        asked = true;
      }
      if (elapsed_s(from_us) > request_.calibrationWait_s) {
        noteNoCalibration(now);
        return false;
      }
      heldUp_.pause_s(kPollEvery_s);
    }
    result_.calibrated = true;
    add(FindingGrade::kGood, Text::tr("Calibration"),
        asked            ? Text::tr("done in the inkwell")
        : rendersForce() ? Text::tr("the device is calibrated")
                         : Text::tr("the device needs none"));
    return true;
  }

  void noteNoCalibration(const DeviceSnapshot& now) {
    if (now.timing.ticks == 0 && heldUp_.starved()) {
      add(FindingGrade::kBad, Text::tr("Computer"), heldUp_.sentence(), HeldUp::remedy());
    } else if (now.timing.ticks == 0) {
      add(FindingGrade::kBad, Text::tr("Servo"), Text::tr("the library's servo loop never called"),
          Text::tr("Close every other program that uses the device; restart the computer"));
    } else {
      add(FindingGrade::kBad, Text::tr("Calibration"),
          Text::tr("the device is not calibrated; its position would be wrong and its force stays off"),
          Text::tr("Put the stylus into the inkwell and repeat the check"));
    }
  }

  bool measure() {
    say(Text::tr("Measuring the servo for %1 s", formatFixed(request_.seconds, 1)));
    const DeviceSnapshot first = device_->snapshot();
    const std::int64_t from_us = clock_.now_us();
    bool docked = true;
    double lowest_rad = 1e9;
    double highest_rad = -1e9;
    DeviceSnapshot now = first;
    while (elapsed_s(from_us) < request_.seconds) {
      heldUp_.pause_s(kPollEvery_s);
      now = device_->snapshot();
      if (!stillThere(now)) {
        return false;
      }
      const double roll_rad = lookAtButtons(now);
      geometry_m_.push_back(now.geometryError_m);
      docked = docked && now.docked;
      lowest_rad = std::min(lowest_rad, roll_rad);
      highest_rad = std::max(highest_rad, roll_rad);
    }
    last_ = now;
    const double time_s = elapsed_s(from_us);
    const auto ticks = static_cast<double>(now.timing.ticks - first.timing.ticks);
    validPoses_ = now.validPoses - first.validPoses;
    invalidPoses_ = now.invalidPoses - first.invalidPoses;
    refusedFrames_ = now.refusedFrames - first.refusedFrames;
    const std::size_t regular = timingClass(kServoPeriod_us);
    result_.rate_Hz = ticks / time_s;
    result_.regularShare =
        ticks > 0.0
            ? static_cast<double>(now.timing.intervals[regular] - first.timing.intervals[regular]) / ticks
            : 0.0;
    result_.timing = now.timing;
    lateTicks_ = now.timing.late - first.timing.late;
    gaps_ = now.timing.gaps - first.timing.gaps;
    if (docked && highest_rad >= lowest_rad) {
      rollNoise_deg_ = degrees(highest_rad - lowest_rad);
    }
    return true;
  }

  void judgeServo() {
    const std::string rate = formatFixed(result_.rate_Hz, 0) + " Hz";
    if (!rendersForce()) {
      const bool quick = result_.rate_Hz >= kGoodReadings_Hz;
      add(quick ? FindingGrade::kGood : FindingGrade::kNote, Text::tr("Rate"), rate,
          quick ? Text() : Text::tr("Close other programs"));
      return;
    }
    const Text slowRemedy = HeldUp::remedy();
    if (result_.rate_Hz < kLowestRate_Hz) {
      add(FindingGrade::kBad, Text::tr("Rate"),
          Text::tr("%1; below %2 Hz no force is rendered", rate, formatFixed(kLowestRate_Hz, 0)), slowRemedy);
    } else if (result_.rate_Hz < kGoodRate_Hz) {
      add(FindingGrade::kNote, Text::tr("Rate"), Text::tr("%1; 1000 Hz are wanted", rate), slowRemedy);
    } else {
      add(FindingGrade::kGood, Text::tr("Rate"), rate);
    }
    const Text jitter = Text::tr(
        "%1 % of the ticks came within 0.1 ms of their time, %2 late, %3 after a pause of more than 5 ms "
        "(the "
        "force is cut then)",
        formatFixed(100.0 * result_.regularShare, 1), lateTicks_, gaps_);
    const bool calm = result_.regularShare >= kGoodRegularShare && gaps_ == 0;
    add(calm ? FindingGrade::kGood : FindingGrade::kNote, Text::tr("Jitter"), jitter,
        calm ? Text() : slowRemedy);
    judgeScheduling(calm);
  }

  /// A refused real-time privilege matters only if felt: a servo that keeps its timing anyway is good.
  void judgeScheduling(bool calm) {
    const RealTimeGrant grant = askForRealTime();
    if (grant.scheduling && grant.memory) {
      add(FindingGrade::kGood, Text::tr("Scheduling"),
          Text::tr("the servo goes before other work and stays in memory"));
      return;
    }
    const Text refused = refusedToServo(grant.scheduling, grant.memory);
    add(calm ? FindingGrade::kGood : FindingGrade::kNote, Text::tr("Scheduling"),
        calm ? Text::tr("%1; the servo kept its time all the same", refused) : refused, grantRealTime());
  }

  /// Returns false if the device gives no position from which force could be computed.
  bool judgePosition() {
    if (!positionIsSound() || !geometryIsSound()) {
      return false;
    }
    if (rendersForce()) {
      judgeStylus();
    }
    return true;
  }

  /// Checks the frames between two snapshots, the later of which becomes last_.
  bool soundBetween(const DeviceSnapshot& first, const DeviceSnapshot& now) {
    last_ = now;
    validPoses_ = now.validPoses - first.validPoses;
    invalidPoses_ = now.invalidPoses - first.invalidPoses;
    refusedFrames_ = now.refusedFrames - first.refusedFrames;
    return positionIsSound();
  }

  bool positionIsSound() {
    const std::int64_t frames = validPoses_ + invalidPoses_ + refusedFrames_;
    const auto lost = static_cast<double>(frames - validPoses_);
    if (frames == 0 || lost > kPosesForgiven * static_cast<double>(frames)) {
      add(FindingGrade::kBad, Text::tr("Position"),
          Text::tr("%1 of %2 {frame|frames} gave a valid position, %3 {was|were} refused", validPoses_,
                   frames, refusedFrames_),
          Text::tr("Calibrate the device again; if it stays so, have it serviced"));
      return false;
    }
    if (last_.frozen) {
      add(FindingGrade::kBad, Text::tr("Position"),
          Text::tr("the position stands still while the stylus is turned"),
          Text::tr("Calibrate the device again; if it stays so, have it serviced"));
      return false;
    }
    return true;
  }

  /// Takes the worst tenth of the measurement: where axes are swapped, some poses look right.
  bool geometryIsSound() {
    if (geometry_m_.empty()) {
      return true;
    }
    const auto worst = geometry_m_.begin() + static_cast<std::ptrdiff_t>(geometry_m_.size() * 9 / 10);
    std::nth_element(geometry_m_.begin(), worst, geometry_m_.end());
    const Text differ =
        Text::tr("position and joint angles differ by %1 mm from what is published for this model",
                 formatFixed(1e3 * *worst, 1));
    if (*worst > kGeometryWrong_m) {
      add(FindingGrade::kBad, Text::tr("Geometry"),
          Text::tr("%1: the position has another unit or other axes, or the device is not calibrated",
                   differ),
          Text::tr("Calibrate again in the inkwell; if it stays so, use another driver of the vendor"));
      return false;
    }
    if (*worst > kGeometryTolerance_m) {
      add(FindingGrade::kNote, Text::tr("Geometry"), differ, Text::tr("Calibrate again in the inkwell"));
    }
    return true;
  }

  /// Remembers which buttons were pressed and which were not; returns the roll.
  double lookAtButtons(const DeviceSnapshot& now) {
    const ToolState tool = toolState(now.sample);
    pressed_ |= tool.buttons;
    released_ |= ~tool.buttons;
    return tool.roll_rad;
  }

  /// "1", "1, 2": the buttons of which `isOne` holds.
  template <typename Predicate>
  static Text buttonsWith(const Predicate& isOne) {
    std::vector<Text> numbers;
    for (const StylusButton& button : kStylusButtons) {
      if (isOne(button.bit)) {
        numbers.emplace_back(std::to_string(button.number));
      }
    }
    return listed(numbers);
  }

  /// Returns false if a button is stuck, or was asked for and did not answer.
  bool judgeButtons() {
    if (!rendersForce()) {
      return true;
    }
    if (request_.buttons && !waitForButtons()) {
      return false;
    }
    const Text stuck = buttonsWith([this](std::uint32_t bit) { return (released_ & bit) == 0; });
    if (!stuck.empty()) {
      add(FindingGrade::kBad, Text::tr("Buttons"), Text::tr("button %1 is pressed all the time", stuck),
          Text::tr("Let go of the buttons and repeat the check; if it stays so, have the stylus serviced"));
      return false;
    }
    const Text silent = buttonsWith([this](std::uint32_t bit) { return (pressed_ & bit) == 0; });
    if (silent.empty()) {
      add(FindingGrade::kGood, Text::tr("Buttons"), Text::tr("both buttons answer"));
    } else if (request_.buttons) {
      add(FindingGrade::kBad, Text::tr("Buttons"), Text::tr("button %1 did not answer", silent),
          Text::tr("Press each button when you are asked to; if it stays so, have the stylus serviced"));
      return false;
    } else {
      add(FindingGrade::kGood, Text::tr("Buttons"),
          Text::tr("none is stuck; button %1 was not pressed", silent));
    }
    return true;
  }

  bool waitForButtons() {
    say(Text::tr("Press each button of the stylus once"));
    const std::int64_t from_us = clock_.now_us();
    const auto seen = [this](std::uint32_t bit) { return (pressed_ & released_ & bit) != 0; };
    while (elapsed_s(from_us) < std::min(kButtonWait_s, request_.calibrationWait_s) &&
           !(seen(kButtonGrip) && seen(kButtonSecond))) {
      heldUp_.pause_s(kPollEvery_s);
      const DeviceSnapshot now = device_->snapshot();
      if (!stillThere(now)) {
        return false;
      }
      (void)lookAtButtons(now);
    }
    return true;
  }

  void judgeStylus() {
    result_.rollReferenced = last_.rollReferenced;
    if (!last_.rollReferenced) {
      add(FindingGrade::kNote, Text::tr("Roll"), Text::tr("the turn of the stylus has no reference yet"),
          Text::tr("Rest the stylus in the inkwell for a moment before training"));
    } else if (rollNoise_deg_ && *rollNoise_deg_ > kRollNoise_deg) {
      add(FindingGrade::kNote, Text::tr("Roll"),
          Text::tr("the turn of the resting stylus wanders by %1 degrees", formatFixed(*rollNoise_deg_, 1)),
          Text::tr("Angles are not known better than that on this device; have it serviced"));
    } else {
      add(FindingGrade::kGood, Text::tr("Roll"),
          rollNoise_deg_
              ? Text::tr("the resting stylus wanders by %1 degrees", formatFixed(*rollNoise_deg_, 2))
              : Text::tr("the docked reference is taken"));
    }
    if (last_.warmest > kWarmAbove) {
      add(FindingGrade::kNote, Text::tr("Motors"), Text::tr("warm; the force is folded back"),
          Text::tr("Let the device rest for a while"));
    }
  }

  void testForce() {
    if (!waitUntilUndocked()) {
      return;
    }
    say(Text::tr("Hold the stylus: it will push upwards with %1 N for %2 s",
                 formatFixed(kSelfTestForce_N, kForceDecimals), formatFixed(kSelfTestTime_s, 0)));
    device_->enableForce(true);
    const DeviceSnapshot before = device_->snapshot();
    const std::int64_t from_us = clock_.now_us();
    DeviceSnapshot now = before;
    bool everOn = false;
    for (double t_s = 0.0; t_s < kSelfTestTime_s; t_s = elapsed_s(from_us)) {
      const double swell = std::sin(kPi * t_s / kSelfTestTime_s);
      device_->write({{0.0, 0.0, kSelfTestForce_N * swell * swell}, 0});
      heldUp_.pause_s(kWriteEvery_s);
      now = device_->snapshot();
      everOn = everOn || now.forceOn;
      if (!stillThere(now)) {
        break;
      }
    }
    device_->write({});
    device_->enableForce(false);
    if (now.state == DeviceState::kLost || cancelled() || !soundBetween(before, now)) {
      return;
    }
    if (!everOn) {
      add(FindingGrade::kBad, Text::tr("Force"), Text::tr("the force output did not switch on"),
          Text::tr("Check the device's power supply and repeat the check"));
    } else if (now.forceTrips > before.forceTrips) {
      add(FindingGrade::kBad, Text::tr("Force"),
          Text::tr("the device's own protection switched the force off"),
          Text::tr("Let the device rest, calibrate it again and repeat the check"));
    } else if (now.forcesSent - before.forcesSent < kForcesSeen ||
               now.forcesRefused - before.forcesRefused + now.refusedFrames - before.refusedFrames > 0) {
      add(FindingGrade::kBad, Text::tr("Force"),
          Text::tr("the library took %1 {frame|frames} with force and refused %2",
                   now.forcesSent - before.forcesSent,
                   now.forcesRefused - before.forcesRefused + now.refusedFrames - before.refusedFrames),
          Text::tr("Let the device rest, calibrate it again and repeat the check"));
    } else {
      add(FindingGrade::kGood, Text::tr("Force"),
          Text::tr("%1 N upwards were sent without an error; only the person holding the stylus knows "
                   "whether they were felt",
                   formatFixed(kSelfTestForce_N, kForceDecimals)));
    }
  }

  bool waitUntilUndocked() {
    if (!device_->snapshot().docked) {
      return true;
    }
    say(Text::tr("Take the stylus out of the inkwell and hold it in the middle of the workspace"));
    const std::int64_t from_us = clock_.now_us();
    while (elapsed_s(from_us) < std::min(kUndockWait_s, request_.calibrationWait_s)) {
      const DeviceSnapshot now = device_->snapshot();
      if (!stillThere(now)) {
        return false;
      }
      if (!now.docked) {
        return true;
      }
      heldUp_.pause_s(kPollEvery_s);
    }
    add(FindingGrade::kNote, Text::tr("Force"), Text::tr("not tested: the stylus stayed in the inkwell"),
        Text::tr("Repeat the check and hold the stylus"));
    return false;
  }

  void close() {
    if (!device_->close()) {
      add(FindingGrade::kBad, Text::tr("Shutdown"),
          Text::tr("the vendor's library does not release the device"),
          Text::tr("Quit Torsio, plug the device in again and start again"));
    }
  }

  const DeviceCheckRequest& request_;
  MonotonicClock clock_;
  HeldUp heldUp_;
  DeviceCheckResult result_;
  std::unique_ptr<HapticDevice> device_;
  DeviceSnapshot last_;
  bool vendorLibrary_ = false;
  std::int64_t begun_us_ = 0;
  std::int64_t lateTicks_ = 0;
  std::int64_t gaps_ = 0;
  std::int64_t validPoses_ = 0;
  std::int64_t invalidPoses_ = 0;
  std::int64_t refusedFrames_ = 0;
  std::optional<double> rollNoise_deg_;
  std::vector<double> geometry_m_;
  std::uint32_t pressed_ = 0;
  std::uint32_t released_ = 0;
};

}  // namespace

bool DeviceCheckResult::usable() const {
  return worst() == nullptr;
}

const DeviceFinding* DeviceCheckResult::worst() const {
  const auto bad = std::find_if(findings.begin(), findings.end(),
                                [](const DeviceFinding& f) { return f.grade == FindingGrade::kBad; });
  return bad != findings.end() ? &*bad : nullptr;
}

DeviceCheckResult checkDevice(const DeviceCheckRequest& request) {
  requireTime(request.seconds, 600.0, Text::tr("the time of the measurement"));
  requireTime(request.calibrationWait_s, 600.0, Text::tr("the wait for the calibration"));
  return Check(request).run();
}

}  // namespace torsio
