// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/recording/unstored_trials.h"
#include "assessment/attempt/trial_listing.h"
#include "sim/core/text.h"

namespace torsio {

/// A trial of this station without a heartbeat for this time was interrupted.
inline constexpr std::int64_t kQuietTrial_us = 10'000'000;

/// A recording that was stored or closed at start.
struct SettledTrial {
  TrialListing trial{};
  bool fromFile = false;              ///< true: stored from a file, because the database was unreachable;
                                      ///< false: closed as interrupted
  std::int64_t exposureAdded_us = 0;  ///< training time that was not logged yet
};

struct StationStart {
  std::vector<SettledTrial> trials{};
  /// One sentence for each recording in a file that could not be stored. The files are kept.
  std::vector<Text> kept{};
};

/// Cleans up at a station's start: stores recordings from files with their context and removes the files;
/// closes this station's interrupted trials; logs the training time that either proves. Audited. Also runs at
/// program start, when nobody is signed in, since it shows nobody's data. Throws DbError if the database is
/// unreachable; the files are then kept.
StationStart settleStation(SessionContext& session, const std::filesystem::path& folder = unstoredFolder());

}  // namespace torsio
