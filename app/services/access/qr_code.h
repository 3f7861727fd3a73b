// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio {

/// A QR code (ISO/IEC 18004), row by row from the top, without the quiet zone of four modules.
struct QrCode {
  std::vector<std::vector<bool>> dark{};  ///< square
};

/// Returns the smallest code of these bytes with 15 % error correction. Throws Error{kBadParameter} for more
/// than a code holds (2 331 bytes).
[[nodiscard]] QrCode qrCode(const std::string& text);
/// Returns the same as one string of 0 and 1 per row, for a page.
[[nodiscard]] std::vector<std::string> qrRows(const std::string& text);

}  // namespace torsio
