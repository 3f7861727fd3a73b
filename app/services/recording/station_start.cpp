// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/station_start.h"

#include <set>
#include <string>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/station_name.h"
#include "app/services/base/assets.h"
#include "app/services/recording/kept_digests.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

// Tolerance between a run's clock and its recording.
constexpr std::int64_t kAgreesWithin_us = 500'000;

/// Logs training time proved by a recording but not logged, because station or database failed before;
/// returns that time.
std::int64_t logMissing_us(SessionContext& session, const TrialListing& trial) {
  // Time on the real arm is logged by its own clock; a tracker's samples are not ticks.
  if (trial.enrolmentId.empty() || isForeign(trial.sceneId)) {
    return 0;
  }
  StudyRepository studies(session.connectionWithoutRight());
  std::int64_t logged_us = 0;
  for (const Exposure& exposure : studies.exposuresOf(trial.enrolmentId)) {
    const bool same = exposure.phaseId == trial.phaseId && exposure.kind == ExposureKind::kVirtual &&
                      exposure.startedUtc_us >= trial.startedUtc_us - kAgreesWithin_us;
    if (same) {
      logged_us += exposure.duration_us;
    }
  }
  const std::int64_t missing_us = trial.summary->samples * kTickPeriod_us - logged_us;
  if (missing_us < kAgreesWithin_us) {
    return 0;
  }
  const Exposure found{.id = session.ids().newUuid(),
                       .enrolmentId = trial.enrolmentId,
                       .phaseId = trial.phaseId,
                       .kind = ExposureKind::kVirtual,
                       .startedUtc_us = trial.startedUtc_us + logged_us,
                       .duration_us = missing_us,
                       .recordedBy = session.actor().userId.empty() ? "torsio" : session.actor().userId,
                       .demonstration = trial.demonstration};
  studies.addExposures({&found, 1});
  return missing_us;
}

SettledTrial settled(SessionContext& session, TrialListing trial, bool fromFile) {
  const std::int64_t added_us = logMissing_us(session, trial);
  const nlohmann::json what{{"exposure_us", added_us}};
  session.note(fromFile ? AuditAction::kTrialImport : AuditAction::kTrialCloseInterrupted,
               AuditObject::kTrial, trial.trialId, what);
  return {std::move(trial), fromFile, added_us};
}

/// Returns the database's version: what was stored when the recording began counts.
TrialListing listingOf(TrialRepository& trials, const Trial& trial) {
  const TrialContext context = trials.context(trial.header.trialId).value_or(TrialContext{});
  return {.trialId = trial.header.trialId,
          .traineeCode = trial.header.traineeCode,
          .enrolmentId = context.enrolmentId,
          .station = context.station,
          .sceneId = trial.header.sceneId,
          .patternId = trial.header.patternId,
          .phaseLabel = trial.header.phaseLabel,
          .startedUtc_us = trial.header.startedUtc_us,
          .demonstration = trial.header.demonstration,
          .summary = trial.summary,
          .moduleId = context.moduleId,
          .phaseId = context.phaseId,
          .attemptMode = context.attemptMode};
}

/// Measures a recording that has just ended and stores its digest; free practice belongs to nobody and is not
/// measured.
void measureNow(SessionContext& session, const TrialListing& trial) {
  if (trial.enrolmentId.empty()) {
    return;
  }
  ExerciseRules rules;
  static_cast<void>(digestOf(session.connectionWithoutRight(), trial, rules, session.now_us()));
}

SettledTrial store(SessionContext& session, const UnstoredTrial& waiting) {
  Transaction transaction(session.connectionWithoutRight());
  TrialRepository trials(session.connectionWithoutRight(), waiting.context);
  trials.import(waiting.trial);
  TrialListing listing = listingOf(trials, waiting.trial);
  measureNow(session, listing);
  SettledTrial stored = settled(session, std::move(listing), true);
  transaction.commit();
  std::error_code ignored;  // stored again at the next start, which is harmless
  std::filesystem::remove(waiting.file, ignored);
  return stored;
}

void importFiles(SessionContext& session, const std::filesystem::path& folder, StationStart& start) {
  UnstoredTrials found = unstoredTrials(session.key().locator, folder);
  start.kept = std::move(found.unreadable);
  for (const UnstoredTrial& waiting : found.trials) {
    try {
      start.trials.push_back(store(session, waiting));
    } catch (const Error& refusal) {
      const auto* database = dynamic_cast<const DbError*>(&refusal);
      if (database != nullptr && database->retryable()) {
        throw;
      }
      start.kept.push_back(Text::tr("A saved recording was not stored, because %1. Its file is kept: %2",
                                    refusal.happenedText(), waiting.file.string()));
    }
  }
}

}  // namespace

StationStart settleStation(SessionContext& session, const std::filesystem::path& folder) {
  StationStart start;
  importFiles(session, folder, start);
  Transaction transaction(session.connectionWithoutRight());
  TrialRepository trials(session.connectionWithoutRight());
  std::set<std::string> names{session.station()};
  if (const StationSign sign = stationSign(); sign.made && sign.name == session.station()) {
    names.insert(sign.computer);  // before the station had a name of its own
  }
  for (const std::string& name : names) {
    for (TrialListing& trial : trials.closeInterrupted(name, session.now_us() - kQuietTrial_us)) {
      measureNow(session, trial);
      start.trials.push_back(settled(session, std::move(trial), false));
    }
  }
  transaction.commit();
  return start;
}

}  // namespace torsio
