// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/remark_revision.h"

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/repository/trial/remark_repository.h"

namespace torsio {

void reviseRemark(SessionContext& session, const Remark& remark, const std::string& text) {
  const Actor& actor = session.actor();
  const RemarkRevision revision = revisionOf(remark, actor.userId, actor.personId, text, session.now_us());
  Transaction transaction(session.connection());
  RemarkRepository(session.connection()).revise(revision);
  session.note({AuditAction::kRemarkAdd, AuditObject::kTrialRemark, remark.id, {}, revisionNote(revision)});
  transaction.commit();
}

}  // namespace torsio
