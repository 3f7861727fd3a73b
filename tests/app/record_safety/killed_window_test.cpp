// SPDX-License-Identifier: GPL-3.0-or-later
// Interruption of operations that only the window has, on both engines.
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/access/first_run.h"
#include "app/services/access/session_context.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/people/account.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/connection/row_reader.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/digest.h"
#include "sim/core/file_io.h"
#include "tests/app/record_safety/killed_maintenance.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

/// A record that covers all cases, with an administrator.
class KilledWindow : public CutOffMaintenance {
 protected:
  static constexpr const char* kPassword = "four walls and a lamp";
  static constexpr const char* kPerson = "real trainee";

  void SetUp() override {
    if (onPostgresql() && std::getenv("TORSIO_KILL_INSTANTS") == nullptr) {
      GTEST_SKIP() << "makes a database anew each time; TORSIO_KILL_INSTANTS says how often";
    }
    CutOffMaintenance::SetUp();
    if (IsSkipped()) {
      return;
    }
    if (onPostgresql()) {
      const std::string schema = parseLocator(locator()).schema;
      template_ = schema + "_template";
      kept_ = schema + "_kept";
      open().executeVerbatim("CREATE DATABASE " + template_);
      openDatabase(inDatabase(template_), OpenMode::kReadWrite).executeVerbatim("CREATE SCHEMA " + schema);
    }
    Connection made = openRecord(onPostgresql() ? inDatabase(template_) : file("template.sqlite"),
                                 OpenMode::kCreate, {.softwareVersion = "test"});
    fill(made);
    cohort_ = enrolForAllocation(made);
    if (onPostgresql()) {
      everyRow_ = hashOfEveryRow(made);
      asMade_ = textFrom(made, everyRow_);
    }
  }
  void TearDown() override {
    if (!template_.empty()) {
      open().executeVerbatim("DROP DATABASE IF EXISTS " + kept_ + " WITH (FORCE)");
      open().executeVerbatim("DROP DATABASE " + template_);
    }
    CutOffMaintenance::TearDown();
  }
  /// Returns the address of the test's schema in another database of its server.
  [[nodiscard]] std::string inDatabase(const std::string& name) const {
    Locator place = parseLocator(locator());
    place.database = name;
    place.parameters.push_back(kPatient);
    return addressOf(place);
  }
  static void fill(Connection& connection) {
    const FullRecord real(connection, "real", false);
    const FullRecord simulated(connection, "demo", true);
    connection.execute("INSERT INTO person_identity (person_id, full_name) VALUES (?, ?)",
                       {real.traineeId, "Li Na"});
    SettingRepository(connection).set("two_people", "no", 1);
    AccessRepository access(connection, PasswordCost::kTest);
    access.addUser({.id = "u-office", .login = "office", .roles = {"administrator"}}, kPassword);
    access.setPassword("u-office", access.sealPassword("office", kPassword), false);
  }
  /// Six people who wait for a group, behind a locked design. Returns their cohort.
  static CohortId enrolForAllocation(Connection& connection) {
    AccessRepository access(connection, PasswordCost::kTest);
    access.addUser({.id = "u-allocator", .login = "allocator", .roles = {"allocator"}}, kPassword);
    access.setPassword("u-allocator", access.sealPassword("allocator", kPassword), false);
    std::vector<Trainee> trainees(6);
    std::vector<PersonId> people;
    for (Trainee& trainee : trainees) {
      trainee.person.id = "waits " + std::to_string(people.size());
      trainee.person.code = "W-" + std::to_string(people.size());
      people.push_back(trainee.person.id);
    }
    PeopleRepository(connection).addTrainees(trainees);
    SystemIdSource ids;
    SessionContext session(connection, ids, {.station = "room", .actor = {.userId = "u-office"}},
                           [] { return kSampleTime_us; });
    const CohortId cohort = addCohort(session, {.name = "Study", .groups = {{"G1", "one"}, {"G2", "two"}}});
    (void)enrolTrainees(session, cohort, {people.begin(), people.end()});
    session.setActor({.userId = "u-allocator"});
    (void)lockAllocation(session, {.cohortId = cohort});
    return cohort;
  }
  [[nodiscard]] std::string target() const {
    return onPostgresql() ? inDatabase(kept_) : file("kept.sqlite");
  }
  [[nodiscard]] std::int64_t ask(const std::string& sql) const {
    Connection record = openDatabase(target(), OpenMode::kReadWrite);
    return numberFrom(record, sql);
  }
  /// Hashes all rows in one query: on a server each query takes time.
  static std::string hashOfEveryRow(Connection& connection) {
    std::string rows;
    for (const std::string& table : selectAll(
             connection, "SELECT tablename FROM pg_tables WHERE schemaname = current_schema() ORDER BY 1", {},
             readText)) {
      rows += (rows.empty() ? "SELECT '" : " UNION ALL SELECT '") + table +
              "' || count(*) || '/' || coalesce(sum(hashtextextended(t::text, 0)), 0) AS h FROM " + table +
              " t";
    }
    return "SELECT md5(string_agg(h, ',' ORDER BY h)) FROM (" + rows + ") AS every";
  }
  static std::string textFrom(Connection& connection, const std::string& sql) {
    return selectFirst(connection, sql, {}, readText).value_or("");
  }
  /// Creates an empty schema in an empty database of the server.
  void emptyServer() const {
    open().executeVerbatim("DROP DATABASE IF EXISTS " + kept_ + " WITH (FORCE)");
    open().executeVerbatim("CREATE DATABASE " + kept_);
    openDatabase(target(), OpenMode::kReadWrite)
        .executeVerbatim("CREATE SCHEMA " + parseLocator(target()).schema);
  }
  /// Restores the initial record, unless `done` shows that the server's is unchanged.
  void makeAnew(const std::function<bool()>& done) const {
    if (!onPostgresql()) {
      removeDatabase(file("kept.sqlite"));
      fs::copy_file(file("template.sqlite"), file("kept.sqlite"));
      return;
    }
    if (made_ && !done()) {
      return;
    }
    open().executeVerbatim("DROP DATABASE IF EXISTS " + kept_ + " WITH (FORCE)");
    open().executeVerbatim("CREATE DATABASE " + kept_ + " TEMPLATE " + template_ + " STRATEGY FILE_COPY");
    made_ = true;
  }
  /// Describes an operation of window_act, how to tell that it is `done`, and what must hold afterwards.
  [[nodiscard]] CutOff act(
      const std::vector<std::string>& words, const std::function<bool()>& done,
      const std::function<void(Connection&)>& after, const std::function<void()>& before = [] {}) const {
    const char* login = words.at(0) == "allocate" ? "allocator" : "office";
    std::vector<std::string> arguments{words.at(0), target(), login, kPassword};
    arguments.insert(arguments.end(), words.begin() + 1, words.end());
    return {.arguments = arguments,
            .before =
                [this, done, before] {
                  makeAnew(done);
                  before();
                },
            .after =
                [this, after] {
                  Connection record = onPostgresql() ? openDatabase(target(), OpenMode::kReadWrite)
                                                     : openRecord(target(), OpenMode::kReadWrite);
                  bool asMade = false;
                  if (onPostgresql()) {  // wait until what the killed program sent has been processed
                    const Transaction waits(record);
                    record.executeVerbatim("LOCK TABLE person IN ACCESS EXCLUSIVE MODE");
                    asMade = textFrom(record, everyRow_) == asMade_;
                  }
                  EXPECT_TRUE(asMade || isSound(record));
                  after(record);
                },
            .done = done,
            .program = TORSIO_WINDOW_ACT};
  }
  void cutOff(const CutOff& cut) const {
    killEverywhere(cut);
    if (!onPostgresql()) {
      fillDiskEverywhere(cut);
    }
  }

