// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/evaluation_repository.h"

#include <array>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/insert_idempotent.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

void insertInstrument(Connection& connection, const Campaign& campaign) {
  Statement raterClass =
      connection.prepare(insertInto("evaluation_class", "campaign_id, class_code, position, weight_milli"));
  std::int64_t position = 0;
  for (const RaterClass& part : campaign.instrument.classes) {
    raterClass.execute({campaign.id, part.id, ++position, part.weight_milli});
  }
  Statement index = connection.prepare(
      insertInto("evaluation_index", "campaign_id, index_number, code, label, weight_milli"));
  std::int64_t number = 0;
  for (const EvaluationIndex& part : campaign.instrument.indices) {
    index.execute({campaign.id, ++number, part.id, part.name, part.weight_milli});
  }
}

void insertParticipants(Connection& connection, const Campaign& campaign) {
  Statement model = connection.prepare(
      insertInto("evaluation_model", "campaign_id, model_code, label, hidden_label, position, trial_id"));
  for (const CampaignModel& part : campaign.models) {
    model.execute(
        {campaign.id, part.code, part.label, part.hiddenLabel, part.position, textOrNull(part.trialId)});
  }
  Statement rater =
      connection.prepare(insertInto("evaluation_rater", "campaign_id, rater_id, class_code, model_order"));
  for (const CampaignRater& part : campaign.raters) {
    rater.execute({campaign.id, part.raterId, part.classCode, part.modelOrder});
  }
}

std::vector<RaterClass> classesOf(Connection& connection, const CampaignId& campaignId) {
  return selectAll(connection,
                   "SELECT c.class_code, r.label, c.weight_milli FROM evaluation_class c"
                   " JOIN rater_class r ON r.code = c.class_code WHERE c.campaign_id = ? ORDER BY c.position",
                   {campaignId}, [](RowReader& row) {
                     return RaterClass{row.text(), row.text(), row.int64()};
                   });
}

std::vector<EvaluationIndex> indicesOf(Connection& connection, const CampaignId& campaignId) {
  return selectAll(
      connection,
      "SELECT code, label, weight_milli FROM evaluation_index WHERE campaign_id = ? ORDER BY index_number",
      {campaignId}, [](RowReader& row) {
        return EvaluationIndex{row.text(), row.text(), row.int64()};
      });
}

std::vector<CampaignModel> modelsOf(Connection& connection, const CampaignId& campaignId) {
  return selectAll(
      connection,
      "SELECT model_code, label, hidden_label, position, trial_id FROM evaluation_model WHERE campaign_id = ?"
      " ORDER BY position",
      {campaignId}, [](RowReader& row) {
        return CampaignModel{row.text(), row.text(), row.text(), row.int64(), row.text()};
      });
}

std::vector<CampaignRater> ratersOf(Connection& connection, const CampaignId& campaignId) {
  return selectAll(connection,
                   "SELECT r.rater_id, r.class_code, r.model_order FROM evaluation_rater r"
                   " JOIN person p ON p.id = r.rater_id WHERE r.campaign_id = ? ORDER BY p.code",
                   {campaignId}, [](RowReader& row) {
                     return CampaignRater{row.text(), row.text(), row.text()};
                   });
}

/// Reads id, name, scale, time and flag; the parts come from tables of their own.
Campaign campaignOf(RowReader& row) {
  Campaign campaign;
  campaign.id = row.text();
  campaign.name = row.text();
  campaign.instrument.scale = {row.int64(), row.int64(), row.int64()};
  campaign.createdUtc_us = row.int64();
  campaign.demonstration = row.boolean();
  return campaign;
}

std::optional<Campaign> findCampaign(Connection& connection, const CampaignId& campaignId) {
  return selectFirst(
      connection,
      "SELECT id, name, scale_lo_steps, scale_hi_steps, steps_per_point, created_utc_us, demonstration"
      " FROM evaluation_campaign WHERE id = ?",
      {campaignId}, campaignOf);
}

ScoreScale scaleOf(Connection& connection, const CampaignId& campaignId) {
  const std::optional<Campaign> campaign = findCampaign(connection, campaignId);
  if (campaign) {
    return campaign->instrument.scale;
  }
  refuse(Text::tr("no such evaluation campaign"), campaignId, Text::tr("Choose an existing one"));
}

/// Stores a mark; throws for another mark with its id.
Inserted insertMark(Connection& connection, const CampaignId& campaignId, const EvaluationMark& mark) {
  using Kind = IdempotentColumn::Kind;
  const std::array<IdempotentColumn, 10> columns{{{"id", mark.id, Kind::kKey},
                                                  {"campaign_id", campaignId},
                                                  {"rater_id", mark.raterId},
                                                  {"model_code", mark.modelCode},
                                                  {"index_number", mark.indexNumber},
                                                  {"version", mark.version},
                                                  {"score_steps", mark.score_steps},
                                                  {"amend_reason", textOrNull(mark.amendReason)},
                                                  {"submitted_utc_us", mark.submittedUtc_us, Kind::kIgnored},
                                                  {"demonstration", mark.demonstration}}};
  return insertIdempotent(connection, "evaluation_mark", columns, Text::tr("this mark"));
}

}  // namespace

