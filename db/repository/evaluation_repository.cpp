// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/evaluation_repository.h"

#include <array>

#include "db/repository/audit_repository.h"
#include "db/repository/insert_once.h"
#include "db/repository/seals.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

void insertInstrument(Connection& connection, const StoredCampaign& campaign) {
  Statement raterClass = connection.prepare(
      "INSERT INTO evaluation_class (campaign_id, class_code, position, weight_milli) VALUES (?, ?, ?, ?)");
  std::int64_t position = 0;
  for (const RaterClass& part : campaign.instrument.classes) {
    raterClass.execute({campaign.id, part.id, ++position, part.weight_milli});
  }
  Statement index = connection.prepare(
      "INSERT INTO evaluation_index (campaign_id, index_number, code, label, weight_milli)"
      " VALUES (?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const EvaluationIndex& part : campaign.instrument.indices) {
    index.execute({campaign.id, ++number, part.id, part.name, part.weight_milli});
  }
}

void insertParticipants(Connection& connection, const StoredCampaign& campaign) {
  Statement model = connection.prepare(
      "INSERT INTO evaluation_model (campaign_id, model_code, label, hidden_label, position)"
      " VALUES (?, ?, ?, ?, ?)");
  for (const StoredModel& part : campaign.models) {
    model.execute({campaign.id, part.code, part.label, part.hiddenLabel, part.position});
  }
  Statement rater = connection.prepare(
      "INSERT INTO evaluation_rater (campaign_id, rater_id, class_code, model_order) VALUES (?, ?, ?, ?)");
  for (const StoredCampaignRater& part : campaign.raters) {
    rater.execute({campaign.id, part.raterId, part.classCode, part.modelOrder});
  }
}

void readInstrument(Connection& connection, StoredCampaign& campaign) {
  Statement raterClass = connection.prepare(
      "SELECT c.class_code, r.label, c.weight_milli FROM evaluation_class c"
      " JOIN rater_class r ON r.code = c.class_code WHERE c.campaign_id = ? ORDER BY c.position");
  raterClass.execute({campaign.id});
  while (raterClass.step()) {
    campaign.instrument.classes.push_back({raterClass.text(0), raterClass.text(1), raterClass.int64(2)});
  }
  Statement index = connection.prepare(
      "SELECT code, label, weight_milli FROM evaluation_index WHERE campaign_id = ? ORDER BY index_number");
  index.execute({campaign.id});
  while (index.step()) {
    campaign.instrument.indices.push_back({index.text(0), index.text(1), index.int64(2)});
  }
}

void readParticipants(Connection& connection, StoredCampaign& campaign) {
  Statement model = connection.prepare(
      "SELECT model_code, label, hidden_label, position FROM evaluation_model WHERE campaign_id = ?"
      " ORDER BY position");
  model.execute({campaign.id});
  while (model.step()) {
    campaign.models.push_back({model.text(0), model.text(1), model.text(2), model.int64(3)});
  }
  Statement rater = connection.prepare(
      "SELECT r.rater_id, r.class_code, r.model_order FROM evaluation_rater r"
      " JOIN person p ON p.id = r.rater_id WHERE r.campaign_id = ? ORDER BY p.code");
  rater.execute({campaign.id});
  while (rater.step()) campaign.raters.push_back({rater.text(0), rater.text(1), rater.text(2)});
}

ScoreScale scaleOf(Connection& connection, const std::string& campaignId) {
  Statement row = connection.prepare(
      "SELECT scale_lo_steps, scale_hi_steps, steps_per_point FROM evaluation_campaign WHERE id = ?");
  row.execute({campaignId});
  if (row.step()) return {row.int64(0), row.int64(1), row.int64(2)};
  throw Error(ErrorCode::kBadData, "no such evaluation campaign", campaignId, "Choose an existing one");
}

std::vector<StoredEvaluationResult> resultsOf(Connection& connection, const std::string& runId) {
  std::vector<StoredEvaluationResult> results;
  Statement row = connection.prepare(
      "SELECT model_code, index_number, weighted_mean, variance, rater_count, missing_count, lowest, highest,"
      " plain_mean, population_variance, sample_variance, standard_error, flags FROM evaluation_result"
      " WHERE run_id = ? ORDER BY model_code, index_number");
  row.execute({runId});
  while (row.step()) {
    results.push_back({row.text(0), row.int64(1), row.real(2), row.real(3), row.int64(4), row.int64(5),
                       row.real(6), row.real(7), row.real(8), row.real(9), row.maybeReal(10),
                       row.maybeReal(11), splitFlags(row.text(12))});
  }
  return results;
}

