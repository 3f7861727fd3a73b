// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/panel_opening.h"

#include <algorithm>

#include "app/services/access/centre_settings.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/sheet_repository.h"

namespace torsio {

bool panelWaitsForOwnSheets(Connection& connection, const EnrolmentId& enrolmentId,
                            const std::string& occasionCode, const RaterId& raterId) {
  return centreSetting<kPanelWaits>(connection) &&
         !SheetRepository(connection).ownSheetsDoneUtc_us(enrolmentId, occasionCode, raterId) &&
         !DiscrepancyRepository(connection).decidedBy(enrolmentId, occasionCode, raterId);
}

std::optional<std::int64_t> panelOpenedToUtc_us(Connection& connection, const EnrolmentId& enrolmentId,
                                                const std::string& occasionCode, const RaterId& raterId) {
  const SheetRepository sheets(connection);
  const std::optional<std::int64_t> opened_us = sheets.panelOpenedUtc_us(enrolmentId, occasionCode);
  if (!opened_us || panelWaitsForOwnSheets(connection, enrolmentId, occasionCode, raterId)) {
    return std::nullopt;
  }
  if (!centreSetting<kPanelWaits>(connection)) {
    return opened_us;
  }
  return std::max(*opened_us, sheets.ownSheetsDoneUtc_us(enrolmentId, occasionCode, raterId).value_or(0));
}

}  // namespace torsio
