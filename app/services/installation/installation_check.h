// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

enum class CheckState : std::uint8_t {
  kGood,
  kWarning,  ///< works, but not as well or as safely as it could
  kFailed,   ///< something that people rely on does not work
  kSkipped,  ///< not looked at: this computer does not have it, or was not asked about it
};

/// Returns "good", "warning", "failed" or "skipped", as --json prints it.
[[nodiscard]] std::string_view storedText(CheckState state) noexcept;

/// Returns "in order", "could be better", "does not work" or "not checked".
[[nodiscard]] Text labelOf(CheckState state);

/// One line about this installation.
struct InstallationCheck {
  std::string name{};  ///< for programs: "backup"
  CheckState state = CheckState::kGood;
  Text finding{};  ///< what was found; without a full stop
  Text remedy{};   ///< what to do; empty if nothing
};

/// Returns what a check looks at, for people: "Backup".
[[nodiscard]] Text labelOf(const InstallationCheck& check);

/// What to look at.
struct Installation {
  std::string locator{};                ///< of the record; empty: the one that the window opens
  bool named = false;                   ///< set by checkInstallation(): `locator` was given
  std::filesystem::path certificate{};  ///< PEM file of the browser desk; empty: none
  std::int64_t now_us = 0;              ///< UTC
};

/// Looks at display, graphics, device, real-time rights, memory, disk, clock, record, schema, backups,
/// copies, keys, certificate and the versions of all stations. Changes nothing; takes at most a few seconds,
/// because no device is opened and the record is not read through. Never throws for what it finds: a check
/// that cannot be made says why.
[[nodiscard]] std::vector<InstallationCheck> checkInstallation(const Installation& installation);

/// Puts what does not work first, then what could be better; equals keep their order.
void sortByUrgency(std::vector<InstallationCheck>& checks);

/// Returns one sentence on how many need attention.
[[nodiscard]] Text summaryOf(const std::vector<InstallationCheck>& checks);

/// Returns the worst state; kGood without checks. A skipped check is no fault.
[[nodiscard]] CheckState worstOf(const std::vector<InstallationCheck>& checks) noexcept;

}  // namespace torsio
