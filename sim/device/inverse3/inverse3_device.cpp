// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/inverse3/inverse3_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim/core/angle.h"
#include "sim/core/clock.h"
#include "sim/core/contracts.h"
#include "sim/core/deadline.h"
#include "sim/core/device_sample.h"
#include "sim/core/error.h"
#include "sim/core/plain_text.h"

namespace torsio {

namespace {

using Json = nlohmann::json;

/// A part of an object; null when it is missing or something else stands there.
Json part(const Json& from, const char* name) {
  const auto found = from.is_object() ? from.find(name) : from.end();
  return from.is_object() && found != from.end() ? *found : Json();
}

double numberOf(const Json& from, const char* name) {
  const Json value = part(from, name);
  return value.is_number() ? value.get<double>() : std::nan("");
}

std::string textOf(const Json& from, const char* name) {
  const Json value = part(from, name);
  return value.is_string() ? value.get<std::string>() : std::string();
}

/// The device of this id in a list of them; null when there is none.
Json deviceOf(const Json& list, const std::string& wanted) {
  if (list.is_array()) {
    for (const Json& device : list) {
      const std::string id = textOf(device, "device_id");
      if (!id.empty() && (wanted.empty() || id == wanted)) {
        return device;
      }
    }
  }
  return {};
}

std::optional<Vec3> cursorOf(const Json& state) {
  const Json place = part(state, "cursor_position");
  const Vec3 cursor_m{numberOf(place, "x"), numberOf(place, "y"), numberOf(place, "z")};
  const double way_m = norm(cursor_m);
  return std::isfinite(way_m) && way_m <= kInverse3Reach_m ? std::optional(cursor_m) : std::nullopt;
}

std::optional<Quat> orientationOf(const Json& state) {
  const Json turn = part(state, "orientation");
  const Quat q{numberOf(turn, "w"), numberOf(turn, "x"), numberOf(turn, "y"), numberOf(turn, "z")};
  const double length = norm(q);
  return std::isfinite(length) && length > 0.5 && length < 2.0 ? std::optional(normalized(q)) : std::nullopt;
}

std::uint32_t buttonsOf(const Json& state) {
  const Json pressed = part(state, "buttons");
  std::uint32_t buttons = 0;
  for (const auto& [name, bit] :
       {std::pair("a", kButtonGrip), std::pair("b", kButtonSecond), std::pair("c", kButtonBookmark)}) {
    const Json value = part(pressed, name);
    buttons |= value.is_boolean() && value.get<bool>() ? static_cast<std::uint32_t>(bit) : 0U;
  }
  return buttons;
}

constexpr std::size_t kMaxEvents = 256;
constexpr double kGripTime_s = 0.1;
/// Middle of the workspace as third parties' examples place it; measure your own.
constexpr Vec3 kCentre_m{0.0, -0.14, 0.2};
/// Half the edge of the cube about it that is used.
constexpr double kHalf_m = 0.1;
/// From a stylus along -z to one that points away from the user (y): a quarter turn about x.
constexpr Quat kAway{0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1, 0.0, 0.0};

constexpr const char* kDefaultPlace = "127.0.0.1:10001";
constexpr std::int64_t kPatience_us = 1'000'000;

Text plugItIn() {
  return Text::tr("Install the device's service and start it (docs/devices.md)");
}

std::unique_ptr<WebSocket> connectToService() {
  const char* const named = std::getenv("TORSIO_INVERSE_SERVICE");
  const std::string place = named != nullptr && *named != '\0' ? named : kDefaultPlace;
  const std::size_t colon = place.rfind(':');
  const int port = colon == std::string::npos ? 0 : std::atoi(place.c_str() + colon + 1);
  if (port <= 0 || port > 65'535) {
    throw Error(ErrorCode::kBadParameter, Text::tr("\"%1\" is not of the form HOST:PORT", place),
                Text::verbatim("TORSIO_INVERSE_SERVICE"), Text::tr("Correct the variable, or unset it"));
  }
  return std::make_unique<WebSocket>(place.substr(0, colon), port, kPatience_us);
}

/// The first message that names the device; empty when none does in time.
Inverse3Message firstMessage(WebSocket& service, const std::string& name) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(kPatience_us);
  std::string text;
  while (!service.closed() && std::chrono::steady_clock::now() < until) {
    if (service.receive(text, kPatience_us / 10)) {
      const std::optional<Inverse3Message> message = inverse3Message(text, name);
      if (message && !message->deviceId.empty()) {
        return *message;
      }
    }
  }
  return {};
}

DriverFinding lookForInverse3(const DeviceRequest& request) {
  try {
    const std::unique_ptr<WebSocket> service = connectToService();
    const Inverse3Message message = firstMessage(*service, request.name);
    if (message.deviceId.empty()) {
      return {false, Text::tr("the service runs, but has no such device"), plugItIn(), {}};
    }
    return {true, Text::tr("found: %1", message.deviceId), "", {}};
  } catch (const Error& error) {
    return {false, error.happenedText(), error.remedyText(), {}};
  }
}

}  // namespace

