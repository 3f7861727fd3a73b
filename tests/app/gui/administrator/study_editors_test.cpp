// SPDX-License-Identifier: GPL-3.0-or-later
// What administrators edit for the study: consent texts, the scoring sheet, the states of a cohort. Form
// errors are shown beside their field, and only after it has been visited.

#include <filesystem>
#include <string>
#include <vector>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>

#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/administrator/people/consent_texts_dialog.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/people/roster_wizard.h"
#include "app/gui/administrator/people/user_dialogs.h"
#include "app/gui/administrator/scoring/campaigns_page.h"
#include "app/gui/administrator/scoring/rubric_dialog.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/station/centre_settings_card.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/field_checks.h"
#include "app/services/access/centre_settings.h"
#include "app/services/people/consent_service.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/rubric_service.h"
#include "assessment/domain/people/consent.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/support/administrator_desk.h"
#include "tests/app/gui/support/hands.h"

namespace torsio::gui {

namespace {

using testing::AdministratorDesk;
using testing::answer;
using testing::giveReason;
using testing::retype;

TEST(ConsentTexts, AreEditedInEachLanguageAndPublishedAsTheNextVersion) {
  AdministratorDesk office;
  auto page = office.open<RosterPage>("administrator");
  QStringList seen;
  answer([&seen](QDialog& dialog) {
    EXPECT_FALSE(child<QPushButton>(dialog, "publish").isEnabled()) << "nothing has changed yet";
    for (const QPushButton* button : dialog.findChildren<QPushButton*>()) {
      EXPECT_FALSE(button->autoDefault()) << "Enter in a field presses nothing";
    }
    EXPECT_FALSE(child<QPushButton>(dialog, "removePurpose").isEnabled()) << "the training record stays";
    child<QPlainTextEdit>(dialog, "text").setPlainText(QStringLiteral("We keep it for two years."));
    child<QPushButton>(dialog, "addPurpose").click();
    retype(child<QLineEdit>(dialog, "title"), QStringLiteral("Photographs"));
    child<QPlainTextEdit>(dialog, "text").setPlainText(QStringLiteral("My picture may be shown."));
    auto& language = child<QComboBox>(dialog, "language");
    language.setCurrentIndex(language.findData(QStringLiteral("zh_CN")));
    child<QListWidget>(dialog, "purposes").setCurrentRow(5);
    retype(child<QLineEdit>(dialog, "title"), QStringLiteral("\u7167\u7247"));
    child<QPlainTextEdit>(dialog, "text")
        .setPlainText(QStringLiteral("\u53ef\u4ee5\u5c55\u793a\u7167\u7247\u3002"));
    EXPECT_TRUE(child<QPushButton>(dialog, "publish").isEnabled());
    answer(giveReason);
    child<QPushButton>(dialog, "publish").click();
    for (int i = 0; i < child<QComboBox>(dialog, "version").count(); ++i) {
      seen << child<QComboBox>(dialog, "version").itemText(i);
    }
    child<QComboBox>(dialog, "version").setCurrentIndex(1);
    EXPECT_TRUE(child<QLineEdit>(dialog, "title").isReadOnly()) << "what was published stays";
    dialog.reject();
  });

  child<QPushButton>(*page, "consentTexts").click();

  EXPECT_EQ(seen,
            QStringList({QStringLiteral("centre-1: asked for it"), QStringLiteral("2026-1 (as it ships)")}));
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

  child<QPushButton>(dialog, "addLanguage").click();

  EXPECT_EQ(child<QComboBox>(dialog, "language").currentData().toString(), QStringLiteral("de"));
  EXPECT_EQ(child<QListWidget>(dialog, "purposes").count(), 5);
  answer(giveReason);
  child<QPushButton>(dialog, "publish").click();
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
    EXPECT_FALSE(child<QPushButton>(dialog, "publish").isEnabled());
    retype(child<QLineEdit>(dialog, "label"), QStringLiteral("Time to the last twist"));
    child<QDoubleSpinBox>(dialog, "weight").setValue(2.0);
    child<QTableWidget>(dialog, "anchors").item(0, 1)->setText(QStringLiteral("never ends"));
    EXPECT_TRUE(child<QPushButton>(dialog, "publish").isEnabled());
    child<QDoubleSpinBox>(dialog, "row.to").setValue(5.0);
    EXPECT_FALSE(child<QPushButton>(dialog, "publish").isEnabled()) << "anchors at 7 and 10 lie outside";
    child<QDoubleSpinBox>(dialog, "row.to").setValue(10.0);
    EXPECT_EQ(previewed(), before);
    answer(giveReason);
    child<QPushButton>(dialog, "publish").click();
    child<QComboBox>(dialog, "revision").setCurrentIndex(1);
    EXPECT_TRUE(child<QLineEdit>(dialog, "label").isReadOnly());
    EXPECT_EQ(child<QLineEdit>(dialog, "label").text(), QStringLiteral("Training time"));
    dialog.reject();
  });

