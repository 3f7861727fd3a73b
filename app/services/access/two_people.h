// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/access_service.h"
#include "app/services/access/session_context.h"
#include "assessment/domain/people/duty.h"
#include "sim/core/error.h"

namespace torsio {

class Connection;

/// How long a request waits for somebody to confirm it.
inline constexpr std::int64_t kRequestLife_us = 14LL * 86'400'000'000;

/// Whether the centre asks for two people: it does unless it switched that off.
[[nodiscard]] bool needsTwoPeople(Connection& connection);
/// Whether a role is given by two people: every one but that of a trainee.
[[nodiscard]] bool isGuardedRole(const std::string& role);

/// Thrown by a service whose act needs a second person: nobody else has asked for it yet.
class SecondPersonNeeded : public Error {
 public:
  SecondPersonNeeded(DutyAct act, std::string subject);
  [[nodiscard]] DutyAct act() const noexcept { return act_; }
  [[nodiscard]] const std::string& subject() const noexcept { return subject_; }

 private:
  DutyAct act_;
  std::string subject_;
};

/// What somebody wants to have confirmed.
struct DutyWish {
  DutyAct act = DutyAct::kResetPassword;
  std::string subject{};
  std::vector<std::string> roles{};  ///< for kGrantRoles: all that the user will have
  std::string shown{};               ///< what the list shows of the subject: a file name; no name of a person
  std::string reason{};
};

/// Stores a request, audited. Returns the first half of the start password for kResetPassword and
/// kGrantRoles, the code of the link for kInvite, which is told once, to whoever asked; the second half, or
/// the link, is made when somebody else confirms, so that no single person ever knows both. Asks for the
/// right to do the act itself (for kRevealAllocation kAllocationReveal or kStudySetup). Throws
/// Error{kBadParameter} without a reason, {kPermission} for the own account, {kBadData} when this is asked
/// for already or a user does not exist.
std::string askSecondPerson(SessionContext& session, const DutyWish& wish);

/// A request that waits.
struct OpenRequest {
  DutyRequest request{};
  std::string requestedBy{};  ///< sign-in name
  std::string shown{};        ///< sign-in name of the user, code of the person, name of the backup
  std::vector<std::string> roles{};
  bool own = false;  ///< the actor asked; somebody else must confirm
};
/// Oldest first. kUserManage or kAllocationReveal.
[[nodiscard]] std::vector<OpenRequest> openRequests(SessionContext& session);
/// Takes the own request back, or refuses another's. Audited. kUserManage or kAllocationReveal.
void declineRequest(SessionContext& session, const std::string& requestId, const std::string& reason);

/// Confirms a request for a new start password, for roles, for an invitation, or to switch the rule off, and
/// does it. Returns the second half of the start password, or what stands in the link (invitationLink());
/// empty for the rule. Audited. kUserManage, for the rule
/// kSettingsEdit. Throws Error{kPermission} for an own request or the own account, {kBadData} when the
/// request is gone; ContractError for another act, which its own service confirms.
std::string confirmRequest(SessionContext& session, const std::string& requestId);

/// For a service, inside the transaction of its act and after it has asked for its right: uses up the request
/// of another person. Does nothing when the rule is off or the actor is the system, which owns the record.
/// Returns who asked; empty: one person was enough. Throws SecondPersonNeeded.
UserId requireSecondPerson(SessionContext& session, DutyAct act, const std::string& subject);

/// Whether `after` has a role that `before` has not and that two people must give. False where the centre
/// does not ask for two, for a physician of the demonstration, and for the second administrator, whom nobody
/// could confirm. In a call that has asked for a right.
[[nodiscard]] bool givesGuardedRole(SessionContext& session, bool demonstration,
                                    const std::vector<std::string>& before,
                                    const std::vector<std::string>& after);
/// Whether a new start password of this user needs two people: for each role but that of a trainee, and for
/// whoever is a rater, whatever roles the account has just now. kUserManage.
[[nodiscard]] bool passwordNeedsTwo(SessionContext& session, const UserAccount& user);
/// Whether one administrator alone may switch the rule off: there is nobody else to ask. In a call that has
/// asked for a right.
[[nodiscard]] bool mayDropTheRule(SessionContext& session);

/// Whether requireSecondPerson() would let the actor do it now. In a call that has asked for a right.
[[nodiscard]] bool secondPersonIsThere(SessionContext& session, DutyAct act, const std::string& subject);

/// A user as it was made.
struct MadeUser {
  UserId id{};
  std::string startPassword{};  ///< whole, or its first half
  bool awaitsSecond = false;    ///< a second person must confirm the roles, and gets the second half
};
/// addUser, by whatever the centre's rule asks: where roles need two people, the account gets those that do
/// not, nobody can sign in to it yet, and a request waits for the rest. kUserManage.
MadeUser makeUser(SessionContext& session, NewUser user);

}  // namespace torsio
