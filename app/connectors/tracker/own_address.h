// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QHostAddress>

namespace torsio {

/// The address of this computer to listen at; null if it is not one.
[[nodiscard]] inline QHostAddress ownAddress(const std::string& text) {
  return text == "localhost" ? QHostAddress(QHostAddress::LocalHost)
                             : QHostAddress(QString::fromStdString(text));
}

}  // namespace torsio
