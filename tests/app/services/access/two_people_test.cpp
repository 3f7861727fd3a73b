// SPDX-License-Identifier: GPL-3.0-or-later
// What two people do together, and nobody can do alone. Sealing requires the password and states the
// meaning of the signature.

#include "app/services/access/two_people.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/signing.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/open_sheets.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/people/account.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/signature_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/refusal.h"

namespace torsio {

namespace {

using testing::refusalCode;

/// A centre that requires two people, with a second administrator "second".
class TwoPeople : public ::testing::Test {
 protected:
  TwoPeople() {
    SettingRepository(centre_.connection()).set(kTwoPeople.name, "yes", 0);
    second_ = addAdministrator("second");
  }
  UserId addAdministrator(const std::string& login, const PersonId& personId = {}) {
    AccessRepository access(centre_.connection(), PasswordCost::kTest);
    const UserId id = "u-" + login;
    access.addUser({.id = id, .login = login, .personId = personId, .roles = {"administrator"}},
                   kStudyPassword);
    access.setPassword(id, access.sealPassword(login, kStudyPassword), false);
    return id;
  }
  SessionContext& asSecond() {
    SessionContext& session = centre_.as("");
    EXPECT_EQ(signIn(session, "second", kStudyPassword).outcome, SignIn::kOk);
    return centre_.session();
  }
  SessionContext& asFirst() {
    centre_.as("administrator");
    return centre_.session();
  }
  UserAccount user(const std::string& login) {
    for (const UserAccount& one : AccessRepository(centre_.connection()).users()) {
      if (one.login == login) {
        return one;
      }
    }
    return {};
  }
  StudyCentre centre_;
  UserId second_;
};

TEST_F(TwoPeople, NobodyResetsThePasswordOfARaterAlone) {
  const UserAccount rater = user("rater");
  EXPECT_THROW(resetPassword(asFirst(), rater.id, "a start password to know", "lost"), SecondPersonNeeded);

  const std::string firstHalf =
      askSecondPerson(asFirst(), {.act = DutyAct::kResetPassword, .subject = rater.id, .reason = "lost"});
  const std::vector<OpenRequest> open = openRequests(asFirst());
  ASSERT_EQ(open.size(), 1U);
  EXPECT_TRUE(open[0].own);
  EXPECT_TRUE(open[0].request.detailJson.empty());
  EXPECT_EQ(open[0].shown, "rater");
  EXPECT_EQ(refusalCode([&] { (void)confirmRequest(asFirst(), open[0].request.id); }),
            ErrorCode::kPermission);
  const std::string secondHalf = confirmRequest(asSecond(), open[0].request.id);

  SessionContext& session = centre_.as("");
  EXPECT_EQ(signIn(session, "rater", firstHalf).outcome, SignIn::kWrong);
  EXPECT_EQ(signIn(session, "rater", secondHalf).outcome, SignIn::kWrong);
  EXPECT_EQ(signIn(session, "rater", firstHalf + "-" + secondHalf).outcome, SignIn::kMustChange);
  EXPECT_TRUE(openRequests(asFirst()).empty());
  EXPECT_EQ(centre_.audited("duty.request"), 1);
  EXPECT_EQ(centre_.audited("duty.confirm"), 1);
  EXPECT_EQ(refusalCode([&] { (void)confirmRequest(asSecond(), open[0].request.id); }), ErrorCode::kBadData);
}

TEST_F(TwoPeople, ATraineesPasswordNeedsOnlyOneAdministrator) {
  resetPassword(asFirst(), user("trainee").id, "a start password to know", "lost");
  EXPECT_TRUE(user("trainee").mustChangePassword);
}

TEST_F(TwoPeople, RolesAreGrantedByTwoWithANewPasswordThatNeitherKnows) {
  const UserAccount trainee = user("trainee");
  EXPECT_THROW(setUserRoles(asFirst(), trainee.id, {"trainee", "rater"}, "scores too"), SecondPersonNeeded);
  setUserRoles(asFirst(), user("statistician").id, {}, "leaves");  // removing roles needs only one

  const std::string half = askSecondPerson(asFirst(), {.act = DutyAct::kGrantRoles,
                                                       .subject = trainee.id,
                                                       .roles = {"trainee", "rater"},
                                                       .reason = "scores too"});
  const std::string rest = confirmRequest(asSecond(), openRequests(asSecond()).at(0).request.id);

  EXPECT_EQ(user("trainee").roles, (std::vector<std::string>{"rater", "trainee"}));
  SessionContext& session = centre_.as("");
  EXPECT_EQ(signIn(session, "trainee", kStudyPassword).outcome, SignIn::kWrong);
  EXPECT_EQ(signIn(session, "trainee", half + "-" + rest).outcome, SignIn::kMustChange);
}

TEST_F(TwoPeople, ANewRaterNeedsTheSecondPersonAndCannotSignInBefore) {
  const MadeUser made = makeUser(
      asFirst(), {.login = "new.rater", .roles = {"rater"}, .startPassword = "a start password to know"});

  EXPECT_TRUE(made.awaitsSecond);
  EXPECT_TRUE(user("new.rater").roles.empty());
  SessionContext& session = centre_.as("");
  for (const std::string& known : {made.startPassword, std::string("a start password to know")}) {
    EXPECT_EQ(signIn(session, "new.rater", known).outcome, SignIn::kWrong);
  }
  const std::string rest = confirmRequest(asSecond(), openRequests(asSecond()).at(0).request.id);
  EXPECT_EQ(signIn(centre_.as(""), "new.rater", made.startPassword + "-" + rest).outcome,
            SignIn::kMustChange);
  EXPECT_EQ(user("new.rater").roles, std::vector<std::string>{"rater"});
  EXPECT_THROW(
      addUser(asFirst(), {.login = "other", .roles = {"allocator"}, .startPassword = kStudyPassword}),
      SecondPersonNeeded);
}

TEST_F(TwoPeople, NobodyConfirmsForThemselvesNotEvenWithASecondAccount) {
  EXPECT_EQ(refusalCode([&] {
              (void)askSecondPerson(asSecond(), {.act = DutyAct::kGrantRoles,
                                                 .subject = second_,
                                                 .roles = {"administrator", "rater"},
                                                 .reason = "why not"});
            }),
            ErrorCode::kPermission);
  const PersonId person = centre_.addChiefs(1).front();
  addAdministrator("one", person);
  addAdministrator("two", person);
  SessionContext& session = centre_.as("");
  ASSERT_EQ(signIn(session, "one", kStudyPassword).outcome, SignIn::kOk);
  (void)askSecondPerson(centre_.session(),
                        {.act = DutyAct::kResetPassword, .subject = user("rater").id, .reason = "lost"});
  ASSERT_EQ(signIn(centre_.as(""), "two", kStudyPassword).outcome, SignIn::kOk);

  const std::string id = openRequests(centre_.session()).at(0).request.id;
  EXPECT_EQ(refusalCode([&] { (void)confirmRequest(centre_.session(), id); }), ErrorCode::kPermission);
  EXPECT_EQ(openRequests(centre_.session()).size(), 1U);
}

TEST_F(TwoPeople, RemovingARatersRolesFirstGivesNoAccessToTheAccount) {
  const PersonId person = centre_.addChiefs(1).front();
  const MadeUser made = makeUser(
      asFirst(), {.login = "chief", .personId = person, .roles = {"rater"}, .startPassword = kStudyPassword});
  (void)confirmRequest(asSecond(), openRequests(asSecond()).at(0).request.id);
  for (const std::vector<std::string>& roles : {std::vector<std::string>{}, {"trainee"}}) {
    setUserRoles(asFirst(), made.id, roles, "to get in");
    EXPECT_THROW(resetPassword(asFirst(), made.id, "a start password to know", "lost"), SecondPersonNeeded);
  }
}

TEST_F(TwoPeople, NobodyCreatesASecondAccountOfAnotherPerson) {
  const PersonId trainee = centre_.addTrainees(1).front();
  const auto add = [&](const char* login) {
    addUser(asFirst(),
            {.login = login, .personId = trainee, .roles = {"trainee"}, .startPassword = kStudyPassword});
  };
  add("t-01");
  EXPECT_EQ(refusalCode([&] { add("shadow"); }), ErrorCode::kBadData);
  setUserActive(asFirst(), user("t-01").id, false, "to make another");
  EXPECT_EQ(refusalCode([&] { add("shadow"); }), ErrorCode::kBadData);
  EXPECT_EQ(refusalCode([&] {
              (void)makeUser(asFirst(), {.login = "shadow", .personId = trainee, .roles = {"rater"}});
            }),
            ErrorCode::kBadData);
  EXPECT_TRUE(user("shadow").id.empty());
}

TEST_F(TwoPeople, AnAccountOfTheDemonstrationDoesNotCircumventTheSecondPerson) {
  for (const char* role : {"administrator", "allocator", "statistician"}) {
    EXPECT_THROW(
        addUser(
            asFirst(),
            {.login = "simulated", .roles = {role}, .startPassword = kStudyPassword, .demonstration = true}),
        SecondPersonNeeded)
        << role;
  }
  addUser(asFirst(), {.login = "demo.physician",
                      .roles = {"rater"},
                      .startPassword = kStudyPassword,
                      .demonstration = true});
  const UserAccount simulated = user("demo.physician");
  resetPassword(asFirst(), simulated.id, "a start password to know", "to look");
  for (const char* role : {"administrator", "allocator", "statistician"}) {
    EXPECT_THROW(setUserRoles(asFirst(), simulated.id, {"rater", role}, "to get in"), SecondPersonNeeded)
        << role;
  }
}

TEST_F(TwoPeople, ARatersFirstAccountNeedsTwoWhateverItsRoles) {
  const std::vector<RaterId> chiefs = centre_.addChiefs(3);
  std::size_t next = 0;
  for (const std::vector<std::string>& roles : {std::vector<std::string>{}, {"trainee"}}) {
    const std::string login = "chief" + std::to_string(next);
    const NewUser wanted{
        .login = login, .personId = chiefs[next++], .roles = roles, .startPassword = kStudyPassword};
    EXPECT_THROW(addUser(asFirst(), wanted), SecondPersonNeeded);

    const MadeUser made = makeUser(asFirst(), wanted);

    EXPECT_TRUE(made.awaitsSecond);
    for (const std::string& known : {std::string(kStudyPassword), made.startPassword, std::string()}) {
      EXPECT_EQ(signIn(centre_.as(""), login, known).outcome, SignIn::kWrong);
    }
    centre_.passTime_us(10 * kMinute_us);  // the wrong tries
    const std::string rest = confirmRequest(asSecond(), openRequests(asSecond()).at(0).request.id);
    EXPECT_EQ(signIn(centre_.as(""), login, made.startPassword + "-" + rest).outcome, SignIn::kMustChange);
    EXPECT_EQ(user(login).roles, roles);
  }

  // Where a centre switched the rule off, one is enough.
  SettingRepository(centre_.connection()).set(kTwoPeople.name, "no", 0);
  const NewUser alone{
      .login = "alone", .personId = chiefs[next], .roles = {"rater"}, .startPassword = kStudyPassword};
  EXPECT_FALSE(makeUser(asFirst(), alone).awaitsSecond);
  EXPECT_EQ(signIn(centre_.as(""), "alone", kStudyPassword).outcome, SignIn::kMustChange);
}

// As ServerRolesTest.WhoeverAsksNeedsTheRightAndIsAnotherRealPerson has it on a server.
TEST_F(TwoPeople, WhoeverIsSimulatedAsksAndConfirmsOnlyWhatConcernsSimulatedPeople) {
  addAdministrator("puppet");
  AccessRepository(centre_.connection(), PasswordCost::kTest)
      .addUser({.id = "u-physician", .login = "physician", .demonstration = true, .roles = {"rater"}},
               kStudyPassword);
  const auto asPuppet = [this]() -> SessionContext& {
    EXPECT_EQ(signIn(centre_.as(""), "puppet", kStudyPassword).outcome, SignIn::kOk);
    return centre_.session();
  };
  const std::vector<TraineeId> people = centre_.addTrainees(1);
  const DutyWish real{.act = DutyAct::kErase, .subject = people[0], .reason = "asked"};
  const DutyWish lost{.act = DutyAct::kResetPassword, .subject = user("rater").id, .reason = "lost"};
  const DutyWish simulated{.act = DutyAct::kGrantRoles,
                           .subject = "u-physician",
                           .roles = {"rater", "statistician"},
                           .reason = "to look"};
  (void)askSecondPerson(asPuppet(), real);  // while it still is nobody's puppet
  (void)askSecondPerson(asPuppet(), lost);
  centre_.connection().executeVerbatim("UPDATE app_user SET demonstration = TRUE WHERE login = 'puppet'");

  // What a simulated person asked for is confirmed by nobody.
  const auto tryAll = [](SessionContext& session) {
    for (const OpenRequest& open : openRequests(session)) {
      if (open.request.act == DutyAct::kResetPassword) {
        EXPECT_EQ(refusalCode([&] { (void)confirmRequest(session, open.request.id); }),
                  ErrorCode::kPermission);
      }
    }
  };
  tryAll(asSecond());
  EXPECT_THROW(erasePersonRecord(asSecond(), people[0], "asked"), SecondPersonNeeded);
  // Nor does a simulated person ask for or confirm anything that concerns a real one.
  for (const DutyWish& wish :
       {real, lost, DutyWish{.act = DutyAct::kOnePerson, .subject = "two_people", .reason = "why not"}}) {
    EXPECT_EQ(refusalCode([&] { (void)askSecondPerson(asPuppet(), wish); }), ErrorCode::kPermission);
  }
  (void)askSecondPerson(asFirst(),
                        {.act = DutyAct::kResetPassword, .subject = user("trainee").id, .reason = "lost"});
  tryAll(asPuppet());
  // What concerns simulated people only, they may.
  (void)askSecondPerson(asPuppet(), simulated);
  for (const OpenRequest& open : openRequests(asSecond())) {
    if (open.request.act == DutyAct::kGrantRoles) {
      (void)confirmRequest(asSecond(), open.request.id);
    }
  }
  EXPECT_EQ(user("physician").roles, (std::vector<std::string>{"rater", "statistician"}));
}

TEST_F(TwoPeople, ErasingNeedsTwoAndUsesUpTheRequest) {
  const std::vector<TraineeId> people = centre_.addTrainees(2);
  EXPECT_THROW(erasePersonRecord(asFirst(), people[0], "asked"), SecondPersonNeeded);
  (void)askSecondPerson(asFirst(), {.act = DutyAct::kErase, .subject = people[0], .reason = "asked"});
  EXPECT_THROW(erasePersonRecord(asFirst(), people[0], "asked"), SecondPersonNeeded);
  EXPECT_THROW(erasePersonRecord(asSecond(), people[1], "asked"), SecondPersonNeeded);

  erasePersonRecord(asSecond(), people[0], "asked");

  EXPECT_EQ(PeopleRepository(centre_.connection()).find(people[0])->state, PersonState::kErased);
  EXPECT_EQ(PeopleRepository(centre_.connection()).find(people[1])->state, PersonState::kActive);
}

TEST_F(TwoPeople, ARequestExpiresAfterTwoWeeksAndCanBeDeclined) {
  const PersonId person = centre_.addTrainees(1).front();
  (void)askSecondPerson(asFirst(), {.act = DutyAct::kErase, .subject = person, .reason = "asked"});
  EXPECT_EQ(refusalCode([&] {
              (void)askSecondPerson(asSecond(), {.act = DutyAct::kErase, .subject = person, .reason = "too"});
            }),
            ErrorCode::kBadData);
  declineRequest(asSecond(), openRequests(asSecond()).at(0).request.id, "not asked by them");
  EXPECT_THROW(erasePersonRecord(asSecond(), person, "asked"), SecondPersonNeeded);

  (void)askSecondPerson(asFirst(), {.act = DutyAct::kErase, .subject = person, .reason = "asked again"});
  centre_.passTime_us(kRequestLife_us + 1);

  EXPECT_THROW(erasePersonRecord(asSecond(), person, "asked"), SecondPersonNeeded);
  EXPECT_TRUE(openRequests(asSecond()).empty());
}

TEST_F(TwoPeople, NobodyLooksAtUnfinishedMarksAlone) {
  const PaperStudy study = centre_.addStudy(2, 2);
  createAssignments(asFirst(), study.plan());
  const DutyWish look{.act = DutyAct::kFreezeInterim,
                      .subject = study.cohortId,
                      .shown = "Study",
                      .reason = "the board meets"};
  EXPECT_FALSE(mayFreezeNow(asFirst(), study.cohortId));
  EXPECT_THROW(freezeData(asFirst(), study.cohortId, "interim", {}, "the board meets"), SecondPersonNeeded);

  (void)askSecondPerson(asFirst(), look);
  EXPECT_TRUE(isRequested(asFirst(), look));
  EXPECT_EQ(openRequests(asSecond()).at(0).shown, "Study");
  EXPECT_THROW(freezeData(asFirst(), study.cohortId, "interim", {}, "the board meets"), SecondPersonNeeded);
  EXPECT_TRUE(frozenData(asFirst(), study.cohortId).empty());
  EXPECT_TRUE(mayFreezeNow(asSecond(), study.cohortId));
  showPassword(centre_.session(), kStudyPassword);
  const FrozenRow frozen = freezeData(centre_.session(), study.cohortId, "interim", {}, "the board meets");

  EXPECT_EQ(frozen.askedBy, "administrator");
  EXPECT_EQ(frozen.createdBy, "second");
  EXPECT_EQ(frozenData(asFirst(), study.cohortId).at(0).askedBy, "administrator");
  EXPECT_FALSE(mayFreezeNow(asSecond(), study.cohortId)) << "one request, one look";
  EXPECT_EQ(centre_.audited("duty.confirm"), 1);
  EXPECT_TRUE(verifyAuditTrail(centre_.connection()).empty());
}

TEST_F(TwoPeople, SheetsThatAreWithdrawnDoNotMakeAStudyComplete) {
  const PaperStudy study = centre_.addStudy(2, 2);
  createAssignments(asFirst(), study.plan());
  std::vector<AssignmentId> all;
  for (const AssignmentStatus& sheet : SheetRepository(centre_.connection()).assignments(study.cohortId)) {
    all.push_back(sheet.assignment.id);
  }
  const SheetCount before = sheetCount(asFirst(), study.cohortId);

  (void)reassignAll(asFirst(), all, RaterId(), "no time");

  const SheetCount after = sheetCount(asFirst(), study.cohortId);
  EXPECT_EQ(after.asked, before.asked);
  EXPECT_EQ(after.dropped, before.asked);
  EXPECT_THROW(freezeData(asFirst(), study.cohortId, "all of it", {}, "nobody had time"), SecondPersonNeeded);

  // Those of a trainee who has left are no longer asked for.
  const EnrolmentId leaver = StudyRepository(centre_.connection()).enrolments(study.cohortId).front().id;
  setEnrolmentState(asFirst(), study.cohortId, leaver, EnrolmentState::kWithdrawn, "moved away");
  EXPECT_LT(sheetCount(asFirst(), study.cohortId).asked, before.asked);
}

TEST_F(TwoPeople, TurningTheRuleOffNeedsTwoIfThereAreTwo) {
  EXPECT_THROW(setCentreSetting<kTwoPeople>(asFirst(), false), SecondPersonNeeded);
  (void)askSecondPerson(
      asFirst(),
      {.act = DutyAct::kOnePerson, .subject = std::string(kTwoPeople.name), .reason = "we are few"});
  EXPECT_EQ(confirmRequest(asSecond(), openRequests(asSecond()).at(0).request.id), "");

  EXPECT_FALSE(needsTwoPeople(centre_.connection()));
  EXPECT_EQ(centre_.audited("setting.change"), 1);
  resetPassword(asFirst(), user("rater").id, "a start password to know", "lost");
}

TEST_F(TwoPeople, NobodyMakesTheOtherAdministratorPowerlessAlone) {
  EXPECT_EQ(refusalCode([&] { setUserActive(asFirst(), second_, false, "left"); }), ErrorCode::kPermission);
  EXPECT_THROW(setUserRoles(asFirst(), second_, {}, "left"), SecondPersonNeeded);
  EXPECT_EQ(user("second").roles, std::vector<std::string>{"administrator"});

  const DutyWish wish{.act = DutyAct::kGrantRoles, .subject = second_, .roles = {}, .reason = "leaves"};
  EXPECT_EQ(askSecondPerson(asFirst(), wish), "");  // nobody needs a new password
  const std::string request = openRequests(asSecond()).at(0).request.id;
  EXPECT_THROW((void)confirmRequest(asFirst(), request), Error);
  EXPECT_EQ(confirmRequest(asSecond(), request), "");  // whom it is about agrees

  EXPECT_TRUE(user("second").roles.empty());
  EXPECT_EQ(signIn(centre_.as(""), "second", kStudyPassword).outcome, SignIn::kOk);
  setUserActive(asFirst(), second_, false, "left");
  setCentreSetting<kTwoPeople>(asFirst(), false);  // the last administrator
}

TEST_F(TwoPeople, ASingleAdministratorCanAddASecondOneOrTurnTheRuleOff) {
  AccessRepository(centre_.connection()).setActive(second_, false);
  EXPECT_THROW(addUser(asFirst(), {.login = "r", .roles = {"rater"}, .startPassword = kStudyPassword}),
               SecondPersonNeeded);

  addUser(asFirst(), {.login = "deputy", .roles = {"administrator"}, .startPassword = kStudyPassword});
  EXPECT_THROW(
      addUser(asFirst(), {.login = "third", .roles = {"administrator"}, .startPassword = kStudyPassword}),
      SecondPersonNeeded);

  AccessRepository(centre_.connection()).setActive(user("deputy").id, false);
  setCentreSetting<kTwoPeople>(asFirst(), false);
  EXPECT_FALSE(needsTwoPeople(centre_.connection()));
}

class Signing : public ::testing::Test {
 protected:
  SessionContext& signedIn() {
    EXPECT_EQ(signIn(centre_.as(""), "rater", kStudyPassword).outcome, SignIn::kOk);
    return centre_.session();
  }
  void signOne(const std::string& id) {
    SessionContext& session = centre_.session();
    session.require(Operation::kMarkSubmit);
    Transaction transaction(session.connection());
    sign(session, {.objectId = id, .reason = "seen twice"});
    transaction.commit();
    endSigning(session);
  }

