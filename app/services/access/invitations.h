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

/// Validity of a link.
inline constexpr std::int64_t kInvitationLife_us = 7LL * 86'400'000'000;

/// Returns empty if not set. kUserManage.
[[nodiscard]] std::string browserAddress(SessionContext& session);
/// Audited. kSettingsEdit. Throws Error{kBadParameter} unless it is the https address of a server (http only
/// for this machine).
void setBrowserAddress(SessionContext& session, const std::string& address);
/// Returns the address of a link. The secret is after the #, so that no server or proxy receives it.
/// `withCode`: two people created it, so its page also asks for the code.
[[nodiscard]] std::string invitationLink(const std::string& browserAddress, const std::string& secret,
                                         bool withCode);

/// A new link, shown once.
struct Invitation {
  UserId userId{};
  std::string login{};
  std::string secret{};  ///< twenty characters in groups; only a hash is stored
  std::int64_t expiresUtc_us = 0;
};
/// Creates a link for each of these users to set their own password; their previous link becomes invalid.
/// Audited. kUserManage. Throws Error{kBadParameter} if nobody is chosen, a user may not sign in, or the
/// actor is chosen; SecondPersonNeeded{kInvite} for a user with a role that needs two people: then one person
/// requests it (askSecondPerson) and hands over the code, another confirms it (confirmRequest) and hands over
/// the link, which is useless without the code.
[[nodiscard]] std::vector<Invitation> invite(SessionContext& session, std::span<const UserId> userIds);
/// What to hand over to an invited person, shown once: a link, or the code of a link that another
/// administrator hands over.
struct HandedInvitation {
  UserId userId{};
  std::string login{};
  std::string secret{};            ///< for invitationLink(); empty: another administrator gets it
  std::string code{};              ///< empty: not needed, or another administrator has it
  std::int64_t expiresUtc_us = 0;  ///< of the link
};
/// Invites according to the centre's rule: if two people are needed, requests the second one and returns the
/// code. Audited. kUserManage. Throws like invite() and askSecondPerson().
[[nodiscard]] std::vector<HandedInvitation> inviteOrAsk(SessionContext& session,
                                                        std::span<const UserId> userIds,
                                                        const std::string& reason);
/// Confirms another administrator's request made by inviteOrAsk(). Audited. kUserManage. Throws Error like
/// confirmRequest().
[[nodiscard]] HandedInvitation confirmInvitation(SessionContext& session, const std::string& requestId);
/// Texts to send or read out with a link or a code. `until`: time in the reader's format. If `centre` is
/// empty, the sentences omit it.
[[nodiscard]] Text invitationSubject(const std::string& centre);
[[nodiscard]] Text invitationWords(const std::string& centre, const std::string& login,
                                   const std::string& link, const std::string& until);
[[nodiscard]] Text invitationCodeWords(const std::string& centre, const std::string& code);
/// Revokes the links of these users. Audited. kUserManage. Returns how many were open. Throws
/// Error{kBadParameter} without a reason.
std::size_t revokeInvitations(SessionContext& session, std::span<const UserId> userIds,
                              const std::string& reason);
/// Returns the expiry time of each user's valid link. kUserManage.
[[nodiscard]] std::map<UserId, std::int64_t> invitationsInForce(SessionContext& session);

/// Accepts an invitation with the link's secret and, if two people created it, the code; spaces and hyphens
/// are ignored. Sets the password, uses up the link and signs in; all or nothing. Audited; failures without
/// the typed text. All invalid links get the same answer (kWrong) and the check is cheap. Throws
/// Error{kBadParameter} for a weak password: the link stays valid.
[[nodiscard]] SignInAnswer acceptInvitation(SessionContext& session, const std::string& secret,
                                            const std::string& code, const std::string& newPassword);

/// Used by confirmRequest() inside its transaction: creates the link for `code` and returns its secret.
[[nodiscard]] std::string makeInvitation(SessionContext& session, const UserId& userId,
                                         const std::string& code);

}  // namespace torsio
