// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/consent_service.h"

#include <algorithm>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/retention_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

std::vector<std::string> purposesOf(const ConsentWords& words) {
  std::vector<std::string> purposes;
  for (const ConsentText& text : words.texts) {
    purposes.push_back(text.purpose);
  }
  return purposes;
}

bool sameWords(const std::vector<ConsentWords>& a, const std::vector<ConsentWords>& b) {
  return std::is_permutation(
      a.begin(), a.end(), b.begin(), b.end(), [](const ConsentWords& left, const ConsentWords& right) {
        return left.language == right.language &&
               std::equal(left.texts.begin(), left.texts.end(), right.texts.begin(), right.texts.end(),
                          [](const ConsentText& x, const ConsentText& y) {
                            return x.purpose == y.purpose && x.title == y.title && x.text == y.text;
                          });
      });
}

void checkTexts(const ConsentWords& words) {
  for (const ConsentText& text : words.texts) {
    if (text.title.empty() || text.text.empty()) {
      refuseParameter(Text::tr("a purpose has no title or no text"),
                      words.language + ", " + (text.title.empty() ? text.purpose : text.title),
                      Text::tr("Fill both in, in every language"));
    }
  }
}

/// Throws if the texts are incomplete or inconsistent.
void checkWords(const std::vector<ConsentWords>& languages, const std::vector<std::string>& known) {
  if (languages.empty()) {
    refuseParameter(Text::tr("there is no language"), Text::tr("consent"), Text::tr("Add at least one"));
  }
  const std::vector<std::string> purposes = purposesOf(languages.front());
  if (std::find(purposes.begin(), purposes.end(), kTrainingRecord) == purposes.end()) {
    refuseParameter(Text::tr("the training record is not asked about"), Text::tr("consent"),
                    Text::tr("Keep this purpose: without it nothing may be recorded"));
  }
  std::set<std::string> seen;
  for (const std::string& purpose : purposes) {
    if (!purpose.empty() && std::find(known.begin(), known.end(), purpose) == known.end()) {
      refuseParameter(Text::tr("there is no such purpose"), purpose, Text::tr("Choose one from the list"));
    }
    if (!purpose.empty() && !seen.insert(purpose).second) {
      refuseParameter(Text::tr("a purpose is asked about twice"), purpose, Text::tr("Remove one of them"));
    }
  }
  std::set<std::string> named;
  for (const ConsentWords& words : languages) {
    if (words.language.empty() || !named.insert(words.language).second) {
      refuseParameter(Text::tr("a language has no name or is listed twice"), words.language,
                      Text::tr("Name each language once"));
    }
    if (purposesOf(words) != purposes) {
      refuseParameter(Text::tr("the languages do not ask about the same purposes"), words.language,
                      Text::tr("Ask about the same purposes in the same order"));
    }
    checkTexts(words);
  }
}

/// Gives the texts without a purpose new codes, the same in each language.
void nameNewPurposes(ConsentRepository& repository, std::vector<ConsentWords>& languages) {
  std::vector<std::string> known = repository.purposes();
  for (std::size_t i = 0; i < languages.front().texts.size(); ++i) {
    if (!languages.front().texts[i].purpose.empty()) {
      continue;
    }
    std::size_t number = known.size() + 1;
    const auto code = [&number] { return "purpose-" + std::to_string(number); };
    while (std::find(known.begin(), known.end(), code()) != known.end()) {
      ++number;
    }
    repository.addPurpose(code());
    known.push_back(code());
    for (ConsentWords& words : languages) {
      words.texts[i].purpose = known.back();
    }
  }
}

ConsentVersion newestOf(ConsentRepository& repository, const std::filesystem::path& assets) {
  std::vector<ConsentVersion> own = repository.versions();
  return own.empty() ? shippedConsent(assets) : std::move(own.back());
}

}  // namespace

