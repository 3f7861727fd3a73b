// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/access_service.h"
#include "app/services/access/session_context.h"
#include "assessment/domain/people/signature.h"
#include "sim/core/error.h"

namespace torsio {

class Connection;

/// Time for which a request can be confirmed.
inline constexpr std::int64_t kRequestLife_us = 14LL * 86'400'000'000;

/// Returns whether the centre requires two people: yes unless turned off.
[[nodiscard]] bool needsTwoPeople(Connection& connection);
/// Returns whether granting a role needs two people: every role except trainee.
[[nodiscard]] bool isGuardedRole(const std::string& role);

/// Thrown by a service if its act needs a second person and there is no request by another one.
class SecondPersonNeeded : public Error {
 public:
  SecondPersonNeeded(DutyAct act, std::string subject);
  [[nodiscard]] DutyAct act() const noexcept { return act_; }
  [[nodiscard]] const std::string& subject() const noexcept { return subject_; }

 private:
  DutyAct act_;
  std::string subject_;
};

/// An act that needs confirmation.
struct DutyWish {
  DutyAct act = DutyAct::kResetPassword;
  std::string subject{};
  std::vector<std::string> roles{};  ///< for kGrantRoles: the complete new set of roles
  std::string shown{};               ///< subject as listed, such as a file name; never a person's name
  std::string reason{};
};

/// Stores a request, audited. Returns the first half of the start password for kResetPassword and
/// kGrantRoles (empty if roles are only taken away), or the code of the link for kInvite, shown once to the
/// requester; the second half or the link is created on confirmation, so that no single person knows both.
/// Requires the right to the act itself (for kRevealAllocation: kAllocationReveal or kStudySetup). Throws
/// Error{kBadParameter} without a reason, {kPermission} for the actor's own account, {kBadData} if this is
/// requested already or a user does not exist.
std::string askSecondPerson(SessionContext& session, const DutyWish& wish);

/// Returns whether the act is requested by anybody, not yet decided. Requires the right to the act.
[[nodiscard]] bool isRequested(SessionContext& session, const DutyWish& wish);

/// A pending request.
struct OpenRequest {
  DutyRequest request{};
  std::string requestedBy{};  ///< sign-in name
  std::string shown{};        ///< user's sign-in name, person's code or backup's name
  std::vector<std::string> roles{};
  bool own = false;         ///< requested by the actor, so somebody else must confirm
  bool mayConfirm = false;  ///< the actor may confirm it: not their own request or account, and their right
};
/// Returns pending requests, oldest first. kUserManage or kAllocationReveal.
[[nodiscard]] std::vector<OpenRequest> openRequests(SessionContext& session);
/// Returns who else could confirm a request of the actor: active administrators, none of the demonstration.
/// kUserManage.
[[nodiscard]] std::vector<UserAccount> otherAdministrators(SessionContext& session);
/// Withdraws the actor's own request, or declines another person's. Audited. kUserManage or
/// kAllocationReveal.
void declineRequest(SessionContext& session, const std::string& requestId, const std::string& reason);

/// Confirms and carries out a request for a new start password, roles, an invitation, or turning the rule
/// off. Returns the second half of the start password or the link's secret (invitationLink()); empty for the
/// rule, and if roles are only taken away. Audited. kUserManage, for the rule kSettingsEdit. Throws
/// Error{kPermission} for the actor's own request or account, {kBadData} if the request is gone;
/// ContractError for other acts, which their services confirm.
std::string confirmRequest(SessionContext& session, const std::string& requestId);

/// Uses up another person's request. For services, inside the transaction of the act and after checking the
/// right. Does nothing if the rule is off or the actor is the system, which owns the record; with
/// `always`, it needs somebody nonetheless. Returns the requester; empty if one person was enough. Throws
/// SecondPersonNeeded.
UserId requireSecondPerson(SessionContext& session, DutyAct act, const std::string& subject,
                           bool always = false);

/// Returns whether `after` adds a role that needs two people. False if the rule is off, for a physician of
/// the demonstration, and for the second administrator, whom nobody could confirm. Call after checking a
/// right.
[[nodiscard]] bool givesGuardedRole(SessionContext& session, bool demonstration,
                                    const std::vector<std::string>& before,
                                    const std::vector<std::string>& after);
/// Returns whether `after` takes the role from an administrator who could confirm, which needs two people:
/// that administrator may be the second. False if the rule is off. Call after checking a right.
[[nodiscard]] bool takesAdministrator(SessionContext& session, const UserAccount& before,
                                      const std::vector<std::string>& after);
/// Returns whether a new start password of this user needs two people: for every role except trainee, and for
/// raters whatever their current roles. kUserManage.
[[nodiscard]] bool passwordNeedsTwo(SessionContext& session, const UserAccount& user);
/// Returns whether one administrator may turn the rule off alone because there is no other. Call after
/// checking a right.
[[nodiscard]] bool mayDropTheRule(SessionContext& session);

/// Returns whether requireSecondPerson() would let the actor proceed now. Call after checking a right.
[[nodiscard]] bool secondPersonIsThere(SessionContext& session, DutyAct act, const std::string& subject,
                                       bool always = false);

/// Result of makeUser().
struct MadeUser {
  UserId id{};
  std::string startPassword{};  ///< whole or first half
  bool awaitsSecond = false;    ///< a second person must confirm it and gets the second half
};
/// Adds a user according to the centre's rule: if roles need two people, or the person is a rater, the
/// account gets only the other roles and no password, and a request is pending for the rest. kUserManage.
MadeUser makeUser(SessionContext& session, NewUser user);

}  // namespace torsio
