// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/frozen_data.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/signing.h"
#include "app/services/access/two_people.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/field_digest.h"
#include "db/repository/base/id_source.h"
#include "db/repository/base/seals.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/freeze_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

using nlohmann::json;
using Hashes = std::map<std::string, std::string>;  ///< row id -> hash
using Manifest = std::map<std::string, Hashes>;     ///< table -> rows

constexpr const char* kFrozenFormat = "torsio frozen data 1";
constexpr std::size_t kShownDifferences = 20;

std::string hashOf(const Enrolment& row) {
  FieldDigest digest("torsio frozen enrolment 1");
  digest.add(row.id).add(row.traineeCode).add(row.groupId).add(row.numberInGroup).add(storedText(row.state));
  return digest.hex();
}

std::string hashOf(const Exposure& row) {
  FieldDigest digest("torsio frozen exposure 1");
  digest.add(row.id).add(row.enrolmentId).add(row.phaseId).add(storedText(row.kind)).add(row.startedUtc_us);
  digest.add(row.duration_us);
  return digest.hex();
}

/// Excludes the description, which may be erased with a person.
std::string hashOf(const ProtocolDeviation& row) {
  FieldDigest digest("torsio frozen deviation 1");
  digest.add(row.id).add(row.enrolmentId).add(row.kind).add(row.happenedUtc_us);
  return digest.hex();
}

std::string hashOf(const Campaign& campaign) {
  FieldDigest digest("torsio frozen campaign 1");
  digest.add(campaign.id).add(campaign.name);
  const EvaluationInstrument& instrument = campaign.instrument;
  digest.add(instrument.scale.lo).add(instrument.scale.hi).add(instrument.scale.stepsPerPoint);
  for (const RaterClass& part : instrument.classes) {
    digest.add(part.id).add(part.weight_milli);
  }
  for (const EvaluationIndex& part : instrument.indices) {
    digest.add(part.id).add(part.weight_milli);
  }
  for (const CampaignModel& model : campaign.models) {
    digest.add(model.code).add(model.hiddenLabel);
  }
  for (const CampaignRater& rater : campaign.raters) {
    digest.add(rater.raterId).add(rater.classCode).add(rater.modelOrder);
  }
  return digest.hex();
}

template <class Row>
Hashes hashesOf(const std::vector<Row>& rows) {
  Hashes hashes;
  for (const Row& row : rows) {
    hashes[row.id] = hashOf(row);
  }
  return hashes;
}

template <class Row>
auto idsOf(const std::vector<Row>& rows) {
  std::vector<decltype(Row::id)> ids;
  for (const Row& row : rows) {
    ids.push_back(row.id);
  }
  return ids;
}

Manifest manifestOf(SessionContext& session, const CohortId& cohortId,
                    const std::vector<CampaignId>& campaignIds) {
  Connection& connection = session.connection();
  StudyRepository study(connection);
  Manifest manifest;
  manifest["enrolment"] = hashesOf(study.enrolments(cohortId));
  Hashes& allocations = manifest["allocation"];
  for (const LockedDesign& design : study.designs(cohortId)) {
    for (const AllocationEntry& record : study.allocations(design.id)) {
      allocations[record.id] = record.recordHash;
    }
  }
  manifest["exposure"] = hashesOf(study.exposures(cohortId));
  manifest["deviation"] = hashesOf(study.deviations(cohortId));
  if (const auto marks = idsOf(RatingRepository(connection).marks(cohortId)); !marks.empty()) {
    manifest["training_mark"] = markHashes(connection, marks);
  }
  Hashes& trials = manifest["trial"];
  const std::vector<TrialId> trialIds = study.trialIds(cohortId);
  for (const TrialId& id : trialIds) {
    trials[id] = "not ended";
  }
  if (!trialIds.empty()) {
    for (const auto& [id, hash] : trialHashes(connection, trialIds)) {
      trials[id] = hash;
    }
  }
  EvaluationRepository evaluations(connection);
  for (const CampaignId& campaignId : campaignIds) {
    const auto campaign = evaluations.campaign(campaignId);
    if (!campaign) {
      refuseParameter(Text::tr("there is no such evaluation"), campaignId,
                      Text::tr("Choose one from the list"));
    }
    manifest["evaluation_campaign"][campaignId] = hashOf(*campaign);
    const auto marks = idsOf(evaluations.marks(campaignId));
    if (marks.empty()) {
      continue;
    }
    Hashes& all = manifest["evaluation_mark"];
    all.merge(evaluationMarkHashes(connection, marks));
  }
  return manifest;
}

