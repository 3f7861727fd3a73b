// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/trial_repository.h"

#include <algorithm>
#include <array>
#include <utility>

#include "db/repository/base/audit_repository.h"
#include "db/repository/base/insert_idempotent.h"
#include "db/repository/base/seals.h"
#include "sim/base/clock.h"
#include "sim/base/contracts.h"
#include "sim/base/error.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

constexpr const char* kSelectTrial =
    "SELECT t.id, p.code, t.scene_id, t.pattern_id, t.organ_hash, t.parameter_hash, t.parameters_json,"
    " t.device_model, t.device_max_force_n, t.device_continuous_force_n, t.device_max_stiffness_n_per_m,"
    " t.workspace_min_x_m, t.workspace_min_y_m, t.workspace_min_z_m, t.workspace_max_x_m, "
    "t.workspace_max_y_m,"
    " t.workspace_max_z_m, t.software_version, t.phase_label, t.drive, t.target_angle_rad, t.force_scale,"
    " t.tick_period_us, t.started_utc_us, t.demonstration"
    " FROM trial t LEFT JOIN person p ON p.id = t.trainee_id WHERE t.id = ?";
constexpr const char* kListing =
    "SELECT t.id, p.code, t.enrolment_id, t.station, t.scene_id, t.pattern_id, t.phase_label, "
    "t.started_utc_us,"
    " t.demonstration, e.sample_count, e.refused_samples, e.late_ticks, e.outcome, e.content_hash, "
    "t.module_id,"
    " t.phase_id, t.attempt_mode"
    " FROM trial t LEFT JOIN person p ON p.id = t.trainee_id LEFT JOIN trial_end e ON e.trial_id = t.id";

using Kind = IdempotentColumn::Kind;

constexpr const char* kCompleted = "completed";
constexpr const char* kInterrupted = "interrupted";

TrialSummary summaryOf(const Statement& row, int first) {
  return {
      .samples = row.int64(first),
      .refusedSamples = row.int64(first + 1),
      .lateTicks = row.int64(first + 2),
      .outcome = row.text(first + 3) == kCompleted ? TrialOutcome::kCompleted : TrialOutcome::kInterrupted,
      .contentHash = row.text(first + 4)};
}

std::vector<TrialListing> listingsOf(Statement& row) {
  constexpr int kSummaryColumn = 9;
  std::vector<TrialListing> listings;
  while (row.step()) {
    TrialListing listing{.trialId = row.text(0),
                         .traineeCode = row.text(1),
                         .enrolmentId = row.text(2),
                         .station = row.text(3),
                         .sceneId = row.text(4),
                         .patternId = row.text(5),
                         .phaseLabel = row.text(6),
                         .startedUtc_us = row.int64(7),
                         .demonstration = row.boolean(8),
                         .summary = std::nullopt,
                         .moduleId = row.text(kSummaryColumn + 5),
                         .phaseId = row.text(kSummaryColumn + 6),
                         .attemptMode = row.text(kSummaryColumn + 7)};
    if (!row.isNull(kSummaryColumn)) listing.summary = summaryOf(row, kSummaryColumn);
    listings.push_back(std::move(listing));
  }
  return listings;
}

DeviceLimits deviceLimitsOf(const Statement& row, int first) {
  return {.maxForce_N = row.real(first),
          .continuousForce_N = row.real(first + 1),
          .maxStiffness_N_per_m = row.real(first + 2),
          .workspaceMin_m = {row.real(first + 3), row.real(first + 4), row.real(first + 5)},
          .workspaceMax_m = {row.real(first + 6), row.real(first + 7), row.real(first + 8)}};
}

TrialHeader headerOf(const Statement& row) {
  return {.trialId = row.text(0),
          .traineeCode = row.text(1),
          .sceneId = row.text(2),
          .patternId = row.text(3),
          .organHash = row.text(4),
          .parameterHash = row.text(5),
          .parametersJson = row.text(6),
          .deviceModel = row.text(7),
          .deviceLimits = deviceLimitsOf(row, 8),
          .softwareVersion = row.text(17),
          .phaseLabel = row.text(18),
          .drive = static_cast<TwistDrive>(row.int64(19)),
          .targetAngle_rad = row.real(20),
          .forceScale = row.real(21),
          .tickPeriod_us = row.int64(22),
          .startedUtc_us = row.int64(23),
          .demonstration = row.boolean(24)};
}

