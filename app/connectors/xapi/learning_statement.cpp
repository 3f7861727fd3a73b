// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/xapi/learning_statement.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QDateTime>
#include <QUuid>
#include <nlohmann/json.hpp>

#include "app/outputs/tables/export_table.h"
#include "app/outputs/tables/pseudonyms.h"
#include "app/services/base/build_info.h"
#include "app/services/recording/competence.h"
#include "assessment/catalogue/quantity.h"
#include "db/connection/connection.h"
#include "db/repository/base/learning_events.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

using Json = nlohmann::ordered_json;

/// Equal names give equal ids.
std::string uuidOf(const std::string& name) {
  const QUuid ours(QStringLiteral("{7c1f7e52-6f0a-5d0e-9a55-3f6f2f0d8e01}"));
  return QUuid::createUuidV5(ours, QByteArray::fromStdString(name))
      .toString(QUuid::WithoutBraces)
      .toStdString();
}

/// Builds a verb of a standard vocabulary.
Json verbOf(const char* id, const char* word) {
  return {{"id", id}, {"display", {{"en", word}}}};
}

Json activity(const std::string& id, const char* type, const std::string& name) {
  Json made{{"objectType", "Activity"}, {"id", id}, {"definition", {{"type", type}}}};
  if (!name.empty()) {
    made["definition"]["name"] = {{"und", name}};
  }
  return made;
}

std::string isoDuration(std::int64_t duration_us) {
  const std::int64_t hundredths = (duration_us + kSecond_us / 200) / (kSecond_us / 100);
  const std::string rest = std::to_string(hundredths % 100);
  return "PT" + std::to_string(hundredths / 100) + "." + (rest.size() < 2 ? "0" : "") + rest + "S";
}

constexpr const char* kCourse = "http://adlnet.gov/expapi/activities/course";
constexpr const char* kSimulation = "http://adlnet.gov/expapi/activities/simulation";
constexpr const char* kComment = "http://activitystrea.ms/schema/1.0/comment";
constexpr const char* kRest = "urn:x-torsio:xapi:activity:rest";

/// Shared by all parts of a statement.
struct Telling {
  Connection& connection;
  const LearningEvent& event;
  const LearningFacts& facts;
  const std::string& homePage;
  std::optional<TrialListing> trial{};
  std::optional<TrainingModule> module{};
};

std::string activityId(const Telling& telling, const std::string& path) {
  return telling.homePage + (telling.homePage.ends_with('/') ? "" : "/") + "torsio/" + path;
}

Json cohortOf(const Telling& telling) {
  return activity(activityId(telling, "cohort/" + telling.facts.cohortId.text()), kCourse,
                  telling.facts.cohortName);
}

Json exerciseOf(const Telling& telling) {
  if (telling.module) {
    return activity(activityId(telling, "exercise/" + telling.module->id.text()), kSimulation,
                    telling.module->title);
  }
  return activity(activityId(telling, "practice/" + telling.trial->sceneId.text() + "/" +
                                          telling.trial->patternId.text()),
                  kSimulation, telling.trial->sceneId.text());
}

/// Competence after this run, with the error rates of the decision.
Json competenceExtensions(const CompetenceVerdict& verdict) {
  const std::string base(kXapiExtensions);
  return {{base + "able", isAble(verdict.level)},
          {base + "attempts", verdict.attempts},
          {base + "false-pass-rate", verdict.errors.falsePass},
          {base + "false-fail-rate", verdict.errors.falseFail},
          {base + "within-attempts", verdict.errors.attempts},
          {base + "competence-design-version", verdict.design.version}};
}

/// Verb and result of a run; empty if it does not count.
std::optional<std::pair<Json, Json>> judged(const Telling& telling, ExerciseRules& rules,
                                            std::int64_t now_us) {
  const TrialListing& trial = *telling.trial;
  if (!telling.module || !trial.summary || !countsAt(*telling.module, trial.attemptMode)) {
    return std::nullopt;
  }
  const AttemptMeasures measures = digestOf(telling.connection, trial, rules, now_us).measures;
  const RunVerdict verdict = verdictOn(*trial.summary, measures, rulesOf(*telling.module));
  if (verdict.outcome != RunOutcome::kPassed && verdict.outcome != RunOutcome::kNotPassed) {
    return std::nullopt;  // interrupted or not judged: neither passed nor failed
  }
  Json result{{"success", verdict.passed()},
              {"completion", true},
              {"duration", isoDuration(telling.facts.duration_us)}};
  const std::optional<double> undone = valueIn(measures.values, Quantity::kUntwisted);
  const std::int64_t of =
      undone ? std::int64_t{1} : std::max(std::ssize(measures.twists), telling.module->leastTwists);
  const std::int64_t reached = undone ? (*undone > 0.0 ? 1 : 0) : measures.twistsOnTarget();
  if (of > 0) {
    result["score"] = {{"scaled", static_cast<double>(reached) / static_cast<double>(of)},
                       {"raw", reached},
                       {"min", 0},
                       {"max", of}};
  }
  result["extensions"] = competenceExtensions(competenceOf(
      telling.connection, trial.traineeCode, *telling.module, rules, now_us, trial.startedUtc_us));
  result["extensions"][std::string(kXapiExtensions) + "verdict"] = storedText(verdict.outcome);
  return std::pair(verdict.passed() ? verbOf("http://adlnet.gov/expapi/verbs/passed", "passed")
                                    : verbOf("http://adlnet.gov/expapi/verbs/failed", "failed"),
                   std::move(result));
}

