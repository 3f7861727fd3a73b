// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/blinded_case.h"
#include "app/services/review/watch_log.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/sheet_check.h"

namespace torsio {

/// What the centre asks of a rater who scores from a recording. kMarkSubmit.
[[nodiscard]] ViewingRules viewingRules(SessionContext& session);

/// Where a keystroke is kept once it is said to be saved.
enum class KeptAt { kThisMachine, kServer };
/// kMarkSubmit.
[[nodiscard]] KeptAt keptAt(SessionContext& session);

/// A case as it is laid on the desk.
struct OpenedSheet {
  BlindedCase shown{};
  RubricRevision rubric{};
  Sheet sheet{};  ///< the draft, or the newest sealed version
  SheetState state = SheetState::kOpen;
  bool panelOpen = false;  ///< all have committed: the marks of the others may be seen
  WatchLog watched{};
};
/// kMarkSubmit, own case. Throws Error{kBadData}: a live case that was not called yet and is not submitted.
[[nodiscard]] OpenedSheet openSheet(SessionContext& session, const AssignmentId& assignmentId);

/// Stores the draft; it is on the disk when the call returns. Call it with every keystroke. Returns the new
/// revision. Drafts leave no trace in the audit trail: they are nobody's record until they are submitted.
/// kMarkSubmit, own case. Throws DbError{kConflict} when the draft was changed at another station meanwhile.
std::int64_t saveSheet(SessionContext& session, const AssignmentId& assignmentId, Sheet sheet,
                       const WatchLog& watched);

/// Checks a sheet against its rubric with the rules of assessment/domain/rating. Pure.
[[nodiscard]] SheetCheck checkSheet(const RubricRevision& rubric, const Sheet& sheet, bool live,
                                    const WatchLog& watched, const ViewingRules& rules);

/// Seals the sheet with what was watched and how fast. kMarkSubmit, own case; audited. Throws Error{kBadData}
/// when checkSheet() says no, DbError{kUnique} when it was submitted before.
void submitSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                 const WatchLog& watched);

/// Whether a sheet is amended by somebody who may know what the others gave.
enum class PanelMarks { kUnseen, kSeen };

/// The next version of a submitted sheet; the one before stays as it is. kMarkSubmit, own case; audited.
/// Throws Error{kBadParameter} without a reason, {kBadData}: not submitted yet, not complete, or the marks of
/// the panel are open: then only moveMark (discrepancy_review.h) changes it, which says kSeen.
void amendSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                const std::string& reason, PanelMarks panel = PanelMarks::kUnseen);

/// One sealed version of an own sheet.
struct SheetVersion {
  std::int64_t version = 1;
  std::optional<std::int64_t> overall_steps{};
  std::string comment{};
  std::string amendReason{};
  std::int64_t submittedUtc_us = 0;
  bool afterPanel = false;  ///< made when the marks of the others were open
};
/// Oldest first. kMarkSubmit, own case.
[[nodiscard]] std::vector<SheetVersion> sheetVersions(SessionContext& session,
                                                      const AssignmentId& assignmentId);

}  // namespace torsio