std::vector<StoredComposite> compositesOf(Connection& connection, const std::string& runId) {
  std::vector<StoredComposite> composites;
  Statement row = connection.prepare(
      "SELECT model_code, composite, standard_error, flags FROM composite_result WHERE run_id = ?"
      " ORDER BY model_code");
  row.execute({runId});
  while (row.step()) {
    composites.push_back({row.text(0), row.real(1), row.maybeReal(2), splitFlags(row.text(3))});
  }
  return composites;
}

/// Whether a mark is there already; refuses another one under its id.
bool isStored(Connection& connection, const std::string& campaignId, const StoredEvaluationMark& mark) {
  using Kind = OnceColumn::Kind;
  Statement stored = connection.prepare("SELECT id FROM evaluation_mark WHERE id = ?");
  stored.execute({mark.id});
  bool there = false;
  while (stored.step()) there = true;
  if (!there) return false;
  const std::array<OnceColumn, 10> columns{{{"id", mark.id, Kind::kKey},
                                            {"campaign_id", campaignId},
                                            {"rater_id", mark.raterId},
                                            {"model_code", mark.modelCode},
                                            {"index_number", mark.indexNumber},
                                            {"version", mark.version},
                                            {"score_steps", mark.score_steps},
                                            {"amend_reason", textOrNull(mark.amendReason)},
                                            {"submitted_utc_us", mark.submittedUtc_us, Kind::kAside},
                                            {"demonstration", mark.demonstration}}};
  insertOnce(connection, "evaluation_mark", columns, "this mark");
  return true;
}

}  // namespace

void EvaluationRepository::addCampaign(const StoredCampaign& campaign) {
  validateInstrument(campaign.instrument);
  Transaction transaction(connection_);
  const ScoreScale& scale = campaign.instrument.scale;
  connection_.execute(
      "INSERT INTO evaluation_campaign (id, name, scale_lo_steps, scale_hi_steps, steps_per_point,"
      " created_utc_us, demonstration) VALUES (?, ?, ?, ?, ?, ?, ?)",
      {campaign.id, campaign.name, scale.lo, scale.hi, scale.stepsPerPoint, campaign.createdUtc_us,
       campaign.demonstration});
  insertInstrument(connection_, campaign);
  insertParticipants(connection_, campaign);
  transaction.commit();
}

std::vector<std::pair<std::string, std::string>> EvaluationRepository::campaigns() {
  std::vector<std::pair<std::string, std::string>> campaigns;
  Statement row =
      connection_.prepare("SELECT id, name FROM evaluation_campaign ORDER BY created_utc_us, name");
  row.execute();
  while (row.step()) campaigns.emplace_back(row.text(0), row.text(1));
  return campaigns;
}

std::optional<StoredCampaign> EvaluationRepository::campaign(const std::string& campaignId) {
  Statement row = connection_.prepare(
      "SELECT id, name, scale_lo_steps, scale_hi_steps, steps_per_point, created_utc_us, demonstration"
      " FROM evaluation_campaign WHERE id = ?");
  row.execute({campaignId});
  if (!row.step()) return std::nullopt;
  StoredCampaign campaign;
  campaign.id = row.text(0);
  campaign.name = row.text(1);
  campaign.instrument.scale = {row.int64(2), row.int64(3), row.int64(4)};
  campaign.createdUtc_us = row.int64(5);
  campaign.demonstration = row.boolean(6);
  readInstrument(connection_, campaign);
  readParticipants(connection_, campaign);
  return campaign;
}

