// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/case_remarks.h"

#include <algorithm>

#include "app/services/review/blinded_case.h"
#include "app/services/study/remark_revision.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/remark.h"
#include "assessment/domain/rating/written_words.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"

namespace torsio {

std::vector<CaseRemark> caseRemarks(SessionContext& session, const AssignmentId& assignmentId) {
  const Assignment assignment = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  std::vector<CaseRemark> own;
  if (assignment.trialId.empty()) {
    return own;
  }
  const RemarkRepository remarks(session.connection());
  auto earlier = remarks.earlierWordings(assignment.trialId);
  for (const Remark& remark : remarks.remarks(assignment.trialId)) {
    if (remark.author == session.actor().userId && remark.purpose != "reply") {
      own.push_back({remark.time_us, remark.text, remark.id, remark.editedUtc_us, earlier[remark.id]});
    }
  }
  return own;
}

void addCaseRemark(SessionContext& session, const AssignmentId& assignmentId, const CaseRemark& remark) {
  const Assignment assignment = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  if (assignment.trialId.empty() || remark.time_us < 0) {
    refuse(Text::tr("this case has no recording to score"), Text::tr("case %1", assignment.caseLabel),
           Text::tr("Write it into the comment of the sheet"));
  }
  requireWords(remark.text, kLongestRemark, Text::tr("case %1", assignment.caseLabel));
  const auto header = TrialRepository(session.connection()).find(assignment.trialId);
  Remark stored;
  stored.id = session.ids().newUuid();
  stored.trialId = assignment.trialId;
  stored.author = session.actor().userId;
  stored.authorPersonId = session.actor().personId;
  stored.purpose = remark.text.empty() ? "bookmark" : "remark";
  stored.tick = header ? remark.time_us / header->tickPeriod_us : 0;
  stored.time_us = remark.time_us;
  stored.text = remark.text;
  stored.createdUtc_us = session.now_us();
  stored.demonstration = assignment.demonstration;
  Transaction transaction(session.connection());
  RemarkRepository(session.connection()).add(stored);
  session.note(AuditAction::kRemarkAdd, AuditObject::kTrialRemark, stored.id);
  transaction.commit();
}

void editCaseRemark(SessionContext& session, const AssignmentId& assignmentId, const RemarkId& remarkId,
                    const std::string& text) {
  const Assignment assignment = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  RemarkRepository remarks(session.connection());
  const std::optional<Remark> remark = remarks.find(remarkId);
  if (!remark || assignment.trialId.empty() || remark->trialId != assignment.trialId) {
    refuseParameter(Text::tr("this case has no such remark"), Text::tr("case %1", assignment.caseLabel),
                    Text::tr("Open the case again"));
  }
  requireWords(text, kLongestRemark, Text::tr("case %1", assignment.caseLabel));
  reviseRemark(session, *remark, text);
}

std::vector<RemarkReply> repliesToMe(SessionContext& session) {
  session.require(Operation::kTrialViewAssigned);
  RemarkRepository repository(session.connection());
  std::vector<Remark> unread = repository.unreadReplies(session.actor().userId);
  std::stable_sort(unread.begin(), unread.end(),
                   [](const Remark& a, const Remark& b) { return a.createdUtc_us < b.createdUtc_us; });
  std::vector<RemarkReply> replies;
  for (const Remark& reply : unread) {
    const std::optional<Remark> remark = repository.find(reply.replyTo);
    replies.push_back(
        {reply.id, remark ? remark->text : std::string(), reply.text, reply.version, reply.time_us});
  }
  return replies;
}

void markReplyRead(SessionContext& session, const std::string& replyId, std::int64_t version) {
  const std::vector<RemarkReply> mine = repliesToMe(session);
  if (std::none_of(mine.begin(), mine.end(), [&](const RemarkReply& one) {
        return one.id == replyId && version >= 1 && version <= one.version;
      })) {
    refuseParameter(Text::tr("there is no such answer"), replyId, Text::tr("Open the list again"));
  }
  Transaction transaction(session.connection());
  RemarkRepository(session.connection())
      .markRead({.remarkId = replyId,
                 .version = version,
                 .reader = session.actor().userId,
                 .readerPersonId = session.actor().personId,
                 .readUtc_us = session.now_us()});
  session.note(AuditAction::kRemarkRead, AuditObject::kTrialRemark, replyId);
  transaction.commit();
}

}  // namespace torsio
