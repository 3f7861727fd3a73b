// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/remark.h"

namespace torsio {

/// A rater's own mark at a time of a case: a mere bookmark, or a remark that the trainee will read once the
/// marks are released.
struct CaseRemark {
  std::int64_t time_us = 0;              ///< since the start of the recording
  std::string text{};                    ///< the newest words; empty: a bookmark
  RemarkId id{};                         ///< not needed to add one, nor the next
  std::int64_t editedUtc_us = 0;         ///< 0: never edited
  std::vector<RemarkWording> earlier{};  ///< what stood there before, oldest first
};

/// Own ones only, by time: nobody sees another rater's before all have committed, nor after. kMarkSubmit, own
/// case.
[[nodiscard]] std::vector<CaseRemark> caseRemarks(SessionContext& session, const AssignmentId& assignmentId);
/// Stored at once. kMarkSubmit, own recorded case; audited. Throws Error{kBadData} for a live case.
void addCaseRemark(SessionContext& session, const AssignmentId& assignmentId, const CaseRemark& remark);
/// New words for an own remark, beside the old ones. kMarkSubmit, own case; audited. Throws
/// Error{kBadParameter} for a remark of another recording, and as revisionOf() does.
void editCaseRemark(SessionContext& session, const AssignmentId& assignmentId, const RemarkId& remarkId,
                    const std::string& text);

/// What a trainee answered to one's remark. Never who it was.
struct RemarkReply {
  RemarkId id{};
  std::string remark{};  ///< one's own words
  std::string text{};    ///< the newest words
  std::int64_t version = 1;
  std::int64_t time_us = 0;  ///< of the moment in the recording
};

/// Lists the answers to one's own remarks that were not read yet, oldest first. kTrialViewAssigned.
[[nodiscard]] std::vector<RemarkReply> repliesToMe(SessionContext& session);

/// Notes that one has read a version of an answer; audited. kTrialViewAssigned. Throws Error{kBadParameter}
/// for what is no unread answer to a remark of one's own.
void markReplyRead(SessionContext& session, const std::string& replyId, std::int64_t version);

}  // namespace torsio
