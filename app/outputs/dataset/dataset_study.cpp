// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/dataset/dataset_study.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/maintenance/signing_key.h"
#include "app/services/maintenance/station_anchor.h"
#include "app/services/scoring/scoring_service.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/results/shown_inputs.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/record/content_hash.h"
#include "sim/record/trial_file.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace {

using Study = nlohmann::ordered_json;

constexpr const char* kStudyFormat = "torsio study 1";

/// Finds parts of a curriculum by code, which is the same in every record.
class CurriculumPlaces {
 public:
  explicit CurriculumPlaces(const std::optional<CurriculumVersion>& version) {
    if (!version) {
      return;
    }
    for (const TrainingModule& module : version->modules) {
      modules_[module.id] = module.code;
    }
    for (const StudyArm& arm : version->arms) {
      for (std::size_t i = 0; i < arm.phases.size(); ++i) {
        phases_[arm.phases[i].id] = {{"arm", arm.code}, {"phase", i}};
      }
    }
  }
  void addModule(const ModuleId& id, Study& json) const {
    if (const auto found = modules_.find(id); found != modules_.end()) {
      json["module"] = found->second;
    }
  }
  void addPhase(const PhaseId& id, Study& json) const {
    if (const auto found = phases_.find(id); found != phases_.end()) {
      json.update(found->second);
    }
  }

 private:
  std::map<ModuleId, std::string> modules_;
  std::map<PhaseId, Study> phases_;
};

/// Returns the people of a cohort, and their codes by enrolment.
Study peopleJson(Connection& connection, const std::vector<Enrolment>& enrolments,
                 std::map<EnrolmentId, std::string>& codeOf) {
  PeopleRepository people(connection);
  Study list = Study::array();
  for (const Enrolment& enrolment : enrolments) {
    codeOf[enrolment.id] = enrolment.traineeCode;
    Study one{{"code", enrolment.traineeCode}, {"group", enrolment.groupCode}};
    if (const auto trainee = people.findTrainee(enrolment.traineeCode)) {
      one["sex"] = trainee->person.sex;
      one["level"] = trainee->person.level;
    }
    one["state"] = storedText(enrolment.state);
    list.push_back(std::move(one));
  }
  return list;
}

Study marksJson(Connection& connection, const ExchangeData& data, const Occasions& occasions, Study& raters) {
  std::vector<Text> left;
  const CohortInputs shown = shownInputs(data.inputs, left);
  Study marks = Study::array();
  std::set<std::string> seen;
  if (shown.trainingMarks.size() != data.inputs.trainingMarks.size()) {
    refuse(Text::tr("not every mark may be shown yet"), data.inputs.title,
           Text::tr("Wait until every sheet is in, or freeze the data"));
  }
  for (const TrainingMark& mark : shown.trainingMarks) {
    seen.insert(mark.rater);
    marks.push_back({{"trainee", mark.trainee},
                     {"rater", mark.rater},
                     {"occasion", occasions.at(mark.occasion).code},
                     {"steps", mark.steps}});
  }
  PeopleRepository people(connection);
  for (const std::string& code : seen) {
    const auto rater = people.findRater(code);
    raters.push_back({{"code", code}, {"class", rater ? rater->classCode : std::string()}});
  }
  return marks;
}

/// Adds training times and deviations.
void addTimesJson(StudyRepository& study, const CohortId& cohortId, const CurriculumPlaces& places,
                  std::map<EnrolmentId, std::string>& codeOf, Study& json) {
  json["exposures"] = Study::array();
  for (const Exposure& exposure : study.exposures(cohortId)) {
    Study one{{"trainee", codeOf[exposure.enrolmentId]},
              {"kind", storedText(exposure.kind)},
              {"started_utc_us", exposure.startedUtc_us},
              {"duration_us", exposure.duration_us}};
    places.addPhase(exposure.phaseId, one);
    json["exposures"].push_back(std::move(one));
  }
  json["deviations"] = Study::array();
  for (const ProtocolDeviation& deviation : study.deviations(cohortId)) {
    Study one{{"kind", deviation.kind},
              {"description", deviation.description},
              {"happened_utc_us", deviation.happenedUtc_us}};
    if (!deviation.enrolmentId.empty()) {
      one["trainee"] = codeOf[deviation.enrolmentId];
    }
    json["deviations"].push_back(std::move(one));
  }
}

