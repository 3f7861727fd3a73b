// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/centres/site_package.h"
#include "assessment/domain/study/site.h"

namespace torsio {

enum class Pooled {
  kAdded,       ///< rows came in
  kNothingNew,  ///< every row was there already; the delivery was recorded
  kRepeated,    ///< this very package was delivered before
  kOlder,       ///< the centre has delivered a newer one
};

struct PoolOutcome {
  Pooled kind = Pooled::kAdded;
  SiteManifest manifest{};
  std::string siteCode{};  ///< by which the people of the centre are qualified
  std::int64_t rowsAdded = 0;
  std::int64_t rowsChanged = 0;  ///< states that went on since the last delivery
  /// Codes of its people who withdrew their consent to research since they were delivered. They stay.
  std::vector<std::string> withdrawn{};
  std::int64_t earlierUtc_us = 0;  ///< kRepeated, kOlder: when the other package came
};

/// Returns whether a record may take packages: it is empty or holds nothing but pooled rows. Needs no right.
[[nodiscard]] bool takesPackages(Connection& connection);

/// Takes the rows of a checked package into a pooled record, all or nothing: by their UUIDs, recordings byte
/// for byte, codes qualified by the centre's, plan rows joined with those that are there. Verifies the record
/// before and after. Audited. kDatabaseRestore. Throws Error: kVerifyFailed if the record does not verify,
/// the key is not the centre's, a row belongs or refers to another centre, or differs from the one delivered
/// before under its id; kBadData if the protocols differ (the first difference named), the record has people
/// of its own or belongs to this centre, simulated and real would mix, or rows do not fit together; DbError
/// if the record cannot be written; what `progress` throws.
[[nodiscard]] PoolOutcome poolSite(SessionContext& session, const std::filesystem::path& file,
                                   const CheckedPackage& package, const ProgressCallback& progress = {});

/// Which centre has delivered what, by code.
struct SiteState {
  Site site{};
  std::vector<SiteDelivery> deliveries{};  ///< oldest first
  std::int64_t trainees = 0;
  std::int64_t recordings = 0;
  std::int64_t marks = 0;
  std::vector<std::string> withdrawn{};  ///< codes of trainees who no longer agree to research
};
/// kReportExportCoded.
[[nodiscard]] std::vector<SiteState> siteStates(SessionContext& session);

}  // namespace torsio
