// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demonstration/demonstration_people.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "app/services/access/centre_settings.h"
#include "app/services/base/build_info.h"
#include "app/services/demonstration/demonstration.h"
#include "app/services/demonstration/demonstration_curriculum.h"
#include "app/services/demonstration/demonstration_desk.h"
#include "app/services/demonstration/demonstration_station.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"

namespace torsio {

namespace {

constexpr std::size_t kTrainees = 30;
constexpr std::uint64_t kDemonstrationCodes = 10'000'000;  // as many digits as the code of a centre takes
constexpr std::size_t kMaleTrainees = 17;                  // paper section 6: 17 men, 13 women
constexpr std::size_t kTrainingRaters = 10;
constexpr std::int64_t kScoring_us = 180'000'000;
constexpr std::int64_t kCallLength_us = 240'000'000;
constexpr std::size_t kMaleTrainingRaters = 7;

struct ClassOfRaters {
  const char* code;
  const char* label;
  const char* prefix;
  std::size_t count;
  std::size_t men;  // paper 5.3: 7 of 20, 6 of 10, 7 of 10
};
constexpr std::array<ClassOfRaters, 3> kClasses{{{"intern", "intern", "RA", 20, 7},
                                                 {"deputy_chief", "deputy chief physician", "RB", 10, 6},
                                                 {"chief", "chief physician", "RC", 10, 7}}};
constexpr std::array<const char*, 3> kGroupLabels{"40 min virtual", "20 min virtual, 20 min real arm",
                                                  "40 min real arm"};

std::string numbered(const std::string& prefix, std::size_t number) {
  return prefix + "-" + (number < 10 ? "0" : "") + std::to_string(number);
}

Person person(IdSource& ids, const std::string& code, bool male, const std::string& level,
              std::int64_t utc_us) {
  Person p;
  p.id = ids.newUuid();
  p.code = code;
  p.sex = male ? "male" : "female";
  p.level = level;
  p.createdUtc_us = utc_us;
  p.demonstration = true;
  return p;
}

std::vector<Trainee> makeTrainees(IdSource& ids, std::int64_t utc_us) {
  constexpr std::array<const char*, 3> kLevels{"first-year graduate", "master's student", "doctoral student"};
  std::vector<Trainee> trainees;
  for (std::size_t i = 0; i < kTrainees; ++i) {
    // Alternate men and women as long as there are both, so that arrival order and sex are independent.
    const bool male = (i * kMaleTrainees) / kTrainees != ((i + 1) * kMaleTrainees) / kTrainees;
    trainees.push_back(
        {person(ids, numbered("T", i + 1), male, kLevels[i % kLevels.size()], utc_us), "right"});
  }
  return trainees;
}

std::vector<Rater> makeRaters(IdSource& ids, const std::string& prefix, std::size_t count, std::size_t men,
                              const std::string& classCode, std::int64_t utc_us) {
  std::vector<Rater> raters;
  for (std::size_t i = 0; i < count; ++i) {
    raters.push_back({person(ids, numbered(prefix, i + 1), i < men, "", utc_us), classCode});
  }
  return raters;
}

/// Allocates the groups by one seeded permutation and stores design, commitment and records.
void allocateTrainees(Connection& connection, IdSource& ids, const std::vector<Trainee>& trainees,
                      const std::vector<StudyGroup>& groups, std::uint64_t seed, std::int64_t utc_us,
                      DemonstrationStudy& study) {
  StudyRepository repository(connection);
  std::vector<Enrolment> enrolments;
  std::vector<AllocationPerson> persons;
  for (const Trainee& trainee : trainees) {
    Enrolment enrolment;
    enrolment.id = ids.newUuid();
    enrolment.cohortId = study.cohortId;
    enrolment.traineeId = trainee.person.id;
    enrolment.enrolledUtc_us = utc_us;
    enrolment.demonstration = true;
    enrolments.push_back(enrolment);
    persons.push_back({trainee.person.code, {}});
  }
  repository.enrol(enrolments);

  AllocationDesign design;
  design.studyId = study.cohortId;
  for (const StudyGroup& group : groups) {
    design.arms.push_back(group.code);
  }
  // A separate stream, so that all other numbers of the demonstration stay the same.
  Digest salt;
  salt.update("salt of the demonstration");
  salt.update(static_cast<std::int64_t>(seed));
  const Allocation allocation = allocate(design, seed, persons, true, salt.hex());
  study.seedCommitment = allocation.commitment;
  study.allocationSeed = static_cast<std::int64_t>(seed);
  LockedDesign stored;
  stored.id = ids.newUuid();
  stored.cohortId = study.cohortId;
  stored.algorithm = storedText(design.method);
  stored.algorithmVersion = kAllocationVersion;
  stored.parametersJson = R"({"arms":3,"ratio":[1,1,1]})";
  stored.generator = kAllocationGenerator;
  stored.seedCommitment = allocation.commitment;
  stored.seed = std::to_string(seed);
  stored.salt = allocation.salt;
  stored.lockedUtc_us = utc_us;
  stored.demonstration = true;
  repository.lockDesign(stored);

  std::vector<AllocationEntry> records;
  std::array<std::int64_t, kGroupLabels.size()> inGroup{};
  for (const AllocationRecord& drawn : allocation.records) {
    AllocationEntry record;
    record.id = ids.newUuid();
    record.designId = stored.id;
    record.sequence = static_cast<std::int64_t>(drawn.position + 1);
    record.enrolmentId = enrolments.at(drawn.position).id;
    record.groupId = groups.at(drawn.arm).id;
    record.numberInGroup = ++inGroup.at(drawn.arm);
    record.drawBefore = static_cast<std::int64_t>(drawn.drawsBefore);
    record.drawAfter = static_cast<std::int64_t>(drawn.drawsAfter);
    record.enrolledBy = "demonstration";
    record.allocatedBy = "demonstration";
    record.softwareVersion = softwareVersion();
    record.allocatedUtc_us = utc_us;
    record.demonstration = true;
    records.push_back(record);
    study.trainees.push_back(
        {drawn.person, record.enrolmentId, drawn.arm, static_cast<std::size_t>(record.numberInGroup)});
  }
  repository.allocate(records);
  repository.revealSeed(stored.id, utc_us);  // no real person is affected
  std::sort(study.trainees.begin(), study.trainees.end(), [](const auto& a, const auto& b) {
    return std::pair(a.group, a.number) < std::pair(b.group, b.number);
  });
}

Campaign makeCampaign(IdSource& ids, const std::vector<std::vector<Rater>>& raters, std::int64_t utc_us) {
  Campaign campaign;
  campaign.id = ids.newUuid();
  campaign.name = std::string(Text::tr("Nine-index evaluation (demonstration)").english());
  campaign.instrument = paperInstrument();
  for (std::size_t c = 0; c < kClasses.size(); ++c) {
    campaign.instrument.classes[c].id = kClasses[c].code;
  }
  campaign.models = {{"PM", "proposed model (Kriging + membrane)", "X", 1},
                     {"FEM", "finite elements", "Y", 2},
                     {"MSM", "mass-spring", "Z", 3}};
  // Counterbalanced: the six orders of three models, one rater after another.
  constexpr std::array<const char*, 6> kOrders{"PM,FEM,MSM", "FEM,MSM,PM", "MSM,PM,FEM",
                                               "PM,MSM,FEM", "FEM,PM,MSM", "MSM,FEM,PM"};
  std::size_t next = 0;
  for (const auto& raterClass : raters) {
    for (const Rater& rater : raterClass) {
      campaign.raters.push_back({rater.person.id, rater.classCode, kOrders[next++ % kOrders.size()]});
    }
  }
  campaign.createdUtc_us = utc_us;
  campaign.demonstration = true;
  return campaign;
}

/// Adds a rubric with only an overall mark, as the paper's physicians gave on the real arm.
RubricRevisionId addOverallRubric(Connection& connection, IdSource& ids, const ScoreScale& scale,
                                  std::int64_t utc_us) {
  RubricRepository rubrics(connection);
  RubricRevision rubric;
  rubric.id = ids.newUuid();
  rubric.rubricId = ids.newUuid();
  rubric.note = "demonstration";
  rubric.overall = scale;
  rubric.createdBy = "demonstration";
  rubric.createdUtc_us = utc_us;
  rubrics.addRubric(rubric.rubricId, "Overall mark on the real arm (demonstration)", utc_us, true);
  rubrics.addRevision(rubric);
  return rubric.id;
}

/// Returns labels of live cases; labels with one digit are left for recorded cases.
std::vector<std::string> liveLabels(std::size_t count, std::uint64_t seed) {
  std::set<std::string> taken;
  for (char figure = '1'; figure <= '9'; ++figure) {
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      taken.insert(std::string{figure, letter});
    }
  }
  return caseLabels(count, taken, seed, 0);
}

/// Returns when a trainee is called to the real arm: before the first phase and after each phase.
std::vector<std::int64_t> callTimes(const CurriculumVersion& curriculum, const DemonstrationTrainee& trainee,
                                    std::int64_t utc_us) {
  std::vector<std::int64_t> times = demonstrationTimes(curriculum, trainee, utc_us);
  const std::vector<TrainingPhase>& phases = curriculum.arms.at(trainee.group).phases;
  for (std::size_t i = phases.size(); i > 0; --i) {
    times[i] = times[i - 1] + phases[i - 1].duration_us;  // before any rest
  }
  times[0] -= kCallLength_us;
  return times;
}

/// Assigns each mark to a request, live on the real arm. Uses separate ids, so that all other ids stay the
/// same.
void assignMarks(Connection& connection, std::vector<SubmittedMark>& marks, std::uint64_t seed,
                 std::int64_t utc_us) {
  constexpr std::uint64_t kOwnStream = 0x61'7373'6967'6eULL;
  if (marks.empty()) {
    return;
  }
  SeededIdSource ids(seed ^ kOwnStream);
  const RubricRevisionId rubric = addOverallRubric(connection, ids, marks.front().scale, utc_us);
  std::map<std::pair<std::string, std::string>, std::string> labels;  // the same for all raters, since it is
                                                                      // called out
  std::map<std::pair<std::string, std::string>, std::int64_t> called_us;
  for (const SubmittedMark& mark : marks) {
    labels[{mark.enrolmentId, mark.occasionCode}];
    called_us[{mark.enrolmentId, mark.occasionCode}] = mark.submittedUtc_us - kScoring_us;
  }
  const std::vector<std::string> drawn = liveLabels(labels.size(), seed);
  std::size_t next = 0;
  for (auto& [live, label] : labels) {
    label = drawn.at(next++);
  }
  std::vector<Assignment> assignments;
  std::map<std::string, std::int64_t> positions;
  for (SubmittedMark& mark : marks) {
    Assignment one;
    one.id = ids.newUuid();
    one.raterId = mark.raterId;
    one.enrolmentId = mark.enrolmentId;
    one.occasionCode = mark.occasionCode;
    one.rubricRevisionId = rubric;
    one.caseLabel = labels.at({mark.enrolmentId, mark.occasionCode});
    one.position = ++positions[mark.raterId];
    one.assignedBy = "demonstration";
    one.assignedUtc_us = utc_us;
    one.demonstration = true;
    mark.assignmentId = one.id;
    assignments.push_back(std::move(one));
  }
  SheetRepository(connection).assign(assignments);
  std::vector<LiveCall> calls;
  for (const auto& [live, label] : labels) {
    calls.push_back({ids.newUuid(), live.first, live.second, "Skills lab (demonstration)", "demonstration",
                     called_us.at(live), called_us.at(live) + kCallLength_us, false});
  }
  CallRepository(connection).add(calls);
}

}  // namespace

