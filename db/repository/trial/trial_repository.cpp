// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/trial_repository.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/insert_idempotent.h"
#include "db/repository/base/learning_events.h"
#include "db/repository/base/stored_term.h"
#include "db/repository/trial/servo_health_columns.h"
#include "sim/core/clock.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

using Kind = IdempotentColumn::Kind;

constexpr const char* kCompleted = "completed";
constexpr const char* kInterrupted = "interrupted";

const std::string kSelectHeader =
    "SELECT t.id, COALESCE(p.site_code, p.code), t.scene_id, t.pattern_id, t.organ_hash, t.parameter_hash, "
    "t.parameters_json,"
    " t.device_model, t.device_max_force_n, t.device_continuous_force_n, t.device_max_stiffness_n_per_m,"
    " t.workspace_min_x_m, t.workspace_min_y_m, t.workspace_min_z_m,"
    " t.workspace_max_x_m, t.workspace_max_y_m, t.workspace_max_z_m,"
    " t.software_version, t.phase_label, t.drive, t.target_angle_rad, t.force_scale, t.tick_period_us,"
    " t.started_utc_us, t.demonstration, t.tissue_model"
    " FROM trial t LEFT JOIN person p ON p.id = t.trainee_id";

/// Foreign recordings have no model.
TissueModel modelOf(const std::string& stored) {
  return stored.empty() ? TissueModel::kTwist : tissueModelOf(stored);
}

DeviceLimits deviceLimitsOf(RowReader& row) {
  return {.maxForce_N = row.real(),
          .continuousForce_N = row.real(),
          .maxStiffness_N_per_m = row.real(),
          .workspaceMin_m = {row.real(), row.real(), row.real()},
          .workspaceMax_m = {row.real(), row.real(), row.real()}};
}

TrialHeader headerOf(RowReader& row) {
  return {.trialId = row.text(),
          .traineeCode = row.text(),
          .sceneId = row.text(),
          .patternId = row.text(),
          .organHash = row.text(),
          .parameterHash = row.text(),
          .parametersJson = row.text(),
          .deviceModel = row.text(),
          .deviceLimits = deviceLimitsOf(row),
          .softwareVersion = row.text(),
          .phaseLabel = row.text(),
          .drive = static_cast<TwistDrive>(row.int64()),
          .targetAngle_rad = row.real(),
          .forceScale = row.real(),
          .tickPeriod_us = row.int64(),
          .startedUtc_us = row.int64(),
          .demonstration = row.boolean(),
          .model = modelOf(row.text())};
}

/// Columns of the closing row `e` of a trial, in the order of summaryOf().
const std::string kSummaryColumns =
    "e.sample_count, e.refused_samples, e.late_ticks, e.outcome, e.content_hash, " + servoHealthColumns("e");
constexpr int kSummaryColumnCount = 5 + kServoHealthColumns;

TrialSummary summaryOf(RowReader& row) {
  return {.samples = row.int64(),
          .refusedSamples = row.int64(),
          .lateTicks = row.int64(),
          .outcome = row.text() == kCompleted ? TrialOutcome::kCompleted : TrialOutcome::kInterrupted,
          .contentHash = row.text(),
          .health = servoHealthOf(row)};
}

/// Empty for a trial without a closing row.
std::optional<TrialSummary> maybeSummaryOf(RowReader& row) {
  if (row.nextIsNull()) {
    row.skip(kSummaryColumnCount);
    return std::nullopt;
  }
  return summaryOf(row);
}

const std::string kSelectListing =
    "SELECT t.id, p.code, t.enrolment_id, t.station, t.scene_id, t.pattern_id, t.phase_label,"
    " t.started_utc_us, t.demonstration, " +
    kSummaryColumns +
    ", t.module_id, t.phase_id, t.attempt_mode, t.tissue_model, t.device_model"
    " FROM trial t LEFT JOIN person p ON p.id = t.trainee_id LEFT JOIN trial_end e ON e.trial_id = t.id";

