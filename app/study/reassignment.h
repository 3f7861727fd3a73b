// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "app/access/session_context.h"
#include "assessment/people/person.h"
#include "sim/base/ids.h"

namespace torsio {

/// Takes a sheet that was not submitted from its rater; with `newRaterId` another one is asked, under a label
/// of theirs. Whoever had the sheet before and lost it gets that one back, with what they had typed; a sheet
/// that was taken back goes to its own rater only. Returns the assignment that counts now, empty without one.
/// Audited. kStudySetup. Throws Error{kBadData}: no reason, submitted already, or the other rater is asked
/// about this case.
AssignmentId reassign(SessionContext& session, const AssignmentId& assignmentId, const RaterId& newRaterId,
                      const std::string& reason);

/// What became of several sheets.
struct SheetsMoved {
  std::size_t moved = 0;
  std::size_t submitted = 0;     ///< left as they are: sealed meanwhile
  std::size_t askedAlready = 0;  ///< left as they are: the other rater is asked about these cases
};
/// reassign() for several sheets, all or none; those that cannot be moved are left and counted. Audited,
/// sheet by sheet. kStudySetup. Throws Error{kBadData} without a reason, or where nothing can be moved.
SheetsMoved reassignAll(SessionContext& session, std::span<const AssignmentId> assignmentIds,
                        const RaterId& newRaterId, const std::string& reason);

}  // namespace torsio
