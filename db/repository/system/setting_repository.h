// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "db/connection/connection.h"

namespace torsio {

/// Stored settings of the centre by name; app/services/access/centre_settings.h says which there are.
class SettingRepository {
 public:
  explicit SettingRepository(Connection& connection) : connection_(connection) {}

  [[nodiscard]] std::optional<std::string> value(std::string_view name) const;
  void set(std::string_view name, const std::string& value, std::int64_t changedUtc_us);

 private:
  Connection& connection_;
};

}  // namespace torsio