DemonstrationStudy storeDemonstrationPeople(Connection& connection, IdSource& ids, std::uint64_t seed,
                                            std::int64_t utc_us) {
  PeopleRepository people(connection);
  StudyRepository studies(connection);
  DemonstrationStudy study;
  if (!studies.centre()) {
    studies.setCentre({ids.newUuid(), "Demonstration centre (simulated)", utc_us, true});
    SettingRepository(connection)
        .set(kCentreCode.name, "D" + std::to_string(seed % kDemonstrationCodes), utc_us);
  }
  std::vector<SeniorityClass> classes;
  for (const ClassOfRaters& c : kClasses) {
    classes.push_back({c.code, c.label, static_cast<std::int64_t>(classes.size() + 1)});
  }
  people.addRaterClasses(classes);

  const std::vector<Trainee> trainees = makeTrainees(ids, utc_us);
  people.addTrainees(trainees);
  const std::vector<Rater> markers =
      makeRaters(ids, "R", kTrainingRaters, kMaleTrainingRaters, "chief", utc_us);
  people.addRaters(markers);
  for (const Rater& rater : markers) {
    study.people.raters.push_back(rater.person.code);
  }
  std::vector<std::vector<Rater>> evaluators;
  for (const ClassOfRaters& c : kClasses) {
    evaluators.push_back(makeRaters(ids, c.prefix, c.count, c.men, c.code, utc_us));
    people.addRaters(evaluators.back());
    study.people.raterClasses.emplace_back();
    for (const Rater& rater : evaluators.back()) {
      study.people.raterClasses.back().push_back(rater.person.code);
    }
  }

  study.cohortId = ids.newUuid();
  std::vector<StudyGroup> groups;
  for (const char* label : kGroupLabels) {
    const auto number = static_cast<std::int64_t>(groups.size() + 1);
    groups.push_back({ids.newUuid(), study.cohortId, number, "G" + std::to_string(number), label});
    study.groupLabels.emplace_back(label);
  }
  constexpr double kMargin = 0.5;  // points
  studies.addCohort({.id = study.cohortId,
                     .name = std::string(Text::tr("Twist training, three arms (demonstration)").english()),
                     .description = "Simulated trainees after section 6 of the paper",
                     .createdUtc_us = utc_us,
                     .demonstration = true,
                     .equivalenceMargin = kMargin},
                    groups);
  allocateTrainees(connection, ids, trainees, groups, seed, utc_us, study);
  study.people.groups.resize(groups.size());
  for (const DemonstrationTrainee& trainee : study.trainees) {
    study.people.groups[trainee.group].push_back(trainee.code);
  }

  const Campaign campaign = makeCampaign(ids, evaluators, utc_us);
  EvaluationRepository(connection).addCampaign(campaign);
  study.campaignId = campaign.id;
  return study;
}

