// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/maintenance/demonstration_removal.h"

#include <vector>

#include "db/repository/system/demonstration_data.h"

namespace torsio {

namespace {

DemonstrationSize sizeOf(const std::vector<DemonstrationRows>& tables) {
  DemonstrationSize size;
  for (const DemonstrationRows& table : tables) {
    size.rows += table.rows;
    if (table.table == "person") {
      size.people += table.rows;
    }
    if (table.table == "trial") {
      size.trials += table.rows;
    }
    if (table.table == "training_mark" || table.table == "evaluation_mark") {
      size.marks += table.rows;
    }
  }
  return size;
}

}  // namespace

DemonstrationSize demonstrationSize(SessionContext& workplace) {
  workplace.require(Operation::kPersonErase);
  return sizeOf(demonstrationRows(workplace.connection()));
}

DemonstrationSize removeDemonstrationData(SessionContext& workplace, const std::string& reason) {
  workplace.require(Operation::kPersonErase);
  return sizeOf(removeDemonstration(workplace.connection(), workplace.actor().userId, workplace.station(),
                                    reason, workplace.now_us()));
}

}  // namespace torsio