TrialListing listingOf(RowReader& row) {
  return {.trialId = row.text(),
          .traineeCode = row.text(),
          .enrolmentId = row.text(),
          .station = row.text(),
          .sceneId = row.text(),
          .patternId = row.text(),
          .phaseLabel = row.text(),
          .startedUtc_us = row.int64(),
          .demonstration = row.boolean(),
          .summary = maybeSummaryOf(row),
          .moduleId = row.text(),
          .phaseId = row.text(),
          .attemptMode = readMaybeTerm<AttemptMode>(row),
          .model = modelOf(row.text()),
          .deviceModel = row.text()};
}

TrialChunk chunkOf(RowReader& row) {
  return {.index = row.int64(),
          .firstTick = row.int64(),
          .samples = row.int64(),
          .bytes = row.blob(),
          .digest = row.text(),
          .outputDigest = row.text()};
}

void insertChunk(Connection& connection, const TrialId& trialId, const TrialChunk& chunk) {
  const std::array<IdempotentColumn, 8> columns{{{"trial_id", trialId, Kind::kKey},
                                                 {"chunk_index", chunk.index, Kind::kKey},
                                                 {"first_tick", chunk.firstTick},
                                                 {"sample_count", chunk.samples},
                                                 {"digest", chunk.digest},
                                                 {"output_digest", chunk.outputDigest},
                                                 {"stored_utc_us", utcNow_us(), Kind::kIgnored},
                                                 {"bytes", chunk.bytes}}};
  insertIdempotent(connection, "trial_chunk", columns,
                   "second " + std::to_string(chunk.index + 1) + " of trial " + trialId);
}

std::vector<IdempotentColumn> headerColumns(const TrialHeader& header, Value trainee) {
  const DeviceLimits& limits = header.deviceLimits;
  return {{"id", header.trialId, Kind::kKey},
          {"trainee_id", std::move(trainee)},
          {"scene_id", header.sceneId},
          {"pattern_id", header.patternId},
          {"organ_hash", header.organHash},
          {"parameter_hash", header.parameterHash},
          {"parameters_json", header.parametersJson},
          {"device_model", header.deviceModel},
          {"device_max_force_n", limits.maxForce_N},
          {"device_continuous_force_n", limits.continuousForce_N},
          {"device_max_stiffness_n_per_m", limits.maxStiffness_N_per_m},
          {"workspace_min_x_m", limits.workspaceMin_m.x},
          {"workspace_min_y_m", limits.workspaceMin_m.y},
          {"workspace_min_z_m", limits.workspaceMin_m.z},
          {"workspace_max_x_m", limits.workspaceMax_m.x},
          {"workspace_max_y_m", limits.workspaceMax_m.y},
          {"workspace_max_z_m", limits.workspaceMax_m.z},
          {"software_version", header.softwareVersion},
          {"phase_label", header.phaseLabel},
          {"drive", static_cast<std::int64_t>(header.drive)},
          {"target_angle_rad", header.targetAngle_rad},
          {"force_scale", header.forceScale},
          {"tick_period_us", header.tickPeriod_us},
          {"started_utc_us", header.startedUtc_us},
          {"demonstration", header.demonstration},
          {"tissue_model",
           isForeign(header.sceneId) ? Value() : Value(std::string(tissueModelId(header.model)))}};
}

std::vector<IdempotentColumn> contextColumns(const TrialContext& context, Kind kind) {
  return {{"station", context.station, kind},
          {"enrolment_id", textOrNull(context.enrolmentId), kind},
          {"module_id", textOrNull(context.moduleId), kind},
          {"phase_id", textOrNull(context.phaseId), kind},
          {"attempt_mode", termOrNull(context.attemptMode), kind},
          {"host_name", textOrNull(context.host.name), kind},
          {"host_os", textOrNull(context.host.os), kind},
          {"host_cpu", textOrNull(context.host.cpu), kind},
          {"host_gpu", textOrNull(context.host.gpu), kind},
          {"import_id", textOrNull(context.importId), kind}};
}