void insertChunk(Connection& connection, const std::string& trialId, const TrialChunk& chunk) {
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
          {"demonstration", header.demonstration}};
}

std::vector<IdempotentColumn> contextColumns(const TrialContext& context, Kind kind) {
  return {{"station", context.station, kind},
          {"enrolment_id", textOrNull(context.enrolmentId), kind},
          {"module_id", textOrNull(context.moduleId), kind},
          {"phase_id", textOrNull(context.phaseId), kind},
          {"attempt_mode", textOrNull(context.attemptMode), kind},
          {"host_name", textOrNull(context.host.name), kind},
          {"host_os", textOrNull(context.host.os), kind},
          {"host_cpu", textOrNull(context.host.cpu), kind},
          {"host_gpu", textOrNull(context.host.gpu), kind}};
}

Value traineeId(Connection& connection, const std::string& code) {
  if (code.empty()) return {};
  Statement row = connection.prepare(
      "SELECT t.person_id FROM trainee t JOIN person p ON p.id = t.person_id WHERE p.code = ?");
  row.execute({code});
  if (row.step()) return row.text(0);
  throw Error(ErrorCode::kBadData, Text("no trainee has the code %1", code), "trial",
              "Enter the trainee first");
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
  insertIdempotent(connection_, "trial", columns, "trial " + header.trialId);
}

void TrialRepository::resume(const std::string& trialId) {
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
  insertTrial(trial.header, false);  // a file does not know for what it was recorded
  for (const TrialChunk& chunk : trial.chunks) insertChunk(connection_, trial.header.trialId, chunk);
  end(trial.header.trialId, context_.station, trial.summary);
  transaction.commit();
}

void TrialRepository::end(const std::string& trialId, const std::string& station,
                          const TrialSummary& summary) {
  Transaction transaction(connection_);
  const std::int64_t now_us = utcNow_us();
  const std::array<IdempotentColumn, 7> columns{
      {{"trial_id", trialId, Kind::kKey},
       {"sample_count", summary.samples},
       {"refused_samples", summary.refusedSamples},
       {"late_ticks", summary.lateTicks},
       {"outcome", summary.outcome == TrialOutcome::kCompleted ? kCompleted : kInterrupted},
       {"content_hash", summary.contentHash},
       {"ended_utc_us", now_us, Kind::kIgnored}}};
  if (insertIdempotent(connection_, "trial_end", columns, "the end of trial " + trialId) ==
      Inserted::kThereAlready) {
    transaction.commit();  // its entry in the audit trail came in the same transaction
    return;
  }
  AuditEntry seal;
  seal.atUtc_us = now_us;
  seal.actor = "torsio";
  seal.station = station;
  seal.action = summary.outcome == TrialOutcome::kCompleted ? "trial.finish" : "trial.interrupted";
  seal.objectKind = kSealedTrial;
  seal.objectId = trialId;
  seal.objectHash = trialHashes(connection_, std::span(&trialId, 1)).at(trialId);
  AuditRepository(connection_).append(seal);
  transaction.commit();
}

void TrialRepository::addEvents(const std::string& trialId, std::span<const StoredTrialEvent> events) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(
      "INSERT INTO trial_event (trial_id, sequence, tick, time_us, kind, label, value)"
      " VALUES (?, ?, ?, ?, ?, ?, ?)");
  for (const StoredTrialEvent& event : events) {
    insert.execute(
        {trialId, event.sequence, event.tick, event.time_us, event.kind, event.label, event.value});
  }
  transaction.commit();
}

std::vector<StoredTrialEvent> TrialRepository::events(const std::string& trialId) {
  std::vector<StoredTrialEvent> events;
  Statement row = connection_.prepare(
      "SELECT sequence, tick, time_us, kind, label, value FROM trial_event WHERE trial_id = ? ORDER BY "
      "sequence");
  row.execute({trialId});
  while (row.step()) {
    events.push_back({row.int64(0), row.int64(1), row.int64(2), row.text(3), row.text(4), row.maybeReal(5)});
  }
  return events;
}