  child<QPushButton>(*page, "reviseRubric").click();

  const RubricRow rubric = rubrics(office.centre.as("administrator")).at(0);
  ASSERT_EQ(rubric.revisions.size(), 2U);
  const RubricLine& line = rubric.revisions.back().rows.at(0);
  EXPECT_EQ(line.code, "training_time") << "a row keeps its code when it is renamed";
  EXPECT_EQ(line.label, "Time to the last twist");
  EXPECT_EQ(line.weight_milli, 2000);
  EXPECT_EQ(line.anchors.at(0).meaning, "never ends");
  EXPECT_EQ(line.scale.hi, 100);
  EXPECT_EQ(rubric.revisions.back().note, "asked for it");
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
  answer(giveReason);
  child<QPushButton>(dialog, "publish").click();

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
  child<QPushButton>(*page, "renameCohort").click();
  answer(giveReason);
  child<QPushButton>(*page, "cohortState").click();

  EXPECT_TRUE(table.asText().contains(QStringLiteral("Autumn 2026")));
  EXPECT_TRUE(table.asText().contains(QStringLiteral("closed")));
  answer(giveReason);
  child<QPushButton>(*page, "cohortState").click();

  EXPECT_EQ(table.visibleRows(), 0);
  EXPECT_TRUE(office.open<ScoringPage>("administrator")->findChild<QComboBox*>()->currentText().isEmpty())
      << "an archived cohort is not offered";
  child<QCheckBox>(*page, "archived").setChecked(true);
  EXPECT_EQ(table.visibleRows(), 1);
  table.select(toQString(id));
  answer(giveReason);
  child<QPushButton>(*page, "cohortState").click();
  EXPECT_EQ(cohorts(office.centre.as("administrator")).at(0).cohort.state, CohortState::kRunning);
}

using testing::button;
using testing::hintBelow;
using testing::leave;

TEST(FieldChecks, ShowNothingForAnUntouchedFieldAndThenItsErrorBelowIt) {
  QDialog window;
  auto* form = new QFormLayout(&window);
  auto* name = new QLineEdit(&window);
  auto* other = new QLineEdit(&window);
  QPushButton accept;
  FieldChecks checks(&window);
  form->addRow(QStringLiteral("Name"), name);
  checks.addNeeded(form, name, QStringLiteral("Enter a name."));
  form->addRow(QStringLiteral("Other"), other);
  checks.addNeeded(form, other, QStringLiteral("Enter the other."));
  checks.decide(&accept);
  window.show();

  EXPECT_FALSE(accept.isEnabled());
  EXPECT_EQ(accept.toolTip(), QStringLiteral("Enter a name."));  // a disabled button says what is missing
  EXPECT_EQ(hintBelow(window, *name), QString());

  leave(*name);
  EXPECT_EQ(hintBelow(window, *name), QStringLiteral("Enter a name."));
  EXPECT_EQ(hintBelow(window, *other), QString());

  retype(*name, QStringLiteral("a"));
  EXPECT_EQ(hintBelow(window, *name), QString());
  EXPECT_FALSE(accept.isEnabled());
  retype(*other, QStringLiteral("b"));
  EXPECT_TRUE(accept.isEnabled());
  EXPECT_EQ(accept.toolTip(), QString());

  retype(*other, QString());
  EXPECT_EQ(hintBelow(window, *other), QStringLiteral("Enter the other."));
}

