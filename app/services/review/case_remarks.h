// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/remark.h"

namespace torsio {

/// A rater's own remark at a time of a case: a bookmark, or a text that the trainee will read once the marks
/// are released.
struct CaseRemark {
  std::int64_t time_us = 0;              ///< since the start of the recording
  std::string text{};                    ///< latest version; empty: a bookmark
  RemarkId id{};                         ///< ignored when adding a remark, like the next member
  std::int64_t editedUtc_us = 0;         ///< 0: never edited
  std::vector<RemarkWording> earlier{};  ///< previous versions, oldest first
};

/// Returns the actor's own remarks by time: raters never see those of others, even after submitting.
/// kMarkSubmit, the actor's case.
[[nodiscard]] std::vector<CaseRemark> caseRemarks(SessionContext& session, const AssignmentId& assignmentId);
/// Stores a remark. kMarkSubmit, the actor's recorded case; audited. Throws Error{kBadData} for a live case.
void addCaseRemark(SessionContext& session, const AssignmentId& assignmentId, const CaseRemark& remark);
/// Adds a new version of the actor's remark; earlier ones are kept. kMarkSubmit, the actor's case; audited.
/// Throws Error{kBadParameter} for a remark on another recording, and like revisionOf().
void editCaseRemark(SessionContext& session, const AssignmentId& assignmentId, const RemarkId& remarkId,
                    const std::string& text);

/// A trainee's reply to the actor's remark, anonymous.
struct RemarkReply {
  RemarkId id{};
  std::string remark{};  ///< the actor's text
  std::string text{};    ///< latest version
  std::int64_t version = 1;
  std::int64_t time_us = 0;  ///< in the recording
};

/// Returns the unread replies to the actor's remarks, oldest first. kTrialViewAssigned.
[[nodiscard]] std::vector<RemarkReply> repliesToMe(SessionContext& session);

/// Marks a version of a reply as read; audited. kTrialViewAssigned. Throws Error{kBadParameter} unless it is
/// an unread reply to the actor's remark.
void markReplyRead(SessionContext& session, const std::string& replyId, std::int64_t version);

}  // namespace torsio