std::vector<TrialListing> TrialRepository::list(const TrialFilter& filter) {
  std::string where;
  std::vector<Value> values;
  const auto restrict = [&](const char* column, const std::string& value) {
    if (value.empty()) return;
    where += (where.empty() ? " WHERE " : " AND ") + std::string(column) + " = ?";
    values.emplace_back(value);
  };
  restrict("p.code", filter.traineeCode);
  restrict("t.enrolment_id", filter.enrolmentId);
  restrict("t.scene_id", filter.sceneId);
  restrict("t.module_id", filter.moduleId);
  values.emplace_back(filter.limit);
  values.emplace_back(filter.offset);
  Statement row =
      connection_.prepare(kListing + where + " ORDER BY t.started_utc_us DESC, t.id DESC LIMIT ? OFFSET ?");
  row.execute(values);
  return listingsOf(row);
}

std::optional<TrialHeader> TrialRepository::find(const std::string& trialId) {
  Statement row = connection_.prepare(kSelectTrial);
  row.execute({trialId});
  if (!row.step()) return std::nullopt;
  return headerOf(row);
}

std::optional<TrialContext> TrialRepository::context(const std::string& trialId) {
  Statement row = connection_.prepare(
      "SELECT station, enrolment_id, module_id, phase_id, attempt_mode, host_name, host_os, host_cpu, "
      "host_gpu"
      " FROM trial WHERE id = ?");
  row.execute({trialId});
  if (!row.step()) return std::nullopt;
  return TrialContext{
      .station = row.text(0),
      .enrolmentId = row.text(1),
      .moduleId = row.text(2),
      .phaseId = row.text(3),
      .attemptMode = row.text(4),
      .host = {.name = row.text(5), .os = row.text(6), .cpu = row.text(7), .gpu = row.text(8)}};
}

Trial TrialRepository::load(const std::string& trialId) {
  const std::optional<TrialHeader> header = find(trialId);
  if (!header) {
    throw Error(ErrorCode::kBadData, "no such trial", trialId, "List the trials to find its id");
  }
  Trial trial{.header = *header, .chunks = {}, .summary = {}};
  Statement chunk = connection_.prepare(
      "SELECT chunk_index, first_tick, sample_count, bytes, digest, output_digest FROM trial_chunk"
      " WHERE trial_id = ? ORDER BY chunk_index");
  chunk.execute({trialId});
  while (chunk.step()) {
    trial.chunks.push_back(
        {chunk.int64(0), chunk.int64(1), chunk.int64(2), chunk.blob(3), chunk.text(4), chunk.text(5)});
    trial.summary.samples += trial.chunks.back().samples;
  }
  trial.summary.outcome = TrialOutcome::kInterrupted;
  Statement closing = connection_.prepare(
      "SELECT sample_count, refused_samples, late_ticks, outcome, content_hash FROM trial_end"
      " WHERE trial_id = ?");
  closing.execute({trialId});
  if (closing.step()) trial.summary = summaryOf(closing, 0);
  return trial;
}

std::vector<TrialListing> TrialRepository::unfinished(const std::string& station) {
  Statement row = connection_.prepare(
      std::string(kListing) + " WHERE e.trial_id IS NULL AND t.station = ? ORDER BY t.started_utc_us, t.id");
  row.execute({station});
  return listingsOf(row);
}

std::vector<TrialListing> TrialRepository::closeInterrupted(const std::string& station,
                                                            std::int64_t quietSinceUtc_us) {
  std::vector<TrialListing> closed;
  Statement last = connection_.prepare("SELECT max(stored_utc_us) FROM trial_chunk WHERE trial_id = ?");
  for (TrialListing& listing : unfinished(station)) {
    last.execute({listing.trialId});
    std::int64_t lastSign_us = listing.startedUtc_us;
    while (last.step()) lastSign_us = std::max(lastSign_us, last.int64(0));
    if (lastSign_us > quietSinceUtc_us) continue;
    Trial trial = load(listing.trialId);
    trial.summary.contentHash = contentHash(trial);
    end(listing.trialId, station, trial.summary);
    listing.summary = trial.summary;
    closed.push_back(std::move(listing));
  }
  return closed;
}

}  // namespace torsio
