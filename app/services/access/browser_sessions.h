// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"

namespace torsio {

// What the record has to do with sessions in browsers, which it does not hold.

/// Changes whenever this user's password does and with endBrowserSessions(), empty for whoever may not sign
/// in any more: a session that began under another one is over. Without permission.
[[nodiscard]] std::string passwordStamp(SessionContext& session, const UserId& userId);
/// Asks whether the actor may see who is signed in with a browser, and end it. kUserManage.
void requireSessionsOfOthers(SessionContext& session);
/// Ends all sessions that this user has in browsers, wherever a server runs on this record: the next request
/// of each is refused. Audited. kUserManage.
void endBrowserSessions(SessionContext& session, const UserId& userId);
/// Notes that sessions of somebody else are ended. Audited. kUserManage.
void noteEndedSessions(SessionContext& session, const UserId& userId);

}  // namespace torsio
