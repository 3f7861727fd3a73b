// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/remark_replies.h"

#include <algorithm>

#include "assessment/domain/rating/remark.h"
#include "db/connection/connection.h"
#include "db/repository/trial/remark_repository.h"
#include "sim/core/refusal.h"

namespace torsio {

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
  session.note(
      {.action = AuditAction::kRemarkRead, .objectKind = AuditObject::kTrialRemark, .objectId = replyId});
  transaction.commit();
}

}  // namespace torsio
