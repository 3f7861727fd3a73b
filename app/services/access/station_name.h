// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "sim/core/text.h"

namespace torsio {

/// A station: one set of settings on one computer. Its name is that of the computer when the station was
/// made, and a sign drawn by chance: "skills-3-k7f2q". It is kept beside the settings, never in the record,
/// so that it stays when the computer is renamed, and two windows with different settings are two stations.
struct StationSign {
  std::string name{};      ///< for trials, audit entries and the board
  std::string computer{};  ///< present name of the computer
  std::filesystem::path settings{};
  bool made = false;  ///< false: these settings have no name of their own, so the computer's is used
};

/// Reads the settings of this account. Thread-safe.
[[nodiscard]] StationSign stationSign();
/// Returns stationSign().name.
[[nodiscard]] std::string stationName();
/// Gives these settings a name, unless they have one. Called when a window starts. Returns false if the
/// settings cannot be written. Thread-safe.
bool makeStationName();
/// Replaces the name of these settings, for a copy of another computer. What was recorded keeps the earlier
/// name. Throws Error{kFileUnwritable}.
void renewStationName();

/// What happened and what to do if somebody else uses this station's name at the same time.
[[nodiscard]] Text twinWords(const std::string& station);
[[nodiscard]] Text twinRemedy();

}  // namespace torsio
