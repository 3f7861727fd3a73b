// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/connectors/tracker/tracker_link.h"

namespace torsio {

/// Settings of this station for OpenIGTLink.
struct TrackerChoice {
  std::optional<TrackerPlace> tracker{};    ///< tracker on the real arm; empty: none
  std::uint16_t outletPort = 0;             ///< at which others may watch the instrument; 0: none
  std::string outletAddress = "127.0.0.1";  ///< to listen at; the default is this computer only
  friend bool operator==(const TrackerChoice&, const TrackerChoice&) = default;
};

/// Reads them from the settings of the user who runs Torsio.
[[nodiscard]] TrackerChoice rememberedTracker();
/// Stores them. Throws Error{kBadParameter} if an address or port is missing.
void rememberTracker(const TrackerChoice& choice);

}  // namespace torsio