void EvaluationRepository::addCampaign(const Campaign& campaign) {
  validateInstrument(campaign.instrument);
  Transaction transaction(connection_);
  const ScoreScale& scale = campaign.instrument.scale;
  connection_.execute(
      insertInto("evaluation_campaign",
                 "id, name, scale_lo_steps, scale_hi_steps, steps_per_point, created_utc_us, demonstration"),
      {campaign.id, campaign.name, scale.lo, scale.hi, scale.stepsPerPoint, campaign.createdUtc_us,
       campaign.demonstration});
  insertInstrument(connection_, campaign);
  insertParticipants(connection_, campaign);
  transaction.commit();
}

std::vector<std::pair<std::string, std::string>> EvaluationRepository::campaigns() const {
  return selectAll(connection_, "SELECT id, name FROM evaluation_campaign ORDER BY created_utc_us, name", {},
                   [](RowReader& row) {
                     return std::pair<std::string, std::string>{row.text(), row.text()};
                   });
}

std::optional<Campaign> EvaluationRepository::campaign(const CampaignId& campaignId) const {
  std::optional<Campaign> campaign = findCampaign(connection_, campaignId);
  if (!campaign) {
    return std::nullopt;
  }
  campaign->instrument.classes = classesOf(connection_, campaignId);
  campaign->instrument.indices = indicesOf(connection_, campaignId);
  campaign->models = modelsOf(connection_, campaignId);
  campaign->raters = ratersOf(connection_, campaignId);
  return campaign;
}

void EvaluationRepository::submit(const CampaignId& campaignId, std::span<const EvaluationMark> marks) {
  if (marks.empty()) {
    return;
  }
  Transaction transaction(connection_);
  const ScoreScale scale = scaleOf(connection_, campaignId);
  std::vector<NewAuditEntry> entries;
  for (const EvaluationMark& mark : marks) {
    if (!isOnScale(mark.score_steps, scale)) {
      refuse(Text::tr("mark of %1 steps is outside %2 .. %3", mark.score_steps, scale.lo, scale.hi),
             Text::tr("rater %1, model %2, index %3", mark.raterId, mark.modelCode, mark.indexNumber),
             Text::tr("Correct the mark"));
    }
    if (insertMark(connection_, campaignId, mark) == Inserted::kNew) {
      entries.push_back(
          {.atUtc_us = mark.submittedUtc_us,
           .actor = mark.raterId,
           .station = station_,
           .action = mark.version == 1 ? AuditAction::kEvaluationSubmit : AuditAction::kEvaluationAmend,
           .objectKind = AuditObject::kEvaluationMark,
           .objectId = mark.id,
           .reason = mark.amendReason});
    }
  }
  AuditRepository(connection_).append(entries);
  transaction.commit();
}

bool EvaluationRepository::hasMarks(const CampaignId& campaignId) const {
  return selectFirst(connection_, "SELECT id FROM evaluation_mark WHERE campaign_id = ? LIMIT 1",
                     {campaignId}, readText)
      .has_value();
}

std::vector<EvaluationMark> EvaluationRepository::marks(const CampaignId& campaignId) const {
  return selectAll(
      connection_,
      "SELECT m.id, m.rater_id, m.model_code, m.index_number, m.version, m.score_steps, m.amend_reason,"
      " m.submitted_utc_us, m.demonstration, p.code, r.class_code FROM evaluation_mark m"
      " JOIN evaluation_rater r ON r.campaign_id = m.campaign_id AND r.rater_id = m.rater_id"
      " JOIN evaluation_class c ON c.campaign_id = r.campaign_id AND c.class_code = r.class_code"
      " JOIN evaluation_model o ON o.campaign_id = m.campaign_id AND o.model_code = m.model_code"
      " JOIN person p ON p.id = m.rater_id"
      " WHERE m.campaign_id = ? AND NOT EXISTS (SELECT 1 FROM evaluation_mark n"
      "  WHERE n.campaign_id = m.campaign_id AND n.rater_id = m.rater_id AND n.model_code = m.model_code"
      "  AND n.index_number = m.index_number AND n.version > m.version)"
      " ORDER BY o.position, c.position, p.code, m.index_number",
      {campaignId}, [](RowReader& row) {
        return EvaluationMark{.id = row.text(),
                              .raterId = row.text(),
                              .modelCode = row.text(),
                              .indexNumber = row.int64(),
                              .version = row.int64(),
                              .score_steps = row.int64(),
                              .amendReason = row.text(),
                              .submittedUtc_us = row.int64(),
                              .demonstration = row.boolean(),
                              .raterCode = row.text(),
                              .classCode = row.text()};
      });
}

void EvaluationRepository::storeRun(const CampaignId& campaignId, const EvaluationRunRows& run) {
  Transaction transaction(connection_);
  insertRun(connection_, RunOwner::kCampaign, campaignId, run.run);
  Statement result = connection_.prepare(insertInto(
      "evaluation_result",
      "run_id, model_code, index_number, weighted_mean, variance, rater_count, missing_count,"
      " lowest, highest, plain_mean, population_variance, sample_variance, standard_error, flags"));
  for (const EvaluationResultRow& row : run.results) {
    result.execute({run.run.id, row.modelCode, row.indexNumber, row.weightedMean, row.variance,
                    row.raterCount, row.missingCount, row.lowest, row.highest, row.plainMean,
                    row.populationVariance, row.sampleVariance, row.standardError, joinFlags(row.flags)});
  }
  Statement composite = connection_.prepare(
      insertInto("composite_result", "run_id, model_code, composite, standard_error, flags"));
  for (const CompositeRow& row : run.composites) {
    composite.execute({run.run.id, row.modelCode, row.composite, row.standardError, joinFlags(row.flags)});
  }
  transaction.commit();
}

}  // namespace torsio
