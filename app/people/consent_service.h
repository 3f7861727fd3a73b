// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/access/session_context.h"
#include "assessment/people/consent.h"
#include "sim/base/ids.h"

namespace torsio {

/// What somebody agrees to, in the words that were shown.
struct ConsentText {
  std::string purpose{};  ///< "training_record", "video", "research", "xapi_export", "teaching"
  std::string version{};  ///< stored with each decision
  std::string title{};
  std::string text{};
};

/// The texts of assets/consent, in the order in which they are asked. `language`: "en", "zh_CN"; an unknown
/// one gives English. Throws Error{kFileMissing, kBadData}.
[[nodiscard]] std::vector<ConsentText> consentTexts(const std::filesystem::path& assets,
                                                    const std::string& language = "en");

/// Every decision, oldest first. kPersonViewCoded.
[[nodiscard]] std::vector<ConsentDecision> consentHistory(SessionContext& session, const PersonId& personId);

/// Given, or withdrawn (`granted` false). Audited. kConsentRecord. Throws Error{kBadParameter} for an unknown
/// purpose or person, or an empty version.
void recordConsent(SessionContext& session, const PersonId& personId, const std::string& purpose,
                   bool granted, const std::string& textVersion);

}  // namespace torsio
