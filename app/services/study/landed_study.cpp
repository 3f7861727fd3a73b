// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/landed_study.h"

#include <algorithm>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/base/identifiers.h"
#include "app/services/people/people_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_content.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/study_statements.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

/// Stores the parts one after another and keeps the mapping to the record's ids.
class Landing {
 public:
  Landing(SessionContext& session, LandedStudy& study)
      : session_(session), study_(study), people_(session.connection()), codes_({}) {
    const std::vector<std::string> used = people_.codes();
    used_ = {used.begin(), used.end()};
    codes_ = PersonCodes(used_);
  }

  LandedOutcome land(const ProgressCallback& progress) {
    addOccasions();
    addCurriculumVersion();
    outcome_.cohortId = addCohort(session_, study_.cohort);
    setStudyStatements(session_, outcome_.cohortId, study_.statements);
    addOrigin();
    addPeople();
    addRaters();
    enrol();
    addTimes();
    for (std::size_t i = 0; i < study_.trials.size(); ++i) {
      tellProgress(progress, Text::tr("Storing recording %1 of %2", i + 1, study_.trials.size()),
                   static_cast<double>(i) / static_cast<double>(study_.trials.size()));
      addTrial(study_.trials[i]);
    }
    addMarks();
    return std::move(outcome_);
  }

 private:
  std::string codeFor(const std::string& wanted, const char* prefix) {
    if (wanted.empty()) {
      return codes_.next(prefix);
    }
    if (!used_.insert(wanted).second) {
      refuse(Text::tr("this code is already in use in the record"), wanted,
             Text::tr("Import into an empty record"));
    }
    return wanted;
  }

  Person newPerson(const std::string& name, const std::string& wanted, const char* prefix) {
    Person person;
    person.id = session_.ids().newUuid();
    person.code = codeFor(wanted, prefix);
    person.createdUtc_us = session_.now_us();
    person.demonstration = study_.cohort.demonstration;
    outcome_.codes[name] = person.code;
    idOf_[name] = person.id;
    return person;
  }

  void notePerson(const Person& person, const std::string& part) {
    session_.note(AuditAction::kPersonAdd, AuditObject::kPerson, person.id,
                  {{"code", person.code}, {"part", part}});
  }

  void addOrigin() {
    StudyImport& origin = study_.origin;
    origin.id = session_.ids().newUuid();
    origin.cohortId = outcome_.cohortId;
    origin.importedBy = session_.actor().userId;
    origin.importedUtc_us = session_.now_us();
    StudyRepository(session_.connection()).addImport(origin);
  }

  void addPeople() {
    for (const LandedPerson& one : study_.people) {
      Person person = newPerson(one.name, one.code, kTraineePrefix);
      person.sex = one.sex;
      person.level = one.level;
      people_.addTrainees(std::vector<Trainee>{{person, {}}});
      notePerson(person, "trainee");
    }
  }

  void addRaters() {
    if (study_.raters.empty()) {
      return;
    }
    const std::vector<SeniorityClass> classes = ensureRaterClasses(session_);
    for (const LandedRater& one : study_.raters) {
      const bool known = std::any_of(classes.begin(), classes.end(), [&](const SeniorityClass& other) {
        return other.code == one.classCode;
      });
      if (!known) {
        refuse(Text::tr("the record has no class of raters '%1'", one.classCode), one.name,
               Text::tr("Use intern, deputy_chief, chief or another of its classes"));
      }
      const Person person = newPerson(one.name, one.code, kRaterPrefix);
      people_.addRaters(std::vector<Rater>{{person, one.classCode}});
      notePerson(person, one.classCode);
    }
  }

