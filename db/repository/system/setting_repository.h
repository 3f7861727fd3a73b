// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "db/connection/connection.h"

namespace torsio {

/// Settings of the centre by name ("language", "idle_lock_s"), common to its stations.
class SettingRepository {
 public:
  explicit SettingRepository(Connection& connection) : connection_(connection) {}

  [[nodiscard]] std::optional<std::string> value(const std::string& name) const;
  void set(const std::string& name, const std::string& value, std::int64_t changedUtc_us);

 private:
  Connection& connection_;
};

}  // namespace torsio
