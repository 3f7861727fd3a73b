// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/access_service.h"
#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// A code that was made, shown once.
struct KioskCard {
  UserId userId{};
  std::string login{};
  std::string code{};  ///< twenty digits; only their hash is kept
};
/// Makes a new code for each of these users; the one before lets nobody in any more. Audited. kUserManage.
/// Throws Error{kBadParameter}: the centre does not allow codes, nobody is chosen, somebody has another role
/// than that of a trainee.
[[nodiscard]] std::vector<KioskCard> makeKioskCodes(SessionContext& session, std::span<const UserId> userIds);
/// Takes the codes of these users back, those who have one. Audited. kUserManage. Returns how many there
/// were. Throws Error{kBadParameter} without a reason.
std::size_t revokeKioskCodes(SessionContext& session, std::span<const UserId> userIds,
                             const std::string& reason);
/// Since when each user has a code that is in force. kUserManage.
[[nodiscard]] std::map<UserId, std::int64_t> kioskCodesInForce(SessionContext& session);

/// At a kiosk, with what a scanner or a hand typed; blanks and hyphens do not matter. The session then
/// belongs to the trainee, whose password counts as not shown. Audited, a failure without what was typed; too
/// many failures at a station make it wait. Nobody comes in while the centre does not allow it.
[[nodiscard]] SignInAnswer signInWithCode(SessionContext& session, const std::string& code);

}  // namespace torsio
