// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"

namespace torsio {

/// Result of reassignAll().
struct SheetsMoved {
  std::size_t moved = 0;
  std::size_t submitted = 0;     ///< unchanged: submitted in the meantime
  std::size_t askedAlready = 0;  ///< unchanged: the new rater is already assigned to these cases
};
/// Withdraws sheets that were not submitted; with `newRaterId`, assigns them to that rater under new labels.
/// A rater who lost such a sheet before gets it back with its draft; a withdrawn sheet can only go back to
/// its own rater. All or nothing; sheets that cannot be moved are skipped and counted. Audited for each
/// sheet. kStudySetup. Throws Error{kBadData} without a reason, for an unknown sheet or rater, or if nothing
/// can be moved.
SheetsMoved reassignAll(SessionContext& session, std::span<const AssignmentId> assignmentIds,
                        const RaterId& newRaterId, const std::string& reason);

}  // namespace torsio
