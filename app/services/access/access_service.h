// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"

namespace torsio {

class Connection;

/// What the first-run wizard asks for.
struct FirstRun {
  std::string centre{};
  std::string login{};     ///< of the first administrator
  std::string password{};  ///< no default exists
  std::string language = "en";
  bool demonstration = false;  ///< whether a demonstration cohort will be made
};

/// Whether nobody can sign in yet: the database has no user.
[[nodiscard]] bool needsFirstRun(Connection& connection);
/// Stores the centre, its settings and the first administrator, whose password is their own from the start.
/// Throws Error{kPermission} when the database has users already, {kBadParameter} for a weak password.
void setUpCentre(SessionContext& session, const FirstRun& first);

/// What came of a try to sign in.
struct SignInAnswer {
  SignIn outcome = SignIn::kWrong;
  Actor actor{};                     ///< for kOk and kMustChange
  std::int64_t waitUntilUtc_us = 0;  ///< for kWait
};

/// With the password; the session then belongs to the actor (for kOk only). Audited; a failure without what
/// was typed.
[[nodiscard]] SignInAnswer signIn(SessionContext& session, const std::string& login,
                                  const std::string& password);
/// With the station PIN: practice without a record and nothing else.
[[nodiscard]] SignInAnswer signInForPractice(SessionContext& session, const std::string& login,
                                             const std::string& pin);
/// After kMustChange, or by the user: the old password must fit. Then signs in. Throws Error{kBadParameter}
/// for a weak or unchanged password, {kPermission} when the old one is wrong.
SignInAnswer changeOwnPassword(SessionContext& session, const std::string& login,
                               const std::string& oldPassword, const std::string& newPassword);
/// The password of whoever is signed in, asked again; the session stays as it is. A failure counts and is
/// audited as at the sign-in.
[[nodiscard]] SignInAnswer checkOwnPassword(SessionContext& session, const std::string& password);
void signOut(SessionContext& session);
/// Whose desk an administrator may see.
enum class SimulatedRole { kTrainee, kPhysician };
/// A simulated person with this role and no other, for an administrator who wants to see what such people
/// see; the session stays as it is until the caller gives it this actor. What they do stays among the
/// simulated people, and they sign without a password (signing.h, kNoPasswordToShow). Audited.
/// kUserManage. Throws Error{kBadParameter} when nobody is simulated.
[[nodiscard]] Actor simulatedPerson(SessionContext& session, SimulatedRole role);

/// A user and a start password that must be changed at the first sign-in. kUserManage. Throws
/// Error{kBadData} for a person who has an account, SecondPersonNeeded (two_people.h) where roles are given
/// that need two people: makeUser() asks for them.
struct NewUser {
  std::string login{};
  PersonId personId{};
  std::vector<std::string> roles{};
  std::string startPassword{};
  bool demonstration = false;
};
UserId addUser(SessionContext& session, const NewUser& user);
[[nodiscard]] std::vector<UserAccount> users(SessionContext& session);
/// At least one active administrator must remain: throws Error{kBadParameter} otherwise, SecondPersonNeeded
/// where roles are given that need two people.
void setUserRoles(SessionContext& session, const UserId& userId, const std::vector<std::string>& roles,
                  const std::string& reason);
void setUserActive(SessionContext& session, const UserId& userId, bool active, const std::string& reason);
/// A new start password, to be changed at the next sign-in. Throws SecondPersonNeeded for whoever has a role
/// that needs two people.
void resetPassword(SessionContext& session, const UserId& userId, const std::string& startPassword,
                   const std::string& reason);
/// One's own station PIN; empty removes it.
void setOwnPin(SessionContext& session, const std::string& pin);

/// Which pages an actor reaches first: the trainee's, the rater's or the administrator's (administrator,
/// allocator, statistician).
enum class Home { kStation, kReview, kAdministrator };
[[nodiscard]] Home homeOf(const Actor& actor);

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
