// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/people/consent.h"
#include "db/connection/connection.h"

namespace torsio {

/// The centre's own consent texts, by version. Each call is one transaction.
class ConsentRepository {
 public:
  explicit ConsentRepository(Connection& connection) : connection_(connection) {}

  /// Returns the codes of the purposes in the order in which they are asked.
  [[nodiscard]] std::vector<std::string> purposes() const;
  /// Adds a purpose as the last one. Throws DbError{kUnique} if the code is taken.
  void addPurpose(const std::string& code);

  /// Oldest first; empty: the centre uses the texts as shipped.
  [[nodiscard]] std::vector<ConsentVersion> versions() const;
  /// Throws DbError{kUnique} if another station published this number first.
  void add(const ConsentVersion& version);

 private:
  Connection& connection_;
};

}  // namespace torsio
