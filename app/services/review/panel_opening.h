// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

class Connection;

/// Returns whether the panel's marks of a case stay hidden from one of its raters although all have
/// submitted: the centre wants that (kPanelWaits), and this rater has own sheets of the same cohort and
/// occasion to submit, whose marks the panel would influence. Not for a case on which the rater has decided
/// already. The caller has checked a right.
[[nodiscard]] bool panelWaitsForOwnSheets(Connection& connection, const EnrolmentId& enrolmentId,
                                          const std::string& occasionCode, const RaterId& raterId);
/// Returns when the panel's marks of a case were opened to one of its raters; empty: they are hidden. The
/// caller has checked a right.
[[nodiscard]] std::optional<std::int64_t> panelOpenedToUtc_us(Connection& connection,
                                                              const EnrolmentId& enrolmentId,
                                                              const std::string& occasionCode,
                                                              const RaterId& raterId);

}  // namespace torsio
