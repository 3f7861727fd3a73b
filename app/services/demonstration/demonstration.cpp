// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demonstration/demonstration.h"

#include <array>
#include <chrono>
#include <map>
#include <system_error>
#include <utility>

#include "app/services/base/build_info.h"
#include "app/services/demonstration/demonstration_curriculum.h"
#include "app/services/demonstration/demonstration_people.h"
#include "app/services/recording/competence.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/recording/trial_digests.h"
#include "app/services/scoring/cohort_inputs.h"
#include "app/services/scoring/scoring_service.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/results/cohort_report.h"
#include "db/connection/connection.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/system/demonstration_data.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr double kPhaseLength_min = 20.0;
constexpr std::int64_t kWeek_us = 7 * kDay_us;
constexpr double kUntwistingsFrom = 0.68;  // share of the total progress
constexpr double kUntwistingsShare = 0.2;

/// Phases on the simulator, by group; the other phases happen on a real arm and only have marks.
struct VirtualPhase {
  std::size_t group;
  const char* label;
  double practisedBefore_min;
};
constexpr std::array<VirtualPhase, 3> kVirtualPhases{
    {{0, "virtual 0-20 min", 0.0}, {0, "virtual 20-40 min", kPhaseLength_min}, {1, "virtual 0-20 min", 0.0}}};

/// Reports steps with their share of the work, and estimates the remaining time.
class ProgressMeter {
 public:
  explicit ProgressMeter(const ProgressCallback& callback) : callback_(callback) {}

  void show(const std::string& step, double fraction) {
    if (!callback_) {
      return;
    }
    const double elapsed_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    callback_({step, fraction, fraction > 0.05 ? elapsed_s * (1.0 - fraction) / fraction : -1.0});
  }

 private:
  const ProgressCallback& callback_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

/// State shared by the steps of one demonstration run.
class Demonstration {
 public:
  Demonstration(const DemonstrationOptions& options, Connection& connection)
      : options_(options),
        connection_(connection),
        ids_(options.seed),
        rules_(options.training.assets),
        meter_(options.progress) {}

  CohortInputs run() {
    meter_.show("Loading the organs", 0.0);
    const Scene training = loadScene(options_.training);
    const Scene example = loadScene(options_.example);
    meter_.show("Enrolling simulated trainees and raters", 0.03);
    study_ = storeDemonstrationPeople(connection_, ids_, options_.seed, options_.simulatedUtc_us);
    curriculum_ = storeDemonstrationCurriculum(connection_, study_, training, options_.training.assets,
                                               options_.seed, options_.simulatedUtc_us);
    recordAll(training, example);
    recordUntwistings();
    storeDemonstrationExposures(connection_, study_, curriculum_, options_.seed, options_.simulatedUtc_us);
    meter_.show("Submitting simulated marks", 0.88);
    submitDemonstrationMarks(connection_, study_, curriculum_, ids_, options_.seed, options_.simulatedUtc_us);
    meter_.show("Computing the evaluation", 0.92);
    return assess(training, example);
  }

  [[nodiscard]] DemonstrationSummary summary() const { return summary_; }

 private:
  void recordAll(const Scene& training, const Scene& example) {
    const double phase_s = kPhaseLength_min * 60.0 / static_cast<double>(options_.shortening);
    ScriptedTrial show;
    show.personSeed = options_.seed;
    show.trialSeed = options_.seed;
    show.duration_s = std::min(phase_s, 20.0);
    show.practisedBefore_min = 60.0;
    show.recording.phaseLabel = kExpertPhase;
    record(example, show, {}, 0.04);

    std::size_t total = 0;
    for (const VirtualPhase& phase : kVirtualPhases) {
      total += study_.people.groups.at(phase.group).size();
    }
    std::size_t done = 0;
    for (const DemonstrationTrainee& trainee : inOrderOfComing(study_.trainees)) {
      for (const VirtualPhase& phase : kVirtualPhases) {
        if (trainee.group != phase.group) {
          continue;
        }
        ScriptedTrial trial;
        trial.personSeed = options_.seed + 1000 * (trainee.group * 10 + trainee.number);
        trial.trialSeed = trial.personSeed + static_cast<std::uint64_t>(phase.practisedBefore_min);
        trial.duration_s = phase_s;
        trial.practisedBefore_min = phase.practisedBefore_min;
        trial.practiceScale = static_cast<double>(options_.shortening);
        trial.fewestTwists = options_.fewestTwists;
        trial.recording.phaseLabel = phase.label;
        const double fraction =
            0.05 + (kUntwistingsFrom - 0.05) * static_cast<double>(done++) / static_cast<double>(total);
        record(training, trial, &trainee, fraction);
      }
    }
  }