void submitDemonstrationMarks(Connection& connection, const DemonstrationStudy& study,
                              const CurriculumVersion& curriculum, IdSource& ids, std::uint64_t seed,
                              std::int64_t utc_us) {
  std::map<std::string, RaterId> raterIds;
  for (const Rater& rater : PeopleRepository(connection).raters()) {
    raterIds[rater.person.code] = rater.person.id;
  }
  std::map<std::string, EnrolmentId> enrolmentIds;
  std::map<std::string, std::vector<std::int64_t>> called;  // by trainee: before the first and after each
                                                            // phase
  for (const DemonstrationTrainee& trainee : study.trainees) {
    enrolmentIds[trainee.code] = trainee.enrolmentId;
    called[trainee.code] = callTimes(curriculum, trainee, utc_us);
  }

  const Occasions occasions = OccasionRepository(connection).all();
  std::vector<SubmittedMark> training;
  const ScoreScale trainingScale = SubmittedMark{}.scale;
  for (const TrainingMark& mark : demonstrationTrainingMarks(trainingScale, study.people, seed)) {
    SubmittedMark stored;
    stored.id = ids.newUuid();
    stored.enrolmentId = enrolmentIds.at(mark.trainee);
    stored.raterId = raterIds.at(mark.rater);
    stored.occasionCode = occasions.at(mark.occasion).code;
    stored.score_steps = mark.steps;
    stored.submittedUtc_us = called.at(mark.trainee).at(mark.occasion) + kScoring_us;
    stored.demonstration = true;
    training.push_back(std::move(stored));
  }
  assignMarks(connection, training, seed, utc_us);
  std::stable_sort(training.begin(), training.end(), [](const SubmittedMark& a, const SubmittedMark& b) {
    return a.submittedUtc_us < b.submittedUtc_us;
  });
  RatingRepository(connection).submit(training);

  EvaluationRepository evaluations(connection);
  const auto campaign = evaluations.campaign(study.campaignId);
  std::vector<std::string> models;
  for (const CampaignModel& model : campaign.value().models) {
    models.push_back(model.code);
  }
  std::vector<EvaluationMark> marks;
  for (const EvaluationRating& rating :
       demonstrationEvaluationMarks(campaign->instrument, study.people, models, seed)) {
    if (!rating.steps) {
      continue;
    }
    EvaluationMark stored;
    stored.id = ids.newUuid();
    stored.raterId = raterIds.at(rating.rater);
    stored.modelCode = rating.model;
    stored.indexNumber = static_cast<std::int64_t>(rating.index + 1);
    stored.score_steps = *rating.steps;
    stored.submittedUtc_us = utc_us;
    stored.demonstration = true;
    marks.push_back(std::move(stored));
  }
  evaluations.submit(study.campaignId, marks);
}

