// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "app/services/devices/device_readiness.h"
#include "app/services/recording/competence.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/training/debrief.h"
#include "app/services/training/trainee_record.h"
#include "assessment/attempt/foreign_measures.h"
#include "assessment/attempt/recorded_twists.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/remark.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr std::int64_t kTrialsToLookThrough = 1'000;

/// Finds a run that an instructor recorded on the same organ with the same parameters.
std::optional<Trial> storedExpert(TrialRepository& trials, const TrialHeader& header) {
  TrialFilter filter;
  filter.sceneId = header.sceneId;
  filter.limit = kTrialsToLookThrough;
  for (const TrialListing& listing : trials.list(filter)) {
    const bool fits = listing.phaseLabel == kExpertPhase && listing.traineeCode.empty() &&
                      listing.patternId == header.patternId && listing.summary;
    if (!fits) {
      continue;
    }
    const std::optional<TrialHeader> found = trials.find(listing.trialId);
    if (found && found->parameterHash == header.parameterHash) {
      return trials.load(listing.trialId);
    }
  }
  return std::nullopt;
}

/// The scene of a trial: the loaded one if it matches, otherwise from the assets. Throws Error if the organ
/// is no longer available (a user's own mesh).
class SceneOfTrial {
 public:
  SceneOfTrial(const TrialHeader& header, const std::filesystem::path& assets, const Scene* scene) {
    if (scene != nullptr && scene->parameterHash == header.parameterHash) {
      scene_ = scene;
      return;
    }
    SceneRequest request = sceneRequestFor(header.parametersJson);
    request.assets = assets;
    request.id = header.sceneId;
    scene_ = &loaded_.emplace(loadScene(request));
  }
  SceneOfTrial(const SceneOfTrial&) = delete;
  SceneOfTrial& operator=(const SceneOfTrial&) = delete;
  [[nodiscard]] const Scene& get() const noexcept { return *scene_; }

 private:
  std::optional<Scene> loaded_;
  const Scene* scene_ = nullptr;
};