json manifestJson(const Manifest& manifest, const SheetCount& sheets, const std::string& whyIncomplete,
                  const UserId& askedBy) {
  json out{{"format", kFrozenFormat},
           {"rows", manifest},
           {"sheets", {{"asked", sheets.asked}, {"submitted", sheets.submitted}}}};
  if (!whyIncomplete.empty()) {
    out["why_incomplete"] = whyIncomplete;
  }
  if (!askedBy.empty()) {
    out["asked_by"] = askedBy.text();
  }
  return out;
}

std::string hashOfText(const std::string& text) {
  Digest digest;
  digest.update(text);
  return digest.hex();
}

/// Parts of a stored manifest.
struct Frozen {
  Manifest rows;
  SheetCount sheets;
  std::string whyIncomplete;
  std::string askedBy;  // a user
};

Frozen frozenFrom(const DataFreeze& stored) {
  try {
    const json all = json::parse(stored.manifestJson);
    Frozen out{
        all.at("rows").get<Manifest>(), {}, all.value("why_incomplete", ""), all.value("asked_by", "")};
    if (all.contains("sheets")) {
      out.sheets = {all.at("sheets").at("asked").get<std::int64_t>(),
                    all.at("sheets").at("submitted").get<std::int64_t>()};
    }
    return out;
  } catch (const json::exception& problem) {
    refuse(Text::tr("the manifest cannot be read: %1", problem.what()), stored.name,
           Text::tr("Verify the database"));
  }
}

/// Sign-in names by user.
std::map<std::string, std::string> loginsIn(Connection& connection) {
  std::map<std::string, std::string> loginOf;
  for (const UserAccount& user : AccessRepository(connection).users()) {
    loginOf.emplace(user.id, user.login);
  }
  return loginOf;
}

FrozenRow rowOf(const DataFreeze& stored, const std::map<std::string, std::string>& loginOf) {
  const auto named = [&](const std::string& user) {
    const auto known = loginOf.find(user);
    return known == loginOf.end() ? user : known->second;
  };
  Frozen frozen = frozenFrom(stored);
  Manifest& manifest = frozen.rows;
  FrozenRow row{.id = stored.id,
                .cohortId = stored.cohortId,
                .name = stored.name,
                .contentHash = stored.contentHash,
                .createdUtc_us = stored.createdUtc_us,
                .createdBy = named(stored.createdBy),
                .sheets = frozen.sheets,
                .whyIncomplete = frozen.whyIncomplete,
                .askedBy = named(frozen.askedBy)};
  row.counts = {.enrolments = manifest["enrolment"].size(),
                .allocations = manifest["allocation"].size(),
                .exposures = manifest["exposure"].size(),
                .deviations = manifest["deviation"].size(),
                .marks = manifest["training_mark"].size(),
                .trials = manifest["trial"].size(),
                .campaigns = manifest["evaluation_campaign"].size(),
                .evaluationMarks = manifest["evaluation_mark"].size()};
  return row;
}

std::optional<DataFreeze> findFreeze(SessionContext& session, const FreezeId& frozenId) {
  FreezeRepository repository(session.connection());
  for (const Cohort& cohort : StudyRepository(session.connection()).cohorts()) {
    for (DataFreeze& freeze : repository.list(cohort.id)) {
      if (freeze.id == frozenId) {
        return std::move(freeze);
      }
    }
  }
  return std::nullopt;
}

/// Describes the differences between two states of a table.
void compareTable(const std::string& table, const Hashes& then, const Hashes& now, FrozenCheck& check) {
  const auto add = [&](const Text& difference) {
    check.same = false;
    if (check.differences.size() < kShownDifferences) {
      check.differences.push_back(difference);
    }
  };
  for (const auto& [id, hash] : then) {
    const auto present = now.find(id);
    if (present == now.end()) {
      add(Text::tr("%1 %2 is no longer there", table, id));
    } else if (present->second != hash) {
      add(Text::tr("%1 %2 has changed", table, id));
    }
  }
  for (const auto& [id, hash] : now) {
    if (!then.contains(id)) {
      add(Text::tr("%1 %2 was added", table, id));
    }
  }
}