  /// Untwistings are recorded in full length, never shortened.
  void recordUntwistings() {
    std::map<std::string, Scene> scenes;
    const std::vector<DemonstrationUntwisting> all = storeDemonstrationUntwisting(
        connection_, study_, options_.training.assets, options_.seed, studyOver_us());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const DemonstrationUntwisting& one = all[i];
      meter_.show(
          "Recording " + one.trial.recording.traineeCode + ", " + one.trial.recording.phaseLabel,
          kUntwistingsFrom + kUntwistingsShare * static_cast<double>(i) / static_cast<double>(all.size()));
      auto scene = scenes.find(one.sceneId);
      if (scene == scenes.end()) {
        SceneRequest request;
        request.assets = options_.training.assets;
        request.id = one.sceneId;
        request.pattern = one.patternId;
        scene = scenes.emplace(one.sceneId, loadScene(request)).first;
      }
      store(scene->second, one.trial, true);
    }
  }

  void record(const Scene& scene, ScriptedTrial trial, const DemonstrationTrainee* trainee, double fraction) {
    RecordingSpec& recording = trial.recording;
    meter_.show("Recording " + (trainee != nullptr ? trainee->code + ", " : "the ") + recording.phaseLabel,
                fraction);
    recording.trialId = ids_.newUuid();
    recording.traineeCode = trainee != nullptr ? trainee->code : "";
    recording.startedUtc_us = options_.simulatedUtc_us;
    recording.demonstration = true;
    TrialContext& context = recording.context;
    context.station = "demonstration";
    if (trainee != nullptr) {
      const DemonstrationPlace place =
          demonstrationPlace(curriculum_, *trainee, recording.phaseLabel, options_.simulatedUtc_us);
      recording.startedUtc_us = place.startedUtc_us;
      context.enrolmentId = trainee->enrolmentId;
      context.moduleId = place.moduleId;
      context.phaseId = place.phaseId;
      context.attemptMode = AttemptMode::kPractice;
    }
    store(scene, trial, trainee != nullptr);
    if (trainee != nullptr && summary_.firstTrialId.empty()) {
      summary_.firstTrialId = recording.trialId;
    }
  }

  /// Records, measures and counts; if `keep`, stores the measures of a trainee's recording.
  void store(const Scene& scene, const ScriptedTrial& trial, bool keep) {
    const RecordingSpec& recording = trial.recording;
    TrialRepository repository(connection_, recording.context);
    recordScriptedTrial(scene, trial, repository);
    const Trial stored = repository.load(recording.trialId);
    const AttemptRules rules = rules_.of(connection_, scene.id, scene.pattern.id, recording.context.moduleId);
    const AttemptMeasures measures = measureRecording(stored, rules);
    summary_.samples += stored.summary.samples;
    summary_.recorded_min += static_cast<double>(measures.duration_us) / 60e6;
    ++summary_.trials;
    if (keep) {
      summary_.twists += std::ssize(measures.twists);
      keepDigest(connection_, stored, measures, rules, options_.simulatedUtc_us);
    }
  }

  /// Returns the end of the study's working week.
  [[nodiscard]] std::int64_t studyOver_us() const { return options_.simulatedUtc_us + kWeek_us; }