/// Returns empty if the organ is no longer available; the debrief then has no expert run.
std::optional<Trial> expertFor(TrialRepository& trials, const TrialHeader& header,
                               const std::filesystem::path& assets, const Scene* scene) {
  if (std::optional<Trial> stored = storedExpert(trials, header)) {
    return stored;
  }
  try {
    return expertRun(SceneOfTrial(header, assets, scene).get(), header.targetAngle_rad);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Adds mishaps if the recorded organ is available.
void addMishapsIfKnown(const TrialHeader& header, std::span<const Sample> samples,
                       const std::filesystem::path& assets, const Scene* scene, DetorsionStory& story) {
  try {
    const SceneOfTrial found(header, assets, scene);
    if (found.get().organHash == header.organHash && found.get().parameterHash == header.parameterHash) {
      addMishaps(found.get(), header, samples, sampleTimes(header, samples).us, story);
    }
  } catch (const Error&) {
    story.mishapsKnown = false;
  }
}

/// Returns the latest older measures of the same recording and rules.
std::optional<EarlierMeasure> earlierMeasure(Connection& connection, const TrialListing& listing,
                                             const AttemptRules& rules, const QuantityValues& now) {
  const std::vector<TrialDigest> older =
      DigestRepository(connection).olderOfTrial(listing.trialId, kMetricsVersion);
  const TrialDigest* kept = findDigest(older, listing.summary.value().contentHash, rules);
  if (kept == nullptr) {
    return std::nullopt;
  }
  const QuantityValues& values = kept->measures.values;
  const EarlierMeasure earlier{.version = kept->formulaVersion,
                               .peakForce_N = valueIn(values, Quantity::kPeakForce),
                               .withinLimits = withinLimits(values, rules)};
  const bool same = earlier.peakForce_N == valueIn(now, Quantity::kPeakForce) &&
                    earlier.withinLimits == withinLimits(now, rules);
  return same ? std::nullopt : std::optional(earlier);
}

/// Adds the number of successive runs, up to this one, that satisfy each mastery rule.
void addStreaks(const TrainingModule& module, const TrialId& trialId, std::vector<Attempt> attempts,
                std::vector<TargetCheck>& checks) {
  const auto present = std::find_if(attempts.begin(), attempts.end(),
                                    [&](const Attempt& attempt) { return attempt.trialId == trialId; });
  if (present != attempts.end()) {
    attempts.erase(present + 1, attempts.end());
  }
  auto check = checks.end() - std::ssize(module.mastery);
  for (const RuleProgress& progress : ruleProgress(module, attempts)) {
    (check++)->streak = progress.streak;
  }
}

/// Of a tracker's recording: what it measured. Nothing was asked of it, and there is nothing to play back.
Debrief realArmDebrief(SessionContext& session, const TrialListing& listing, const Trial& trial) {
  const std::vector<Sample> samples = decodeTrial(trial);
  ExerciseRules rules;
  const AttemptMeasures measures =
      listing.summary ? digestOf(session.connection(), listing, rules, session.now_us()).measures
                      : foreignAttempt(trial.header, samples);
  Debrief out;
  out.trialId = listing.trialId;
  out.phaseLabel = trial.header.phaseLabel;
  out.startedUtc_us = trial.header.startedUtc_us;
  out.duration_s = static_cast<double>(measures.duration_us) * 1e-6;
  out.demonstration = trial.header.demonstration;
  RealArmStory& story = out.realArm.emplace();
  story.sentences = foreignSentences(measures.values);
  for (const Unseen& gap : unseenStretches(trial.header, samples)) {
    story.unseen.push_back({static_cast<double>(gap.from_us) * 1e-6, static_cast<double>(gap.to_us) * 1e-6});
  }
  return out;
}

}  // namespace

Debrief debrief(SessionContext& session, const TrialId& trialId, const std::filesystem::path& assets,
                const Scene* scene) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const TrialListing listing = ownTrial(session, record, trialId);
  TrialRepository trials(session.connection());
  const Trial trial = trials.load(trialId);
  if (isForeign(trial.header.sceneId)) {
    return realArmDebrief(session, listing, trial);
  }
  const TrainingModule* module = record.module(listing.moduleId);
  ExerciseRules exercises(assets);
  const AttemptRules rules = recordedRules(
      exercises.of(session.connection(), listing.sceneId, listing.patternId, listing.moduleId), trial.header);
  // Decode and measure once, for the debrief and for the stored digest.
  const std::vector<Sample> samples = decodeTrial(trial);
  const MeasuredTrial measured = measureTwists(trial.header, samples, rules);
  const AttemptMeasures measures = measureAttempt(measured);
  if (listing.summary) {
    keepDigest(session.connection(), trial, measures, rules, session.now_us());
  }
  // An untwisting is not compared with an expert.
  const std::optional<Trial> expert =
      measured.detorsion ? std::nullopt : expertFor(trials, trial.header, assets, scene);
  Debrief out = makeDebrief(trial.header, samples, measured, rules, expert ? &*expert : nullptr);
  out.recording = std::make_shared<const Trial>(trial);
  if (expert) {
    out.expertRecording = std::make_shared<const Trial>(*expert);
  }
  if (out.detorsion) {
    addMishapsIfKnown(trial.header, samples, assets, scene, *out.detorsion);
    // At a tear, too.
    out.missed = missedTargets(out.verdict, Timeline(trial.header, samples), *out.detorsion);
  }
  if (listing.summary) {
    out.earlier = earlierMeasure(session.connection(), listing, rules, measures.values);
  }
  out.moduleId = listing.moduleId;
  out.mode = listing.attemptMode;
  out.verdict = verdictOn(trial.summary, measures, rules);
  if (const std::optional<ServoHealth>& health = trial.summary.health) {
    out.servoTrouble = servoTrouble(*health, trial.summary.samples);
    out.servoRemedy = servoRemedy(*health);
  }
  if (module != nullptr) {
    out.moduleTitle = module->title;
    addStreaks(*module, trialId, attemptsOf(session, record.personId, module->id), out.verdict.checks);
    out.competence = competenceOf(session.connection(), record.code, *module, exercises, session.now_us());
  }
  for (const Remark& remark : RemarkRepository(session.connection()).remarks(trialId)) {
    if (remark.purpose != "bookmark" || remark.author != session.actor().userId) {
      continue;
    }
    out.bookmarks.push_back({remark.id, static_cast<double>(remark.time_us) * 1e-6, remark.text});
  }
  return out;
}

void addBookmark(SessionContext& session, const TrialId& trialId, double at_s, const std::string& text) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const TrialListing listing = ownTrial(session, record, trialId);
  Transaction transaction(session.connection());
  const RemarkId id = keepBookmark(session, listing, at_s, text);
  session.note(AuditAction::kTrialBookmark, AuditObject::kTrialRemark, id);
  transaction.commit();
}

}  // namespace torsio
