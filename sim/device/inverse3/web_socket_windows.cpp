// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/error.h"
#include "sim/device/inverse3/web_socket.h"

namespace torsio {

struct WebSocket::Wire {};

WebSocket::WebSocket(const std::string&, int, std::int64_t) {
  throw Error(ErrorCode::kDevice, Text::tr("this device is not supported on this system yet"),
              Text::verbatim("WebSocket"), Text::tr("Use another device"));
}
WebSocket::~WebSocket() = default;
bool WebSocket::receive(std::string&, std::int64_t) {
  return false;
}
void WebSocket::send(const std::string&) {}
bool WebSocket::closed() const noexcept {
  return true;
}

}  // namespace torsio
