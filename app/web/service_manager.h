// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio::web {

/// Tells systemd the state of this service ("READY=1"), as sd_notify(3) does: a datagram to the socket named
/// in NOTIFY_SOCKET. Does nothing without one; failures are ignored.
void tellServiceManager(const std::string& state);

}  // namespace torsio::web
