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

/// A trial of this station with no heartbeat for so long was interrupted.
inline constexpr std::int64_t kQuietTrial_us = 10'000'000;

/// A recording that the station put in order.
struct SettledTrial {
  TrialListing trial{};
  bool fromFile = false;              ///< the database had been away; else it was closed as interrupted
  std::int64_t exposureAdded_us = 0;  ///< training time of the recording that had not been logged yet
};

struct StationStart {
  std::vector<SettledTrial> trials{};
  /// Recordings that wait in a file and could not be stored: one plain sentence each. Their files are kept.
  std::vector<Text> kept{};
};

/// What a station owes the record when it starts: first the recordings that went to files are stored with all
/// that they were made for, and their files removed; then the trials of this station that were cut off are
/// closed as interrupted; the training time that either proves is logged. Audited. For the start of the
/// program too, when nobody is signed in: it shows nobody's data. Throws DbError (the database is away); then
/// the files are still there.
StationStart settleStation(SessionContext& session, const std::filesystem::path& folder = unstoredFolder());

}  // namespace torsio
