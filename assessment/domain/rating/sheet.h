// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace torsio {

/// One row of a sheet: a score, or the reason for a missing one. Both empty: unanswered (drafts only).
struct SheetRow {
  std::string code{};
  std::optional<std::int64_t> score_steps{};
  std::string notAssessableReason{};
};

/// A rater's answers.
struct Sheet {
  std::int64_t revision = 0;  ///< of a draft: number of saves, 0: never saved; of a sealed sheet: its version
  std::optional<std::int64_t> overall_steps{};
  std::string notAssessableReason{};
  std::string comment{};
  std::vector<SheetRow> rows{};
  std::int64_t changedUtc_us = 0;
};

/// How a recording was watched: which parts, at what speed, and how long the rater worked.
struct SheetViewing {
  std::string watched{};  ///< "0-1200;1500-1600": watched intervals in hundredths of a second; drafts only
  std::optional<std::int64_t>
      watched_permille{};                ///< share of the recording; empty: live. Submitted marks only
  std::int64_t slowest_permille = 1000;  ///< playback speed; 1000 is real time
  std::int64_t fastest_permille = 1000;
  std::int64_t worked_us = 0;
};

}  // namespace torsio