/// Returns " IN (?,?,?)".
std::string among(std::size_t values) {
  std::string list = " IN (?";
  for (std::size_t i = 1; i < values; ++i) {
    list += ",?";
  }
  return list + ")";
}

/// Takes a trial out of the map; throws Error (kBadData) if it is missing.
Trial taken(std::map<TrialId, Trial>& trials, const TrialId& trialId) {
  const auto found = trials.find(trialId);
  if (found == trials.end() || found->second.header.trialId != trialId) {
    refuse(Text::tr("no such run"), trialId, Text::tr("List the runs to find its id"));
  }
  return std::move(found->second);
}

Value traineeId(Connection& connection, const std::string& code) {
  if (code.empty()) {
    return {};
  }
  const std::optional<std::string> id = selectFirst(
      connection, "SELECT t.person_id FROM trainee t JOIN person p ON p.id = t.person_id WHERE p.code = ?",
      {code}, readText);
  if (id) {
    return *id;
  }
  refuse(Text::tr("no trainee has the code %1", code), Text::tr("run"), Text::tr("Enter the trainee first"));
}

}  // namespace

void TrialRepository::begin(const TrialHeader& header) {
  TORSIO_EXPECTS(current_.empty() && !header.trialId.empty());
  insertTrial(header, true);
  current_ = header.trialId;
}

void TrialRepository::insertTrial(const TrialHeader& header, bool sameContext) {
  std::vector<IdempotentColumn> columns = headerColumns(header, traineeId(connection_, header.traineeCode));
  const std::vector<IdempotentColumn> context =
      contextColumns(context_, sameContext ? Kind::kContent : Kind::kIgnored);
  columns.insert(columns.end(), context.begin(), context.end());
  Transaction transaction(connection_);
  insertIdempotent(connection_, "trial", columns, "trial " + header.trialId);
  noteLearningEvents(connection_, LearningEventKind::kLaunched, {&header.trialId.text(), 1});
  transaction.commit();
}

void TrialRepository::resume(const TrialId& trialId) {
  TORSIO_EXPECTS(current_.empty() && !trialId.empty());
  current_ = trialId;
}

void TrialRepository::append(const TrialChunk& chunk) {
  TORSIO_EXPECTS(!current_.empty());
  insertChunk(connection_, current_, chunk);
}

void TrialRepository::finish(const TrialSummary& summary) {
  TORSIO_EXPECTS(!current_.empty());
  end(current_, context_.station, summary);
  current_.clear();
}

void TrialRepository::import(const Trial& trial) {
  verifyContent(trial);
  Transaction transaction(connection_);
  insertTrial(trial.header, false);  // a file does not contain the context of its recording
  for (const TrialChunk& chunk : trial.chunks) {
    insertChunk(connection_, trial.header.trialId, chunk);
  }
  end(trial.header.trialId, context_.station, trial.summary);
  transaction.commit();
}

void TrialRepository::end(const TrialId& trialId, const std::string& station, const TrialSummary& summary) {
  Transaction transaction(connection_);
  const std::int64_t now_us = utcNow_us();
  const std::optional<ServoHealth>& health = summary.health;
  const std::array<IdempotentColumn, 11> columns{
      {{"trial_id", trialId, Kind::kKey},
       {"sample_count", summary.samples},
       {"refused_samples", summary.refusedSamples},
       {"late_ticks", summary.lateTicks},
       {"outcome", summary.outcome == TrialOutcome::kCompleted ? kCompleted : kInterrupted},
       {"content_hash", summary.contentHash},
       {"real_time_priority", health ? Value(health->priority) : Value()},
       {"memory_locked", health ? Value(health->memory) : Value()},
       {"skipped_ticks", health ? Value(health->skippedTicks) : Value()},
       {"force_cuts", health ? Value(health->forceCuts) : Value()},
       {"ended_utc_us", now_us, Kind::kIgnored}}};
  if (insertIdempotent(connection_, "trial_end", columns, "the end of trial " + trialId) ==
      Inserted::kThereAlready) {
    transaction.commit();  // the audit entry is part of the same transaction
    return;
  }
  NewAuditEntry entry{.atUtc_us = now_us,
                      .actor = "torsio",
                      .station = station,
                      .action = summary.outcome == TrialOutcome::kCompleted ? AuditAction::kTrialFinish
                                                                            : AuditAction::kTrialInterrupted,
                      .objectKind = AuditObject::kTrial,
                      .objectId = trialId};
  AuditRepository(connection_).append(entry);
  noteLearningEvents(connection_, LearningEventKind::kCompleted, {&trialId.text(), 1});
  transaction.commit();
}

