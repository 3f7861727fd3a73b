// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/access/browser_sessions.h"

#include "db/repository/people/access_repository.h"

namespace torsio {

std::string passwordStamp(SessionContext& session, const UserId& userId) {
  return AccessRepository(session.connectionWithoutRight()).passwordStamp(userId);
}

void requireSessionsOfOthers(SessionContext& session) {
  session.require(Operation::kUserManage);
}

void noteEndedSessions(SessionContext& session, const UserId& userId) {
  session.require(Operation::kUserManage);
  session.note(
      {.action = AuditAction::kUserEndSessions, .objectKind = AuditObject::kAppUser, .objectId = userId});
}

}  // namespace torsio
