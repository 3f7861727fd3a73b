// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/connectors/tracker/tracker_link.h"

namespace torsio {

/// What this station does with OpenIGTLink.
struct TrackerChoice {
  std::optional<TrackerPlace> tracker{};    ///< of the real arm; empty: none
  std::uint16_t outletPort = 0;             ///< where others may watch the instrument; 0: nowhere
  std::string outletAddress = "127.0.0.1";  ///< on which it is offered: of this computer alone
  friend bool operator==(const TrackerChoice&, const TrackerChoice&) = default;
};

/// Reads what this station remembers (settings of the user who runs Torsio).
[[nodiscard]] TrackerChoice rememberedTracker();
/// Remembers it. Throws Error{kBadParameter} for a place without address or port.
void rememberTracker(const TrackerChoice& choice);

}  // namespace torsio
