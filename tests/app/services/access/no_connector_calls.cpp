// SPDX-License-Identifier: GPL-3.0-or-later
// For a build without a connector: the connectors' rights are tested in a build with all of them.
#include "tests/app/services/access/permission_calls.h"

namespace torsio {

std::vector<ServiceCall> connectorCalls() {
  return {};
}

}  // namespace torsio
