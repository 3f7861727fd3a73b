// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/browser_sessions.h"

#include "db/connection/connection.h"
#include "db/repository/people/access_repository.h"

namespace torsio {

std::string passwordStamp(SessionContext& session, const UserId& userId) {
  return AccessRepository(session.connectionWithoutRight()).passwordStamp(userId);
}

void requireSessionsOfOthers(SessionContext& session) {
  session.require(Operation::kUserManage);
}

void endBrowserSessions(SessionContext& session, const UserId& userId) {
  session.require(Operation::kUserManage);
  Transaction transaction(session.connection());
  AccessRepository(session.connection()).endSessions(userId);
  noteEndedSessions(session, userId);
  transaction.commit();
}

void noteEndedSessions(SessionContext& session, const UserId& userId) {
  session.require(Operation::kUserManage);
  session.note(
      {.action = AuditAction::kUserEndSessions, .objectKind = AuditObject::kAppUser, .objectId = userId});
}

}  // namespace torsio