/// Adds verb, object and result. False: nothing to report.
bool tell(const Telling& telling, ExerciseRules& rules, std::int64_t now_us, Json& statement) {
  switch (telling.event.kind) {
    case LearningEventKind::kRegistered:
      statement["verb"] = verbOf("http://adlnet.gov/expapi/verbs/registered", "registered");
      statement["object"] = cohortOf(telling);
      return true;
    case LearningEventKind::kLaunched:
      statement["verb"] = verbOf("http://adlnet.gov/expapi/verbs/launched", "launched");
      statement["object"] = exerciseOf(telling);
      return true;
    case LearningEventKind::kCompleted:
      statement["verb"] = verbOf("http://adlnet.gov/expapi/verbs/completed", "completed");
      statement["object"] = exerciseOf(telling);
      statement["result"] = {{"completion", true}, {"duration", isoDuration(telling.facts.duration_us)}};
      return true;
    case LearningEventKind::kJudged: {
      auto verdict = judged(telling, rules, now_us);
      if (!verdict) {
        return false;
      }
      statement["verb"] = std::move(verdict->first);
      statement["object"] = exerciseOf(telling);
      statement["result"] = std::move(verdict->second);
      return true;
    }
    case LearningEventKind::kRested:
      statement["verb"] = verbOf("http://adlnet.gov/expapi/verbs/experienced", "experienced");
      statement["object"] = activity(activityId(telling, "rest"), kRest, "rest");
      statement["result"] = {{"duration", isoDuration(telling.facts.duration_us)}};
      return true;
    case LearningEventKind::kRemarkRead:
      statement["verb"] = verbOf("http://activitystrea.ms/schema/1.0/read", "read");
      statement["object"] =
          activity(activityId(telling, "remark/" + uuidOf("remark/" + telling.event.objectId)), kComment, "");
      return true;
    case LearningEventKind::kEnd:
      break;
  }
  return false;
}

/// The parts that make two statements equivalent.
nlohmann::json comparableParts(const nlohmann::json& statement) {
  nlohmann::json kept;
  kept["id"] = statement.value("id", "");
  const auto part = [&](const char* name, const char* inner) {
    if (statement.contains(name) && statement[name].is_object() && statement[name].contains(inner)) {
      kept[name] = statement[name][inner];
    }
  };
  part("actor", "account");
  part("verb", "id");
  part("object", "id");
  part("context", "registration");
  kept["result"] = statement.value("result", nlohmann::json::object());
  kept["time"] =
      QDateTime::fromString(QString::fromStdString(statement.value("timestamp", "")), Qt::ISODateWithMs)
          .toMSecsSinceEpoch();
  return kept;
}

}  // namespace

std::string statementId(const LearningEvent& event) {
  return uuidOf("statement/" + std::string(storedText(event.kind)) + "/" + event.objectId);
}

std::string accountName(const LrsIdentity& identity, const PersonId& personId) {
  const Pseudonyms names(identity.accountKey);
  return names.of("L", personId.text()) + names.of("", personId.text());
}

std::string statementOf(Connection& connection, const LearningEvent& event, const LrsIdentity& identity,
                        ExerciseRules& rules, std::int64_t now_us) {
  const std::optional<LearningFacts> facts = LearningRepository(connection).facts(event);
  if (!facts) {
    return {};
  }
  Telling telling{connection, event, *facts, identity.settings.homePage};
  if (!facts->trialId.empty()) {
    telling.trial = TrialRepository(connection).listing(facts->trialId);
  }
  if (!facts->moduleId.empty()) {
    telling.module = CurriculumRepository(connection).module(facts->moduleId);
  }
  Json statement;
  statement["id"] = statementId(event);
  statement["actor"] = {
      {"objectType", "Agent"},
      {"account",
       {{"homePage", identity.settings.homePage}, {"name", accountName(identity, event.personId)}}}};
  if (!tell(telling, rules, now_us, statement)) {
    return {};
  }
  Json context{{"platform", "Torsio " + softwareVersion()}};
  if (!facts->enrolmentId.empty()) {
    context["registration"] = uuidOf("registration/" + facts->enrolmentId.text());
    if (event.kind != LearningEventKind::kRegistered) {
      context["contextActivities"] = {{"parent", Json::array({cohortOf(telling)})}};
    }
  }
  statement["context"] = std::move(context);
  statement["timestamp"] = cellText(ExportCell(event.happenedUtc_us));
  return statement.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool sameStatement(const std::string& sent, const std::string& stored) {
  const nlohmann::json a = nlohmann::json::parse(sent, nullptr, false);
  const nlohmann::json b = nlohmann::json::parse(stored, nullptr, false);
  try {
    return a.is_object() && b.is_object() && comparableParts(a) == comparableParts(b);
  } catch (const nlohmann::json::exception&) {
    return false;  // members have the wrong types
  }
}

}  // namespace torsio
