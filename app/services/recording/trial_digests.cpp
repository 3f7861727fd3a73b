// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/trial_digests.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <future>
#include <map>
#include <string_view>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "app/services/recording/competence.h"
#include "app/services/recording/kept_digests.h"
#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/contracts.h"
#include "sim/record/trial.h"

namespace torsio {

namespace {

/// A stored recording and the rules for judging it.
struct RecordingToMeasure {
  Trial trial{};
  AttemptRules rules{};
};

/// Decodes and measures recordings on all cores while the owning thread reads the next ones. The results and
/// their order are the same as on one core. The destructor waits for work in progress.
class MeasuringAhead {
 public:
  /// `now_us`: computation time written into the digests.
  explicit MeasuringAhead(std::int64_t now_us) : now_us_(now_us) {}

  /// Returns whether this many more samples may be given now; otherwise take some results first, so that
  /// memory stays bounded. Always true if nothing is in progress.
  [[nodiscard]] bool hasRoomFor(std::int64_t samples) const;
  /// Starts measuring a batch, one recording after the other.
  void give(std::vector<RecordingToMeasure> recordings);
  [[nodiscard]] bool empty() const { return underWay_.empty(); }
  /// Waits for the oldest batch. Throws Error if a recording cannot be read.
  [[nodiscard]] std::vector<TrialDigest> take();

 private:
  struct Batch {
    std::future<std::vector<TrialDigest>> digests{};
    std::int64_t samples = 0;
  };

  std::int64_t now_us_;
  std::deque<Batch> underWay_;
  std::int64_t samples_ = 0;  ///< of all batches in progress
};

constexpr std::int64_t kMaxSamples = 1'500'000;  // decoded; about a hundred bytes each

std::vector<TrialDigest> measuredInTurn(const std::vector<RecordingToMeasure>& recordings,
                                        std::int64_t now_us) {
  std::vector<TrialDigest> digests;
  for (const auto& [trial, rules] : recordings) {
    digests.push_back(keptDigest(trial, measureRecording(trial, rules), rules, now_us));
  }
  return digests;
}

bool MeasuringAhead::hasRoomFor(std::int64_t samples) const {
  return underWay_.empty() || (underWay_.size() < std::max(1U, std::thread::hardware_concurrency()) &&
                               samples_ + samples <= kMaxSamples);
}

void MeasuringAhead::give(std::vector<RecordingToMeasure> recordings) {
  Batch batch;
  for (const RecordingToMeasure& recording : recordings) {
    batch.samples += recording.trial.summary.samples;
  }
  samples_ += batch.samples;
  batch.digests = std::async(std::launch::async, [recordings = std::move(recordings), now_us = now_us_] {
    return measuredInTurn(recordings, now_us);
  });
  underWay_.push_back(std::move(batch));
}

std::vector<TrialDigest> MeasuringAhead::take() {
  TORSIO_EXPECTS(!underWay_.empty());
  Batch batch = std::move(underWay_.front());
  underWay_.pop_front();
  samples_ -= batch.samples;
  return batch.digests.get();
}

constexpr std::int64_t kEveryTrial = 10'000'000;
constexpr std::int64_t kKeepEvery_samples = 2'500'000;  // forty minutes of recordings
constexpr std::int64_t kBatch_samples = 100'000;

/// Position of an enrolment in the study.
struct Place {
  std::size_t group = 0;
  std::int64_t number = 0;  ///< in the group
};

std::map<std::string, Place> placesOf(StudyRepository& study, const CohortId& cohortId) {
  const std::vector<StudyGroup> groups = study.groups(cohortId);
  std::map<std::string, Place> out;
  for (const Enrolment& enrolment : study.enrolments(cohortId)) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const StudyGroup& g) { return g.code == enrolment.groupCode; });
    if (group != groups.end()) {
      out[enrolment.id] = {static_cast<std::size_t>(group - groups.begin()), enrolment.numberInGroup};
    }
  }
  return out;
}

