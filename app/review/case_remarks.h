// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/access/session_context.h"
#include "sim/base/ids.h"

namespace torsio {

/// A rater's own mark at a time of a case: a mere bookmark, or a remark that the trainee will read once the
/// marks are released.
struct CaseRemark {
  std::int64_t time_us = 0;  ///< since the start of the recording
  std::string text{};        ///< empty: a bookmark
};

/// Own ones only, by time: nobody sees another rater's before all have committed, nor after. kMarkSubmit, own
/// case.
[[nodiscard]] std::vector<CaseRemark> caseRemarks(SessionContext& session, const AssignmentId& assignmentId);
/// Stored at once. kMarkSubmit, own recorded case; audited. Throws Error{kBadData} for a live case.
void addCaseRemark(SessionContext& session, const AssignmentId& assignmentId, const CaseRemark& remark);

}  // namespace torsio