std::optional<Inverse3Message> inverse3Message(const std::string& json, const std::string& wanted) {
  const Json whole = Json::parse(json, nullptr, false);
  if (!whole.is_object()) {
    return std::nullopt;
  }
  Inverse3Message message;
  const Json device = deviceOf(part(whole, "inverse3"), wanted);
  message.deviceId = textOf(device, "device_id");
  const Json version = part(part(part(device, "config"), "device_info"), "firmware_version");
  message.firmware = version.is_null() ? std::string() : plainLine(version.dump());
  message.cursor_m = cursorOf(part(device, "state"));
  for (const char* const kind : {"wireless_verse_grip", "verse_grip"}) {
    const Json grip = part(deviceOf(part(whole, kind), {}), "state");
    if (!message.orientation && grip.is_object()) {
      message.orientation = orientationOf(grip);
      message.buttons = buttonsOf(grip);
    }
  }
  return message;
}

std::string inverse3Force(const std::string& deviceId, const Vec3& force_N) {
  const Json values{{"x", force_N.x}, {"y", force_N.y}, {"z", force_N.z}};
  const Json command{{"device_id", deviceId}, {"commands", {{"set_cursor_force", {{"values", values}}}}}};
  return Json{{"inverse3", Json::array({command})}}.dump();
}

Inverse3Device::Inverse3Device(std::unique_ptr<WebSocket> service, const Inverse3Message& first,
                               const DeviceRequest& request)
    : service_(std::move(service)),
      deviceId_(first.deviceId),
      origin_m_(request.workspaceCentre_m - kCentre_m),
      events_(kMaxEvents) {
  identity_.model = "Inverse3";
  identity_.vendor = "Haply";
  identity_.serial = plainLine(first.deviceId);
  identity_.driverVersion = first.firmware;
  identity_.openedAs = identity_.serial;
  identity_.inputDof = first.orientation ? 6 : 3;
  identity_.outputDof = 3;
  identity_.assumed = {Text::tr("maximum force"), Text::tr("usable workspace")};
  identity_.notes.push_back(Text::tr("this kind of device was not confirmed on hardware yet"));
  if (!first.orientation) {
    identity_.notes.push_back(Text::tr("no handle is connected: the jaw cannot be turned or closed"));
  }
  const Vec3 half_m{kHalf_m, kHalf_m, kHalf_m};
  capabilities_.model = identity_.model;
  capabilities_.workspaceMin_m = request.workspaceCentre_m - half_m;
  capabilities_.workspaceMax_m = request.workspaceCentre_m + half_m;
  capabilities_.rendersForce = true;
  reading_.pose.orientation = kAway;
}

Inverse3Device::~Inverse3Device() {
  (void)close();
}

void Inverse3Device::start(const DeviceTick& tick) {
  TORSIO_EXPECTS(!thread_.joinable() && !closed_);
  tick_ = tick;
  thread_ = std::thread([this] { follow(); });
}