/// Returns the positions of the phases of a cohort's protocol.
std::map<std::string, std::size_t> phasePositions(Connection& connection, const CohortId& cohortId) {
  std::map<std::string, std::size_t> out;
  const CurriculumVersionId versionId = StudyRepository(connection).cohort(cohortId).curriculumVersionId;
  const auto version = CurriculumRepository(connection).version(versionId);
  if (!version) {
    return out;
  }
  for (const StudyArm& arm : version->arms) {
    for (std::size_t i = 0; i < arm.phases.size(); ++i) {
      out[arm.phases[i].id] = i + 1;
    }
  }
  return out;
}

/// Returns the enrolments' finished trials in the order of recording. Imported recordings may have equal
/// start times: then the protocol determines the order, never a random id.
std::vector<TrialListing> finishedTrials(Connection& connection, const CohortId& cohortId,
                                         const std::map<std::string, Place>& places) {
  TrialFilter filter;
  filter.limit = kEveryTrial;
  std::vector<TrialListing> listed = TrialRepository(connection).list(filter);
  std::erase_if(listed, [&](const TrialListing& trial) {
    return !trial.summary || trial.summary->contentHash.empty() || !places.contains(trial.enrolmentId);
  });
  const std::map<std::string, std::size_t> phases = phasePositions(connection, cohortId);
  using Sequence = std::tuple<std::int64_t, std::size_t, std::size_t, std::int64_t, std::string_view>;
  std::vector<std::pair<Sequence, std::size_t>> order;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const TrialListing& trial = listed[i];
    const auto phase = phases.find(trial.phaseId);
    const Place& place = places.at(trial.enrolmentId);
    order.emplace_back(Sequence(trial.startedUtc_us, phase == phases.end() ? 0 : phase->second, place.group,
                                place.number, trial.trialId.text()),
                       i);
  }
  std::sort(order.begin(), order.end());
  std::vector<TrialListing> sorted;
  for (const auto& [sequence, i] : order) {
    sorted.push_back(std::move(listed[i]));
  }
  return sorted;
}

using Kept = std::map<std::string, std::vector<TrialDigest>>;

/// Returns the digests of a cohort's trials with the current formulas, by trial.
Kept keptOf(Connection& connection, const CohortId& cohortId) {
  Kept kept;
  for (auto& [trialId, digest] : DigestRepository(connection).ofCohort(cohortId, kMetricsVersion)) {
    kept[trialId].push_back(std::move(digest));
  }
  return kept;
}

/// New digests, stored in batches: killing the program loses only seconds of work.
class Fresh {
 public:
  explicit Fresh(Connection& connection) : connection_(connection) {}
  Fresh(const Fresh&) = delete;
  Fresh& operator=(const Fresh&) = delete;

  void add(TrialDigest digest, std::int64_t samples) {
    waiting_.push_back(std::move(digest));
    waiting_samples_ += samples;
    if (waiting_samples_ >= kKeepEvery_samples) {
      keep();
    }
  }
  void keep() {
    if (!waiting_.empty() && !connection_.readOnly()) {
      DigestRepository(connection_).add(waiting_);
    }
    waiting_.clear();
    waiting_samples_ = 0;
  }

 private:
  Connection& connection_;
  std::vector<TrialDigest> waiting_;
  std::int64_t waiting_samples_ = 0;
};

/// A recording without a stored digest.
struct Unmeasured {
  std::size_t place = 0;  ///< index in the list
  AttemptRules rules{};
};

/// Returns the end of the next batch for one core: about a second of work, or one longer recording.
std::size_t endOfBatch(const std::vector<TrialListing>& listed, const std::vector<Unmeasured>& unmeasured,
                       std::size_t from) {
  std::int64_t samples = 0;
  std::size_t end = from;
  for (; end < unmeasured.size() && end - from < TrialLoader::kAtOnce; ++end) {
    samples += listed[unmeasured[end].place].summary->samples;
    if (end > from && samples > kBatch_samples) {
      break;
    }
  }
  return end;
}

