// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/retention.h"
#include "db/connection/connection.h"

namespace torsio {

/// The register of copies of the record. Confined to its connection's thread; every function may throw
/// DbError.
class CopyRegister {
 public:
  explicit CopyRegister(Connection& connection) : connection_(connection) {}

  /// Adds a copy and returns its new id. It replaces an older copy by the same station at the same place.
  std::string add(RecordCopy copy);
  /// Copies not known to be deleted, newest first.
  [[nodiscard]] std::vector<RecordCopy> all() const;
  /// Those of all() that contain this person: made since the person was added.
  [[nodiscard]] std::vector<RecordCopy> holding(const PersonId& personId) const;
  void setGone(const std::string& id, std::int64_t utc_us);

 private:
  Connection& connection_;
};

}  // namespace torsio
