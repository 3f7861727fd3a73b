// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/demonstration_removal.h"

#include <vector>

#include "db/migrations/compaction.h"
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

DemonstrationSize demonstrationSize(SessionContext& session) {
  session.require(Operation::kPersonErase);
  return sizeOf(demonstrationRows(session.connection()));
}

DemonstrationSize removeDemonstrationData(SessionContext& session, const std::string& reason) {
  session.require(Operation::kPersonErase);
  const DemonstrationSize size = sizeOf(removeDemonstration(session.connection(), session.actor().userId,
                                                            session.station(), reason, session.now_us()));
  compactDatabase(session.connection());
  return size;
}

}  // namespace torsio
