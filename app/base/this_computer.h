// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QHostAddress>
#include <QString>

namespace torsio {

/// Whether a host's name or address is this computer's own: nothing that goes there leaves it. A name that
/// only begins like an address ("127.0.0.1.example.org") is another computer's. An IPv6 address may stand in
/// brackets, as in a URL.
[[nodiscard]] inline bool isThisComputer(const std::string& host) {
  const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
  return host == "localhost" ||
         QHostAddress(QString::fromStdString(bracketed ? host.substr(1, host.size() - 2) : host))
             .isLoopback();
}

}  // namespace torsio