/// Where the cohort was imported from, oldest first.
Study originJson(const StudyRepository& study, const CohortId& cohortId) {
  Study steps = Study::array();
  for (const StudyImport& import : study.imports(cohortId)) {
    if (const Study earlier = Study::parse(import.earlierJson, nullptr, false); earlier.is_array()) {
      steps.insert(steps.end(), earlier.begin(), earlier.end());
    }
    steps.push_back({{"layout", import.layout},
                     {"source", import.source},
                     {"hash", import.contentHash},
                     {"signed_by", import.signedBy},
                     {"imported_utc_us", import.importedUtc_us}});
  }
  return steps;
}

std::string sealedText(const std::string& studyJson) {
  Digest digest;
  digest.update(studyJson);
  return "torsio-study 1 " + digest.hex();
}

/// Reads study.json part by part.
class StudyReader {
 public:
  explicit StudyReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  LandedStudy read() {
    const std::string text = jsonTextIn(folder_ / kDatasetStudyFile);
    const Study json = Study::parse(text);
    if (!json.is_object() || json.value("format", "") != kStudyFormat) {
      refuse(Text::tr("not a study of a data set of Torsio"), (folder_ / kDatasetStudyFile).string(),
             Text::tr("Export the data set anew, with --whole"));
    }
    try {
      readCohort(json);
      readPeople(json);
      readRest(json);
      readOrigin(json, text);
    } catch (const nlohmann::json::exception&) {
      refuse(Text::tr("the study of the data set is damaged"), (folder_ / kDatasetStudyFile).string(),
             Text::tr("Export the data set anew, with --whole"));
    }
    for (LandedTrial& landed : study_.trials) {
      verifyContent(landed.trial);
    }
    return std::move(study_);
  }

 private:
  void readOrigin(const Study& json, const std::string& text) {
    if (json.contains("origin") && json.at("origin").is_array()) {
      study_.origin.earlierJson = json.at("origin").dump();
    }
    if (json.contains("statements")) {
      for (const auto& [item, statement] : json.at("statements").items()) {
        if (const auto known = fromStoredText<StudyItem>(item)) {
          study_.statements[*known] = statement.get<std::string>();
        }
      }
    }
    const std::filesystem::path file = folder_ / kDatasetSealFile;
    if (!std::filesystem::exists(file)) {
      return;
    }
    const Study seal = Study::parse(jsonTextIn(file));
    const std::string key = seal.is_object() ? seal.value("public_key", "") : std::string();
    const std::string signature = seal.is_object() ? seal.value("signature", "") : std::string();
    if (!isPublicKey(key) || !isSignature(signature) || !genuine(sealedText(text), signature, key)) {
      refuse(Text::tr("the study was changed after it was signed"), file.string(),
             Text::tr("Export the data set anew, with --whole"));
    }
    study_.origin.signedBy = key;
  }

  static std::string textIn(const Study& json, const char* key) { return json.at(key).get<std::string>(); }

  /// Each record names its file.
  template <typename Enum>
  [[nodiscard]] Enum termIn(const Study& json, const char* key) const {
    const auto found = fromStoredText<Enum>(textIn(json, key));
    if (!found) {
      refuse(Text::tr("'%1' is unknown here", textIn(json, key)), (folder_ / kDatasetStudyFile).string(),
             Text::tr("Export the data set anew, with --whole"));
    }
    return *found;
  }

