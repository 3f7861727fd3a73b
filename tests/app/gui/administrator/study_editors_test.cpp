// SPDX-License-Identifier: GPL-3.0-or-later
// What administrators edit for the study: consent texts, the scoring sheet, the states of a cohort.
#include <filesystem>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>

#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/administrator/people/consent_texts_dialog.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/scoring/rubric_dialog.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/people/consent_service.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/rubric_service.h"
#include "assessment/domain/people/consent.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;
using testing::answer;

QPushButton& editorButton(QWidget& page, const char* name) {
  return child<QPushButton>(page, name);
}

void giveBoardsReason(QDialog& dialog) {
  child<QLineEdit>(dialog, "reason").setText(QStringLiteral("as the board asked"));
  dialog.accept();
}

/// Changes the text of a field as if typed.
void typeInto(QLineEdit& field, const QString& text) {
  field.setText(text);
  Q_EMIT field.textEdited(text);
}

TEST(ConsentTexts, AreEditedInEachLanguageAndPublishedAsTheNextVersion) {
  AdministratorDesk office;
  auto page = office.open<RosterPage>("administrator");
  QStringList seen;
  answer([&seen](QDialog& dialog) {
    EXPECT_FALSE(editorButton(dialog, "publish").isEnabled()) << "nothing has changed yet";
    for (const QPushButton* button : dialog.findChildren<QPushButton*>()) {
      EXPECT_FALSE(button->autoDefault()) << "Enter in a field presses nothing";
    }
    EXPECT_FALSE(editorButton(dialog, "removePurpose").isEnabled()) << "the training record stays";
    child<QPlainTextEdit>(dialog, "text").setPlainText(QStringLiteral("We keep it for two years."));
    editorButton(dialog, "addPurpose").click();
    typeInto(child<QLineEdit>(dialog, "title"), QStringLiteral("Photographs"));
    child<QPlainTextEdit>(dialog, "text").setPlainText(QStringLiteral("My picture may be shown."));
    auto& language = child<QComboBox>(dialog, "language");
    language.setCurrentIndex(language.findData(QStringLiteral("zh_CN")));
    child<QListWidget>(dialog, "purposes").setCurrentRow(5);
    typeInto(child<QLineEdit>(dialog, "title"), QStringLiteral("\u7167\u7247"));
    child<QPlainTextEdit>(dialog, "text")
        .setPlainText(QStringLiteral("\u53ef\u4ee5\u5c55\u793a\u7167\u7247\u3002"));
    EXPECT_TRUE(editorButton(dialog, "publish").isEnabled());
    answer(giveBoardsReason);
    editorButton(dialog, "publish").click();
    for (int i = 0; i < child<QComboBox>(dialog, "version").count(); ++i) {
      seen << child<QComboBox>(dialog, "version").itemText(i);
    }
    child<QComboBox>(dialog, "version").setCurrentIndex(1);
    EXPECT_TRUE(child<QLineEdit>(dialog, "title").isReadOnly()) << "what was published stays";
    dialog.reject();
  });

  editorButton(*page, "consentTexts").click();

  EXPECT_EQ(seen, QStringList({QStringLiteral("centre-1: as the board asked"),
                               QStringLiteral("2026-1 (as it ships)")}));
  const ConsentVersion now = askedConsent(office.centre.as("administrator"), office.centre.assets());
  EXPECT_EQ(wordsIn(now, "en").texts.front().text, "We keep it for two years.");
  ASSERT_EQ(wordsIn(now, "zh_CN").texts.size(), 6U);
  EXPECT_EQ(wordsIn(now, "zh_CN").texts.back().title, "\u7167\u7247");
}

