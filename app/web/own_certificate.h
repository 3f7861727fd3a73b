// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/web/http_server.h"

namespace torsio::web {

/// How other machines of the network may call this one: its IPv4 addresses, then its name.
[[nodiscard]] std::vector<std::string> machineNames();

/// A certificate that this machine signed for itself: browsers ask before they trust it.
struct OwnCertificate {
  TlsMaterial tls;
  std::string fingerprint{};  ///< SHA-256, as browsers show it: "AB:CD:..."
};

/// Reads the certificate of `folder`, or makes one for these names, this machine and a year (ECDSA, P-256):
/// when there is none, when it does not name them all, when it is good for less than two weeks from `now_s`
/// (seconds since 1970). The file is for its owner alone. Throws Error{kFileUnwritable, kFileUnreadable}.
[[nodiscard]] OwnCertificate ownCertificate(const std::filesystem::path& folder,
                                            const std::vector<std::string>& names, std::int64_t now_s);
/// The fingerprint of the first certificate of a PEM text; empty where there is none.
[[nodiscard]] std::string fingerprintOf(const std::string& certificate);

}  // namespace torsio::web