ConsentVersion shippedConsent(const std::filesystem::path& assets) {
  const std::filesystem::path file = assets / "consent" / "consent.json";
  const std::string bytes = readFile(file);
  ConsentVersion shipped;
  try {
    const nlohmann::json json = nlohmann::json::parse(bytes);
    shipped.id = json.at("version").get<std::string>();
    for (const auto& [language, texts] : json.at("languages").items()) {
      ConsentWords words{language, {}};
      for (const nlohmann::json& part : texts) {
        words.texts.push_back({part.at("purpose").get<std::string>(), part.at("title").get<std::string>(),
                               part.at("text").get<std::string>()});
      }
      shipped.languages.push_back(std::move(words));
    }
    if (shipped.languages.empty()) {
      refuse(Text::tr("the consent texts have no language"), file.string(),
             Text::tr("Restore the file from the installation"));
    }
  } catch (const nlohmann::json::exception& problem) {
    refuse(Text::tr("the consent texts cannot be read: %1", problem.what()), file.string(),
           Text::tr("Restore the file from the installation"));
  }
  return shipped;
}

const ConsentWords& wordsIn(const ConsentVersion& version, const std::string& language) {
  for (const std::string& wanted : {language, std::string("en")}) {
    for (const ConsentWords& words : version.languages) {
      if (words.language == wanted) {
        return words;
      }
    }
  }
  return version.languages.front();
}

ConsentVersion askedConsent(SessionContext& session, const std::filesystem::path& assets) {
  session.require(Operation::kPractice);
  ConsentRepository repository(session.connection());
  return newestOf(repository, assets);
}

std::vector<ConsentVersion> consentVersions(SessionContext& session, const std::filesystem::path& assets) {
  session.require(Operation::kPersonViewCoded);
  std::vector<ConsentVersion> versions{shippedConsent(assets)};
  for (ConsentVersion& own : ConsentRepository(session.connection()).versions()) {
    versions.push_back(std::move(own));
  }
  return versions;
}

std::string publishConsent(SessionContext& session, const std::filesystem::path& assets,
                           std::vector<ConsentWords> languages, const std::string& note) {
  session.require(Operation::kSettingsEdit);
  if (note.empty()) {
    refuseParameter(Text::tr("no note says what changed"), Text::tr("consent"),
                    Text::tr("Say it in a few words"));
  }
  Transaction transaction(session.connection());
  ConsentRepository repository(session.connection());
  checkWords(languages, repository.purposes());
  const ConsentVersion before = newestOf(repository, assets);
  if (sameWords(before.languages, languages)) {
    refuseParameter(Text::tr("nothing has changed"), before.id, Text::tr("Change a text first"));
  }
  nameNewPurposes(repository, languages);
  ConsentVersion next;
  next.number = before.number + 1;
  next.id = "centre-" + std::to_string(next.number);
  next.note = note;
  next.languages = std::move(languages);
  next.publishedBy = session.actor().userId;
  next.publishedUtc_us = session.now_us();
  repository.add(next);
  session.note(
      {.action = AuditAction::kConsentPublish,
       .objectKind = AuditObject::kConsentVersion,
       .objectId = next.id,
       .oldJson = nlohmann::json{{"version", before.id}}.dump(),
       .newJson =
           nlohmann::json{{"version", next.id}, {"purposes", purposesOf(next.languages.front())}}.dump(),
       .reason = note});
  transaction.commit();
  return next.id;
}

std::vector<ConsentDecision> consentHistory(SessionContext& session, const PersonId& personId) {
  session.require(Operation::kPersonViewCoded);
  return PeopleRepository(session.connection()).consents(personId);
}