std::vector<TrialListing> TrialRepository::list(const TrialFilter& filter) {
  std::string where;
  std::vector<Value> values;
  const auto restrict = [&](const char* column, const std::string& value) {
    if (value.empty()) {
      return;
    }
    where += (where.empty() ? " WHERE " : " AND ") + std::string(column) + " = ?";
    values.emplace_back(value);
  };
  restrict("p.code", filter.traineeCode);
  restrict("t.enrolment_id", filter.enrolmentId);
  restrict("t.scene_id", filter.sceneId);
  restrict("t.module_id", filter.moduleId);
  values.emplace_back(filter.limit);
  values.emplace_back(filter.offset);
  return selectAll(connection_,
                   kSelectListing + where + " ORDER BY t.started_utc_us DESC, t.id DESC LIMIT ? OFFSET ?",
                   values, listingOf);
}

std::optional<TrialHeader> TrialRepository::find(const TrialId& trialId) const {
  return selectFirst(connection_, kSelectHeader + " WHERE t.id = ?", {trialId}, headerOf);
}

std::map<TrialId, std::int64_t> TrialRepository::startsOf(const CohortId& cohortId) const {
  Statement rows = connection_.prepare(
      "SELECT t.id, t.started_utc_us FROM enrolment e JOIN trial t ON t.enrolment_id = e.id"
      " WHERE e.cohort_id = ?");
  rows.execute({cohortId});
  std::map<TrialId, std::int64_t> starts;
  while (rows.step()) {
    RowReader row(rows);
    TrialId id = row.text();
    starts.emplace(std::move(id), row.int64());
  }
  return starts;
}

std::optional<TrialListing> TrialRepository::listing(const TrialId& trialId) const {
  return selectFirst(connection_, kSelectListing + " WHERE t.id = ?", {trialId}, listingOf);
}

std::optional<TrialContext> TrialRepository::context(const TrialId& trialId) const {
  return selectFirst(
      connection_,
      "SELECT station, enrolment_id, module_id, phase_id, attempt_mode, host_name, host_os, host_cpu, "
      "host_gpu, import_id"
      " FROM trial WHERE id = ?",
      {trialId}, [](RowReader& row) {
        return TrialContext{
            .station = row.text(),
            .enrolmentId = row.text(),
            .moduleId = row.text(),
            .phaseId = row.text(),
            .attemptMode = readMaybeTerm<AttemptMode>(row),
            .host = {.name = row.text(), .os = row.text(), .cpu = row.text(), .gpu = row.text()},
            .importId = row.text()};
      });
}

Trial TrialRepository::load(const TrialId& trialId) const {
  return TrialLoader(connection_).load(trialId);
}

TrialLoader::Statements::Statements(Connection& connection, std::size_t trials)
    : headers(connection.prepare(kSelectHeader + " WHERE t.id" + among(trials))),
      chunks(connection.prepare("SELECT trial_id, chunk_index, first_tick, sample_count, bytes, digest,"
                                " output_digest FROM trial_chunk WHERE trial_id" +
                                among(trials) + " ORDER BY trial_id, chunk_index")),
      closings(connection.prepare("SELECT e.trial_id, " + kSummaryColumns +
                                  " FROM trial_end e WHERE e.trial_id" + among(trials))) {}

