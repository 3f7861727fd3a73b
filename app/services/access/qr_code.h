// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio {

/// A QR code (ISO/IEC 18004), row by row from above, without the four modules of white that belong round it.
struct QrCode {
  std::vector<std::vector<bool>> dark{};  ///< as many rows as columns
};

/// Returns the smallest code of these bytes that can still be read when 15 % of it are spoiled. Throws
/// Error{kBadParameter} for more than a code holds (2 331 bytes).
[[nodiscard]] QrCode qrCode(const std::string& text);

}  // namespace torsio
