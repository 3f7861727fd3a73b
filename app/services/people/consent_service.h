// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/consent.h"

namespace torsio {

/// Reads the words of assets/consent, which are asked until the centre publishes its own. Throws
/// Error{kFileMissing, kBadData}.
[[nodiscard]] ConsentVersion shippedConsent(const std::filesystem::path& assets);

/// The words of a version in `language` ("en", "zh_CN"); a language it lacks gives English, or the first.
[[nodiscard]] const ConsentWords& wordsIn(const ConsentVersion& version, const std::string& language);

/// What is asked now. kPractice (whoever may be asked).
[[nodiscard]] ConsentVersion askedConsent(SessionContext& session, const std::filesystem::path& assets);
/// Every version, the shipped one first. kPersonViewCoded.
[[nodiscard]] std::vector<ConsentVersion> consentVersions(SessionContext& session,
                                                          const std::filesystem::path& assets);

/// Makes `languages` the version that is asked from now on; decisions about earlier ones stay. A text without
/// a purpose is a new one, at the same place in each language; it gets a code. Returns the id. Audited.
/// kSettingsEdit. Throws Error{kBadParameter}: no note, no language, the training record is missing, an empty
/// title or text, an unknown purpose or one that comes twice, purposes that differ between languages,
/// nothing that has changed.
std::string publishConsent(SessionContext& session, const std::filesystem::path& assets,
                           std::vector<ConsentWords> languages, const std::string& note);

/// Every decision, oldest first. kPersonViewCoded.
[[nodiscard]] std::vector<ConsentDecision> consentHistory(SessionContext& session, const PersonId& personId);

/// Enters what was signed on paper: given, or withdrawn (`granted` false). `signedUtc_us`: the day beside the
/// signature; 0: today. Audited. kConsentRecord. Throws Error{kBadParameter} for an unknown purpose or
/// person, an empty version, a day that is still to come.
void recordConsent(SessionContext& session, const PersonId& personId, const std::string& purpose,
                   bool granted, const std::string& textVersion, std::int64_t signedUtc_us = 0);

}  // namespace torsio
