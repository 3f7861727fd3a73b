// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/inverse3/inverse3_driver.h"

#include <chrono>
#include <cstdlib>
#include <string>
#include <utility>

#include "sim/core/error.h"
#include "sim/device/inverse3/inverse3_device.h"

namespace torsio {

namespace {

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
