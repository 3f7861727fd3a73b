// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "sim/core/random.h"

namespace torsio {

/// Source of new record ids. The application makes them, never the database, so that records of several
/// stations can be merged. Not thread-safe.
class IdSource {
 public:
  virtual ~IdSource() = default;
  /// Returns a UUID (RFC 9562, version 4) in lower-case text, 36 characters.
  [[nodiscard]] virtual std::string newUuid() = 0;
};

/// Ids from the operating system's random numbers (libsodium): for all real data.
class SystemIdSource final : public IdSource {
 public:
  [[nodiscard]] std::string newUuid() override;
};

/// Reproducible ids from a seed: for the demonstration and tests only.
class SeededIdSource final : public IdSource {
 public:
  explicit SeededIdSource(std::uint64_t seed) : random_(seed) {}
  [[nodiscard]] std::string newUuid() override;

 private:
  Random random_;
};

}  // namespace torsio
