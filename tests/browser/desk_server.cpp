// SPDX-License-Identifier: GPL-3.0-or-later
// The real review desk with a centre of fictitious people, for browser tests: prints its port and an
// invitation of "physician1", and ends with its standard input. Commands on standard input: a number: the
// first physician edits the draft at the desk; "release": trainees see marks and remarks; "answers": prints
// the replies that the first physician sees at the desk. `desk_server SCENE PATTERN`: organ and pattern of
// the recordings; TORSIO_PUBLIC_URL in the environment: the proxy in front of it.
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <QCoreApplication>

#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "app/services/base/assets.h"
#include "app/services/review/case_remarks.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/rater_calibration.h"
#include "app/services/review/review_queue.h"
#include "app/services/study/scoring_plan.h"
#include "app/web/http_server.h"
#include "app/web/web_desk.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/rating/campaign.h"
#include "db/connection/row_reader.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/scene/scene.h"
#include "tests/app/support/review_centre.h"

namespace {

using namespace torsio;

/// Formats "50 65 -": the rows of a sheet and the overall mark.
std::string marksOf(const Sheet& sheet) {
  const auto said = [](const auto& steps) { return steps ? std::to_string(*steps) : std::string("-"); };
  std::string marks;
  for (const char* code : {"time", "accuracy"}) {
    const auto row = std::find_if(sheet.rows.begin(), sheet.rows.end(),
                                  [code](const SheetRow& one) { return one.code == code; });
    marks += (row == sheet.rows.end() ? "-" : said(row->score_steps)) + " ";
  }
  return marks + said(sheet.overall_steps);
}

/// The physician of `session` opens their draft, gives its second row this mark and saves. Prints the marks
/// before and after.
void goOnAtTheDesk(SessionContext& session, std::int64_t steps) {
  for (const QueueLine& line : reviewQueue(session).lines) {
    if (line.state != SheetState::kDraft) {
      continue;
    }
    OpenedSheet opened = openSheet(session, line.shown.assignmentId);
    std::cout << marksOf(opened.sheet) << "\n";
    std::erase_if(opened.sheet.rows, [](const SheetRow& row) { return row.code == "accuracy"; });
    opened.sheet.rows.push_back({"accuracy", steps, ""});
    (void)saveSheet(session, line.shown.assignmentId, opened.sheet, opened.watched);
    std::cout << marksOf(openSheet(session, line.shown.assignmentId).sheet) << std::endl;
    return;
  }
  std::cout << "no draft\nno draft" << std::endl;
}

/// Releases the marks of all occasions to the trainees, even if incomplete.
void releaseAll(SessionContext& session, const std::string& cohort) {
  for (const ReleaseState& state : releaseStates(session, cohort)) {
    if (!state.released) {
      releaseMarks(session, cohort, state.occasion.code, "asked for by a test");
    }
  }
  std::cout << "released" << std::endl;
}

/// Prints trainees' replies to the remarks of `session` in one line.
void tellAnswers(SessionContext& session) {
  for (const RemarkReply& reply : repliesToMe(session)) {
    std::cout << reply.remark << " > " << reply.text << "; ";
  }
  std::cout << std::endl;
}

/// Creates a centre whose live cases are still to be called, for a day that is played by `torsio serve`.
/// Prints its address and keeps it until the input ends. `locator` empty: in a file.
int prepareDay(const std::string& locator) {
  testing::ReviewCentre centre({.raters = 10,
                                .trainees = 3,
                                .trial_s = 0.5,
                                .live = true,
                                .liveOccasions = {"pre", "mid", "post"},
                                .called = false,
                                .locator = locator});
  AccessRepository access(centre.connection(), PasswordCost::kTest);
  for (const UserAccount& user : access.users()) {
    access.setPassword(user.id, access.sealPassword(user.login, "correct horse battery"), false);
  }
  std::cout << centre.locator() << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc > 1 && std::string(argv[1]) == "--day") {
    return prepareDay(argc > 2 ? argv[2] : "");
  }
  SceneRequest organ;
  organ.assets = assetsFolder();
  organ.id = argc > 1 ? argv[1] : "forearm";
  organ.pattern = argc > 2 ? argv[2] : "";
  const Scene scene = loadScene(organ);
  testing::ReviewCentre centre({.raters = 2, .trainees = 3, .trial_s = 6.0, .live = true, .scene = &scene});
  AccessRepository access(centre.connection(), PasswordCost::kTest);
  for (const UserAccount& user : access.users()) {
    access.setPassword(user.id, access.sealPassword(user.login, "correct horse battery"), false);
  }
  const std::string trainee =
      selectFirst(centre.connection(), "SELECT person_id FROM trainee", {}, [](RowReader& row) {
        return row.text();
      }).value();
  access.addUser({.id = "u-apprentice", .login = "apprentice", .personId = trainee, .roles = {"trainee"}},
                 "correct horse battery");
  access.setPassword("u-apprentice", access.sealPassword("apprentice", "correct horse battery"), false);
  addReferenceRuns(*centre.administrator(),
                   {{centre.trialIds()[0], centre.rubricRevisionId(), 6.2, 8, false}});
  Campaign campaign;
  campaign.id = "campaign";
  campaign.name = "Two models";
  campaign.instrument = paperInstrument();
  campaign.instrument.classes = {{"chief", "chief physicians", 1000}};
  campaign.models = {{"PM", "proposed model", "K", 1, centre.trialIds()[0]},
                     {"FEM", "finite elements", "M", 2, {}}};
  campaign.raters = {{centre.raterId(0), "chief", "PM,FEM"}};
  EvaluationRepository(centre.connection()).addCampaign(campaign);
  SettingRepository(centre.connection()).set(kTwoPeople.name, "no", 0);
  // Uses the server's clock: the centre's is frozen.
  SessionContext inviting({centre.locator(), "station", centre.administrator()->actor()});
  const std::vector<UserId> invited{centre.physician(1)->actor().userId};
  const std::string secret = invite(inviting, invited).at(0).secret;
  web::WebDesk desk({.locator = centre.locator(),
                     .assets = assetsFolder(),
                     .publicUrl = qEnvironmentVariable("TORSIO_PUBLIC_URL").toStdString(),
                     .workers = 2,
                     .passwordCost = PasswordCost::kTest});
  const web::HttpServer server({"127.0.0.1", 0}, {}, {},
                               [&desk](web::HttpRequest request, web::HttpServer::Reply reply) {
                                 desk.handle(std::move(request), std::move(reply));
                               });
  std::cout << server.port() << "\n" << secret << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    const auto physician = centre.physician(0);
    SessionContext session({centre.locator(), "station", physician->actor()});
    if (line == "release") {
      SessionContext office({centre.locator(), "station", centre.administrator()->actor()});
      releaseAll(office, selectFirst(centre.connection(), "SELECT id FROM cohort", {}, [](RowReader& row) {
                           return row.text();
                         }).value());
    } else if (line == "answers") {
      tellAnswers(session);
    } else {
      goOnAtTheDesk(session, std::stoll(line));
    }
  }
  return 0;
}