TEST(FieldChecks, AreNotCalledForAFormBeingDestroyed) {
  int asked = 0;
  {
    QDialog window;
    auto* form = new QFormLayout(&window);
    auto* name = new QLineEdit(&window);
    auto* checks = new FieldChecks(&window);
    form->addRow(QStringLiteral("Name"), name);
    checks->add(form, name, [&asked] {
      ++asked;
      return QString();
    });
    window.show();
    window.activateWindow();
    name->setFocus();
    QApplication::processEvents();
    ASSERT_TRUE(name->hasFocus());
    asked = 0;
  }
  EXPECT_EQ(asked, 0);
}

TEST(NewUser, ShowsAtTheFieldWhatIsMissing) {
  std::vector<QString> said;
  answer([&said](QDialog& dialog) {
    auto& login = child<QLineEdit>(dialog, "login");
    auto* person = dialog.findChild<QComboBox*>();
    leave(login);
    said.push_back(hintBelow(dialog, login));
    retype(login, QStringLiteral("mei"));
    said.push_back(hintBelow(dialog, login));
    child<QCheckBox>(dialog, "trainee").click();
    leave(*person);
    said.push_back(hintBelow(dialog, *person));
    EXPECT_FALSE(button(dialog, QStringLiteral("Add user"))->isEnabled());
    person->setCurrentIndex(1);
    said.push_back(hintBelow(dialog, *person));
    EXPECT_TRUE(button(dialog, QStringLiteral("Add user"))->isEnabled());
    dialog.accept();
  });

  const std::optional<NewUser> user = askNewUser(nullptr, {{"person-1", QStringLiteral("T-01")}});

  ASSERT_TRUE(user.has_value());
  ASSERT_EQ(said.size(), 4U);
  EXPECT_FALSE(said[0].isEmpty());
  EXPECT_EQ(said[1], QString());
  EXPECT_TRUE(said[2].contains(QStringLiteral("person"))) << said[2].toStdString();
  EXPECT_EQ(said[3], QString());
}

TEST(NewPerson, ShowsAtTheFieldWhatIsMissing) {
  answer([](QDialog& dialog) {
    auto& name = child<QLineEdit>(dialog, "name");
    leave(name);
    EXPECT_FALSE(hintBelow(dialog, name).isEmpty());
    retype(name, QStringLiteral("Li Na"));
    EXPECT_TRUE(hintBelow(dialog, name).isEmpty());
    dialog.findChild<QCheckBox*>()->setChecked(false);
    QComboBox* scores = dialog.findChildren<QComboBox*>().back();
    leave(*scores);
    EXPECT_FALSE(hintBelow(dialog, *scores).isEmpty());
    EXPECT_FALSE(button(dialog, QStringLiteral("Add person"))->isEnabled());
    dialog.reject();
  });

  EXPECT_FALSE(askPerson(nullptr, std::nullopt, {}).has_value());
}

TEST(RubricHints, AppearAtTheFieldAndNameACriterionThatIsNotShown) {
  AdministratorDesk office;
  office.centre.addPaperRubric();
  office.centre.as("administrator");
  RubricDialog dialog(office.shell());
  dialog.show();
  auto& label = child<QLineEdit>(dialog, "label");
  auto& problem = child<QLabel>(dialog, "problem");
  auto& to = child<QDoubleSpinBox>(dialog, "row.to");

  const QString name = label.text();
  retype(label, QString());
  EXPECT_FALSE(hintBelow(dialog, label).isEmpty());
  EXPECT_TRUE(problem.isHidden());
  retype(label, name);
  EXPECT_TRUE(hintBelow(dialog, label).isEmpty());

  to.setValue(-3.0);
  EXPECT_FALSE(hintBelow(dialog, to).isEmpty());
  EXPECT_FALSE(child<QPushButton>(dialog, "publish").isEnabled());

  dialog.findChild<QListWidget*>()->setCurrentRow(1);
  EXPECT_TRUE(hintBelow(dialog, to).isEmpty());
  EXPECT_TRUE(problem.text().startsWith(name)) << problem.text().toStdString();
}

