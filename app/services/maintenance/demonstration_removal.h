// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "app/services/access/session_context.h"

namespace torsio {

/// Amount of simulated data in the record.
struct DemonstrationSize {
  std::int64_t people = 0;
  std::int64_t trials = 0;
  std::int64_t marks = 0;
  std::int64_t rows = 0;  ///< in all tables
};

/// For the confirmation question. kPersonErase.
[[nodiscard]] DemonstrationSize demonstrationSize(SessionContext& session);

/// Removes all demonstration data at once; real data are not touched (removeDemonstration in
/// db/repository/system/demonstration_data.h). kPersonErase, audited. Returns what was removed. Throws Error
/// (kBadData) if real data depend on simulated ones; nothing is removed then.
DemonstrationSize removeDemonstrationData(SessionContext& session, const std::string& reason);

}  // namespace torsio
