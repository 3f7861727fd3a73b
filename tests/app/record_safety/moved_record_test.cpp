// SPDX-License-Identifier: GPL-3.0-or-later
// A copied record leaves two: each one's register of copies, and thus an erase, names the other.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/session_context.h"
#include "app/services/maintenance/copies.h"
#include "assessment/domain/people/account.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "tests/app/record_safety/killed_maintenance.h"

namespace torsio {
namespace {

class MovedRecord : public CutOffMaintenance {
 protected:
  void SetUp() override {
    CutOffMaintenance::SetUp();
    if (IsSkipped()) {
      return;
    }
    target_ = onPostgresql() ? addressWithoutPassword() : file("moved.sqlite");
    Connection connection = openRecord(record(), OpenMode::kReadWrite);
    AccessRepository access(connection, PasswordCost::kTest);
    access.addUser({.id = "u-office", .login = "office", .roles = {kAdministratorRole}},
                   "four walls and a lamp");
  }
  [[nodiscard]] std::string record() const { return file("record.sqlite"); }
  [[nodiscard]] test::ProgramRun copy(const std::string& to) const {
    return run({"db", "copy", "--as-system", record(), to});
  }
  [[nodiscard]] static std::vector<std::string> placesKnownAt(const std::string& locator) {
    std::vector<std::string> places;
    for (const ListedCopy& listed : copiesOf(locator)) {
      if (listed.copy.kind == CopyKind::kMoved) {
        places.push_back(listed.copy.place);
      }
    }
    return places;
  }
  /// Returns the places that an erase at `locator` names.
  [[nodiscard]] static std::vector<std::string> namedByErase(const std::string& locator) {
    Connection connection = openRecord(locator, OpenMode::kReadWrite);
    SystemIdSource ids;
    Actor actor{.userId = "u-office", .login = "office"};
    actor.roles = {kAdministratorRole};
    SessionContext session(connection, ids, {locator, "room", actor}, utcNow_us);
    session.beginCall();
    std::vector<std::string> places;
    for (const ListedCopy& listed : copiesHolding(session, personIn(connection))) {
      places.push_back(listed.copy.place);
    }
    return places;
  }
  static bool has(const std::vector<std::string>& places, const std::string& place) {
    return std::find(places.begin(), places.end(), place) != places.end();
  }

  std::string target_;
};

TEST_F(MovedRecord, EachEndNamesTheOtherAndNotItself) {
  ASSERT_EQ(copy(target_).code, 0);
  const std::string there = parseLocator(target_).shown();

  EXPECT_EQ(placesKnownAt(record()), std::vector<std::string>{there});
  EXPECT_EQ(placesKnownAt(target_), std::vector<std::string>{record()});
  EXPECT_TRUE(has(namedByErase(target_), record())) << "the record that was left behind holds everybody";
  EXPECT_TRUE(has(namedByErase(record()), there));
  const test::ProgramRun listed = run({"db", "copies", "--database", target_});
  EXPECT_NE(listed.out.find("record before or after a move"), std::string::npos) << listed.out << listed.err;

  EXPECT_EQ(copy(target_).code, static_cast<int>(ErrorCode::kBadData)) << "a record is there already";
  EXPECT_EQ(placesKnownAt(record()), std::vector<std::string>{there}) << "which is still there";
  Connection moved = openRecord(target_, OpenMode::kReadWrite);
  EXPECT_TRUE(isSound(moved));
}

TEST_F(MovedRecord, ACancelledMoveIsNotListed) {
  if (onPostgresql()) {
    GTEST_SKIP() << "what is given up does not depend on the engine";
  }
  EXPECT_NE(copy(file("nowhere/moved.sqlite")).code, 0);
  EXPECT_TRUE(placesKnownAt(record()).empty());
}

}  // namespace
}  // namespace torsio
