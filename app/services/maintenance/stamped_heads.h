// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/people/audit_entry.h"
#include "sim/core/text.h"

namespace torsio {

class Connection;
class SessionContext;

/// The authority (RFC 3161) that the centre asks for time stamps of its heads.
struct StampAuthority {
  std::string address{};       ///< http:// or https://; only a hash is sent there
  std::string certificates{};  ///< PEM of its root
};

/// Reads a PEM file of an authority's root. Throws Error: kFileMissing; kFileUnreadable, also for a pipe or a
/// device; kBadData for a file without a certificate or of more than 30,000 bytes.
[[nodiscard]] std::string certificatesOf(const std::filesystem::path& file);
/// Empty: the centre names none. Requires no right: whoever can read the record may check a stamp.
[[nodiscard]] std::optional<StampAuthority> stampAuthority(Connection& connection);
[[nodiscard]] std::optional<StampAuthority> stampAuthority(const std::string& locator);
/// Sets it; an empty address: no time stamps from now on. Audited. kSettingsEdit. Throws Error:
/// kBadParameter for something that is no address, kBadData without a certificate.
void setStampAuthority(SessionContext& session, const StampAuthority& authority);

inline constexpr std::chrono::seconds kStampPatience{15};

/// Asks for a time stamp of a head and checks the answer. Returns the line to keep beside it: "torsio-stamp 1
/// HASH ANSWER", SHA-256 of the head's line and the authority's bytes in base64. Waits at most `patience`.
/// Throws Error: kFileUnreadable if there was no usable answer, kVerifyFailed like stampIn().
[[nodiscard]] std::string stampedBy(const StampAuthority& authority, const std::string& head,
                                    std::chrono::milliseconds patience = kStampPatience);
inline constexpr const char* kStampWord = "torsio-stamp";  ///< first word of such a line
[[nodiscard]] bool isStampLine(const std::string& line);
/// Returns whether such a line is complete.
[[nodiscard]] bool isWholeStamp(const std::string& line);

/// A time at which the trail existed, by somebody else's clock.
struct ProvenTime {
  std::int64_t length = 0;  ///< number of entries
  std::int64_t utc_us = 0;
  std::string authority{};
};
/// What heads kept elsewhere say about the trail.
struct HeadsVerdict {
  std::vector<AuditFinding> findings{};
  std::vector<ProvenTime> proven{};  ///< of heads that match the trail, in the order of the file
  std::vector<Text> notes{};         ///< what no finding is: what was proven, stamps that are missing
};
/// Compares the trail with lines kept elsewhere (compareWithHeads()) and checks their time stamps.
/// `certificates`: PEM of the authority's root; empty: as the centre's settings say. Throws Error, DbError.
[[nodiscard]] HeadsVerdict judgeHeads(Connection& connection, const std::vector<std::string>& lines,
                                      const std::string& publicKey, const std::string& certificates);
[[nodiscard]] HeadsVerdict judgeHeads(const std::string& locator, const std::vector<std::string>& lines,
                                      const std::string& publicKey, const std::string& certificates);

}  // namespace torsio