/// Returns whether freezing this state is an interim look at real data.
bool twoDecide(const Cohort& cohort, const SheetCount& sheets) {
  return !sheets.complete() && !cohort.demonstration;
}

}  // namespace

SheetCount sheetCount(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kResultsCompute);
  return countSheets(session.connection(), cohortId);
}

bool mayFreezeNow(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kResultsCompute);
  return !twoDecide(StudyRepository(session.connection()).cohort(cohortId), sheetCount(session, cohortId)) ||
         secondPersonIsThere(session, DutyAct::kFreezeInterim, cohortId);
}

FrozenRow freezeData(SessionContext& session, const CohortId& cohortId, const std::string& name,
                     const std::vector<CampaignId>& campaignIds, const std::string& whyIncomplete) {
  session.require(Operation::kResultsCompute);
  if (name.empty()) {
    refuseParameter(Text::tr("the data set has no name"), Text::tr("name"), Text::tr("Enter one"));
  }
  Transaction transaction(session.connection());
  FreezeRepository repository(session.connection(), session.station());
  if (repository.findByName(name)) {
    refuseParameter(Text::tr("another data set has this name"), name,
                    Text::tr("Choose another name; frozen data stay as they are"));
  }
  const Cohort cohort = StudyRepository(session.connection()).cohort(cohortId);
  const SheetCount sheets = sheetCount(session, cohortId);
  if (!sheets.complete() && whyIncomplete.empty()) {
    refuse(
        sentenceOf(sheets), cohort.name,
        Text::tr("Wait for the others, or say why an interim state is frozen: every report of it says so"));
  }
  const UserId askedBy =
      twoDecide(cohort, sheets) ? requireSecondPerson(session, DutyAct::kFreezeInterim, cohortId) : UserId();
  DataFreeze freeze;
  freeze.id = session.ids().newUuid();
  freeze.cohortId = cohortId;
  freeze.name = name;
  freeze.manifestJson =
      manifestJson(manifestOf(session, cohortId, campaignIds), sheets, whyIncomplete, askedBy).dump();
  freeze.contentHash = hashOfText(freeze.manifestJson);
  freeze.createdBy = session.actor().userId;
  freeze.createdUtc_us = session.now_us();
  freeze.demonstration = cohort.demonstration;
  repository.add(freeze);  // together with its audit entry
  sign(session, {.kind = SignedKind::kFrozenDataset,
                 .objectId = freeze.id,
                 .meaning = SignatureMeaning::kFroze,
                 .demonstration = freeze.demonstration});
  transaction.commit();
  endSigning(session);
  return rowOf(freeze, loginsIn(session.connection()));
}

std::vector<FrozenRow> frozenData(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kResultsCompute);
  const std::map<std::string, std::string> loginOf = loginsIn(session.connection());
  std::vector<FrozenRow> rows;
  for (const DataFreeze& stored : FreezeRepository(session.connection()).list(cohortId)) {
    rows.push_back(rowOf(stored, loginOf));
  }
  return rows;
}

FrozenCheck compareWithFrozen(SessionContext& session, const FreezeId& frozenId) {
  session.require(Operation::kResultsCompute);
  const auto stored = findFreeze(session, frozenId);
  if (!stored) {
    refuseParameter(Text::tr("there is no such data set"), frozenId, Text::tr("Choose one from the list"));
  }
  FrozenCheck check;
  if (hashOfText(stored->manifestJson) != stored->contentHash) {
    check.same = false;
    check.differences.emplace_back(
        Text::tr("the manifest does not fit its hash: the database was tampered with"));
    return check;
  }
  const Manifest then = frozenFrom(*stored).rows;
  std::vector<CampaignId> campaignIds;
  if (const auto campaigns = then.find("evaluation_campaign"); campaigns != then.end()) {
    for (const auto& [id, hash] : campaigns->second) {
      campaignIds.push_back(id);
    }
  }
  Manifest now = manifestOf(session, stored->cohortId, campaignIds);
  for (const auto& [table, rows] : then) {
    compareTable(table, rows, now[table], check);
  }
  for (const auto& [table, rows] : now) {
    if (!then.contains(table)) {
      compareTable(table, {}, rows, check);
    }
  }
  return check;
}

}  // namespace torsio