  CohortInputs assess(const Scene& training, const Scene& example) {
    const ScoringStamp stamp{studyOver_us(), true};
    const CampaignResult campaign = evaluateCampaign(connection_, study_.campaignId, ids_, stamp);
    const TrainingResult marks = scoreTraining(connection_, study_.cohortId, ids_, stamp);
    CohortInputs inputs = cohortInputs(connection_, study_.cohortId, campaign, marks);
    inputs.title = Text::tr("Twist training: cohort report");
    inputs.createdUtc_us = options_.createdUtc_us;
    inputs.demonstration = true;
    inputs.trainingTimeDivisor = options_.shortening;
    inputs.simulated = {
        Text::tr(
            "The trainees' movements come from a scripted hand with a seed; the simulator, the recorder and "
            "every computation are the real ones."),
        demonstrationTimeRule(), demonstrationTrainingRule(), demonstrationEvaluationRule(),
        demonstrationUntwistingRule()};
    inputs.facts = {
        {Text::tr("Organ of the training"),
         Text::tr("%1 (%2)", Text(training.title), Text(training.provenance))},
        {Text::tr("Second organ"), Text::tr("%1 (%2)", Text(example.title), Text(example.provenance))},
        {Text::tr("Seed"), std::to_string(options_.seed)},
        {Text::tr("Simulated date"),
         Text::tr("%1, the same in every run", Text::verbatim("2026-01-05 08:00 UTC"))}};
    inputs.trials =
        TrialDigests(options_.training.assets).read(connection_, study_.cohortId, options_.simulatedUtc_us);
    inputs.competence =
        competenceOfCohort(connection_, curriculum_.id, inputs.trainees, rules_, options_.simulatedUtc_us);
    for (const Scene* scene : {&training, &example}) {
      inputs.provenance.emplace_back(Text::tr("organ %1", scene->id), scene->organHash);
      inputs.provenance.emplace_back(Text::tr("model parameters %1", scene->id), scene->parameterHash);
      for (const OrganWarning& warning : scene->organWarnings) {
        inputs.provenance.emplace_back(Text::tr("Warning about the organ of a recording"), coded(warning));
      }
    }
    return inputs;
  }

  const DemonstrationOptions& options_;
  Connection& connection_;
  SeededIdSource ids_;
  ExerciseRules rules_;
  ProgressMeter meter_;
  DemonstrationStudy study_;
  CurriculumVersion curriculum_;
  DemonstrationSummary summary_;
};

/// Throws if the demonstration would replace a record that contains real data.
void requireOnlySimulated(const fs::path& record) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(record, ignored))) {
    return;
  }
  Text why = Text::tr("is a record with real people or data");
  try {
    Connection connection = openRecord(record.string(), OpenMode::kReadOnly);
    if (holdsOnlySimulated(connection)) {
      return;
    }
  } catch (const Error& error) {
    why = Text::tr("may be a record with real people: %1", error.happenedText());
  }
  throw Error(ErrorCode::kFileUnwritable, why, record.string(),
              Text::tr("Choose a separate folder for the demonstration; this file was not changed"));
}

/// Replaces an older demonstration that nobody has open by the finished one.
void replaceDemonstration(const fs::path& finished, const fs::path& record) {
  requireOnlySimulated(record);
  std::error_code failed;
  if (fs::exists(record, failed)) {
    checkpointSqlite(record);
  }
  checkpointSqlite(finished);
  fs::rename(finished, record, failed);
  if (failed) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("cannot be written"), record.string(),
                Text::tr("Close other programs that use it"));
  }
}

void requireShortening(const DemonstrationOptions& options) {
  if (options.shortening >= 1 && options.shortening <= 600) {
    return;
  }
  refuseParameter(Text::tr("the shortening must lie between 1 and 600"), std::to_string(options.shortening),
                  Text::tr("Give 60 for twenty seconds a phase"));
}

}  // namespace

DemonstrationSummary fillDemonstration(const DemonstrationOptions& options, Connection& connection) {
  requireShortening(options);
  Transaction transaction(connection);
  Demonstration demonstration(options, connection);
  static_cast<void>(demonstration.run());
  transaction.commit();
  return demonstration.summary();
}

DemonstrationSummary runDemonstration(const DemonstrationOptions& options) {
  requireShortening(options);
  ensureFolder(options.out);
  DemonstrationSummary summary;
  const fs::path record = options.out / "torsio.sqlite";
  requireOnlySimulated(record);
  sweepUnfinished(options.out);
  const FileInTheMaking database(record);
  {
    MigrationOptions migration;
    migration.softwareVersion = softwareVersion();
    migration.now_us = options.simulatedUtc_us;
    Connection connection = openRecord(database.path().string(), OpenMode::kCreate, migration);
    Demonstration demonstration(options, connection);
    const CohortInputs inputs = demonstration.run();
    summary = demonstration.summary();
    if (options.progress) {
      options.progress({Text::tr("Writing the report"), 0.95, -1.0});
    }
    summary.report = options.out / "cohort.pdf";
    summary.table = options.out / "cohort.csv";
    summary.database = record;
    options.writeReport(inputs, summary);
  }
  replaceDemonstration(database.path(), record);
  if (options.progress) {
    options.progress({Text::tr("Done"), 1.0, 0.0});
  }
  return summary;
}

}  // namespace torsio
