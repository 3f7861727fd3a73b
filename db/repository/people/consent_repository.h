// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/people/consent.h"
#include "db/connection/connection.h"

namespace torsio {

/// What people are asked to agree to, in the centre's own words, version by version. One call, one
/// transaction.
class ConsentRepository {
 public:
  explicit ConsentRepository(Connection& connection) : connection_(connection) {}

  /// Codes of the purposes, in the order in which they are asked.
  [[nodiscard]] std::vector<std::string> purposes() const;
  /// Adds a purpose after all others. Throws DbError{kUnique} when the code is taken.
  void addPurpose(const std::string& code);

  /// Oldest first; empty: the centre uses the words that ship.
  [[nodiscard]] std::vector<ConsentVersion> versions() const;
  /// Throws DbError{kUnique} when another station published this number first.
  void add(const ConsentVersion& version);

 private:
  Connection& connection_;
};

}  // namespace torsio
