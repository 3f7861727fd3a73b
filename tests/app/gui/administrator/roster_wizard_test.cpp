// SPDX-License-Identifier: GPL-3.0-or-later
// The roster wizard with its real buttons, from the file to the people in the record.
#include "app/gui/administrator/people/roster_wizard.h"

#include <filesystem>

#include <QAbstractButton>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QRadioButton>

#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/people/people_service.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {
namespace {

namespace fs = std::filesystem;
using testing::AdministratorDesk;

/// The wizard on its first page, with a file of this text.
class RosterWizardTest : public ::testing::Test {
 protected:
  void SetUp() override { office.centre.as("administrator"); }

  RosterWizard& open(const std::string& text, bool raters = false) {
    const fs::path file = office.centre.folder() / "roster.csv";
    writeFileAtomically(file, text);
    wizard = std::make_unique<RosterWizard>(office.shell());
    wizard->restart();
    wizard->show();
    wizard->findChild<QLineEdit*>(QStringLiteral("path"))->setText(toQString(file));
    for (QRadioButton* kind : wizard->findChildren<QRadioButton*>()) {
      if ((kind->text() == QStringLiteral("&Raters")) == raters) {
        kind->setChecked(true);
      }
    }
    return *wizard;
  }
  void next() {
    ASSERT_TRUE(wizard->button(QWizard::NextButton)->isEnabled());
    wizard->button(QWizard::NextButton)->click();
    office.shell().waitForJobs();
  }
  void choose(RosterField field, const char* column) {
    auto* box =
        wizard->currentPage()->findChild<QComboBox*>(QString::fromLatin1(rosterFieldCode(field).data()));
    ASSERT_NE(box, nullptr);
    box->setCurrentIndex(box->findText(QString::fromLatin1(column)));
  }
  DataTable& lines() { return *wizard->currentPage()->findChild<DataTable*>(); }
  QAbstractButton& import() { return *wizard->button(QWizard::FinishButton); }
  std::size_t known() { return torsio::people(office.centre.session()).size(); }

