// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "sim/core/random.h"

namespace torsio {

/// Where new record ids come from. The application makes them, never the database, so that records of several
/// stations can be merged. One thread.
class IdSource {
 public:
  virtual ~IdSource() = default;
  /// A UUID (RFC 9562, version 4) in lower-case text, 36 characters.
  [[nodiscard]] virtual std::string newUuid() = 0;
};

/// From the operating system's random numbers (libsodium): for everything real.
class SystemIdSource final : public IdSource {
 public:
  [[nodiscard]] std::string newUuid() override;
};

/// Gives the same ids for the same seed: for the demonstration and tests only.
class SeededIdSource final : public IdSource {
 public:
  explicit SeededIdSource(std::uint64_t seed) : random_(seed) {}
  [[nodiscard]] std::string newUuid() override;

 private:
  Random random_;
};

}  // namespace torsio
