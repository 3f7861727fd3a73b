// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial_repository.h"

#include <algorithm>
#include <utility>

#include "db/repository/audit_repository.h"
#include "db/repository/seals.h"
#include "sim/base/clock.h"
#include "sim/base/contracts.h"
#include "sim/base/error.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

constexpr const char* kInsertTrial =
    "INSERT INTO trial (id, trainee_id, enrolment_id, station, scene_id, pattern_id, organ_hash, "
    "parameter_hash,"
    " parameters_json, device_model, device_max_force_n, device_continuous_force_n,"
    " device_max_stiffness_n_per_m, workspace_min_x_m, workspace_min_y_m, workspace_min_z_m, "
    "workspace_max_x_m,"
    " workspace_max_y_m, workspace_max_z_m, software_version, phase_label, drive, target_angle_rad, "
    "force_scale,"
    " tick_period_us, started_utc_us, demonstration)"
    " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";
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
    " t.demonstration, e.sample_count, e.refused_samples, e.late_ticks, e.outcome, e.content_hash"
    " FROM trial t LEFT JOIN person p ON p.id = t.trainee_id LEFT JOIN trial_end e ON e.trial_id = t.id";

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
                         .summary = std::nullopt};
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
  connection.execute(
      "INSERT INTO trial_chunk (trial_id, chunk_index, first_tick, sample_count, digest, output_digest,"
      " stored_utc_us, bytes) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
      {trialId, chunk.index, chunk.firstTick, chunk.samples, chunk.digest, chunk.outputDigest, utcNow_us(),
       chunk.bytes});
}

Value traineeId(Connection& connection, const std::string& code) {
  if (code.empty()) return {};
  Statement row = connection.prepare(
      "SELECT t.person_id FROM trainee t JOIN person p ON p.id = t.person_id WHERE p.code = ?");
  row.execute({code});
  if (row.step()) return row.text(0);
  throw Error(ErrorCode::kBadData, "no trainee has the code " + code, "trial", "Enter the trainee first");
}

}  // namespace

void TrialRepository::begin(const TrialHeader& header) {
  TORSIO_EXPECTS(current_.empty() && !header.trialId.empty());
  const DeviceLimits& limits = header.deviceLimits;
  connection_.execute(kInsertTrial, {header.trialId,
                                     traineeId(connection_, header.traineeCode),
                                     textOrNull(context_.enrolmentId),
                                     context_.station,
                                     header.sceneId,
                                     header.patternId,
                                     header.organHash,
                                     header.parameterHash,
                                     header.parametersJson,
                                     header.deviceModel,
                                     limits.maxForce_N,
                                     limits.continuousForce_N,
                                     limits.maxStiffness_N_per_m,
                                     limits.workspaceMin_m.x,
                                     limits.workspaceMin_m.y,
                                     limits.workspaceMin_m.z,
                                     limits.workspaceMax_m.x,
                                     limits.workspaceMax_m.y,
                                     limits.workspaceMax_m.z,
                                     header.softwareVersion,
                                     header.phaseLabel,
                                     static_cast<std::int64_t>(header.drive),
                                     header.targetAngle_rad,
                                     header.forceScale,
                                     header.tickPeriod_us,
                                     header.startedUtc_us,
                                     header.demonstration});
  current_ = header.trialId;
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
  begin(trial.header);
  current_.clear();  // whatever happens now, nothing is being recorded
  for (const TrialChunk& chunk : trial.chunks) insertChunk(connection_, trial.header.trialId, chunk);
  end(trial.header.trialId, context_.station, trial.summary);
  transaction.commit();
}

void TrialRepository::end(const std::string& trialId, const std::string& station,
                          const TrialSummary& summary) {
  Transaction transaction(connection_);
  const std::int64_t now_us = utcNow_us();
  connection_.execute(
      "INSERT INTO trial_end (trial_id, sample_count, refused_samples, late_ticks, outcome, content_hash,"
      " ended_utc_us) VALUES (?, ?, ?, ?, ?, ?, ?)",
      {trialId, summary.samples, summary.refusedSamples, summary.lateTicks,
       summary.outcome == TrialOutcome::kCompleted ? kCompleted : kInterrupted, summary.contentHash, now_us});
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

struct OwnConnectionTrialSink::Open {
  Open(const std::string& locator, const TrialContext& context)
      : connection(openDatabase(locator, OpenMode::kReadWrite)), repository(connection, context) {}
  Connection connection;
  TrialRepository repository;
};

OwnConnectionTrialSink::OwnConnectionTrialSink(std::string locator, TrialContext context)
    : locator_(std::move(locator)), context_(std::move(context)) {}

OwnConnectionTrialSink::~OwnConnectionTrialSink() = default;

void OwnConnectionTrialSink::begin(const TrialHeader& header) {
  if (!open_) open_ = std::make_unique<Open>(locator_, context_);
  open_->repository.begin(header);
}

void OwnConnectionTrialSink::append(const TrialChunk& chunk) {
  TORSIO_EXPECTS(open_ != nullptr);
  open_->repository.append(chunk);
}

void OwnConnectionTrialSink::finish(const TrialSummary& summary) {
  TORSIO_EXPECTS(open_ != nullptr);
  open_->repository.finish(summary);
  open_.reset();
}

}  // namespace torsio
