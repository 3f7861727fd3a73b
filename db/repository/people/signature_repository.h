// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

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

}  // namespace torsio
