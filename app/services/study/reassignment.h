// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"

namespace torsio {

/// What became of several sheets.
struct SheetsMoved {
  std::size_t moved = 0;
  std::size_t submitted = 0;     ///< left as they are: sealed meanwhile
  std::size_t askedAlready = 0;  ///< left as they are: the other rater is asked about these cases
};
/// Takes sheets that were not submitted from their raters; with `newRaterId` another one is asked, under a
/// label of theirs. Whoever had such a sheet before and lost it gets that one back, with what they had typed;
/// a sheet that was taken back goes to its own rater only. All or none; those that cannot be moved are left
/// and counted. Audited, sheet by sheet. kStudySetup. Throws Error{kBadData}: no reason, an unknown sheet or
/// rater, or nothing that can be moved.
SheetsMoved reassignAll(SessionContext& session, std::span<const AssignmentId> assignmentIds,
                        const RaterId& newRaterId, const std::string& reason);

}  // namespace torsio
