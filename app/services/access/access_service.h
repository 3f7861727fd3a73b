// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"

namespace torsio {

class Connection;

/// Input of the first-run wizard.
struct FirstRun {
  std::string centre{};
  std::string login{};     ///< of the first administrator
  std::string password{};  ///< there is no default
  std::string language = "en";
  bool demonstration = false;  ///< create a demonstration cohort
};

/// Returns whether the database has no user yet.
[[nodiscard]] bool needsFirstRun(Connection& connection);
/// Stores the centre, its settings and the first administrator, who need not change the password. Throws
/// Error{kPermission} if the database already has users, {kBadParameter} for a weak password.
void setUpCentre(SessionContext& session, const FirstRun& first);

/// Result of signing in.
struct SignInAnswer {
  SignIn outcome = SignIn::kWrong;
  Actor actor{};                     ///< for kOk, kMustChange and kMustEnrol
  std::int64_t waitUntilUtc_us = 0;  ///< for kWait
};

/// Signs in with a password; for kOk the session then belongs to the actor. Audited; failures without the
/// typed text. `place`: where it is tried, such as a browser's address; empty: this station. Failures make
/// only this place wait, so nobody can keep the owner of an account out from elsewhere. `code`: of the second
/// factor, or a recovery code; empty: kCodeNeeded for an account that has one.
[[nodiscard]] SignInAnswer signIn(SessionContext& session, const std::string& login,
                                  const std::string& password, const std::string& place = {},
                                  const std::string& code = {});
/// Like signIn() at this station, without a second factor: for the lock of somebody who is signed in here.
[[nodiscard]] SignInAnswer signInAgain(SessionContext& session, const std::string& login,
                                       const std::string& password);
/// Signs in with the station PIN, only for practice without a record.
[[nodiscard]] SignInAnswer signInForPractice(SessionContext& session, const std::string& login,
                                             const std::string& pin);
struct PasswordChange {
  std::string login{};
  std::string oldPassword{};
  std::string newPassword{};
  std::string code{};  ///< see signIn()
};
/// Changes the password after kMustChange or on request, and signs in. Throws Error{kBadParameter} for a weak
/// or unchanged password, {kPermission} if the old one or the code is wrong. `place`: see signIn().
SignInAnswer changeOwnPassword(SessionContext& session, const PasswordChange& change,
                               const std::string& place = {});
/// Checks the signed-in user's password, as a signature does; the session is unchanged, and no second factor
/// is asked for. A failure counts and is audited like one at sign-in.
[[nodiscard]] SignInAnswer checkOwnPassword(SessionContext& session, const std::string& password);
void signOut(SessionContext& session);
/// Roles that an administrator can preview.
enum class SimulatedRole { kTrainee, kPhysician };
/// Returns a simulated person with only this role, for an administrator who wants to see that role's pages;
/// the session is unchanged until the caller sets this actor. Their actions affect only simulated people, and
/// they sign without a password (signing.h, kNoPasswordToShow). Audited. kUserManage. Throws
/// Error{kBadParameter} if there is no simulated person.
[[nodiscard]] Actor simulatedPerson(SessionContext& session, SimulatedRole role);

/// A user with a start password, which must be changed at the first sign-in. kUserManage. Throws
/// Error{kBadData} for a person who has an account, SecondPersonNeeded (two_people.h) for roles that need two
/// people, and for a rater's account with a password; makeUser() requests the second person. Nobody can sign
/// in without a start password.
struct NewUser {
  std::string login{};
  PersonId personId{};
  std::vector<std::string> roles{};
  std::string startPassword{};
  bool demonstration = false;
};
UserId addUser(SessionContext& session, const NewUser& user);
[[nodiscard]] std::vector<UserAccount> users(SessionContext& session);
/// Returns the user with this id, for services. Throws Error{kBadParameter} if there is none.
[[nodiscard]] UserAccount userOf(std::span<const UserAccount> all, const UserId& userId);
/// Throws Error{kBadParameter} unless an active administrator remains, SecondPersonNeeded for new roles that
/// need two people.
void setUserRoles(SessionContext& session, const UserId& userId, const std::vector<std::string>& roles,
                  const std::string& reason);
void setUserActive(SessionContext& session, const UserId& userId, bool active, const std::string& reason);
/// Sets a new start password, to be changed at the next sign-in, and removes the second factor. Throws
/// SecondPersonNeeded if the user has a role that needs two people.
void resetPassword(SessionContext& session, const UserId& userId, const std::string& startPassword,
                   const std::string& reason);
/// Sets the actor's station PIN; empty removes it.
void setOwnPin(SessionContext& session, const std::string& pin);

/// Start page of an actor: the trainee's, the rater's or the administrator's (administrator, allocator,
/// statistician).
enum class Home { kStation, kReview, kAdministrator };
[[nodiscard]] Home homeOf(const Actor& actor);

// The record's part in browser sessions, which it does not store.

/// Returns a stamp that changes with this user's password and with endBrowserSessions(); empty if the user
/// may not sign in. A session that began with another stamp is over. Without permission.
[[nodiscard]] std::string passwordStamp(SessionContext& session, const UserId& userId);
/// Throws unless the actor may see and end browser sessions of others. kUserManage.
void requireSessionsOfOthers(SessionContext& session);
/// Ends all browser sessions of this user on every server of this record: their next request is refused.
/// Audited. kUserManage.
void endBrowserSessions(SessionContext& session, const UserId& userId);
/// Audits that sessions of another user are ended. kUserManage.
void noteEndedSessions(SessionContext& session, const UserId& userId);

}  // namespace torsio