  CohortId cohort_;  // of people who wait for a group

 private:
  std::string template_;  // database names on the server
  std::string kept_;
  std::string everyRow_;
  std::string asMade_;
  mutable bool made_ = false;
};

TEST_F(KilledWindow, APersonIsErasedCompletelyOrNotAtAll) {
  const auto number = [](Connection& record, const std::string& sql) {
    return numberFrom(record, sql + "'" + kPerson + "'");
  };
  cutOff(act(
      {"erase", kPerson},
      [this] {
        return ask("SELECT count(*) FROM person WHERE state = 'erased' AND id = 'real trainee'") > 0;
      },
      [&number](Connection& record) {
        const std::int64_t erased =
            number(record, "SELECT count(*) FROM person WHERE state = 'erased' AND id = ");
        EXPECT_EQ(number(record, "SELECT count(*) FROM person WHERE id = "), 1);
        EXPECT_EQ(number(record, "SELECT count(*) FROM person_identity WHERE person_id = "), 1 - erased);
        EXPECT_EQ(number(record, "SELECT count(*) FROM erasure WHERE person_id = "), erased);
        EXPECT_EQ(
            number(record, "SELECT count(*) FROM audit_entry WHERE action = 'person.erase' AND object_id = "),
            erased);
      }));
}

TEST_F(KilledWindow, TheDemonstrationIsRemovedCompletelyOrNotAtAll) {
  const auto people = [](Connection& record, const char* which) {
    return numberFrom(record, std::string("SELECT count(*) FROM person WHERE demonstration = ") + which);
  };
  std::int64_t real = 0;
  cutOff(act(
      {"remove-demonstration"},
      [this] { return ask("SELECT count(*) FROM person WHERE demonstration = TRUE") == 0; },
      [&](Connection& record) {
        const std::int64_t removed =
            numberFrom(record, "SELECT count(*) FROM audit_entry WHERE action = 'demonstration.remove'");
        EXPECT_EQ(people(record, "TRUE") == 0, removed == 1);
        real = real == 0 ? people(record, "FALSE") : real;
        EXPECT_EQ(people(record, "FALSE"), real);
      }));
}