/// Reads and measures recordings, stores their digests and fills in their rows.
void measure(Connection& connection, const std::vector<TrialListing>& listed,
             const std::vector<Unmeasured>& unmeasured, std::int64_t now_us, const ProgressCallback& progress,
             std::vector<TrialSummaryRow>& rows) {
  TrialLoader loader(connection);
  Fresh fresh(connection);
  MeasuringAhead ahead(now_us);
  std::size_t done = 0;
  const auto take = [&] {
    for (TrialDigest& digest : ahead.take()) {
      const auto& [place, rules] = unmeasured[done++];
      rows[place] = summaryRow(listed[place], digest, rules);
      fresh.add(std::move(digest), listed[place].summary->samples);
    }
  };
  const auto give = [&](std::size_t from) {
    const std::size_t end = endOfBatch(listed, unmeasured, from);
    if (progress) {
      const std::size_t place = unmeasured[from].place;
      progress({Text::tr("Reading recording %1 of %2", place + 1, listed.size()),
                static_cast<double>(place) / static_cast<double>(listed.size()), -1.0});
    }
    std::vector<TrialId> ids;
    std::int64_t samples = 0;
    for (std::size_t i = from; i < end; ++i) {
      ids.push_back(listed[unmeasured[i].place].trialId);
      samples += listed[unmeasured[i].place].summary->samples;
    }
    while (!ahead.hasRoomFor(samples)) {
      take();
    }
    std::vector<RecordingToMeasure> batch;
    for (Trial& trial : loader.load(ids)) {
      batch.push_back({std::move(trial), unmeasured[from + batch.size()].rules});
    }
    ahead.give(std::move(batch));
    return end;
  };
  try {
    for (std::size_t from = 0; from < unmeasured.size();) {
      from = give(from);
    }
    while (!ahead.empty()) {
      take();
    }
  } catch (...) {
    fresh.keep();  // cancelled, or an unreadable recording: the others need not be measured again
    throw;
  }
  fresh.keep();
}

}  // namespace

std::vector<TrialSummaryRow> TrialDigests::ofCohort(SessionContext& session, const CohortId& cohortId,
                                                    const ProgressCallback& progress) {
  session.require(Operation::kResultsCompute);
  return read(session.connection(), cohortId, session.now_us(), progress);
}

std::vector<TrialSummaryRow> TrialDigests::read(Connection& connection, const CohortId& cohortId,
                                                std::int64_t now_us, const ProgressCallback& progress) {
  StudyRepository study(connection);
  const std::map<std::string, Place> places = placesOf(study, cohortId);
  const std::vector<TrialListing> listed = finishedTrials(connection, cohortId, places);
  Kept kept = keptOf(connection, cohortId);
  std::vector<TrialSummaryRow> out(listed.size());
  std::vector<Unmeasured> unmeasured;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const TrialListing& listing = listed[i];
    const AttemptRules rules = rules_.of(connection, listing.sceneId, listing.patternId, listing.moduleId);
    if (const TrialDigest* known = findDigest(kept[listing.trialId], listing.summary->contentHash, rules)) {
      out[i] = summaryRow(listing, *known, rules);
    } else {
      unmeasured.push_back({i, rules});
    }
  }
  measured_ += unmeasured.size();
  measure(connection, listed, unmeasured, now_us, progress, out);
  for (std::size_t i = 0; i < listed.size(); ++i) {
    out[i].group = places.at(listed[i].enrolmentId).group;
  }
  return out;
}

std::vector<CohortCompetence> TrialDigests::competenceOf(SessionContext& session,
                                                         const CurriculumVersionId& versionId,
                                                         const std::vector<CohortTrainee>& trainees) {
  session.require(Operation::kResultsCompute);
  return readCompetence(session.connection(), versionId, trainees, session.now_us());
}

std::vector<CohortCompetence> TrialDigests::readCompetence(Connection& connection,
                                                           const CurriculumVersionId& versionId,
                                                           const std::vector<CohortTrainee>& trainees,
                                                           std::int64_t now_us) {
  return competenceOfCohort(connection, versionId, trainees, rules_, now_us);
}

}  // namespace torsio
