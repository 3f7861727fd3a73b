// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/consent.h"
#include "assessment/domain/people/retention.h"

namespace torsio {

/// Reads the texts of assets/consent, which are used until the centre publishes its own. Throws
/// Error{kFileMissing, kBadData}.
[[nodiscard]] ConsentVersion shippedConsent(const std::filesystem::path& assets);

/// Returns a version's texts in `language` ("en", "zh_CN"), falling back to English, or the first language.
[[nodiscard]] const ConsentWords& wordsIn(const ConsentVersion& version, const std::string& language);

/// Returns the version in use. kPractice.
[[nodiscard]] ConsentVersion askedConsent(SessionContext& session, const std::filesystem::path& assets);
/// Returns all versions, the shipped one first. kPersonViewCoded.
[[nodiscard]] std::vector<ConsentVersion> consentVersions(SessionContext& session,
                                                          const std::filesystem::path& assets);

/// Publishes `languages` as the version in use; decisions on earlier versions stay. A text without a purpose
/// is new, at the same place in each language, and gets a code. Returns the id. Audited. kSettingsEdit.
/// Throws Error{kBadParameter}: no note, no language, training record missing, empty title or text, unknown
/// or duplicate purpose, purposes that differ between languages, no change.
std::string publishConsent(SessionContext& session, const std::filesystem::path& assets,
                           std::vector<ConsentWords> languages, const std::string& note);

/// Returns all decisions, oldest first. kPersonViewCoded.
[[nodiscard]] std::vector<ConsentDecision> consentHistory(SessionContext& session, const PersonId& personId);

/// Records a paper decision: given, or withdrawn (`granted` false). `signedUtc_us`: date of the signature; 0:
/// today. Audited. kConsentRecord. Throws Error{kBadParameter} for an unknown purpose or person, an empty
/// version, a future date.
void recordConsent(SessionContext& session, const PersonId& personId, const std::string& purpose,
                   bool granted, const std::string& textVersion, std::int64_t signedUtc_us = 0);

/// Requests a copy of the actor's own record, or its erasure; administrators see it in their list. Audited.
/// kTrialViewOwn. Throws Error{kBadParameter} if the actor is not a person of the record, or the same request
/// is pending.
void requestAboutOwnRecord(SessionContext& session, PersonRequestKind kind);
/// Withdraws a pending request. Audited. kTrialViewOwn. Throws Error{kBadData} if it is not the actor's, or
/// answered already.
void takeBackOwnRequest(SessionContext& session, const std::string& requestId);
/// Returns the actor's requests, latest first. kTrialViewOwn.
[[nodiscard]] std::vector<PersonRequest> ownRequests(SessionContext& session);

/// Returns everybody's requests, latest first. kPersonExport.
[[nodiscard]] std::vector<PersonRequest> personRequests(SessionContext& session);
/// Marks a request as done, or declined with a reason. Audited. kPersonExport. Throws Error{kBadParameter}:
/// declined without a reason; {kBadData}: answered already.
void answerPersonRequest(SessionContext& session, const std::string& requestId, bool done,
                         const std::string& reason);

}  // namespace torsio
