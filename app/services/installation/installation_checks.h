// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "app/services/installation/installation_check.h"
#include "sim/core/error.h"

// The single checks. Private to app/services/installation.
namespace torsio {

/// Limits of these checks, which docs/cli.md states.
inline constexpr std::int64_t kBackupDue_days = 7;
inline constexpr std::int64_t kCertificateSoon_days = 30;
inline constexpr std::int64_t kFleetRemembered_days =
    30;                                ///< older heartbeats are of stations no longer used
inline constexpr int kPatience_s = 5;  ///< with the record
inline constexpr double kDiskTight_gb = 5.0;
inline constexpr double kDiskFull_gb = 0.5;

[[nodiscard]] inline bool isOnServer(const std::string& locator) {
  return locator.find("://") != std::string::npos;
}

[[nodiscard]] inline InstallationCheck good(std::string name, Text finding) {
  return {std::move(name), CheckState::kGood, std::move(finding), {}};
}

/// A check that an error ends.
[[nodiscard]] inline InstallationCheck failed(std::string name, const Error& error) {
  const Text& where = error.whereText();
  return {
      std::move(name), CheckState::kFailed,
      where.empty() ? error.happenedText() : Text::tr("%1: %2", where, error.happenedText()),
      error.remedyText().empty() ? Text(Text::tr("Check the path and its permissions")) : error.remedyText()};
}

// Of this computer (machine_checks.cpp).
[[nodiscard]] InstallationCheck configurationCheck();
[[nodiscard]] InstallationCheck displayCheck();
[[nodiscard]] InstallationCheck graphicsCheck();
[[nodiscard]] InstallationCheck deviceCheck();
[[nodiscard]] InstallationCheck realTimeCheck();
[[nodiscard]] InstallationCheck memoryCheck();
[[nodiscard]] InstallationCheck clockCheck();
[[nodiscard]] InstallationCheck diskCheck(const std::filesystem::path& folder);
[[nodiscard]] InstallationCheck certificateCheck(const Installation& installation);
[[nodiscard]] InstallationCheck keyCheck(const std::filesystem::path& record);
[[nodiscard]] InstallationCheck witnessCheck();

/// Of the record, until one fails: "record", "schema", "trail_clock", "access", "fleet", "copies", "backup"
/// (record_checks.cpp).
[[nodiscard]] std::vector<InstallationCheck> recordChecks(const Installation& installation);

}  // namespace torsio
