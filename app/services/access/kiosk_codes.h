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

/// A new code, shown once.
struct KioskCard {
  UserId userId{};
  std::string login{};
  std::string code{};  ///< twenty digits; only a hash is stored
};
/// Creates a new code for each of these users; their previous code becomes invalid. Audited. kUserManage.
/// Throws Error{kBadParameter} if the centre does not allow codes, nobody is chosen, or a user has a role
/// other than trainee.
[[nodiscard]] std::vector<KioskCard> makeKioskCodes(SessionContext& session, std::span<const UserId> userIds);
/// Revokes the codes of those users who have one. Audited. kUserManage. Returns how many there were. Throws
/// Error{kBadParameter} without a reason.
std::size_t revokeKioskCodes(SessionContext& session, std::span<const UserId> userIds,
                             const std::string& reason);
/// Returns since when each user has had a valid code. kUserManage.
[[nodiscard]] std::map<UserId, std::int64_t> kioskCodesInForce(SessionContext& session);

/// Signs in at a kiosk with a scanned or typed code; spaces and hyphens are ignored. The session then belongs
/// to the trainee, as if no password had been entered. Audited; failures without the typed text; too many
/// failures at a station cause a wait. Refused if the centre does not allow codes.
[[nodiscard]] SignInAnswer signInWithCode(SessionContext& session, const std::string& code);

}  // namespace torsio