void recordConsent(SessionContext& session, const PersonId& personId, const std::string& purpose,
                   bool granted, const std::string& textVersion, std::int64_t signedUtc_us) {
  session.require(Operation::kConsentRecord);
  Transaction transaction(session.connection());
  const std::vector<std::string> known = ConsentRepository(session.connection()).purposes();
  if (std::find(known.begin(), known.end(), purpose) == known.end()) {
    refuseParameter(Text::tr("there is no such purpose"), purpose, Text::tr("Choose one from the list"));
  }
  if (textVersion.empty()) {
    refuseParameter(Text::tr("the version of the text shown is missing"), purpose,
                    Text::tr("Give the version of the consent text"));
  }
  const std::int64_t now_us = session.now_us();
  if (signedUtc_us > now_us + kDay_us) {
    refuseParameter(Text::tr("the day of the signature is still to come"), purpose,
                    Text::tr("Enter the date on the paper"));
  }
  PeopleRepository repository(session.connection());
  const auto person = repository.find(personId);
  if (!person || person->state == PersonState::kErased) {
    refuseParameter(Text::tr("there is no such person"), personId, Text::tr("Choose one from the list"));
  }
  const std::int64_t signed_us = signedUtc_us == 0 ? now_us : signedUtc_us;
  repository.recordConsent({.personId = personId,
                            .purpose = purpose,
                            .granted = granted,
                            .textVersion = textVersion,
                            .decidedUtc_us = now_us,
                            .recordedBy = session.actor().userId,
                            .demonstration = person->demonstration,
                            .form = ConsentForm::kPaper,
                            .signedUtc_us = signed_us});
  session.note(
      {.action = granted ? AuditAction::kConsentGrant : AuditAction::kConsentWithdraw,
       .objectKind = AuditObject::kConsent,
       .objectId = personId,
       .newJson =
           nlohmann::json{{"purpose", purpose}, {"text", textVersion}, {"signed_utc_us", signed_us}}.dump()});
  transaction.commit();
}

namespace {

void close(SessionContext& session, const std::string& requestId, PersonRequestAnswer answer,
           const std::string& reason) {
  Transaction transaction(session.connection());
  RequestRepository(session.connection()).answer(requestId, answer, reason, session.now_us());
  session.note(AuditAction::kPersonRequestAnswer, AuditObject::kPersonRequest, requestId,
               {{"answer", storedText(answer)}}, reason);
  transaction.commit();
}

}  // namespace

void requestAboutOwnRecord(SessionContext& session, PersonRequestKind kind) {
  session.require(Operation::kTrialViewOwn);
  if (session.actor().personId.empty()) {
    refuseParameter(Text::tr("your account does not belong to a person of this record"),
                    session.actor().login, Text::tr("Sign in as a trainee"));
  }
  for (const PersonRequest& earlier : ownRequests(session)) {
    if (earlier.kind == kind && !earlier.answer) {
      refuseParameter(Text::tr("you have asked for this already"), earlier.id,
                      Text::tr("Wait for the answer, or withdraw your request"));
    }
  }
  const PersonRequest request{.id = session.ids().newUuid(),
                              .personId = session.actor().personId,
                              .kind = kind,
                              .askedUtc_us = session.now_us()};
  Transaction transaction(session.connection());
  RequestRepository(session.connection()).add(request);
  session.note(AuditAction::kPersonRequest, AuditObject::kPersonRequest, request.id,
               {{"kind", storedText(kind)}});
  transaction.commit();
}

void takeBackOwnRequest(SessionContext& session, const std::string& requestId) {
  session.require(Operation::kTrialViewOwn);
  const std::vector<PersonRequest> own = ownRequests(session);
  if (std::none_of(own.begin(), own.end(), [&](const PersonRequest& one) { return one.id == requestId; })) {
    refuse(Text::tr("this is not your request"), requestId, Text::tr("Read the page again"));
  }
  close(session, requestId, PersonRequestAnswer::kTakenBack, {});
}

std::vector<PersonRequest> ownRequests(SessionContext& session) {
  session.require(Operation::kTrialViewOwn);
  std::vector<PersonRequest> own = RequestRepository(session.connection()).all();
  std::erase_if(own, [&](const PersonRequest& one) { return one.personId != session.actor().personId; });
  return own;
}

std::vector<PersonRequest> personRequests(SessionContext& session) {
  session.require(Operation::kPersonExport);
  return RequestRepository(session.connection()).all();
}

void answerPersonRequest(SessionContext& session, const std::string& requestId, bool done,
                         const std::string& reason) {
  session.require(Operation::kPersonExport);
  if (!done && reason.empty()) {
    refuseParameter(Text::tr("declining a request needs a reason"), requestId,
                    Text::tr("Say in a few words why"));
  }
  close(session, requestId, done ? PersonRequestAnswer::kDone : PersonRequestAnswer::kDeclined, reason);
}

}  // namespace torsio