  void readCohort(const Study& json) {
    const Study& cohort = json.at("cohort");
    study_.cohort.name = textIn(cohort, "name");
    study_.cohort.description = textIn(cohort, "description");
    study_.cohort.demonstration = cohort.value("simulated", false);
    if (cohort.contains("equivalence_margin")) {
      study_.cohort.equivalenceMargin = cohort.at("equivalence_margin").get<double>();
    }
    for (const Study& group : json.at("groups")) {
      study_.cohort.groups.push_back({textIn(group, "code"), textIn(group, "label")});
    }
    if (json.contains("curriculum")) {
      study_.curriculum = {textIn(json.at("curriculum"), "name"),
                           textIn(json.at("curriculum"), "description"),
                           jsonTextIn(folder_ / "curriculum.json")};
    }
    const Study& scale = json.at("scale");
    study_.scale = {scale.at("lowest").get<std::int64_t>(), scale.at("highest").get<std::int64_t>(),
                    scale.at("steps_per_point").get<std::int64_t>()};
    validateScale(study_.scale);
    for (const Study& occasion : json.at("occasions")) {
      study_.occasions.push_back(textIn(occasion, "label"));
      labelOf_[textIn(occasion, "code")] = study_.occasions.back();
    }
  }

  void readPeople(const Study& json) {
    for (const Study& one : json.at("trainees")) {
      const std::string code = textIn(one, "code");
      study_.people.push_back({.name = code,
                               .code = code,
                               .group = textIn(one, "group"),
                               .sex = textIn(one, "sex"),
                               .level = textIn(one, "level"),
                               .state = termIn<EnrolmentState>(one, "state")});
      known_.insert(code);
    }
    for (const Study& one : json.at("raters")) {
      study_.raters.push_back({textIn(one, "code"), textIn(one, "code"), textIn(one, "class")});
      knownRaters_.insert(textIn(one, "code"));
    }
  }

  [[nodiscard]] std::string knownIn(const Study& json, const char* key,
                                    const std::set<std::string>& known) const {
    std::string code = textIn(json, key);
    if (!known.contains(code)) {
      refuse(Text::tr("the study has nobody with the code %1", code), (folder_ / kDatasetStudyFile).string(),
             Text::tr("Export the data set anew, with --whole"));
    }
    return code;
  }

  static LandedPlace placeIn(const Study& json) {
    return {json.value("module", ""), json.value("arm", ""), json.value("phase", std::size_t{0})};
  }

  /// A recording that the study names, in the folder of the data set: no name leads out of it.
  [[nodiscard]] std::filesystem::path fileIn(const Study& json) const {
    std::error_code broken;  // a name too long, a circle of links
    const std::filesystem::path folder = std::filesystem::weakly_canonical(folder_, broken);
    const std::filesystem::path file =
        std::filesystem::weakly_canonical(folder / textIn(json, "file"), broken);
    if (broken ||
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first != folder.end()) {
      refuse(Text::tr("the study names a file outside its data set"), textIn(json, "file"),
             Text::tr("Export the data set anew, with --whole"));
    }
    return file;
  }

  void readRest(const Study& json) {
    for (const Study& one : json.at("marks")) {
      study_.marks.push_back({.person = knownIn(one, "trainee", known_),
                              .rater = knownIn(one, "rater", knownRaters_),
                              .occasion = labelOf_.at(textIn(one, "occasion")),
                              .steps = one.at("steps").get<std::int64_t>()});
    }
    for (const Study& one : json.at("exposures")) {
      study_.exposures.push_back({knownIn(one, "trainee", known_), termIn<ExposureKind>(one, "kind"),
                                  one.at("started_utc_us").get<std::int64_t>(),
                                  one.at("duration_us").get<std::int64_t>(), placeIn(one)});
    }
    for (const Study& one : json.at("deviations")) {
      study_.deviations.push_back({one.contains("trainee") ? knownIn(one, "trainee", known_) : std::string(),
                                   textIn(one, "kind"), textIn(one, "description"),
                                   one.at("happened_utc_us").get<std::int64_t>()});
    }
    for (const Study& one : json.at("recordings")) {
      LandedTrial landed;
      landed.trial = readTrialFile(fileIn(one));
      if (one.value("content_hash", landed.trial.summary.contentHash) != landed.trial.summary.contentHash) {
        refuse(Text::tr("the study lists another recording under this name"), textIn(one, "file"),
               Text::tr("Export the data set anew, with --whole"));
      }
      landed.person = knownIn(one, "trainee", known_);
      landed.place = placeIn(one);
      if (one.contains("mode")) {
        landed.mode = termIn<AttemptMode>(one, "mode");
      }
      study_.trials.push_back(std::move(landed));
    }
  }