  AdministratorDesk office;
  std::unique_ptr<RosterWizard> wizard;
};

TEST_F(RosterWizardTest, ImportsAFileWithColumnsChosenByHand) {
  open("Kennung;Wer;Geschlecht\nS-1;Ann Smith;f\nS-2;Bo Chen;m\nS-3;Cy Diaz;m\n");

  next();
  EXPECT_FALSE(wizard->button(QWizard::NextButton)->isEnabled()) << "the headers tell nothing yet";
  choose(RosterField::kExternalId, "Kennung");
  choose(RosterField::kFullName, "Wer");
  choose(RosterField::kSex, "Geschlecht");
  next();
  ASSERT_EQ(lines().visibleRows(), 3);
  ASSERT_EQ(known(), 0U) << "the dry run leaves nothing behind";
  ASSERT_TRUE(import().isEnabled());
  import().click();
  office.shell().waitForJobs();

  EXPECT_EQ(wizard->result(), QDialog::Accepted);
  ASSERT_TRUE(wizard->outcome().has_value());
  EXPECT_EQ(wizard->outcome()->added, 3U);
  const auto named = namedPeople(office.centre.session());
  ASSERT_EQ(named.size(), 3U);
  for (const NamedPersonRow& one : named) {
    EXPECT_EQ(one.row.person.sex, one.identity.externalId == "S-1" ? "female" : "male");
  }
  EXPECT_EQ(office.centre.audited("roster.import"), 1);
}

TEST_F(RosterWizardTest, AFileOfRatersIsDetectedBeforeTheyBecomeTrainees) {
  open("Staff number,Full name,Class\nC-1,Ann Smith,chief physician\n");
  next();
  auto& hint = child<QLabel>(*wizard, "rosterHint");
  EXPECT_FALSE(hint.isHidden());
  EXPECT_TRUE(hint.text().contains(QStringLiteral("The column Class"))) << hint.text().toStdString();
  wizard->button(QWizard::CancelButton)->click();

  open("Staff number,Full name,Sex\nS-1,Bo Chen,m\n");
  next();
  EXPECT_TRUE(child<QLabel>(*wizard, "rosterHint").isHidden());
}

TEST_F(RosterWizardTest, ImportsNothingIfAnyLineIsWrongAndSaysWhatToCorrect) {
  open("Staff ID,Name,Age\nS-1,Ann Smith,24\nS-2,,25\nS-1,Twice,26\nS-4,Old,250\n");

  next();
  next();

  EXPECT_FALSE(import().isEnabled());
  const QString shown = lines().asText();
  EXPECT_TRUE(shown.contains(QStringLiteral("Full name is missing")) &&
              shown.contains(QStringLiteral("is already on line 2")) &&
              shown.contains(QStringLiteral("not a plausible age")))
      << shown.toStdString();
  wizard->button(QWizard::CancelButton)->click();
  EXPECT_EQ(known(), 0U);
  EXPECT_EQ(office.centre.audited("roster.import"), 0);
}

TEST_F(RosterWizardTest, ACorrectedFileKeepsItsColumnsAndEmptyOrDuplicateLinesAreNoObstacle) {
  open("Kennung;Wer;Jahre;Bemerkung\nS-1;Ann Smith;24;erste\nS-2;Bo Chen;250;zweite\n");
  next();
  EXPECT_TRUE(lines().asText().contains(QStringLiteral("Bemerkung"))) << "every column of the file is shown";
  EXPECT_TRUE(lines().asText().contains(QStringLiteral("zweite")));
  choose(RosterField::kExternalId, "Kennung");
  choose(RosterField::kFullName, "Wer");
  choose(RosterField::kAge, "Jahre");
  next();
  EXPECT_FALSE(import().isEnabled()) << "an age of 250";
  wizard->button(QWizard::CancelButton)->click();

  open(
      "Kennung;Wer;Jahre;Bemerkung\nS-1;Ann Smith;24;erste\n;;;\nS-2;Bo Chen;25;zweite\nS-2;Bo "
      "Chen;25;zweite\n");
  next();
  ASSERT_TRUE(wizard->button(QWizard::NextButton)->isEnabled()) << "the choices are remembered";
  next();
  ASSERT_TRUE(import().isEnabled()) << lines().asText().toStdString();
  import().click();
  office.shell().waitForJobs();

  EXPECT_EQ(wizard->outcome()->added, 2U);
  for (const NamedPersonRow& one : namedPeople(office.centre.session())) {
    EXPECT_EQ(one.row.person.age_years, one.identity.externalId == "S-1" ? 24 : 25);
  }
}

TEST_F(RosterWizardTest, IdentifiesPeopleByNumberAndChangesOnlyDifferences) {
  open("Staff ID,Name,E-mail\nS-1,Ann Smith,ann@example.org\n");
  next();
  next();
  import().click();
  office.shell().waitForJobs();

  // The same number with a new name; the same address with a new number.
  open("Staff ID,Name,E-mail\nS-1,Ann Miller,ann@example.org\nS-9,Other Ann,ann@example.org\n");
  next();
  next();
  EXPECT_TRUE(lines().asText().contains(QStringLiteral("Ann Smith")));
  EXPECT_TRUE(lines().asText().contains(QStringLiteral("belongs to T-01 already")));
  import().click();
  office.shell().waitForJobs();

  EXPECT_EQ(wizard->outcome()->added, 1U);
  EXPECT_EQ(wizard->outcome()->changed, 1U);
  EXPECT_EQ(known(), 2U);
}

TEST_F(RosterWizardTest, StopsDuringTenThousandAndStoresNothing) {
  std::string text = "Staff ID,Name\n";
  for (int i = 0; i < 10'000; ++i) {
    text += "S-" + std::to_string(i) + ",Intern " + std::to_string(i) + "\n";
  }
  open(text);
  next();
  wizard->button(QWizard::NextButton)->click();
  EXPECT_FALSE(import().isEnabled());
  int signs = 0;
  QObject::connect(&office.shell(), &ShellContext::jobMoved, [&](const QString& step) {
    if (step == QStringLiteral("Trying it out") && ++signs == 3) {
      wizard->button(QWizard::CancelButton)->click();
    }
  });

  office.shell().waitForJobs();
  QApplication::processEvents();

  EXPECT_GE(signs, 3);
  EXPECT_EQ(wizard->result(), QDialog::Rejected);
  EXPECT_FALSE(wizard->isVisible());
  EXPECT_EQ(known(), 0U);
}

TEST_F(RosterWizardTest, ImportsTenThousandWhileTheWindowStaysResponsive) {
  constexpr int kPeople = 10'000;
  // A frozen window would be frozen for the dry run or the import, both of which take longer on a busy
  // machine.
  constexpr qint64 kFrozen_ms = 1'000;
  std::string text = "Staff ID,Name,Sex\n";
  for (int i = 0; i < kPeople; ++i) {
    text += "S-" + std::to_string(i) + ",Intern " + std::to_string(i) + (i % 2 == 0 ? ",f\n" : ",m\n");
  }
  open(text);
  next();
  QElapsedTimer since;
  since.start();
  qint64 longest_ms = 0;
  QTimer beat;
  QElapsedTimer last;
  QObject::connect(&beat, &QTimer::timeout, [&] { longest_ms = std::max(longest_ms, last.restart()); });
  last.start();
  beat.start(10);

  next();
  const qint64 preview_ms = since.restart();
  ASSERT_EQ(lines().visibleRows(), kPeople);
  import().click();
  office.shell().waitForJobs();
  const qint64 commit_ms = since.elapsed();

  RecordProperty("preview_ms", static_cast<int>(preview_ms));
  RecordProperty("commit_ms", static_cast<int>(commit_ms));
  RecordProperty("longest_pause_ms", static_cast<int>(longest_ms));
  EXPECT_EQ(wizard->outcome()->added, static_cast<std::size_t>(kPeople));
  EXPECT_EQ(known(), static_cast<std::size_t>(kPeople));
  EXPECT_LT(longest_ms, std::max(kFrozen_ms, std::min(preview_ms, commit_ms) / 2));
}

}  // namespace
}  // namespace torsio::gui