  void enrol() {
    StudyRepository study(session_.connection());
    std::map<std::string, GroupId> groups;
    for (const StudyGroup& group : study.groups(outcome_.cohortId)) {
      groups[group.code] = group.id;
    }
    std::map<std::string, std::int64_t> numbers;
    std::vector<Enrolment> enrolments;
    for (const LandedPerson& one : study_.people) {
      Enrolment enrolment;
      enrolment.id = session_.ids().newUuid();
      enrolment.cohortId = outcome_.cohortId;
      enrolment.traineeId = idOf_.at(one.name);
      enrolment.state = one.state;
      enrolment.enrolledUtc_us = session_.now_us();
      enrolment.demonstration = study_.cohort.demonstration;
      if (!one.group.empty()) {
        enrolment.groupId = groups.at(one.group);
        enrolment.numberInGroup = ++numbers[one.group];
      }
      enrolmentOf_[one.name] = enrolment.id;
      session_.note(AuditAction::kEnrolmentAdd, AuditObject::kEnrolment, enrolment.id,
                    {{"cohort", outcome_.cohortId.text()},
                     {"trainee", outcome_.codes.at(one.name)},
                     {"group", one.group}});
      enrolments.push_back(std::move(enrolment));
    }
    study.enrol(enrolments);
  }

  void addOccasions() {
    for (const std::string& wanted : study_.occasions) {
      const Occasions known = OccasionRepository(session_.connection()).all();
      const auto found = std::find_if(known.begin(), known.end(), [&](const Occasion& one) {
        return one.code == wanted || one.label == wanted;
      });
      occasionOf_[wanted] = found != known.end() ? found->code : addOccasion(session_, wanted).code;
    }
  }

  void addCurriculumVersion() {
    const LandedCurriculum& landed = study_.curriculum;
    if (landed.name.empty()) {
      return;
    }
    const CurriculumId id = addCurriculum(session_, landed.name, landed.description,
                                          parseCurriculum(landed.json, "curriculum.json"));
    const CurriculumVersionId versionId = publishCurriculum(session_, id, "", study_.assets);
    runCurriculum(session_, versionId);
    study_.cohort.curriculumVersionId = versionId;
    version_ = CurriculumRepository(session_.connection()).version(versionId).value();
  }

  /// Return the ids for codes of the imported curriculum.
  [[nodiscard]] ModuleId moduleOf(const LandedPlace& place) const {
    const auto found = std::find_if(version_.modules.begin(), version_.modules.end(),
                                    [&](const TrainingModule& one) { return one.code == place.module; });
    if (!place.module.empty() && found == version_.modules.end()) {
      refusePlace(place.module);
    }
    return place.module.empty() ? ModuleId() : found->id;
  }
  [[nodiscard]] PhaseId phaseOf(const LandedPlace& place) const {
    const auto found = std::find_if(version_.arms.begin(), version_.arms.end(),
                                    [&](const StudyArm& one) { return one.code == place.arm; });
    if (place.arm.empty()) {
      return {};
    }
    if (found == version_.arms.end() || place.phase >= found->phases.size()) {
      refusePlace(place.arm);
    }
    return found->phases[place.phase].id;
  }
  [[noreturn]] static void refusePlace(const std::string& code) {
    refuse(Text::tr("the curriculum has nothing under this code"), code,
           Text::tr("Export the data set anew, with --whole"));
  }

  void addTimes() {
    StudyRepository study(session_.connection());
    std::vector<Exposure> exposures;
    for (const LandedExposure& landed : study_.exposures) {
      exposures.push_back({.id = session_.ids().newUuid(),
                           .enrolmentId = enrolmentOf_.at(landed.person),
                           .phaseId = phaseOf(landed.place),
                           .kind = landed.kind,
                           .startedUtc_us = landed.startedUtc_us,
                           .duration_us = landed.duration_us,
                           .recordedBy = session_.actor().login,
                           .demonstration = study_.cohort.demonstration});
    }
    study.addExposures(exposures);
    for (const LandedDeviation& landed : study_.deviations) {
      study.addDeviation(
          {.id = session_.ids().newUuid(),
           .cohortId = outcome_.cohortId,
           .enrolmentId = landed.person.empty() ? EnrolmentId() : enrolmentOf_.at(landed.person),
           .kind = landed.kind,
           .description = landed.description,
           .happenedUtc_us = landed.happenedUtc_us,
           .reportedBy = session_.actor().login,
           .reportedUtc_us = session_.now_us(),
           .demonstration = study_.cohort.demonstration});
    }
  }

