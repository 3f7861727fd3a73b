// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/build_info.h"

#include <QCoreApplication>

#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

std::string softwareVersion() {
  return TORSIO_VERSION;
}

const std::string& programHash() {
  static const std::string kHash = [] {
    try {
      Digest digest;
      digest.update(readFile(QCoreApplication::applicationFilePath().toStdString()));
      return digest.hex();
    } catch (const Error&) {
      return std::string();
    }
  }();
  return kHash;
}

}  // namespace torsio