TEST(AllocationHints, NameABlockSizeThatIsNoMultipleOfTheGroups) {
  AdministratorDesk office;
  const CohortId cohort = office.centre.addStudy(6).cohortId;
  auto page = office.open<AllocationPage>("allocator", toQString(cohort));
  page->show();
  auto& method = child<QComboBox>(*page, "method");
  method.setCurrentIndex(method.findData(static_cast<int>(AllocationMethod::kPermutedBlocks)));
  auto& blocks = child<QLineEdit>(*page, "blocks");
  EXPECT_TRUE(hintBelow(*page, blocks).isEmpty());

  for (const char* wrong : {"4", "3, x", ""}) {
    retype(blocks, QLatin1String(wrong));
    EXPECT_FALSE(hintBelow(*page, blocks).isEmpty()) << wrong;
    EXPECT_FALSE(child<QPushButton>(*page, "lockButton").isEnabled()) << wrong;
  }
  retype(blocks, QStringLiteral("3, 6"));
  EXPECT_TRUE(hintBelow(*page, blocks).isEmpty());
  EXPECT_TRUE(child<QPushButton>(*page, "lockButton").isEnabled());
}

TEST(ConsentHints, AppearAtTheFieldAndNameALanguageThatIsNotShown) {
  AdministratorDesk office;
  office.centre.as("administrator");
  ConsentTextsDialog dialog(office.shell());
  dialog.show();
  auto& title = child<QLineEdit>(dialog, "title");
  retype(title, QString());
  EXPECT_FALSE(hintBelow(dialog, title).isEmpty());
  EXPECT_FALSE(child<QPushButton>(dialog, "publish").isEnabled());
  retype(title, QStringLiteral("Record"));
  EXPECT_TRUE(hintBelow(dialog, title).isEmpty());
  EXPECT_TRUE(child<QPushButton>(dialog, "publish").isEnabled());

  child<QPushButton>(dialog, "addPurpose").click();  // empty in every language
  auto& language = child<QComboBox>(dialog, "language");
  EXPECT_FALSE(hintBelow(dialog, language).isEmpty());
}

TEST(StationSettings, AreNotSavedWithoutANameAndSayItBelowTheField) {
  AdministratorDesk office;
  office.centre.as("administrator");
  CentreSettingsCard card(office.shell());
  card.read();
  card.resize(1200, 400);
  card.show();
  auto& name = child<QLineEdit>(card, "centreName");
  retype(name, QStringLiteral("  "));
  EXPECT_FALSE(hintBelow(card, name).isEmpty());
  EXPECT_FALSE(child<QPushButton>(card, "keepSettings").isEnabled());
  retype(name, QStringLiteral("Hospital"));
  EXPECT_TRUE(hintBelow(card, name).isEmpty());
  EXPECT_TRUE(child<QPushButton>(card, "keepSettings").isEnabled());
}

TEST(StationSettings, SetWhatRatersMustWatchAndRefuseInvalidSpeeds) {
  AdministratorDesk office;
  office.centre.as("administrator");
  CentreSettingsCard card(office.shell());
  card.read();
  card.resize(1200, 400);
  card.show();
  retype(child<QLineEdit>(card, "centreName"), QStringLiteral("Hospital"));
  auto& speeds = child<QLineEdit>(card, "playbackSpeeds");
  retype(speeds, QStringLiteral("fast"));
  EXPECT_FALSE(hintBelow(card, speeds).isEmpty());
  EXPECT_FALSE(child<QPushButton>(card, "keepSettings").isEnabled());
  retype(speeds, QStringLiteral("0.5, 2"));
  child<QDoubleSpinBox>(card, "minimumWatched").setValue(50.0);
  child<QDoubleSpinBox>(card, "discrepancyPoints").setValue(1.5);
  child<QPushButton>(card, "keepSettings").click();

  Connection& connection = office.centre.connection();
  EXPECT_DOUBLE_EQ(centreSetting<kMinimumWatched_percent>(connection), 50.0);
  EXPECT_EQ(centreSetting<kPlaybackSpeeds>(connection), (std::vector{0.5, 1.0, 2.0}));
  EXPECT_DOUBLE_EQ(centreSetting<kDiscrepancy_points>(connection), 1.5);
  card.read();
  EXPECT_EQ(speeds.text(), QStringLiteral("0.5, 1, 2"));
}

