// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/web/http_server.h"

namespace torsio::web {

/// Names of this machine in the network: its IPv4 addresses, then its host name.
[[nodiscard]] std::vector<std::string> machineNames();

/// A self-signed certificate: browsers ask before they trust it.
struct OwnCertificate {
  TlsMaterial tls;
  std::string fingerprint{};  ///< SHA-256 as browsers show it: "AB:CD:..."
};

/// Reads the certificate in `folder`, or makes one (ECDSA P-256, one year, for these names and this machine)
/// if there is none, it lacks a name, or it expires within two weeks of `now_s` (seconds since 1970). The
/// file is readable by its owner only. Throws Error{kFileUnwritable, kFileUnreadable}.
[[nodiscard]] OwnCertificate ownCertificate(const std::filesystem::path& folder,
                                            const std::vector<std::string>& names, std::int64_t now_s);
/// Returns the DNS names in the first certificate of a PEM text, such as "desk.example.org" or
/// "*.example.org".
[[nodiscard]] std::vector<std::string> namesIn(const std::string& certificate);
/// Returns the fingerprint of the first certificate in a PEM text; empty if there is none.
[[nodiscard]] std::string fingerprintOf(const std::string& certificate);

}  // namespace torsio::web
