// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/people/consent_service.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "sim/base/ids.h"

namespace torsio {

namespace {

constexpr std::array<const char*, 5> kPurposes{"training_record", "video", "research", "xapi_export",
                                               "teaching"};

bool isPurpose(const std::string& purpose) {
  return std::find(kPurposes.begin(), kPurposes.end(), purpose) != kPurposes.end();
}

}  // namespace

std::vector<ConsentText> consentTexts(const std::filesystem::path& assets, const std::string& language) {
  const std::filesystem::path file = assets / "consent" / "consent.json";
  const std::string bytes = readFile(file);
  std::vector<ConsentText> texts;
  try {
    const nlohmann::json json = nlohmann::json::parse(bytes);
    const std::string version = json.at("version").get<std::string>();
    const nlohmann::json& languages = json.at("languages");
    const nlohmann::json& chosen = languages.contains(language) ? languages.at(language) : languages.at("en");
    for (const char* purpose : kPurposes) {
      const nlohmann::json& part = chosen.at(purpose);
      texts.push_back(
          {purpose, version, part.at("title").get<std::string>(), part.at("text").get<std::string>()});
    }
  } catch (const nlohmann::json::exception& problem) {
    throw Error(ErrorCode::kBadData, Text("the consent texts cannot be read: %1", problem.what()),
                file.string(), "Restore the file from the installation");
  }
  return texts;
}

std::vector<ConsentDecision> consentHistory(SessionContext& session, const PersonId& personId) {
  session.require(Operation::kPersonViewCoded);
  return PeopleRepository(session.connection()).consents(personId);
}

void recordConsent(SessionContext& session, const PersonId& personId, const std::string& purpose,
                   bool granted, const std::string& textVersion) {
  session.require(Operation::kConsentRecord);
  if (!isPurpose(purpose)) {
    throw Error(ErrorCode::kBadParameter, "there is no such purpose", purpose, "Choose one from the list");
  }
  if (textVersion.empty()) {
    throw Error(ErrorCode::kBadParameter, "it is not said which text was shown", purpose,
                "Give the version of the consent text");
  }
  Transaction transaction(session.connection());
  PeopleRepository repository(session.connection());
  const auto person = repository.find(personId);
  if (!person || person->state == PersonState::kErased) {
    throw Error(ErrorCode::kBadParameter, "there is no such person", personId, "Choose one from the list");
  }
  repository.recordConsent({personId, purpose, granted, textVersion, session.now_us(), session.actor().userId,
                            person->demonstration});
  session.note({.action = granted ? AuditAction::kConsentGrant : AuditAction::kConsentWithdraw,
                .objectKind = AuditObject::kConsent,
                .objectId = personId,
                .newJson = nlohmann::json{{"purpose", purpose}, {"text", textVersion}}.dump()});
  transaction.commit();
}

}  // namespace torsio
