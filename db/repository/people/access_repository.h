// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"
#include "db/connection/connection.h"
#include "db/repository/people/password.h"

namespace torsio {

struct SignInResult {
  SignIn outcome = SignIn::kWrong;
  UserId userId{};                   ///< for kOk and kMustChange
  std::int64_t waitUntilUtc_us = 0;  ///< for kWait
};

/// Failures in a row that cost nothing; each one more doubles the wait, from one second to one minute. Nobody
/// can lock anybody out for longer, an administrator neither. Names that nobody has are answered alike.
inline constexpr std::int64_t kFreeFailures = 3;
inline constexpr std::int64_t kLongestWait_us = 60'000'000;

/// A password or PIN as it is stored; empty: none.
struct SealedSecret {
  std::string hash{};
};

/// A card's code that is in force.
struct KioskCodeRow {
  UserId userId{};
  std::int64_t madeUtc_us = 0;
};

/// A link that is open. One that has expired stays so until somebody is invited anew.
struct InvitationRow {
  UserId userId{};
  std::int64_t madeUtc_us = 0;
  std::int64_t expiresUtc_us = 0;
};

/// Users, roles, and the matrix role x operation (data of the migration). Default deny.
class AccessRepository {
 public:
  explicit AccessRepository(Connection& connection, PasswordCost cost = PasswordCost::kModerate)
      : connection_(connection), cost_(cost) {}

  /// Whether one of the user's roles has the operation; unknown and disabled users may nothing.
  [[nodiscard]] bool allowed(const UserId& userId, const std::string& operation) const;

  /// Whether it is an account of simulated people.
  [[nodiscard]] bool isOfDemonstration(const UserId& userId) const;
  /// Every sign-in name, in order.
  [[nodiscard]] std::vector<std::string> logins() const;
  /// Sign-in name of the account that a person has, be it switched off; empty: none.
  [[nodiscard]] std::string loginOf(const PersonId& personId) const;

  /// Sealing takes about a second on purpose: do it before a transaction begins, or everybody else waits for
  /// the database meanwhile. Throw Error (kBadParameter) for a weak secret; an empty PIN is none.
  [[nodiscard]] SealedSecret sealPassword(const std::string& login, const std::string& password) const;
  [[nodiscard]] SealedSecret sealPin(const std::string& pin) const;

  /// The password must be changed at the first sign-in.
  void addUser(const UserAccount& user, const SealedSecret& password);
  void addUser(const UserAccount& user, const std::string& password) {
    addUser(user, sealPassword(user.login, password));
  }
  [[nodiscard]] std::vector<UserAccount> users() const;
  /// Other roles, and disabling, end an invitation too: it was made for what the account could do then.
  void setRoles(const UserId& userId, const std::vector<std::string>& roles);
  void setActive(const UserId& userId, bool active);

  [[nodiscard]] SignInResult signIn(const std::string& login, const std::string& password,
                                    std::int64_t now_us);
  /// Own change, or a reset by an administrator (`mustChange`). Ends any wait, and any invitation.
  void setPassword(const UserId& userId, const SealedSecret& password, bool mustChange);

  /// A station PIN opens practice without a record and nothing else; none removes it.
  void setPin(const UserId& userId, const SealedSecret& pin);
  [[nodiscard]] SignInResult signInForPractice(const std::string& login, const std::string& pin,
                                               std::int64_t now_us);

  /// Makes the code behind this hash the only one of a user; none of theirs before lets anybody in.
  void setKioskCode(const std::string& id, const UserId& userId, const std::string& codeHash,
                    std::int64_t utc_us);
  /// Returns whether there was one in force.
  bool revokeKioskCode(const UserId& userId, std::int64_t utc_us);
  [[nodiscard]] std::vector<KioskCodeRow> kioskCodes() const;
  /// By the hash of what a card says; somebody with any other role than that of a trainee is let in by none.
  /// Failures are counted for each station.
  [[nodiscard]] SignInResult signInWithCode(const std::string& codeHash, const std::string& station,
                                            std::int64_t now_us);

  /// Makes the link behind this hash the only one of its user; none of theirs before is good any more.
  void addInvitation(const std::string& id, const InvitationRow& invitation, const std::string& tokenHash);
  /// Returns whether there was an open one.
  bool revokeInvitation(const UserId& userId);
  [[nodiscard]] std::vector<InvitationRow> openInvitations() const;
  /// Whose open link this is; nobody's when it has expired or the user is disabled.
  [[nodiscard]] std::optional<UserId> invited(const std::string& tokenHash, std::int64_t now_us) const;
  /// Uses a link up; false: somebody else did, or it is not open any more. Of two at once one succeeds.
  [[nodiscard]] bool useInvitation(const std::string& tokenHash, std::int64_t now_us);

  /// Whatever this user has open in browsers is over.
  void endSessions(const UserId& userId);
  /// Changes whenever the user's password does and with endSessions(); empty for whoever may not sign in.
  [[nodiscard]] std::string passwordStamp(const UserId& userId) const;

 private:
  struct Account;
  [[nodiscard]] std::optional<Account> account(const std::string& login) const;
  [[nodiscard]] SignInResult check(const std::string& login, const std::string& secret, bool pin,
                                   std::int64_t now_us);
  [[nodiscard]] Account unknownAccount(const std::string& login) const;
  /// Until when nobody may try; empty: now.
  [[nodiscard]] std::optional<std::int64_t> waitOf(const Account& account, std::int64_t now_us);
  void setFailures(const Account& account, std::int64_t failures, std::int64_t lockedUntilUtc_us);

  Connection& connection_;
  PasswordCost cost_;
};

}  // namespace torsio
