// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QHostAddress>

namespace torsio {

/// Returns the address at which this computer listens; null for what is none.
[[nodiscard]] inline QHostAddress ownAddress(const std::string& text) {
  return text == "localhost" ? QHostAddress(QHostAddress::LocalHost)
                             : QHostAddress(QString::fromStdString(text));
}

}  // namespace torsio
