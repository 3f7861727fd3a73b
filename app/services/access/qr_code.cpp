// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/qr_code.h"

#include <cstddef>
#include <memory>

#include <qrencode.h>

#include "sim/core/error.h"

namespace torsio {

QrCode qrCode(const std::string& text) {
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> made(
      QRcode_encodeData(static_cast<int>(text.size()), reinterpret_cast<const unsigned char*>(text.data()), 0,
                        QR_ECLEVEL_M),
      &QRcode_free);
  if (made == nullptr) {
    refuseParameter(Text::tr("this does not fit into a QR code"), std::to_string(text.size()),
                    Text::tr("Use a shorter address"));
  }
  const auto side = static_cast<std::size_t>(made->width);
  QrCode code;
  for (std::size_t row = 0; row < side; ++row) {
    std::vector<bool>& modules = code.dark.emplace_back();
    for (std::size_t column = 0; column < side; ++column) {
      modules.push_back((made->data[row * side + column] & 1) != 0);
    }
  }
  return code;
}

std::vector<std::string> qrRows(const std::string& text) {
  std::vector<std::string> rows;
  for (const std::vector<bool>& modules : qrCode(text).dark) {
    std::string& row = rows.emplace_back();
    for (const bool dark : modules) {
      row += dark ? '1' : '0';
    }
  }
  return rows;
}

}  // namespace torsio
