// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/record_copy.h"
#include "db/connection/connection.h"

namespace torsio {

/// The register of copies. Belongs to the thread of its connection; every function may throw DbError.
class CopyRegister {
 public:
  explicit CopyRegister(Connection& connection) : connection_(connection) {}

  /// Gives it an id, and returns that. A copy at the place of an older one of the same station takes its
  /// place here too.
  std::string add(const RecordCopy& copy);
  /// Those not known to be gone, newest first.
  [[nodiscard]] std::vector<RecordCopy> all() const;
  /// Of these, the ones that hold this person: made since the person was entered.
  [[nodiscard]] std::vector<RecordCopy> holding(const PersonId& personId) const;
  void setGone(const std::string& id, std::int64_t utc_us);

 private:
  Connection& connection_;
};

}  // namespace torsio
