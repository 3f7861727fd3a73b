// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/probe.h"

#include "db/connection/connection.h"

namespace torsio {

void probe(Connection& connection) {
  (void)connection.selectVerbatim("SELECT 1");
}

}  // namespace torsio