  StudyCentre centre_;
};

TEST_F(Signing, AnAdministratorActingAsASimulatedPhysicianSignsOnlySimulatedObjectsWithoutAPassword) {
  addUser(centre_.as("administrator"),
          {.login = "demo", .roles = {"rater"}, .startPassword = kStudyPassword, .demonstration = true});
  const Actor physician = simulatedPerson(centre_.as("administrator"), SimulatedRole::kPhysician);
  centre_.as("").setActor(physician);
  centre_.passTime_us(3 * 60 * kMinute_us);
  SessionContext& session = centre_.session();
  EXPECT_FALSE(passwordIsDue(session));  // nobody knows one

  session.require(Operation::kMarkSubmit);
  sign(session, {.objectId = "a", .demonstration = true});
  EXPECT_THROW(sign(session, {.objectId = "b"}), Error);

  EXPECT_EQ(
      SignatureRepository(centre_.connection()).all(SignedKind::kTrainingMark).at("a").passwordShownUtc_us,
      0);
  Actor real = physician;
  real.userId = "somebody real";
  session.setActor(real);
  EXPECT_TRUE(passwordIsDue(session));
}

TEST_F(Signing, APasswordAllowsSigningForAQuarterOfAnHour) {
  signedIn();
  signOne("a");
  centre_.passTime_us(14 * kMinute_us);
  signOne("b");
  centre_.passTime_us(2 * kMinute_us);
  EXPECT_TRUE(passwordIsDue(centre_.session()));
  EXPECT_THROW(signOne("c"), PasswordDue);

  EXPECT_THROW(showPassword(centre_.session(), "something else entirely"), Error);
  EXPECT_THROW(signOne("c"), PasswordDue);
  showPassword(centre_.session(), kStudyPassword);
  signOne("c");

  const auto all = SignatureRepository(centre_.connection()).all(SignedKind::kTrainingMark);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all.at("c").meaning, SignatureMeaning::kScored);
  EXPECT_EQ(all.at("c").reason, "seen twice");
  EXPECT_EQ(all.at("c").signedUtc_us, all.at("c").passwordShownUtc_us);
  EXPECT_EQ(all.at("b").signedUtc_us - all.at("b").passwordShownUtc_us, 14 * kMinute_us);
  EXPECT_EQ(centre_.audited("signature.give"), 3);
  EXPECT_EQ(centre_.audited("user.sign_in_failed"), 1);
}

TEST_F(Signing, ACentreCanRequireThePasswordForEachSignature) {
  setCentreSetting<kSignMinutes>(centre_.as("administrator"), 0);
  signedIn();

  EXPECT_THROW(signOne("a"), PasswordDue) << "the sign-in is no signature";
  showPassword(centre_.session(), kStudyPassword);
  signOne("a");
  EXPECT_THROW(signOne("b"), PasswordDue);
  showPassword(centre_.session(), kStudyPassword);
  signOne("b");
  EXPECT_TRUE(passwordIsDue(centre_.session()));
  EXPECT_THROW(setCentreSetting<kSignMinutes>(centre_.as("administrator"), 61), Error);
}

TEST_F(Signing, AClockThatWasSetBackAllowsNoSigning) {
  signedIn();
  centre_.passTime_us(-kMinute_us);
  EXPECT_TRUE(passwordIsDue(centre_.session()));
}

TEST_F(Signing, AnAccountOfTheDemonstrationSignsOnlySimulatedObjects) {
  AccessRepository access(centre_.connection(), PasswordCost::kTest);
  access.addUser({.id = "demo", .login = "demo", .demonstration = true, .roles = {"rater"}},
                 access.sealPassword("demo", kStudyPassword));
  access.setPassword("demo", access.sealPassword("demo", kStudyPassword), false);
  ASSERT_EQ(signIn(centre_.as(""), "demo", kStudyPassword).outcome, SignIn::kOk);
  SessionContext& session = centre_.session();
  session.require(Operation::kMarkSubmit);

  EXPECT_THROW(sign(session, {.objectId = "real"}), Error);
  sign(session, {.objectId = "simulated", .demonstration = true});

  EXPECT_EQ(SignatureRepository(centre_.connection()).all(SignedKind::kTrainingMark).size(), 1U);
}

TEST_F(Signing, GuessingWhileSigningHasTheSameDelaysAsSigningIn) {
  signedIn();
  for (int i = 0; i < 4; ++i) {
    EXPECT_THROW(showPassword(centre_.session(), "guess"), Error);
  }
  const Error refused = testing::refusal([&] { showPassword(centre_.session(), kStudyPassword); });
  EXPECT_NE(refused.happened().find("too many failures"), std::string::npos) << "not even tried";
}

}  // namespace

}  // namespace torsio
