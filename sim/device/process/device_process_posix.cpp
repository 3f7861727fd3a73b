// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "sim/core/clock.h"
#include "sim/core/deadline.h"
#include "sim/core/error.h"
#include "sim/device/hdapi/hdapi_device.h"
#include "sim/device/hdapi/hdapi_library.h"
#include "sim/device/process/device_channel.h"
#include "sim/device/process/device_child_posix.h"
#include "sim/device/process/device_process.h"

namespace torsio {

namespace {

using std::chrono::steady_clock;

constexpr auto kLookEvery = std::chrono::milliseconds(5);
// Looks in a row without a frame: each takes at least kLookEvery, so that a machine that stalls both does not
// count.
constexpr int kLooksForgiven = static_cast<int>(kChildEnded_us / 5'000);
// A library that calibrates or searches takes seconds; more is a hang.
constexpr auto kOpens = std::chrono::seconds(15);
// A device that was lost because its process was ended, or ended by itself: no driver has such a code.
constexpr std::uint32_t kProcessEnded = 0xffff'ffffU;
constexpr std::int64_t kLostPatience_us = 200'000;
constexpr std::chrono::milliseconds kSecondHandCloses{500};
constexpr const char* kStylusDriver = "hdapi";

template <std::size_t Size>
void copyText(const std::string& from, std::array<char, Size>& to) {
  std::memcpy(to.data(), from.data(), std::min(from.size(), Size - 1));
}

/// What a second device process made of the force that the first one left.
enum class SecondHand { kNotNeeded, kUnderWay, kSwitchedOff, kRefused };

/// A stylus whose driver runs in the device process.
class ProcessDevice final : public HapticDevice {
 public:
  ProcessDevice(std::unique_ptr<DeviceChild> child, std::int64_t patience_us, std::function<bool()> cancelled,
                std::function<Text(std::uint32_t)> lossText)
      : child_(std::move(child)),
        report_(child_->report()),
        patience_us_(patience_us),
        cancelled_(std::move(cancelled)),
        lossText_(std::move(lossText)) {
    snapshot_.state = DeviceState::kOpened;
  }
  ~ProcessDevice() override { (void)close(); }

  void serve() override;
  bool close() override;
  void enableForce(bool on) noexcept override {
    child_->channel().forceWished.store(on);
    forceAsked_.store(forceAsked_.load() || on);
  }
  [[nodiscard]] DeviceSnapshot snapshot() noexcept override;
  [[nodiscard]] bool nextEvent(DeviceEvent& event) noexcept override {
    return child_->channel().events.next(taken_, event);
  }
  [[nodiscard]] Text lossText(std::uint32_t code) const override {
    if (code != kProcessEnded) {
      return lossText_ ? lossText_(code) : HapticDevice::lossText(code);
    }
    secondHand_.wait(SecondHand::kUnderWay);
    return secondHand_.load() == SecondHand::kNotNeeded ? Text::tr("the device does not answer")
                                                        : secondHandText_;
  }
  [[nodiscard]] const DeviceIdentity& identity() const noexcept override { return report_.identity; }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override {
    return report_.capabilities;
  }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand& command) noexcept override {
    force_ = {command.force_N, force_.number + 1};
    child_->channel().force.publish(force_);
  }
  void dropForce() noexcept override { child_->channel().drops.fetch_add(1); }

 private:
  void watch() noexcept;
  void takeSecondHand() noexcept;
  void letGoAgain();

  std::unique_ptr<DeviceChild> child_;
  ChannelReport report_;
  const std::int64_t patience_us_;
  std::function<bool()> cancelled_;
  std::function<Text(std::uint32_t)> lossText_;  // empty: the usual words
  std::thread supervisor_;
  std::atomic<bool> lost_{false};
  std::atomic<bool> ending_{false};
  std::atomic<bool> forceAsked_{false};
  std::atomic<SecondHand> secondHand_{SecondHand::kNotNeeded};
  Text secondHandText_;  // complete before secondHand_ says that there is one
  bool closed_ = false;
  bool released_ = false;
  DeviceSnapshot snapshot_;
  std::uint64_t taken_ = 0;  // events
  MailedForce force_;
  MailedReading reading_;
  ReadingAge age_{kDeviceStale | kDeviceUncalibrated, kReadingStale_us, kReadingLost_us};
};

void ProcessDevice::serve() {
  child_->channel().serveAsked.store(true);
  if (child_->leaves(ChannelStage::kOpened, kOpens, cancelled_) == ChannelStage::kServoRefused) {
    const ChannelReport report = child_->report();
    refuseDevice(report.happened, report.remedy);
  }
  supervisor_ = std::thread([this] { watch(); });
}

void ProcessDevice::watch() noexcept {
  (void)requestRealTime(RealTimeRank::kWatchdog);
  DeviceChannel& channel = child_->channel();
  std::uint64_t frames = 0;
  int still = 0;
  while (!ending_.load()) {
    std::this_thread::sleep_for(kLookEvery);
    const std::uint64_t seen = channel.frames.load(std::memory_order_acquire);
    still = seen != frames || seen == 0 ? 0 : still + 1;
    frames = seen;
    const std::optional<DeviceSnapshot> snapshot = channel.snapshot.latest();
    const bool over = snapshot && snapshot->state == DeviceState::kLost;  // said by the driver itself
    if (child_->gone() || child_->stopped() || (still >= kLooksForgiven && !over)) {
      if (forceAsked_.load()) {
        secondHand_.store(SecondHand::kUnderWay);
      }
      lost_.store(true);
      child_->end();
      takeSecondHand();
      return;
    }
  }
}

/// Where force was asked for, a device process that ended may have left one: another takes it off. The
/// supervisor's thread, or any after it has ended.
void ProcessDevice::takeSecondHand() noexcept {
  if (!forceAsked_.load()) {
    return;
  }
  const MonotonicClock clock;
  const std::int64_t begun_us = clock.now_us();
  SecondHand came = SecondHand::kRefused;
  try {
    letGoAgain();
    secondHandText_ =
        Text::tr("the device does not answer; a second connection switched its force off after %1 ms",
                 (clock.now_us() - begun_us) / 1000);
    came = SecondHand::kSwitchedOff;
  } catch (const Error& error) {
    secondHandText_ = Text::tr(
        "the device does not answer, and a second connection that would switch its force off failed (%1): "
        "let go of the stylus and switch the device off",
        error.happenedText());
  } catch (const std::exception&) {  // no memory for the words
  }
  secondHand_.store(came);
  secondHand_.notify_all();
}

/// Throws Error{kDevice} when the force may still be there.
void ProcessDevice::letGoAgain() {
  ChannelRequest request = child_->channel().request;
  request.onlyLetGo = true;
  DeviceChild second(request);
  const std::chrono::microseconds patience(kSecondHand_us);
  if (second.leaves(ChannelStage::kStarting, patience, {}) != ChannelStage::kServing) {
    const ChannelReport report = second.report();
    refuseDevice(report.library.status == HdapiLoadStatus::kLoaded || report.library.sentence.empty()
                     ? report.happened
                     : report.library.sentence,
                 report.remedy);
  }
  const auto until = steady_clock::now() + kSecondHandCloses;
  while (!second.gone() && steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

DeviceSnapshot ProcessDevice::snapshot() noexcept {
  if (const std::optional<DeviceSnapshot> newest = child_->channel().snapshot.latest()) {
    snapshot_ = *newest;
  }
  if (lost_.load()) {
    snapshot_.state = DeviceState::kLost;
    snapshot_.lostBecause = snapshot_.lostBecause == 0 ? kProcessEnded : snapshot_.lostBecause;
    const SecondHand hand = secondHand_.load();
    snapshot_.forceOn =
        snapshot_.forceOn && hand != SecondHand::kNotNeeded && hand != SecondHand::kSwitchedOff;
  }
  if (closed_) {
    snapshot_.state = DeviceState::kClosed;
    snapshot_.forceOn = snapshot_.forceOn && !released_;
  }
  return snapshot_;
}

DeviceSample ProcessDevice::read(std::int64_t time_us) noexcept {
  reading_ = child_->channel().reading.latest().value_or(reading_);
  DeviceSample sample = age_.marked(reading_, time_us);
  if (lost_.load(std::memory_order_relaxed)) {
    sample.status |= kDeviceLost | kDeviceStale;
  }
  return sample;
}

bool ProcessDevice::close() {
  if (closed_) {
    return released_;
  }
  closed_ = true;
  ending_.store(true);
  if (supervisor_.joinable()) {
    supervisor_.join();
  }
  DeviceChannel& channel = child_->channel();
  channel.closeAsked.store(true);
  // A lost device was released already or is ended anyway: do not wait for its library.
  const std::optional<DeviceSnapshot> last = channel.snapshot.latest();
  const bool lost = lost_.load() || (last && last->state == DeviceState::kLost);
  const auto until =
      steady_clock::now() +
      std::chrono::microseconds(lost ? std::min(patience_us_, kLostPatience_us) : patience_us_);
  while (!child_->gone() && steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  released_ = child_->gone() && !lost_.load() && channel.released.load();
  child_->end();
  const std::optional<DeviceSnapshot> end = channel.snapshot.latest();
  const bool off = channel.silent.load() || (end && end->state == DeviceState::kLost && !end->forceOn);
  if (!released_ && !lost_.load() && !off) {
    takeSecondHand();
  }
  return released_;
}

/// What came of a device process; no device when it only looked, or found no library.
struct HostedOpening {
  ChannelReport report;
  std::unique_ptr<HapticDevice> device;
};

HostedOpening openHosted(const ChannelRequest& request, std::int64_t patience_us,
                         const std::function<bool()>& cancelled,
                         const std::function<Text(std::uint32_t)>& lossText) {
  auto child = std::make_unique<DeviceChild>(request);
  const ChannelStage stage = child->leaves(ChannelStage::kStarting, kOpens, cancelled);
  HostedOpening opening{child->report(), nullptr};
  if (stage == ChannelStage::kRefused) {
    throw Error(ErrorCode::kDevice, opening.report.happened, Text::tr("haptic device"),
                opening.report.remedy);
  }
  if (stage != ChannelStage::kLooked) {
    opening.device = std::make_unique<ProcessDevice>(std::move(child), patience_us, cancelled, lossText);
  }
  return opening;
}

}  // namespace

StylusOpening openStylus(const StylusRequest& request) {
  if (request.inThisProcess) {
    StylusOpening opening{loadHdapi(request.library), nullptr};
    if (opening.library.status == HdapiLoadStatus::kLoaded && !request.onlyLibrary) {
      opening.driver = std::make_unique<HdapiDevice>(opening.library.api, request.options);
    }
    return opening;
  }
  ChannelRequest asked;
  copyText(kStylusDriver, asked.driver);
  copyText(request.library, asked.library);
  copyText(request.options.deviceName, asked.deviceName);
  asked.deviceToWorld = request.options.deviceToWorld;
  asked.workspaceCentre_m = request.options.workspaceCentre_m;
  asked.stylusTip_m = request.options.stylusTip_m;
  asked.onlyLook = request.onlyLibrary;
  HostedOpening hosted = openHosted(asked, request.options.patience_us, request.cancelled,
                                    [](std::uint32_t code) { return hdapiErrorText(code); });
  return {hosted.report.library, std::move(hosted.device)};
}

DeviceDriver hosted(const DeviceDriver& driver) {
  const auto asked = [id = driver.id](const DeviceRequest& request, bool onlyLook) {
    ChannelRequest channel;
    copyText(id, channel.driver);
    copyText(request.name, channel.deviceName);
    channel.workspaceCentre_m = request.workspaceCentre_m;
    channel.onlyLook = onlyLook;
    return channel;
  };
  DeviceDriver elsewhere = driver;
  elsewhere.look = [asked, driver](const DeviceRequest& request) -> DriverFinding {
    if (request.inThisProcess) {
      return driver.look(request);
    }
    try {
      return openHosted(asked(request, true), HdapiOptions().patience_us, request.cancelled, {})
          .report.finding;
    } catch (const Error& error) {
      return {false, error.happenedText(), error.remedyText(), {}};
    }
  };
  elsewhere.open = [asked, driver](const DeviceRequest& request) {
    return request.inThisProcess
               ? driver.open(request)
               : openHosted(asked(request, false), HdapiOptions().patience_us, request.cancelled, {}).device;
  };
  return elsewhere;
}

}  // namespace torsio
