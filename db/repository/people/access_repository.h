// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/outdated_access.h"
#include "db/connection/connection.h"
#include "db/repository/people/stored_password.h"

namespace torsio {

struct SignInResult {
  SignIn outcome = SignIn::kWrong;
  UserId userId{};                   ///< for kOk and kMustChange
  std::int64_t waitUntilUtc_us = 0;  ///< for kWait
  /// What proves the sign-in to a prepared server (tellSession()); empty elsewhere.
  std::string serverToken{};
  bool hasSecondFactor = false;  ///< for kOk and kMustChange of signIn()
  bool byRecoveryCode = false;   ///< with one of the account's recovery codes, which is used up
};

/// Consecutive failures without a wait; each further one doubles the wait, from one second to one minute.
/// Nobody, not even an administrator, can be locked out for longer. Unknown logins are treated alike.
inline constexpr std::int64_t kFreeFailures = 3;
inline constexpr std::int64_t kLongestWait_us = 60'000'000;

/// A password or PIN as stored; empty: none.
struct SealedSecret {
  std::string hash{};
};

struct KioskCodeRow {
  UserId userId{};
  std::int64_t madeUtc_us = 0;
};

/// An open invitation. An expired one stays until the user is invited again.
struct InvitationRow {
  UserId userId{};
  std::int64_t madeUtc_us = 0;
  std::int64_t expiresUtc_us = 0;
};

/// Users, roles, and the matrix role x operation (filled by the migration). Default deny.
class AccessRepository {
 public:
  explicit AccessRepository(Connection& connection, PasswordCost cost = PasswordCost::kFull)
      : connection_(connection), cost_(cost) {}

  /// True if one of the user's roles permits the operation; never for unknown or disabled users.
  [[nodiscard]] bool allowed(const UserId& userId, const std::string& operation) const;

  [[nodiscard]] bool isOfDemonstration(const UserId& userId) const;
  /// Returns all logins, in order.
  [[nodiscard]] std::vector<std::string> logins() const;
  /// Returns the login of a person's account, even if disabled; empty: none.
  [[nodiscard]] std::string loginOf(const PersonId& personId) const;

  /// Hashing takes about a second on purpose: do it before a transaction begins, or everybody else waits for
  /// the database. Throws Error (kBadParameter) for a weak secret; an empty PIN means none.
  [[nodiscard]] SealedSecret sealPassword(const std::string& login, const std::string& password) const;
  [[nodiscard]] SealedSecret sealPin(const std::string& pin) const;

  /// Adds a user, who must change the password at the first sign-in.
  void addUser(const UserAccount& user, const SealedSecret& password);
  void addUser(const UserAccount& user, const std::string& password) {
    addUser(user, sealPassword(user.login, password));
  }
  [[nodiscard]] std::vector<UserAccount> users() const;
  /// Changing roles or disabling also revokes an invitation, which was made for the former rights.
  void setRoles(const UserId& userId, const std::vector<std::string>& roles);
  void setActive(const UserId& userId, bool active);

  /// `place`: where it is tried, such as a station or an address. Failures count for this place only, so
  /// that nobody can keep the owner of an account out from elsewhere. `code`: of the second factor, six
  /// digits or a recovery code; empty: none. It is looked at only if the password fits; wrong ones count for
  /// the account, wherever they are typed.
  [[nodiscard]] SignInResult signIn(const std::string& login, const std::string& password,
                                    std::int64_t now_us, const std::string& place = {},
                                    const std::string& code = {});
  /// Like signIn(), without asking for a second factor: for whoever has signed in with it before.
  [[nodiscard]] SignInResult signInAgain(const std::string& login, const std::string& password,
                                         std::int64_t now_us, const std::string& place);
  /// Sets a password: an administrator's reset (`mustChange`), or one that its owner chooses by an
  /// invitation. Ends waits and invitations, and removes the second factor, which the former password
  /// sealed. Returns whether there was one.
  bool setPassword(const UserId& userId, const SealedSecret& password, bool mustChange);
  /// Sets the password that the user has changed, with the secret of the second factor sealed under it
  /// (sealedCodeSecret()); empty: there is none.
  void changePassword(const UserId& userId, const SealedSecret& password, const std::string& sealedCode);

