// SPDX-License-Identifier: GPL-3.0-or-later
// Registered competence designs: who may register them, whom they apply to, and the default.
#include <algorithm>

#include <gtest/gtest.h>

#include "app/services/recording/competence_service.h"
#include "app/services/recording/competence_text.h"
#include "app/services/training/transcript.h"
#include "app/services/training/trend.h"
#include "db/repository/people/access_repository.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "tests/app/support/training_centre.h"

namespace torsio {
namespace {

using testing::kMinute_us;
using testing::TrainingCentre;

constexpr double kExpertSkill = 1.0;

/// Signs in a user who may edit curricula.
SessionContext& asAdministrator(TrainingCentre& centre) {
  const UserId id = "the administrator";
  AccessRepository access(centre.connection(), PasswordCost::kTest);
  const auto users = access.users();
  if (std::none_of(users.begin(), users.end(), [&](const UserAccount& user) { return user.id == id; })) {
    access.addUser({.id = id, .login = "admin", .roles = {"administrator"}}, "a long enough password");
  }
  centre.session().setActor({.userId = id, .login = "admin", .roles = {"administrator"}});
  return centre.session();
}

CompetenceDesign stricter(TrainingCentre& centre) {
  CompetenceDesign design;
  design.moduleId = centre.module("first");
  design.inadequate = 0.4;
  design.attempts = 30;
  return design;
}

TEST(CompetenceDesigns, ApplyToTraineesWhoStartAfterTheirRegistration) {
  TrainingCentre centre;
  centre.attempt("first", "practice", kExpertSkill);  // T-01 starts before
  centre.passTime_us(kMinute_us);
  const CompetenceDesign stored = registerCompetence(asAdministrator(centre), stricter(centre));
  EXPECT_EQ(stored.version, 1);
  EXPECT_EQ(stored.limit, 4.06);  // as calculated by an independent program
  EXPECT_DOUBLE_EQ(stored.tolerance_rad, radians(5.0));
  centre.passTime_us(kMinute_us);

  centre.become("T-01");
  const CompetenceVerdict before =
      trend(centre.session(), centre.person(), centre.module("first")).competence;
  EXPECT_EQ(before.design.version, 0);
  const std::string rule = competenceRuleText(before).str();
  EXPECT_NE(rule.find("none was registered"), std::string::npos);
  EXPECT_NE(rule.find("with a force of at most 6.00 N, in a run that was finished"), std::string::npos)
      << rule;
  centre.become("T-02");
  const CompetenceVerdict shown = trend(centre.session(), centre.person(), centre.module("first")).competence;
  EXPECT_EQ(shown.design, stored);  // even before the first attempt
  centre.attempt("first", "practice", kExpertSkill);
  const Transcript paper = transcript(centre.session(), centre.person());
  EXPECT_EQ(paper.modules.front().competence.design, stored);
  EXPECT_EQ(paper.modules.front().competence.errors.attempts, 30);
}

TEST(CompetenceDesigns, AreRefusedToTraineesAndIfTheyMissTheirErrorRates) {
  TrainingCentre centre;
  EXPECT_THROW((void)registerCompetence(centre.session(), stricter(centre)), Error);
  SessionContext& session = asAdministrator(centre);
  CompetenceDesign weak = stricter(centre);
  weak.inadequate = 0.2;  // two thirds of the competent would fail
  EXPECT_THROW((void)registerCompetence(session, weak), Error);
  CompetenceDesign chosen = stricter(centre);
  chosen.source = ToleranceSource::kChosen;
  chosen.tolerance_rad = radians(3.0);
  EXPECT_THROW((void)registerCompetence(session, chosen), Error);  // no reason
  chosen.reason = "as agreed in the house";
  EXPECT_EQ(registerCompetence(session, chosen).version, 1);
  CompetenceDesign nowhere = stricter(centre);
  nowhere.moduleId = "nowhere";
  EXPECT_THROW((void)registerCompetence(session, nowhere), Error);
  session.beginCall();
  const std::vector<ExerciseDesigns> all = competenceDesigns(session);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].registered.size(), 1U);
  EXPECT_TRUE(all[1].registered.empty());
  session.beginCall();
  EXPECT_THROW((void)expertTolerance_deg(session, centre.module("first"), centre.cohort().id), Error);
}

}  // namespace
}  // namespace torsio
