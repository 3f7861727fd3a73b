// SPDX-License-Identifier: GPL-3.0-or-later
// What the window knows about pages and rights without the database.
#include <set>

#include <gtest/gtest.h>

#include "app/gui/base/page.h"
#include "app/gui/program/window_main.h"
#include "sim/core/error.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;

TEST(RightsOfTheWindow, StayAsReadWhileServicesCheckAgain) {
  AdministratorDesk office;
  SessionContext& session = office.centre.as("administrator");
  ASSERT_TRUE(office.shell().may(Operation::kUserManage));

  office.centre.connection().execute("DELETE FROM role_operation WHERE operation_code = ?",
                                     {std::string(operationCode(Operation::kUserManage))});

  EXPECT_TRUE(office.shell().may(Operation::kUserManage));
  EXPECT_THROW(session.require(Operation::kUserManage), Error);
  office.shell().readRights();
  EXPECT_FALSE(office.shell().may(Operation::kUserManage));
}

TEST(RightsOfTheWindow, AreThoseOfTheSignedInUser) {
  AdministratorDesk office;
  office.centre.as("administrator");
  ASSERT_TRUE(office.shell().may(Operation::kUserManage));

  office.centre.as("statistician");

  EXPECT_FALSE(office.shell().may(Operation::kUserManage));
  EXPECT_TRUE(office.shell().may(Operation::kResultsCompute));
}

TEST(PageTable, ContainsEveryPageOnceWithAUniqueName) {
  std::set<PageId> ids;
  std::set<QString> texts;

  for (const PageGroup& group : allPages()) {
    for (const PageEntry& entry : group.pages) {
      EXPECT_TRUE(ids.insert(entry.id).second) << pageText(entry.id).toStdString();
      EXPECT_TRUE(texts.insert(pageText(entry.id)).second) << pageText(entry.id).toStdString();
      EXPECT_FALSE(pageTitle(entry.id).isEmpty());
    }
  }

  EXPECT_EQ(ids.size(), static_cast<std::size_t>(PageId::kDevices) + 1);  // last entry of the table
}

}  // namespace
}  // namespace torsio::gui
