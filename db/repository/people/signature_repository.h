// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "assessment/domain/people/signature.h"
#include "db/connection/connection.h"

namespace torsio {

/// Signatures beside what was sealed. Append-only.
class SignatureRepository {
 public:
  explicit SignatureRepository(Connection& connection) : connection_(connection) {}

  /// Throws DbError (kUnique) when the object is signed already.
  void add(const Signature& signature);
  /// All of a kind, by what was signed.
  [[nodiscard]] std::map<std::string, Signature> all(SignedKind kind) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
