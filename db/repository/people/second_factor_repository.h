// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// The second factor of an account: its secret (sealedCodeSecret()) and one-time recovery codes.
struct SecondFactor {
  std::string sealed{};
  std::int64_t lastStep = 0;      ///< latest step whose code was accepted
  std::size_t recoveryCodes = 0;  ///< not used yet
};

/// On a prepared server an account's session sees its own; who manages users sees who has one, but no secret.
class SecondFactorRepository {
 public:
  explicit SecondFactorRepository(Connection& connection) : connection_(connection) {}

  /// Empty: the account has none.
  [[nodiscard]] std::optional<SecondFactor> find(const UserId& userId) const;
  /// Returns the accounts that have one.
  [[nodiscard]] std::vector<UserId> owners() const;

  /// Adds the second factor of an account that has none. `lastStep`: of the code that confirmed it. Recovery
  /// codes are stored as hashes. One transaction, or part of the open one.
  void add(const UserId& userId, const std::string& sealed, std::int64_t lastStep,
           std::span<const std::string> recoveryCodes, std::int64_t utc_us);
  /// Replaces the sealed secret after a change of password.
  void reseal(const UserId& userId, const std::string& sealed);
  /// Uses up a step and those before it. False if it is used up already; of two concurrent calls one
  /// succeeds.
  [[nodiscard]] bool useStep(const UserId& userId, std::int64_t step);
  /// Uses up a recovery code, however it is spaced. False if there is none like this; of two concurrent calls
  /// one succeeds.
  [[nodiscard]] bool useRecoveryCode(const UserId& userId, const std::string& code);
  /// Returns whether there was one.
  bool remove(const UserId& userId);

 private:
  Connection& connection_;
};

}  // namespace torsio