std::map<TrialId, Trial> TrialLoader::Statements::read(std::span<const Value> ids) {
  std::map<TrialId, Trial> trials;
  headers.execute(ids);
  for (TrialHeader& header : readRows(headers, headerOf)) {
    Trial& trial = trials[header.trialId];
    trial.header = std::move(header);
    trial.summary.outcome = TrialOutcome::kInterrupted;
  }
  chunks.execute(ids);
  for (auto& [id, chunk] : readRows(chunks, [](RowReader& row) {
         TrialId of = row.text();
         return std::pair(std::move(of), chunkOf(row));
       })) {
    Trial& trial = trials[id];
    trial.summary.samples += chunk.samples;
    trial.chunks.push_back(std::move(chunk));
  }
  closings.execute(ids);
  for (auto& [id, closing] : readRows(closings, [](RowReader& row) {
         TrialId of = row.text();
         return std::pair(std::move(of), summaryOf(row));
       })) {
    trials[id].summary = std::move(closing);
  }
  return trials;
}

TrialLoader::TrialLoader(Connection& connection) : connection_(connection), one_(connection, 1) {}

Trial TrialLoader::load(const TrialId& trialId) {
  const Value id(trialId);
  std::map<TrialId, Trial> found = one_.read({&id, 1});
  return taken(found, trialId);
}

std::vector<Trial> TrialLoader::load(std::span<const TrialId> trialIds) {
  TORSIO_EXPECTS(trialIds.size() <= kAtOnce);
  std::vector<Trial> trials;
  if (trialIds.empty()) {
    return trials;
  }
  if (!many_) {
    many_.emplace(connection_, kAtOnce);
  }
  std::vector<Value> ids(trialIds.begin(), trialIds.end());
  ids.resize(kAtOnce, Value(trialIds.back()));  // duplicates in the IN list find one row
  std::map<TrialId, Trial> found = many_->read(ids);
  for (const TrialId& trialId : trialIds) {
    trials.push_back(taken(found, trialId));
  }
  return trials;
}

std::vector<std::string> TrialRepository::warnedParameters(const CohortId& cohortId) const {
  return selectAll(connection_,
                   "SELECT DISTINCT t.parameters_json FROM enrolment e JOIN trial t ON t.enrolment_id = e.id"
                   " WHERE e.cohort_id = ? AND (t.parameters_json LIKE '%\"organ_warnings\"%' OR"
                   " t.parameters_json LIKE '%_confirmed\":true%') ORDER BY 1",
                   {cohortId}, [](RowReader& row) { return std::string(row.text()); });
}

std::vector<TrialListing> TrialRepository::unfinished(const std::string& station) const {
  return selectAll(
      connection_,
      kSelectListing + " WHERE e.trial_id IS NULL AND t.station = ? ORDER BY t.started_utc_us, t.id",
      {station}, listingOf);
}

std::vector<TrialListing> TrialRepository::closeInterrupted(const std::string& station,
                                                            std::int64_t quietSinceUtc_us) {
  std::vector<TrialListing> closed;
  Statement last = connection_.prepare("SELECT max(stored_utc_us) FROM trial_chunk WHERE trial_id = ?");
  for (TrialListing& listing : unfinished(station)) {
    last.execute({listing.trialId});
    std::int64_t lastSign_us = listing.startedUtc_us;
    for (const std::int64_t stored_us : readRows(last, readInt64)) {
      lastSign_us = std::max(lastSign_us, stored_us);
    }
    if (lastSign_us > quietSinceUtc_us) {
      continue;
    }
    Trial trial = load(listing.trialId);
    trial.summary.contentHash = contentHash(trial);
    end(listing.trialId, station, trial.summary);
    listing.summary = trial.summary;
    closed.push_back(std::move(listing));
  }
  return closed;
}

}  // namespace torsio
