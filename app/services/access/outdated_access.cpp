// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/outdated_access.h"

#include "db/connection/connection.h"
#include "db/repository/people/access_repository.h"

namespace torsio {

OutdatedAccess outdatedAccess(SessionContext& session) {
  session.require(Operation::kUserManage);
  return AccessRepository(session.connection()).outdatedAccess(session.now_us());
}

Text sentenceOf(const OutdatedAccess& outdated) {
  if (outdated.cards.empty() && outdated.links.empty()) {
    return {};
  }
  return Text::tr(
      "%1 kiosk {card|cards} and %2 {invitation|invitations} of an earlier version open nothing any more",
      outdated.cards.size(), outdated.links.size());
}

Text remedyForOutdatedAccess() {
  return Text::tr("Make new ones under Users: Kiosk cards, Invite");
}

}  // namespace torsio