TEST(ConsentTexts, ANewLanguageStartsWithTheTextsShown) {
  AdministratorDesk office;
  office.centre.as("administrator");
  ConsentTextsDialog dialog(office.shell());
  answer([](QDialog& asked) {
    auto& code = child<QLineEdit>(asked, "code");
    code.setText(QStringLiteral("en"));
    EXPECT_FALSE(testing::button(asked, QStringLiteral("Add"))->isEnabled()) << "is there already";
    code.setText(QStringLiteral("xx-nothing"));
    EXPECT_FALSE(testing::button(asked, QStringLiteral("Add"))->isEnabled()) << "no language";
    code.setText(QStringLiteral("de"));
    testing::press(asked, QStringLiteral("Add"));
  });

  editorButton(dialog, "addLanguage").click();

  EXPECT_EQ(child<QComboBox>(dialog, "language").currentData().toString(), QStringLiteral("de"));
  EXPECT_EQ(child<QListWidget>(dialog, "purposes").count(), 5);
  answer(giveBoardsReason);
  editorButton(dialog, "publish").click();
  EXPECT_EQ(wordsIn(askedConsent(office.centre.as("administrator"), office.centre.assets()), "de").language,
            "de");
}

TEST(ConsentTexts, AreNotLostByClosing) {
  AdministratorDesk office;
  office.centre.as("administrator");
  ConsentTextsDialog dialog(office.shell());
  dialog.show();
  child<QPlainTextEdit>(dialog, "text").setPlainText(QStringLiteral("half a sentence"));

  answer([](QDialog& sure) { sure.reject(); });
  dialog.reject();
  EXPECT_TRUE(dialog.isVisible());
  answer([](QDialog& sure) { sure.accept(); });
  dialog.reject();

  EXPECT_FALSE(dialog.isVisible());
}

TEST(ConsentForms, ArePrintedWithEveryPurposeAndOneForEachCode) {
  AdministratorDesk office;
  const ConsentVersion version = shippedConsent(office.centre.assets());
  const std::filesystem::path one = office.centre.folder() / "one.pdf";
  const std::filesystem::path three = office.centre.folder() / "three.pdf";

  writeConsentForms(version, wordsIn(version, "en"), {"T-01"}, QStringLiteral("Skills lab"), one);
  writeConsentForms(version, wordsIn(version, "zh_CN"), {"T-01", "T-02", ""}, QStringLiteral("Skills lab"),
                    three);

  const auto pages = [](const std::filesystem::path& file) {
    const std::string bytes = readFile(file);
    const auto at = bytes.find("/Count ");
    return at == std::string::npos ? 0 : std::stoi(bytes.substr(at + 7));
  };
  EXPECT_EQ(pages(one), 1);
  EXPECT_EQ(pages(three), 3);
}

TEST(RubricDialog, EditsTheSheetBesideTheRatersViewAndPublishesARevision) {
  AdministratorDesk office;
  office.centre.addPaperRubric();
  auto page = office.open<ScoringPage>("administrator");
  answer([](QDialog& dialog) {
    const auto previewed = [&dialog] {
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      return dialog.findChildren<ScoreRow*>().size();
    };
    for (const QPushButton* button : dialog.findChildren<QPushButton*>()) {
      EXPECT_FALSE(button->text().isEmpty()) << button->objectName().toStdString();
      EXPECT_FALSE(button->autoDefault()) << "Enter in a field presses nothing";
    }
    const auto before = previewed();
    EXPECT_FALSE(editorButton(dialog, "publish").isEnabled());
    typeInto(child<QLineEdit>(dialog, "label"), QStringLiteral("Time to the last twist"));
    child<QDoubleSpinBox>(dialog, "weight").setValue(2.0);
    child<QTableWidget>(dialog, "anchors").item(0, 1)->setText(QStringLiteral("never ends"));
    EXPECT_TRUE(editorButton(dialog, "publish").isEnabled());
    child<QDoubleSpinBox>(dialog, "row.to").setValue(5.0);
    EXPECT_FALSE(editorButton(dialog, "publish").isEnabled()) << "anchors at 7 and 10 lie outside";
    child<QDoubleSpinBox>(dialog, "row.to").setValue(10.0);
    EXPECT_EQ(previewed(), before);
    answer(giveBoardsReason);
    editorButton(dialog, "publish").click();
    child<QComboBox>(dialog, "revision").setCurrentIndex(1);
    EXPECT_TRUE(child<QLineEdit>(dialog, "label").isReadOnly());
    EXPECT_EQ(child<QLineEdit>(dialog, "label").text(), QStringLiteral("Training time"));
    dialog.reject();
  });

  editorButton(*page, "reviseRubric").click();

  const RubricRow rubric = rubrics(office.centre.as("administrator")).at(0);
  ASSERT_EQ(rubric.revisions.size(), 2U);
  const RubricLine& line = rubric.revisions.back().rows.at(0);
  EXPECT_EQ(line.code, "training_time") << "a row keeps its code when it is renamed";
  EXPECT_EQ(line.label, "Time to the last twist");
  EXPECT_EQ(line.weight_milli, 2000);
  EXPECT_EQ(line.anchors.at(0).meaning, "never ends");
  EXPECT_EQ(line.scale.hi, 100);
  EXPECT_EQ(rubric.revisions.back().note, "as the board asked");
}

