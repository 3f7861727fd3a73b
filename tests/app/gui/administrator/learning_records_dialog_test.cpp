// SPDX-License-Identifier: GPL-3.0-or-later
// Learning records in the window: enabled, sent, rejected, retried.
#include "app/gui/administrator/station/learning_records_dialog.h"

#include <QCheckBox>
#include <QSettings>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "assessment/domain/people/learning_event.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/study_repository.h"
#include "tests/app/gui/support/maintenance_window.h"
#include "tests/support/test_lrs.h"

namespace torsio::gui {
namespace {

using torsio::testing::TestLrs;

class LearningPages : public MaintenancePages {
 protected:
  void SetUp() override {
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       folder_.path() + QStringLiteral("/settings"));
    MaintenancePages::SetUp();
  }
  /// Enrols somebody who has consented.
  void enrolSomebody() {
    Connection& connection = window_->session()->connectionWithoutRight();
    const PersonId who = PeopleRepository(connection).trainees().front().person.id;
    PeopleRepository(connection)
        .recordConsent({.personId = who,
                        .purpose = kLearningConsent,
                        .granted = true,
                        .textVersion = "1",
                        .recordedBy = "office"});
    StudyRepository studies(connection);
    studies.addCohort({"course", "Autumn course", "", 1, false}, {});
    const Enrolment enrolment{
        .id = "enrolment", .cohortId = "course", .traineeId = who, .enrolledUtc_us = 1'763'712'000'000'000};
    studies.enrol({&enrolment, 1});
  }
};

TEST_F(LearningPages, AreEnabledSentRejectedAndRetried) {
  TestLrs store;
  window_->desk()->open(PageId::kDevices);
  EXPECT_TRUE(child<QPushButton>(*window_->desk()->page(), "learningRecordsButton").isEnabled());
  LearningRecordsDialog dialog(context(), window_.get());
  EXPECT_FALSE(child<QCheckBox>(dialog, "lrsOn").isChecked()) << "off until somebody turns it on";
  EXPECT_FALSE(child<QPushButton>(dialog, "lrsSend").isEnabled());

  child<QCheckBox>(dialog, "lrsOn").setChecked(true);
  child<QLineEdit>(dialog, "lrsEndpoint").setText(QStringLiteral("http://lrs.example.org/xapi"));
  child<QLineEdit>(dialog, "lrsHomePage").setText(QStringLiteral("https://skills.example.org"));
  child<QPushButton>(dialog, "lrsKeep").click();
  EXPECT_EQ(failures_.size(), 1) << "elsewhere in the clear";
  child<QLineEdit>(dialog, "lrsEndpoint").setText(toQString(store.endpoint()));
  child<QPushButton>(dialog, "lrsKeep").click();
  child<QLineEdit>(dialog, "lrsUser").setText(QString::fromLatin1(TestLrs::kUser));
  child<QLineEdit>(dialog, "lrsSecret").setText(QString::fromLatin1(TestLrs::kSecret));
  child<QPushButton>(dialog, "lrsSetKey").click();
  EXPECT_TRUE(child<QLineEdit>(dialog, "lrsSecret").text().isEmpty());
  EXPECT_TRUE(child<QLabel>(dialog, "lrsKeyText").text().contains(QStringLiteral("has a key")));
  EXPECT_EQ(failures_.size(), 1);

  store.become(TestLrs::Fault::kRefuses);
  enrolSomebody();
  child<QPushButton>(dialog, "lrsKeep").click();
  EXPECT_TRUE(child<QLabel>(dialog, "lrsState").text().startsWith(QStringLiteral("Waiting: 1")));
  child<QPushButton>(dialog, "lrsSend").click();
  context().waitForJobs();
  QCoreApplication::processEvents();
  auto& dead = child<DataTable>(dialog, "deadLetters");
  EXPECT_EQ(dead.visibleRows(), 0) << "the store has taken nothing yet: it may refuse everything";
  EXPECT_TRUE(child<QLabel>(dialog, "lrsState")
                  .text()
                  .contains(QStringLiteral("HTTP 400 this statement does not please")));

  store.become(TestLrs::Fault::kNone);
  child<QPushButton>(dialog, "lrsRetry").click();
  EXPECT_EQ(dead.visibleRows(), 0);
  child<QPushButton>(dialog, "lrsSend").click();
  context().waitForJobs();
  QCoreApplication::processEvents();
  EXPECT_TRUE(child<QLabel>(dialog, "lrsState").text().contains(QStringLiteral("delivered: 1")));
  EXPECT_EQ(store.stored().size(), 1U);
  EXPECT_TRUE(store.complaints().empty());
  EXPECT_EQ(failures_.size(), 1);
}

}  // namespace
}  // namespace torsio::gui
