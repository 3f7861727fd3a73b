// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/build_info.h"

namespace torsio {

std::string softwareVersion() {
  return TORSIO_VERSION;
}

}  // namespace torsio
