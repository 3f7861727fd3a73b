// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/services/access/session_context.h"
#include "app/services/review/blinded_case.h"
#include "app/services/review/watch_log.h"
#include "app/services/review/watched_time.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/sheet_check.h"
#include "sim/core/error.h"

namespace torsio {

/// Returns the viewing rules for raters. kMarkSubmit.
[[nodiscard]] ViewingRules viewingRules(SessionContext& session);

/// Where a draft reported as saved is stored.
enum class KeptAt { kThisMachine, kServer };
/// kMarkSubmit.
[[nodiscard]] KeptAt keptAt(SessionContext& session);

/// An opened sheet.
struct OpenedSheet {
  BlindedCase shown{};
  RubricRevision rubric{};
  Sheet sheet{};  ///< the draft, or the latest sealed version
  SheetState state = SheetState::kOpen;
  bool panelOpen = false;  ///< the others' marks may be shown (panel_opening.h)
  WatchLog watched{};
  std::optional<std::int64_t> calledUtc_us{};  ///< live: the latest call
};
/// kMarkSubmit, the actor's case. Throws Error{kBadData} for a live case that was neither called nor
/// submitted.
[[nodiscard]] OpenedSheet openSheet(SessionContext& session, const AssignmentId& assignmentId);

/// Stores the draft; on disk when the call returns. Call it with every keystroke. Returns the new revision.
/// Drafts are not audited: they are not part of the record until submitted. kMarkSubmit, the actor's case.
/// Throws DbError{kConflict} if the draft was changed at another station, SheetSealed if it was submitted.
std::int64_t saveSheet(SessionContext& session, const AssignmentId& assignmentId, Sheet sheet,
                       const WatchLog& watched);

/// Checks a sheet against its rubric with the rules of assessment/domain/rating. Pure function.
[[nodiscard]] SheetCheck checkSheet(const RubricRevision& rubric, const Sheet& sheet, bool live,
                                    const WatchLog& watched, const ViewingRules& rules);

/// Checks an opened sheet as it stands on the page; `now_us`: of the session, for the time since the call.
/// Pure function.
[[nodiscard]] SheetCheck checkSheet(const OpenedSheet& opened, const Sheet& sheet, const WatchLog& watched,
                                    const ViewingRules& rules, std::int64_t now_us);

/// Returns the centre's viewing rules. The caller has checked a right.
[[nodiscard]] ViewingRules centreViewingRules(Connection& connection);
/// Returns what was watched of a recording, for the audit trail.
[[nodiscard]] nlohmann::json viewingNote(const WatchLog& watched);
/// Throws Error{kBadData} if too little of the recording was watched, or at a speed that is not allowed.
void requireWatched(const SheetCheck& check, const Text& where);

/// The sheet is sealed already, by an earlier or a simultaneous submission. kBadData.
class SheetSealed : public Error {
 public:
  explicit SheetSealed(const std::string& caseLabel);
};

/// Seals the sheet with the viewing data. kMarkSubmit, the actor's case; audited. Throws Error{kBadData} if
/// checkSheet() finds problems, SheetSealed if it was submitted before.
void submitSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                 const WatchLog& watched);

/// Whether the author of an amendment may know the other raters' marks.
enum class PanelMarks { kUnseen, kSeen };

/// Adds a version to a submitted sheet; earlier ones are kept. kMarkSubmit, the actor's case; audited. Throws
/// Error{kBadParameter} without a reason, {kBadData} if it is not submitted or incomplete, or the panel's
/// marks are visible: then only moveMark() (discrepancy_review.h) may change it, with kSeen.
void amendSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                const std::string& reason, PanelMarks panel = PanelMarks::kUnseen);

/// A sealed version of the actor's sheet.
struct SheetVersion {
  std::int64_t version = 1;
  std::optional<std::int64_t> overall_steps{};
  std::string comment{};
  std::string amendReason{};
  std::int64_t submittedUtc_us = 0;
  bool afterPanel = false;  ///< made while the other raters' marks were visible
};
/// Oldest first. kMarkSubmit, the actor's case.
[[nodiscard]] std::vector<SheetVersion> sheetVersions(SessionContext& session,
                                                      const AssignmentId& assignmentId);

/// Adds the report of a browser to the viewing data of a case (watchedInBrowser()) and stores it with the
/// draft. Returns the current sheet. kMarkSubmit, the actor's recorded case, not submitted. Throws
/// Error{kBadParameter} for a reversed stretch and a speed that the centre does not allow, {kBadData} for a
/// live or submitted case.
[[nodiscard]] OpenedSheet reportViewing(SessionContext& session, const AssignmentId& assignmentId,
                                        const std::vector<PlayedStretch>& played);

}  // namespace torsio
