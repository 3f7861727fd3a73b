// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "assessment/domain/ids.h"

namespace torsio {

using SiteDeliveryId = Id<struct SiteDeliveryIdTag>;

/// A centre whose packages were pooled into a record.
struct Site {
  CentreId centreId{};
  std::string code{};  ///< qualifies the codes of its people: "NJ" of NJ/T-07; unique in the record
  std::string name{};
  std::string publicKey{};  ///< signs every package of this centre, 64 hexadecimal digits
  std::int64_t firstUtc_us = 0;
  bool demonstration = false;
};

/// What one package brought.
struct SiteDelivery {
  SiteDeliveryId id{};
  CentreId centreId{};
  std::int64_t sequence = 0;  ///< 1, 2, 3 ... of the centre
  std::string packageHash{};
  std::int64_t madeUtc_us = 0;
  std::int64_t trailLength = 0;  ///< of the centre's own audit trail when the package was made
  std::string trailHash{};
  std::string protocolHash{};
  std::int64_t rowsAdded = 0;
  std::int64_t leftOut = 0;  ///< trainees who do not agree to research
  std::string receivedBy{};
  std::int64_t receivedUtc_us = 0;
  bool demonstration = false;
};

inline constexpr std::size_t kLongestCentreCode = 8;

/// Returns whether a text is the code of a centre: a capital Latin letter, then up to seven more, digits or
/// hyphens.
[[nodiscard]] constexpr bool isCentreCode(std::string_view text) noexcept {
  if (text.empty() || text.size() > kLongestCentreCode || text.front() < 'A' || text.front() > 'Z') {
    return false;
  }
  for (const char c : text) {
    if (!((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-')) {
      return false;
    }
  }
  return true;
}

/// Returns the code to begin with: the initials of the name ("Skills laboratory Nanjing": SLN), or "C" and
/// the beginning of the id where the name has no two words in Latin letters.
[[nodiscard]] std::string firstCentreCode(std::string_view name, const CentreId& id);

/// Returns "NJ/T-07".
[[nodiscard]] inline std::string qualifiedCode(const std::string& site, const std::string& code) {
  return site + "/" + code;
}

}  // namespace torsio