TEST(RubricDialog, ExportsASheetToAFileAndImportsOne) {
  AdministratorDesk office;
  office.centre.addPaperRubric();
  office.centre.as("administrator");
  RubricDialog dialog(office.shell());
  const std::filesystem::path file = office.centre.folder() / "sheet.json";

  ASSERT_TRUE(dialog.exportTo(file));
  RubricTemplate written = parseRubric(readFile(file), "sheet");
  written.revision.rows.pop_back();
  writeFileAtomically(file, rubricText("other", written.revision));
  ASSERT_TRUE(dialog.importFrom(file));
  answer(giveBoardsReason);
  editorButton(dialog, "publish").click();

  const RubricRow rubric = rubrics(office.centre.as("administrator")).at(0);
  EXPECT_EQ(rubric.name, "Twist training");
  EXPECT_EQ(rubric.revisions.back().rows.size(), 2U);
}

TEST(CohortsPage, RenamesClosesAndArchivesACohort) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(2);
  const CohortId id =
      addCohort(office.centre.session(), {.name = "Autumn", .groups = {{"G1", "one"}, {"G2", "two"}}});
  enrolTrainees(office.centre.session(), id, trainees);
  lockAllocation(office.centre.as("allocator"), {.cohortId = id});
  allocateAll(office.centre.as("allocator"), id);
  auto page = office.open<CohortsPage>("administrator");
  auto& table = child<DataTable>(*page, "cohorts");
  table.select(toQString(id));
  answer([](QDialog& dialog) {
    child<QLineEdit>(dialog, "name").setText(QStringLiteral("Autumn 2026"));
    dialog.accept();
  });
  editorButton(*page, "renameCohort").click();
  answer(giveBoardsReason);
  editorButton(*page, "cohortState").click();

  EXPECT_TRUE(table.asText().contains(QStringLiteral("Autumn 2026")));
  EXPECT_TRUE(table.asText().contains(QStringLiteral("closed")));
  answer(giveBoardsReason);
  editorButton(*page, "cohortState").click();

  EXPECT_EQ(table.visibleRows(), 0);
  EXPECT_TRUE(office.open<ScoringPage>("administrator")->findChild<QComboBox*>()->currentText().isEmpty())
      << "an archived cohort is not offered";
  child<QCheckBox>(*page, "archived").setChecked(true);
  EXPECT_EQ(table.visibleRows(), 1);
  table.select(toQString(id));
  answer(giveBoardsReason);
  editorButton(*page, "cohortState").click();
  EXPECT_EQ(cohorts(office.centre.as("administrator")).at(0).cohort.state, CohortState::kRunning);
}

}  // namespace
}  // namespace torsio::gui