TEST(RosterHints, AppearBelowThePathAndBelowColumnsThatTheHeadingsDoNotSuggest) {
  AdministratorDesk office;
  office.centre.as("administrator");
  const std::filesystem::path file = office.centre.folder() / "roster.csv";
  writeFileAtomically(file, "Kennung;Wer\nS-1;Ann Smith\n");
  RosterWizard wizard(office.shell());
  wizard.restart();
  wizard.show();
  auto& path = child<QLineEdit>(wizard, "path");
  QAbstractButton& next = *wizard.button(QWizard::NextButton);
  EXPECT_EQ(hintBelow(wizard, path), QString());
  leave(path);
  EXPECT_FALSE(hintBelow(wizard, path).isEmpty());

  retype(path, QStringLiteral("/no/such/roster.csv"));
  EXPECT_EQ(hintBelow(wizard, path), QString());
  next.click();
  EXPECT_TRUE(hintBelow(wizard, path).contains(QStringLiteral("/no/such/roster.csv")))
      << hintBelow(wizard, path).toStdString();
  EXPECT_TRUE(next.isEnabled()) << "the file may be there now";
  retype(path, toQString(file));
  EXPECT_EQ(hintBelow(wizard, path), QString());
  next.click();

  auto& number = child<QComboBox>(*wizard.currentPage(), rosterFieldCode(RosterField::kExternalId).data());
  EXPECT_FALSE(hintBelow(wizard, number).isEmpty()) << "Next waits for it";
  number.setCurrentIndex(1);
  EXPECT_EQ(hintBelow(wizard, number), QString());
}

TEST(CampaignHints, AppearAtInvalidModelsWeightsAndRaters) {
  AdministratorDesk office;
  office.centre.as("administrator");
  PersonRow chief;
  chief.person.id = "chief-1";
  chief.person.code = "R-01";
  chief.raterClass = "chief";
  CampaignDialog dialog({chief}, {}, office.centre.assets(), nullptr);
  dialog.resize(900, 900);
  dialog.show();
  auto& name = child<QLineEdit>(dialog, "name");
  auto& models = child<QPlainTextEdit>(dialog, "models");
  auto& raters = child<DataTable>(dialog, "raters");
  const QList<QDoubleSpinBox*> weights = dialog.findChildren<QDoubleSpinBox*>();
  ASSERT_EQ(weights.size(), 12);
  QPushButton& create = *button(dialog, QStringLiteral("Create"));

  EXPECT_EQ(hintBelow(dialog, name), QString());
  leave(name);
  EXPECT_FALSE(hintBelow(dialog, name).isEmpty());
  retype(name, QStringLiteral("Three models"));
  EXPECT_TRUE(hintBelow(dialog, raters).contains(QStringLiteral("Missing"))) << "two classes have nobody";

  weights[9]->setValue(0.0);
  weights[10]->setValue(0.0);
  EXPECT_TRUE(hintBelow(dialog, *weights.back()).contains(QStringLiteral("sum to 1")));
  weights[11]->setValue(1.0);
  EXPECT_EQ(hintBelow(dialog, *weights.back()), QString());
  EXPECT_EQ(hintBelow(dialog, raters), QString());
  EXPECT_TRUE(create.isEnabled()) << create.toolTip().toStdString();
  weights[0]->setValue(0.9);
  EXPECT_TRUE(hintBelow(dialog, *weights[8]).contains(QStringLiteral("sum to 1")));
  EXPECT_FALSE(create.isEnabled());

  models.setPlainText(QStringLiteral("PM = one\nPM = two"));
  EXPECT_TRUE(hintBelow(dialog, models).contains(QStringLiteral("PM"))) << "which code stands twice";
  models.setPlainText(QStringLiteral("PM = one\n= two"));
  EXPECT_FALSE(hintBelow(dialog, models).isEmpty()) << "a line without a code is not left out in silence";
  raters.view().clearSelection();
  EXPECT_FALSE(hintBelow(dialog, raters).isEmpty());
}

}  // namespace

}  // namespace torsio::gui