  void addTrial(LandedTrial& landed) {
    TrialHeader& header = landed.trial.header;
    header.traineeCode = outcome_.codes.at(landed.person);
    if (header.trialId.empty()) {
      header.trialId = session_.ids().newUuid();
      landed.trial.summary.contentHash = contentHash(landed.trial);
    }
    TrialRepository trials(session_.connection());
    if (trials.find(header.trialId)) {
      refuse(Text::tr("the record has this recording already"), header.trialId,
             Text::tr("Import into an empty record"));
    }
    TrialContext context;
    context.station = session_.station();
    context.enrolmentId = enrolmentOf_.at(landed.person);
    context.moduleId = moduleOf(landed.place);
    context.phaseId = phaseOf(landed.place);
    context.attemptMode = landed.mode;
    context.importId = study_.origin.id;
    trials.setContext(std::move(context));
    trials.import(landed.trial);
  }

  void addMarks() {
    std::vector<SubmittedMark> marks;
    for (const LandedMark& landed : study_.marks) {
      SubmittedMark mark;
      mark.id = session_.ids().newUuid();
      mark.enrolmentId = enrolmentOf_.at(landed.person);
      mark.raterId = idOf_.at(landed.rater);
      mark.occasionCode = occasionOf_.at(landed.occasion);
      mark.score_steps = landed.steps;
      mark.scale = study_.scale;
      mark.comment = study_.markComment;
      mark.submittedUtc_us = session_.now_us();
      mark.demonstration = study_.cohort.demonstration;
      mark.importId = study_.origin.id;
      if (landed.trial) {
        mark.trialId = study_.trials.at(*landed.trial).trial.header.trialId;
      }
      marks.push_back(std::move(mark));
    }
    RatingRepository(session_.connection(), session_.station()).submit(marks);
  }

  SessionContext& session_;
  LandedStudy& study_;
  PeopleRepository people_;
  std::set<std::string> used_;
  PersonCodes codes_;
  LandedOutcome outcome_;
  CurriculumVersion version_;                // imported; without one it has no parts
  std::map<std::string, std::string> idOf_;  // person ids by name
  std::map<std::string, EnrolmentId> enrolmentOf_;
  std::map<std::string, std::string> occasionOf_;  // code by the name used in the data
};

/// Throws if a name or label of imported data cannot be read, was shortened by a spreadsheet, or two names of
/// people look alike.
void checkNames(const LandedStudy& study) {
  Identifiers people("name");
  const auto take = [&people](const std::string& name) {
    people.take(name, name);
    if (isSpreadsheetNumber(name)) {
      refuse(Text::tr(
                 "the name \"%1\" looks like a number that a spreadsheet has shortened: people can no longer "
                 "be told apart by it",
                 name),
             name, Text::tr("Write the whole number as text, everywhere in the data"));
    }
  };
  for (const LandedPerson& one : study.people) {
    take(one.name);
    requireReadable(one.level, one.name);
  }
  for (const LandedRater& one : study.raters) {
    take(one.name);
  }
  requireReadable(study.curriculum.name, Text::tr("curriculum"));
}

}  // namespace

void requireLanding(SessionContext& session) {
  session.require(Operation::kStudySetup);
  session.require(Operation::kStudyEnrol);
  session.require(Operation::kPersonEdit);
  session.require(Operation::kCurriculumEdit);
}

LandedOutcome landStudy(SessionContext& session, LandedStudy study, const LandingNote& note,
                        const ProgressCallback& progress) {
  requireLanding(session);
  checkNames(study);
  // The header of a recording is part of its hash: what was simulated stays so, whatever the study says.
  study.cohort.demonstration =
      study.cohort.demonstration ||
      std::any_of(study.trials.begin(), study.trials.end(),
                  [](const LandedTrial& landed) { return landed.trial.header.demonstration; });
  Transaction transaction(session.connection());
  LandedOutcome outcome = Landing(session, study).land(progress);
  session.note(
      {AuditAction::kTrialImport, AuditObject::kCohort, outcome.cohortId, {}, note.json, note.reason});
  transaction.commit();
  return outcome;
}

}  // namespace torsio
