// SPDX-License-Identifier: GPL-3.0-or-later
// A build that lacks a connector: its rights are tested with all of them.
#include "tests/app/services/access/permission_calls.h"

namespace torsio::testing {

std::vector<ServiceCall> connectorCalls() {
  return {};
}

}  // namespace torsio::testing