  std::filesystem::path folder_;
  LandedStudy study_;
  std::map<std::string, std::string> labelOf_;  // occasion labels by code
  std::set<std::string> known_;                 // codes of trainees
  std::set<std::string> knownRaters_;
};

}  // namespace

std::string datasetStudyJson(Connection& connection, const ExchangeData& data) {
  TORSIO_EXPECTS(!data.pseudonyms);
  StudyRepository study(connection);
  const CohortId& cohortId = data.request.cohortId;
  const Cohort cohort = study.cohort(cohortId);
  const auto version = CurriculumRepository(connection).version(cohort.curriculumVersionId);
  const CurriculumPlaces places(version);
  Study json{{"format", kStudyFormat},
             {"cohort",
              {{"name", cohort.name},
               {"description", cohort.description},
               {"simulated", data.inputs.demonstration}}}};
  if (cohort.equivalenceMargin) {
    json["cohort"]["equivalence_margin"] = *cohort.equivalenceMargin;
  }
  if (Study origin = originJson(study, cohortId); !origin.empty()) {
    json["origin"] = std::move(origin);
  }
  for (const auto& [item, statement] : data.inputs.statements) {
    json["statements"][std::string(storedText(item))] = statement;
  }
  if (version) {
    for (const Curriculum& curriculum : CurriculumRepository(connection).curricula()) {
      if (curriculum.id == version->curriculumId) {
        json["curriculum"] = {{"name", curriculum.name}, {"description", curriculum.description}};
      }
    }
  }
  json["groups"] = Study::array();
  for (const StudyGroup& group : study.groups(cohortId)) {
    json["groups"].push_back({{"code", group.code}, {"label", group.label}});
  }
  std::map<EnrolmentId, std::string> codeOf;
  json["trainees"] = peopleJson(connection, study.enrolments(cohortId), codeOf);
  const Occasions occasions = occasionsOfCohort(connection, cohortId);
  json["occasions"] = Study::array();
  for (const Occasion& occasion : occasions) {
    json["occasions"].push_back({{"code", occasion.code}, {"label", occasion.label}});
  }
  const ScoreScale& scale = data.inputs.trainingScale;
  json["scale"] = {{"lowest", scale.lo}, {"highest", scale.hi}, {"steps_per_point", scale.stepsPerPoint}};
  Study raters = Study::array();
  Study marks = marksJson(connection, data, occasions, raters);
  json["raters"] = std::move(raters);
  json["marks"] = std::move(marks);
  addTimesJson(study, cohortId, places, codeOf, json);
  json["recordings"] = Study::array();
  for (const TrialSummaryRow& trial : data.inputs.trials) {
    const auto context = TrialRepository(connection).context(trial.trialId);
    Study one{{"file", "recordings/" + trial.trialId.text() + ".torsio"},
              {"trainee", trial.trainee},
              {"content_hash", trial.contentHash}};
    places.addModule(context.value().moduleId, one);
    places.addPhase(context->phaseId, one);
    if (context->attemptMode) {
      one["mode"] = storedText(*context->attemptMode);
    }
    json["recordings"].push_back(std::move(one));
  }
  return json.dump(2) + "\n";
}

std::string datasetSeal(const std::string& studyJson) {
  const std::optional<StationSignature> signature = signedByStation(sealedText(studyJson));
  return signature
             ? Study{{"public_key", signature->publicKey}, {"signature", signature->signature}}.dump(2) + "\n"
             : std::string();
}

LandedStudy readDatasetStudy(const std::filesystem::path& folder) {
  return StudyReader(folder).read();
}

}  // namespace torsio