void EvaluationRepository::submit(const std::string& campaignId,
                                  std::span<const StoredEvaluationMark> marks) {
  if (marks.empty()) return;
  Transaction transaction(connection_);
  const ScoreScale scale = scaleOf(connection_, campaignId);
  Statement insert = connection_.prepare(
      "INSERT INTO evaluation_mark (id, campaign_id, rater_id, model_code, index_number, version, "
      "score_steps,"
      " amend_reason, submitted_utc_us, demonstration) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  std::vector<std::string> ids;
  std::vector<const StoredEvaluationMark*> added;
  for (const StoredEvaluationMark& mark : marks) {
    if (!isOnScale(mark.score_steps, scale)) {
      throw Error(ErrorCode::kBadData,
                  Text("score of %1 steps lies outside %2 .. %3", mark.score_steps, scale.lo, scale.hi),
                  Text("rater %1, model %2, index %3", mark.raterId, mark.modelCode, mark.indexNumber),
                  "Correct the score");
    }
    if (isStored(connection_, campaignId, mark)) continue;
    insert.execute({mark.id, campaignId, mark.raterId, mark.modelCode, mark.indexNumber, mark.version,
                    mark.score_steps, textOrNull(mark.amendReason), mark.submittedUtc_us,
                    mark.demonstration});
    ids.push_back(mark.id);
    added.push_back(&mark);
  }
  if (added.empty()) {
    transaction.commit();
    return;
  }
  const std::map<std::string, std::string> hashes = evaluationMarkHashes(connection_, ids);
  std::vector<AuditEntry> seals;
  for (const StoredEvaluationMark* mark : added) {
    AuditEntry seal;
    seal.atUtc_us = mark->submittedUtc_us;
    seal.actor = mark->raterId;
    seal.station = station_;
    seal.action = mark->version == 1 ? "evaluation.submit" : "evaluation.amend";
    seal.objectKind = kSealedEvaluationMark;
    seal.objectId = mark->id;
    seal.reason = mark->amendReason;
    seal.objectHash = hashes.at(mark->id);
    seals.push_back(seal);
  }
  AuditRepository(connection_).append(seals);
  transaction.commit();
}

bool EvaluationRepository::hasMarks(const std::string& campaignId) {
  Statement row = connection_.prepare("SELECT 1 FROM evaluation_mark WHERE campaign_id = ? LIMIT 1");
  row.execute({campaignId});
  return row.step();
}

std::vector<StoredEvaluationMark> EvaluationRepository::marks(const std::string& campaignId) {
  std::vector<StoredEvaluationMark> marks;
  Statement row = connection_.prepare(
      "SELECT m.id, m.rater_id, m.model_code, m.index_number, m.version, m.score_steps, m.amend_reason,"
      " m.submitted_utc_us, m.demonstration, p.code, r.class_code FROM evaluation_mark m"
      " JOIN evaluation_rater r ON r.campaign_id = m.campaign_id AND r.rater_id = m.rater_id"
      " JOIN evaluation_class c ON c.campaign_id = r.campaign_id AND c.class_code = r.class_code"
      " JOIN evaluation_model o ON o.campaign_id = m.campaign_id AND o.model_code = m.model_code"
      " JOIN person p ON p.id = m.rater_id"
      " WHERE m.campaign_id = ? AND NOT EXISTS (SELECT 1 FROM evaluation_mark n"
      "  WHERE n.campaign_id = m.campaign_id AND n.rater_id = m.rater_id AND n.model_code = m.model_code"
      "  AND n.index_number = m.index_number AND n.version > m.version)"
      " ORDER BY o.position, c.position, p.code, m.index_number");
  row.execute({campaignId});
  while (row.step()) {
    marks.push_back({.id = row.text(0),
                     .raterId = row.text(1),
                     .modelCode = row.text(2),
                     .indexNumber = row.int64(3),
                     .version = row.int64(4),
                     .score_steps = row.int64(5),
                     .amendReason = row.text(6),
                     .submittedUtc_us = row.int64(7),
                     .demonstration = row.boolean(8),
                     .raterCode = row.text(9),
                     .classCode = row.text(10)});
  }
  return marks;
}

void EvaluationRepository::storeRun(const std::string& campaignId, const StoredEvaluationRun& run) {
  Transaction transaction(connection_);
  insertRun(connection_, RunOwner::kCampaign, campaignId, run.run);
  Statement result = connection_.prepare(
      "INSERT INTO evaluation_result (run_id, model_code, index_number, weighted_mean, variance, rater_count,"
      " missing_count, lowest, highest, plain_mean, population_variance, sample_variance, standard_error, "
      "flags)"
      " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const StoredEvaluationResult& row : run.results) {
    result.execute({run.run.id, row.modelCode, row.indexNumber, row.weightedMean, row.variance,
                    row.raterCount, row.missingCount, row.lowest, row.highest, row.plainMean,
                    row.populationVariance, row.sampleVariance, row.standardError, joinFlags(row.flags)});
  }
  Statement composite = connection_.prepare(
      "INSERT INTO composite_result (run_id, model_code, composite, standard_error, flags)"
      " VALUES (?, ?, ?, ?, ?)");
  for (const StoredComposite& row : run.composites) {
    composite.execute({run.run.id, row.modelCode, row.composite, row.standardError, joinFlags(row.flags)});
  }
  transaction.commit();
}

std::optional<StoredEvaluationRun> EvaluationRepository::latestRun(const std::string& campaignId) {
  const std::optional<AssessmentRun> run = findLatestRun(connection_, RunOwner::kCampaign, campaignId);
  if (!run) return std::nullopt;
  return StoredEvaluationRun{*run, resultsOf(connection_, run->id), compositesOf(connection_, run->id)};
}

}  // namespace torsio
