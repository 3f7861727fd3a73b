// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/people/signature.h"
#include "db/connection/connection.h"

namespace torsio {

/// Signatures of sealed objects. Append-only.
class SignatureRepository {
 public:
  explicit SignatureRepository(Connection& connection) : connection_(connection) {}

  /// Throws DbError (kUnique) if the object is already signed.
  void add(const Signature& signature);
  /// All signatures of a kind, by signed object.
  [[nodiscard]] std::map<std::string, Signature> all(SignedKind kind) const;

 private:
  Connection& connection_;
};

/// Requests for acts that need two people, and the decisions. Both are append-only.
class DutyRepository {
 public:
  explicit DutyRepository(Connection& connection) : connection_(connection) {}

  void add(const DutyRequest& request);
  /// Undecided requests made at or after `sinceUtc_us`, oldest first.
  [[nodiscard]] std::vector<DutyRequest> open(std::int64_t sinceUtc_us) const;
  /// Throws DbError (kUnique) if it was decided already.
  void decide(const std::string& requestId, DutyDecision decision, const UserId& decidedBy,
              std::int64_t utc_us);

 private:
  Connection& connection_;
};

}  // namespace torsio