namespace {

constexpr double kDesksAt = 0.97;  // share of the total progress

/// People whose pages have content, and who therefore get accounts.
struct DemonstrationUsers {
  TraineeId traineeId;
  RaterId raterId;
};

DemonstrationUsers fillWithPeople(SessionContext& session, const std::filesystem::path& assets,
                                  const ProgressCallback& progress) {
  DemonstrationOptions options;
  options.training.assets = assets;
  options.training.id = "forearm";
  options.example.assets = assets;
  options.example.id = "stomach";
  options.fewestTwists = kDemonstrationTwists;
  options.progress = progress;
  static_cast<void>(fillDemonstration(options, session.connectionWithoutRight()));
  // Content of the pages of the demonstration's trainee and physician.
  if (progress) {
    progress({Text::tr("Preparing accounts"), kDesksAt, -1.0});
  }
  const DemonstrationStation station =
      storeDemonstrationStation(session.connectionWithoutRight(), session.ids(), assets, session.now_us());
  const DemonstrationDesk desk =
      storeDemonstrationDesk(session.connectionWithoutRight(), session.ids(), loadScene(options.training),
                             {.seed = options.seed, .utc_us = session.now_us()});
  return {station.personId, desk.raterIds.front()};
}

StartAccount account(SessionContext& session, const std::string& login, const std::string& role,
                     const Person& person) {
  StartAccount made{login, role, person.code, randomStartPassword()};
  addUser(session, {.login = login,
                    .personId = person.id,
                    .roles = {role},
                    .startPassword = made.startPassword,
                    .demonstration = true});
  return made;
}

std::vector<StartAccount> accountsOf(SessionContext& session, const DemonstrationUsers& users) {
  PeopleRepository people(session.connectionWithoutRight());
  const std::vector<Trainee> trainees = people.trainees();
  const std::vector<Rater> raters = people.raters();
  const auto trainee = std::find_if(trainees.begin(), trainees.end(), [&](const Trainee& candidate) {
    return candidate.person.id == users.traineeId;
  });
  const auto rater = std::find_if(raters.begin(), raters.end(), [&](const Rater& candidate) {
    return candidate.person.id == users.raterId;
  });
  TORSIO_EXPECTS(trainee != trainees.end() && rater != raters.end());
  return {account(session, "demo.trainee", "trainee", trainee->person),
          account(session, "demo.physician", "rater", rater->person)};
}

}  // namespace

std::vector<StartAccount> addDemonstration(SessionContext& session, const std::filesystem::path& assets,
                                           const ProgressCallback& progress) {
  return accountsOf(session, fillWithPeople(session, assets, progress));
}

}  // namespace torsio
