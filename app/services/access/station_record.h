// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "sim/core/text.h"

namespace torsio {

/// Who decided where the record of this station is.
enum class RecordOrigin : std::uint8_t {
  kConfigured,  ///< the configuration of this computer
  kChosen,      ///< somebody at the window of this account
  kUsual,       ///< nobody
};

/// The record that the window opens, and commands to which none is named.
struct StationRecord {
  std::string locator;
  RecordOrigin origin = RecordOrigin::kUsual;
};

/// Throws like requireRecordOfAll(), for what the configuration says.
[[nodiscard]] StationRecord stationRecord();

/// Throws Error that names `place` if a locator for all accounts of a computer, which can read it, holds a
/// password, is a relative path, or is none.
void requireRecordOfAll(const std::string& locator, const Text& place);

/// Returns "set in FILE, line N", "chosen in the window" or "where nothing else is said".
[[nodiscard]] Text wordsFor(RecordOrigin origin);

/// Returns the locator that somebody chose in the window; empty: none.
[[nodiscard]] std::string chosenRecord();
void chooseRecord(const std::string& locator);

/// Returns the folder for the data of this account, which may be missing. Needs a QCoreApplication; the names
/// of application and organization determine the folder, so all programs of Torsio have the same.
[[nodiscard]] std::filesystem::path dataFolder();

/// Returns torsio.sqlite in dataFolder(), which is created if missing. Throws Error{kFileUnwritable}.
[[nodiscard]] std::string usualRecord();

}  // namespace torsio