  /// Sets the station PIN, which only opens practice without a record; empty removes it.
  void setPin(const UserId& userId, const SealedSecret& pin);
  [[nodiscard]] SignInResult signInForPractice(const std::string& login, const std::string& pin,
                                               std::int64_t now_us, const std::string& place = {});

  /// Stores a user's new kiosk code, with keptOfProof() of what the card proves; earlier codes become
  /// invalid.
  void setKioskCode(const std::string& id, const UserId& userId, const std::string& proof,
                    std::int64_t utc_us);
  /// Returns whether there was a valid code.
  bool revokeKioskCode(const UserId& userId, std::int64_t utc_us);
  [[nodiscard]] std::vector<KioskCodeRow> kioskCodes() const;
  /// Signs in with the proof of a card; only users whose sole role is trainee are admitted. Failures are
  /// counted per station.
  [[nodiscard]] SignInResult signInWithCode(const std::string& proof, const std::string& station,
                                            std::int64_t now_us);

  /// Stores a user's new invitation, with keptOfProof(); earlier ones become invalid.
  void addInvitation(const std::string& id, const InvitationRow& invitation, const std::string& proof);
  /// Returns whether there was an open invitation.
  bool revokeInvitation(const UserId& userId);
  [[nodiscard]] std::vector<InvitationRow> openInvitations() const;
  /// Returns the user of an open invitation; empty if it has expired or the user is disabled.
  [[nodiscard]] std::optional<UserId> invited(const std::string& proof, std::int64_t now_us) const;
  /// On a prepared server: opens a session that may set the password of an open invitation's user, and
  /// nothing else, and returns its token; empty elsewhere, and without one.
  [[nodiscard]] std::string openInvitedSession(const std::string& proof);
  /// The same of a simulated person, with that person's rights, for an administrator who has signed in.
  [[nodiscard]] std::string openSimulatedSession(const UserId& userId);
  /// Ends the server's session of this connection.
  void endOwnServerSession();
  [[nodiscard]] OutdatedAccess outdatedAccess(std::int64_t now_us) const;
  /// Consumes an invitation. False if it is no longer open; of two concurrent calls one succeeds.
  [[nodiscard]] bool useInvitation(const std::string& proof, std::int64_t now_us);

  /// Ends the user's browser sessions.
  void endSessions(const UserId& userId);
  /// Returns a stamp that changes with the user's password and with endSessions(); empty if the user may not
  /// sign in.
  [[nodiscard]] std::string passwordStamp(const UserId& userId) const;

 private:
  struct Account;
  [[nodiscard]] std::optional<Account> account(const std::string& login) const;
  /// What was typed to sign in, and where.
  struct Typed;
  [[nodiscard]] SignInResult check(const Typed& typed, std::int64_t now_us);
  /// Checks the code of an account whose password fits. Returns kOk without a second factor.
  [[nodiscard]] SignIn checkCode(const Account& account, const Typed& typed, std::int64_t now_us,
                                 SignInResult& result);
  /// True if the code fits and was not used before; uses it up.
  [[nodiscard]] bool acceptsCode(const Account& account, const Typed& typed, std::int64_t now_us,
                                 SignInResult& result);
  void storePassword(const UserId& userId, const SealedSecret& password, bool mustChange);
  /// Reads the failures at a place from their bucket. What nobody outside knows (the account's hash, or the
  /// centre's id for unknown logins) chooses it: no login can be made up that shares another's.
  void readFailures(Account& account, const std::string& login, const std::string& place) const;
  /// True if the secret fits; fills `result.serverToken` on a prepared server.
  [[nodiscard]] bool fits(const Account& account, const std::string& login, const std::string& secret,
                          bool pin, SignInResult& result);
  /// Ends the user's server sessions but that of this connection.
  void endOtherServerSessions(const UserId& userId);
  /// End of the current wait; empty: none.
  [[nodiscard]] std::optional<std::int64_t> waitOf(const Account& account, std::int64_t now_us);
  void setFailures(const Account& account, std::int64_t failures, std::int64_t lockedUntilUtc_us);

  Connection& connection_;
  PasswordCost cost_;
};

}  // namespace torsio