void Inverse3Device::beginClose() {
  ending_.store(true);
  while (inTick_.load()) {
    std::this_thread::sleep_for(std::chrono::microseconds(50));  // it may go before the driver's thread
  }
}

void Inverse3Device::switchOff() noexcept {
  ending_.store(true);
  const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(2 * kInverse3Look_us);
  while (!released() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  if (!released()) {  // the thread that would send zero is the one that ends
    service_->send(inverse3Force(deviceId_, {}));
  }
}

bool Inverse3Device::close() {
  beginClose();
  if (thread_.joinable()) {
    thread_.join();
  }
  closed_ = true;
  service_.reset();
  released_.store(true, std::memory_order_release);
  return true;
}

/// The driver's thread, until the end or the loss of the device.
void Inverse3Device::follow() {
  (void)requestRealTime(RealTimeRank::kServo);
  const MonotonicClock clock;
  begun_us_ = clock.now_us();
  taken_us_ = begun_us_;
  TickMeter meter;
  std::string text;
  service_->send(inverse3Force(deviceId_, {}));  // the service answers commands
  while (!ending_.load(std::memory_order_relaxed)) {
    const bool came = service_->receive(text, kInverse3Look_us);
    const std::int64_t now_us = clock.now_us();
    if (service_->closed() || now_us - taken_us_ > kInverse3Lost_us) {
      break;
    }
    if (came) {
      (void)meter.begin(now_us);
    }
    answer(came, text, now_us);
    if (came) {
      meter.end(clock.now_us());
      state_.timing = meter.values();
    }
    snapshots_.publish(state_);
  }
  service_->send(inverse3Force(deviceId_, {}));
  if (!ending_.load()) {
    state_.state = DeviceState::kLost;
    publish(kDeviceLost | kDeviceStale, clock.now_us());
    runTick(clock.now_us());
    snapshots_.publish(state_);
    (void)events_.push({DeviceEvent::Kind::kLost, clock.now_us() - begun_us_, 0, 0, 0});
  }
  released_.store(true, std::memory_order_release);
}

/// Reads, lets the tick answer, and sends the force; none while the position of the hand is unknown.
void Inverse3Device::answer(bool came, const std::string& text, std::int64_t now_us) {
  const bool valid = came && take(text, now_us);
  if (came) {
    ++(valid ? state_.validPoses : state_.invalidPoses);
  }
  publish(valid ? kDeviceOk : (came ? kDeviceInvalid : kDeviceStale), now_us);
  runTick(now_us);
  if (!valid) {
    gate_.close();
  }
  const Vec3 force_N = valid ? allowedForce_N(now_us) : Vec3{};
  service_->send(inverse3Force(deviceId_, force_N));
  state_.forcesSent += norm(force_N) > 0.0 ? 1 : 0;
}

void Inverse3Device::runTick(std::int64_t now_us) {
  if (tick_.run == nullptr) {
    return;
  }
  // Sequentially consistent: either beginClose() sees this tick and waits, or this tick sees the end.
  inTick_.store(true);
  if (!ending_.load()) {
    tick_.run(tick_.context, now_us - begun_us_);
  }
  inTick_.store(false);
}

bool Inverse3Device::take(const std::string& text, std::int64_t now_us) {
  const std::optional<Inverse3Message> message = inverse3Message(text, deviceId_);
  if (!message || message->deviceId != deviceId_ || !message->cursor_m) {
    return false;
  }
  keep(*message, now_us);
  return true;
}

/// Makes the reading of a valid message: the device's axes are those of the world.
void Inverse3Device::keep(const Inverse3Message& message, std::int64_t now_us) {
  const double step_s = 1e-6 * static_cast<double>(std::clamp<std::int64_t>(now_us - taken_us_, 0, 100'000));
  taken_us_ = now_us;
  reading_.pose.position_m = origin_m_ + *message.cursor_m;
  if (message.orientation) {
    const Quat before = reading_.pose.orientation;
    reading_.pose.orientation = *message.orientation * kAway;
    const Vec3 axis = rotate(before, {0.0, 0.0, 1.0});
    reading_.roll_rad += unwrapNear(turnAbout(axis, before, reading_.pose.orientation), 0.0);
  }
  const double goal = (message.buttons & kButtonGrip) != 0 ? 1.0 : 0.0;
  const double most = step_s / kGripTime_s;
  reading_.grip += std::clamp(goal - reading_.grip, -most, most);
  if (reading_.buttons != message.buttons) {
    (void)events_.push({DeviceEvent::Kind::kButtons, now_us - begun_us_, message.buttons, 0, 0});
  }
  reading_.buttons = message.buttons;
}

void Inverse3Device::publish(std::uint32_t trouble, std::int64_t now_us) {
  reading_.time_us = now_us - begun_us_;
  published_.sample = quantize(reading_, published_.sample);
  published_.sample.status |= trouble;
  ++published_.number;
  readings_.publish(published_);
  state_.sample = published_.sample;
  if (state_.state != DeviceState::kLost) {
    state_.calibration = state_.validPoses > 0 ? CalibrationState::kCalibrated : CalibrationState::kUnknown;
    state_.rollReferenced = true;  // the handle knows its own zero
    state_.forceOn = forceWished_.load(std::memory_order_relaxed);
    state_.state = state_.forceOn ? DeviceState::kRunning : DeviceState::kReady;
  } else {
    state_.forceOn = false;
  }
}

/// The force that may be sent now, N.
Vec3 Inverse3Device::allowedForce_N(std::int64_t now_us) {
  const MailedForce wanted = forces_.latest();
  if (wanted.number != forceNumber_) {
    forceNumber_ = wanted.number;
    forceNew_us_ = now_us;
  }
  const std::uint32_t drops = drops_.load(std::memory_order_relaxed);
  if (drops != dropsSeen_) {
    dropsSeen_ = drops;
    droppedNumber_ = wanted.number;
    gate_.close();
  }
  const bool mayPush = forceWished_.load(std::memory_order_relaxed) && wanted.number > droppedNumber_ &&
                       now_us - forceNew_us_ <= kInverse3Stale_us && isFinite(wanted.force_N);
  if (!mayPush) {
    gate_.close();
  }
  const double share = gate_.advance(std::clamp<std::int64_t>(now_us - sent_us_, 0, kServoPeriod_us));
  sent_us_ = now_us;
  const double size_N = norm(wanted.force_N);
  if (!mayPush || !(size_N > 0.0)) {
    return {};
  }
  return wanted.force_N * (share * std::min(1.0, capabilities_.maxForce_N / size_N));
}

DeviceSnapshot Inverse3Device::snapshot() noexcept {
  DeviceSnapshot snapshot = snapshots_.latest();
  if (closed_) {
    snapshot.state = DeviceState::kClosed;
    snapshot.forceOn = false;
  }
  return snapshot;
}

DeviceSample Inverse3Device::read(std::int64_t time_us) noexcept {
  return age_.marked(readings_.latest(), time_us);
}

void Inverse3Device::write(const ForceCommand& command) noexcept {
  wanted_ = {command.force_N, wanted_.number + 1};
  forces_.publish(wanted_);
}

std::unique_ptr<HostedDevice> openInverse3(const DeviceRequest& request) {
  std::unique_ptr<WebSocket> service = connectToService();
  const Inverse3Message message = firstMessage(*service, request.name);
  if (message.deviceId.empty()) {
    throw Error(ErrorCode::kDevice, Text::tr("the service runs, but has no such device"),
                Text::verbatim("Inverse3"), plugItIn());
  }
  return std::make_unique<Inverse3Device>(std::move(service), message, request);
}

DeviceDriver inverse3Driver() {
  DeviceDriver driver;
  driver.id = "inverse3";
  driver.name = "Haply Inverse3";
  driver.needs = Text::tr("the device's service on this computer; not confirmed on hardware");
  driver.rendersForce = true;
  driver.look = lookForInverse3;
  driver.open = openInverse3;
  return driver;
}

}  // namespace torsio
