// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "db/repository/system/site_tables.h"
#include "sim/core/text.h"

namespace torsio {

class Connection;

/// What every centre of a trial must do alike, as JSON text by part: "curriculum", "competence", "groups",
/// "rubrics", "evaluation", "rules", "organs". Without ids, times and people.
struct TrialProtocol {
  std::map<std::string, std::string> parts{};

  /// BLAKE2b-256 of all parts but the organs, which are known only from recordings.
  [[nodiscard]] std::string hash() const;
};

/// Reads the protocol of a cohort from a record. Inside a transaction or not; the caller has checked a right.
[[nodiscard]] TrialProtocol protocolOf(Connection& connection, const SiteScope& scope);

/// Returns one sentence for each part that differs, with the first place that does; of organs only those that
/// both have recordings of.
[[nodiscard]] std::vector<Text> protocolDifferences(const TrialProtocol& here, const TrialProtocol& package);

}  // namespace torsio