TEST_F(KilledWindow, EverybodyIsAllocatedOrNobody) {
  const std::string allocated =
      "SELECT count(*) FROM allocation a JOIN enrolment e ON e.id = a.enrolment_id"
      " WHERE e.cohort_id = '" +
      cohort_.text() + "'";
  cutOff(act(
      {"allocate", cohort_}, [this, allocated] { return ask(allocated) > 0; },
      [&](Connection& record) {
        const std::int64_t drawn = numberFrom(record, allocated);
        EXPECT_TRUE(drawn == 0 || drawn == 6) << drawn;
        EXPECT_EQ(
            numberFrom(record, "SELECT count(*) FROM enrolment WHERE group_id IS NOT NULL AND cohort_id = '" +
                                   cohort_.text() + "'"),
            drawn);
        EXPECT_EQ(numberFrom(record, "SELECT count(*) FROM audit_entry WHERE action = 'allocation.draw'"),
                  drawn);
      }));
}

TEST_F(KilledWindow, ANewSchemaIsReachedStepByStepOrLater) {
  const auto oldRecord = [this] {
    if (onPostgresql()) {
      emptyServer();
    } else {
      removeDatabase(file("kept.sqlite"));
    }
    Connection old = openDatabase(target(), OpenMode::kCreate);
    migrate(old, {embeddedMigrations().front()}, {.softwareVersion = "test", .backup = false});
  };
  const auto version = [this] {
    Connection record = openDatabase(target(), OpenMode::kReadWrite);
    return checkSchema(record, embeddedMigrations()).version;
  };
  const std::int64_t newest = embeddedMigrations().back().version;
  CutOff cut{.arguments = {"open", target(), "office", kPassword},
             .before = oldRecord,
             .after =
                 [&] {
                   const std::int64_t reached = version();
                   EXPECT_TRUE(reached >= 1 && reached <= newest) << reached;
                   if (reached == newest) {
                     Connection record = openDatabase(target(), OpenMode::kReadWrite);
                     EXPECT_TRUE(isSound(record));
                   }
                 },
             .program = TORSIO_WINDOW_ACT};
  killEverywhere(cut);
}

TEST_F(KilledWindow, AFirstRunWithSimulatedPeopleIsCompleteOrUndone) {
  if (std::getenv("TORSIO_KILL_INSTANTS") == nullptr) {
    GTEST_SKIP() << "takes a minute; TORSIO_KILL_INSTANTS says how many";
  }
  const fs::path folder = folder_ / "centre";
  const std::string record = onPostgresql() ? target() : (folder / "record.sqlite").string();
  std::set<std::int64_t> whole;
  const auto expectAllOrNothing = [&whole](const std::string& place) {
    if (lookAtRecord(place) != RecordPlace::kCentre) {
      if (onPostgresql() || fs::exists(place)) {
        Connection nobody = openDatabase(place, OpenMode::kReadOnly);
        EXPECT_TRUE(checkSchema(nobody, embeddedMigrations()).version == 0 || personIn(nobody).empty());
      }
      return;
    }
    Connection centre = openRecord(place, OpenMode::kReadOnly);
    EXPECT_TRUE(isSound(centre));
    EXPECT_EQ(numberFrom(centre, "SELECT count(*) FROM app_user"), 1);
    whole.insert(numberFrom(centre, "SELECT count(*) FROM person") +
                 1000 * numberFrom(centre, "SELECT count(*) FROM trial_end"));
  };
  CutOff cut{.arguments = {"first-run", record, "office", kPassword},
             .before =
                 [&] {
                   if (!onPostgresql()) {
                     fs::remove_all(folder);
                     fs::create_directory(folder);
                     return;
                   }
                   emptyServer();
                 },
             .after = [&] { expectAllOrNothing(record); },
             .done = [&] { return lookAtRecord(record) == RecordPlace::kCentre; },
             .program = TORSIO_WINDOW_ACT,
             .atMost = 12};
  killEverywhere(cut);

  lookEverywhere(cut, [&] {
    if (onPostgresql()) {
      expectAllOrNothing(record);
      return;
    }
    const fs::path seen = folder_ / "seen";
    fs::remove_all(seen);
    fs::copy(folder, seen, fs::copy_options::recursive);
    expectAllOrNothing((seen / "record.sqlite").string());
  });

  EXPECT_EQ(whole.size(), 1U) << "every whole demonstration has as many people and recordings";
}

TEST_F(KilledWindow, APackageIsCompleteOrMissing) {
  if (onPostgresql()) {
    GTEST_SKIP() << "what it writes does not depend on the engine";
  }
  const fs::path package = folder_ / "package";
  cutOff(act(
      {"package", kPerson, package.string()}, [&package] { return fs::exists(package); },
      [&package](Connection& record) {
        if (!fs::exists(package)) {
          return;
        }
        for (const auto& one : nlohmann::json::parse(readFile(package / "manifest.json")).at("files")) {
          Digest digest;
          digest.update(std::string_view(readFile(package / one.at("file").get<std::string>())));
          EXPECT_EQ(digest.hex(), one.at("blake2b_256")) << one;
        }
        EXPECT_EQ(numberFrom(record, "SELECT count(*) FROM record_copy WHERE kind = 'package' AND place = '" +
                                         package.string() + "'"),
                  1);
      },
      [&package] { fs::remove_all(package); }));
  expectNothingHalf();
}

}  // namespace
}  // namespace torsio
