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
#include "sim/core/text.h"

namespace torsio {

class Connection;

/// The choice of the centre where browsers find its review desk: "https://desk.example.org".
/// How long a link is good.
inline constexpr std::int64_t kInvitationLife_us = 7LL * 86'400'000'000;

/// Empty: none was set. kUserManage.
[[nodiscard]] std::string browserAddress(SessionContext& session);
/// Audited. kSettingsEdit. Throws Error{kBadParameter} for what is no https address of a server (http for
/// this machine alone).
void setBrowserAddress(SessionContext& session, const std::string& address);
/// The address of a link. The secret stands behind the #: no server and no proxy is ever told it. `withCode`:
/// two people made it, and its page asks for the code too.
[[nodiscard]] std::string invitationLink(const std::string& browserAddress, const std::string& secret,
                                         bool withCode);

/// A link that was made, shown once.
struct Invitation {
  UserId userId{};
  std::string login{};
  std::string secret{};  ///< twenty characters in groups; only a hash is kept
  std::int64_t expiresUtc_us = 0;
};
/// Makes a link for each of these users, with which they set a password of their own; the one before is of no
/// use any more. Audited. kUserManage. Throws Error{kBadParameter}: nobody is chosen, somebody may not sign
/// in, the own account; SecondPersonNeeded{kInvite} for whoever has a role that needs two people: then one
/// asks for it (askSecondPerson) and hands over the code, another confirms it (confirmRequest) and hands over
/// the link, which is of no use without the code.
[[nodiscard]] std::vector<Invitation> invite(SessionContext& session, std::span<const UserId> userIds);
/// What is handed over to somebody who was invited, shown once: a link, or the code of a link that another
/// administrator hands over.
struct HandedInvitation {
  UserId userId{};
  std::string login{};
  std::string secret{};            ///< of invitationLink(); empty: somebody else gets it
  std::string code{};              ///< empty: none is needed, or somebody else has it
  std::int64_t expiresUtc_us = 0;  ///< of the link
};
/// Invites by whatever the centre's rule asks: where two people are needed, asks for the second one and
/// returns the code. Audited. kUserManage. Throws as invite() and askSecondPerson().
[[nodiscard]] std::vector<HandedInvitation> inviteOrAsk(SessionContext& session,
                                                        std::span<const UserId> userIds,
                                                        const std::string& reason);
/// Confirms what somebody else asked for by inviteOrAsk(). Audited. kUserManage. Throws Error as
/// confirmRequest().
[[nodiscard]] HandedInvitation confirmInvitation(SessionContext& session, const std::string& requestId);
/// The words that go with a link or with a code, to be sent or read out. `until`: as the reader writes a
/// time. `centre` may be empty: the sentences then name none.
[[nodiscard]] Text invitationSubject(const std::string& centre);
[[nodiscard]] Text invitationWords(const std::string& centre, const std::string& login,
                                   const std::string& link, const std::string& until);
[[nodiscard]] Text invitationCodeWords(const std::string& centre, const std::string& code);
/// Takes the links of these users back. Audited. kUserManage. Returns how many were open. Throws
/// Error{kBadParameter} without a reason.
std::size_t revokeInvitations(SessionContext& session, std::span<const UserId> userIds,
                              const std::string& reason);
/// Until when each user has a link that is good. kUserManage.
[[nodiscard]] std::map<UserId, std::int64_t> invitationsInForce(SessionContext& session);

/// With what stands in the link and, where two people made it, the code; blanks and hyphens do not matter.
/// Sets the password, uses the link up and signs in; both or nothing. Audited, a failure without what was
/// typed. Whatever is wrong with a link is answered alike (kWrong), and costs nothing but the look. Throws
/// Error{kBadParameter} for a weak password: the link stays good.
[[nodiscard]] SignInAnswer acceptInvitation(SessionContext& session, const std::string& secret,
                                            const std::string& code, const std::string& newPassword);

/// For confirmRequest(), inside its transaction: makes the link that goes with `code`, and returns its
/// secret.
[[nodiscard]] std::string makeInvitation(SessionContext& session, const UserId& userId,
                                         const std::string& code);

}  // namespace torsio
