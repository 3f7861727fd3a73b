// SPDX-License-Identifier: GPL-3.0-or-later
// The curriculum editor with real widgets: nothing is lost, everything can be set, published versions do not
// change.
#include "app/gui/administrator/curriculum/curriculum_editor.h"

#include <algorithm>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTableView>
#include <QTableWidget>
#include <QTest>

#include "app/gui/administrator/curriculum/competence_dialog.h"
#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/curriculum/exercise_editor.h"
#include "app/gui/administrator/study/cohort_dialogs.h"
#include "app/gui/base/language.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/theme.h"
#include "app/outputs/report/cell_trace.h"
#include "app/outputs/report/report_data.h"
#include "app/services/recording/competence_service.h"
#include "app/services/study/curriculum_service.h"
#include "assessment/domain/study/curriculum.h"
#include "db/repository/people/access_repository.h"
#include "tests/app/gui/support/administrator_desk.h"
#include "tests/app/gui/support/watched_shell.h"
#include "tests/app/support/training_centre.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;
using testing::answer;
using testing::press;
using testing::type;

/// Uses every field of the format, with more digits than any field displays.
constexpr const char* kEverything = R"({
  "format": "torsio curriculum 1",
  "modules": [
    {"code": "A1", "title": "Pronate", "scene": "forearm", "pattern": "pronation",
     "mode": "practice", "target_deg": -61.234567, "tolerance_deg": 4.321987, "hold_s": 1.234567,
     "max_force_n": 3.333333, "max_torque_nm": 0.1234567, "attempt_limit": 12, "requires": [],
     "mastery": [
       {"metric": "force.peak", "comparison": "at_most", "threshold": 2.718281828, "unit": "N", "consecutive": 2},
       {"metric": "twist.bias", "comparison": "at_least", "threshold": -0.000123, "unit": "rad", "consecutive": 1},
       {"metric": "twist.on_target", "comparison": "at_least", "threshold": 0.66666667, "unit": "1", "consecutive": 3}]},
    {"code": "A2", "title": "Hold", "scene": "forearm", "pattern": "supination",
     "mode": "graded", "target_deg": 45, "tolerance_deg": 5, "hold_s": 0, "requires": [], "mastery": []},
    {"code": "A3", "title": "Follow", "scene": "forearm", "pattern": "pronation",
     "mode": "graded", "target_deg": -30, "tolerance_deg": 5, "hold_s": 2, "requires": ["A1", "A2"],
     "mastery": [
       {"metric": "time.total", "comparison": "at_most", "threshold": 90.55555, "unit": "s", "consecutive": 1}]}
  ],
  "arms": [
    {"code": "G1", "label": "Both", "rest_min": 5.125, "rest_splittable": true, "phases": [
      {"kind": "virtual", "label": "any", "minutes": 12.345678},
      {"kind": "virtual", "label": "follow", "minutes": 7.5, "module": "A3"},
      {"kind": "real", "label": "arm", "minutes": 20}]},
    {"code": "G2", "label": "Real arm only", "rest_min": 0, "rest_splittable": false, "phases": [
      {"kind": "real", "label": "arm", "minutes": 39.845678}]}
  ],
  "occasions": [{"code": "pre", "after_min": 0}, {"code": "post", "after_min": 39.845678}]
})";

std::string addEverything(AdministratorDesk& office) {
  office.centre.as("administrator");
  return addCurriculum(office.centre.session(), "Everything", "", parseCurriculum(kEverything, "test"));
}

/// Finds a field by its accessible name.
template <typename Field>
Field* named(QWidget& in, const char* name) {
  for (Field* field : in.findChildren<Field*>()) {
    if (field->accessibleName() == QString::fromLatin1(name)) {
      return field;
    }
  }
  ADD_FAILURE() << "no field " << name;
  return nullptr;
}

/// Selects every row of every list, like somebody who is only looking.
void browse(CurriculaPage& page) {
  for (const char* name : {"exercises", "groups"}) {
    auto* list = page.findChild<QListWidget*>(QString::fromLatin1(name));
    for (int row = 0; row < list->count(); ++row) {
      list->setCurrentRow(row);
    }
  }
  for (int tab = 0; tab < child<CurriculumEditor>(page, "editor").count(); ++tab) {
    child<CurriculumEditor>(page, "editor").setCurrentIndex(tab);
  }
}

void choose(QComboBox* box, const QString& code) {
  box->setCurrentIndex(box->findData(code));
  ASSERT_EQ(box->currentData().toString(), code);
  Q_EMIT box->activated(box->currentIndex());
}

template <typename Field>
Field* cell(QTableWidget* table, int row, int column) {
  return qobject_cast<Field*>(table->cellWidget(row, column));
}

/// A draft with everything in it, open in the editor.
class DraftInTheEditor : public ::testing::Test {
 protected:
  AdministratorDesk office;
  const std::string id = addEverything(office);
  std::unique_ptr<CurriculaPage> page = office.open<CurriculaPage>("administrator");
};

TEST(CurriculumEditor, SavesUntouchedContentUnchanged) {
  AdministratorDesk office;
  const std::string id = addEverything(office);
  const std::string before = curriculumJson(curriculumDraft(office.centre.session(), id).content);
  auto page = office.open<CurriculaPage>("administrator");
  EXPECT_TRUE(child<CurriculumEditor>(*page, "editor").problems().empty());

  browse(*page);
  page->retranslate();
  ASSERT_TRUE(page->save());

  const CurriculumDraft after = curriculumDraft(office.centre.session(), id);
  EXPECT_EQ(after.revision, 2);
  EXPECT_EQ(curriculumJson(after.content), before);
}

TEST_F(DraftInTheEditor, FitsASmallScreenWithoutScrollingItsForms) {
  page->resize(1162, 716);  // 1366 x 768 without navigation and header
  page->show();
  QApplication::processEvents();

  auto& editor = child<CurriculumEditor>(*page, "editor");
  for (int tab = 0; tab < editor.count(); ++tab) {
    editor.setCurrentIndex(tab);
    QApplication::processEvents();
    for (const QScrollArea* area : editor.currentWidget()->findChildren<QScrollArea*>()) {
      EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0) << "tab " << tab;
      EXPECT_EQ(area->verticalScrollBar()->maximum(), 0) << "tab " << tab;
    }
  }
}

TEST_F(DraftInTheEditor, ShowsFullNamesInItsListIfThereIsRoom) {
  ASSERT_TRUE(page->add("Twisting of the small intestine, second year", ""));
  page->resize(1700, 1000);  // beside the navigation of a 1920 x 1080 screen
  page->show();
  QApplication::processEvents();

  const QTableView& list = child<DataTable>(*page, "curricula").view();
  for (int row = 0; row < list.model()->rowCount(); ++row) {
    const QString name = list.model()->index(row, 0).data().toString();
    EXPECT_LE(list.fontMetrics().horizontalAdvance(name), list.columnWidth(0) - 2 * kSpace)
        << name.toStdString();
  }
}

TEST_F(DraftInTheEditor, ShowsFullNamesInItsListOnASmallScreen) {
  ASSERT_TRUE(page->add("Twisting of the small intestine, second year", ""));
  page->resize(1146, 700);  // 1366 x 768 without navigation and header
  page->show();
  QApplication::processEvents();

  const QTableView& list = child<DataTable>(*page, "curricula").view();
  int lines = 0;
  for (int row = 0; row < list.model()->rowCount(); ++row) {
    const QString name = list.model()->index(row, 0).data().toString();
    const QRect room(0, 0, list.columnWidth(0) - 2 * kSpace, 10'000);
    const QRect needed = list.fontMetrics().boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, name);
    EXPECT_LE(needed.width(), room.width()) << name.toStdString();
    EXPECT_LE(needed.height(), list.rowHeight(row)) << name.toStdString();
    lines = std::max(lines, needed.height() / list.fontMetrics().height());
  }
  EXPECT_GE(lines, 2) << "nothing had to wrap";
}

// Shipped exercises have names in every language; displaying them does not translate the stored text.
TEST(CurriculumEditor, ShowsShippedNamesInTheWindowsLanguage) {
  AdministratorDesk office;
  office.centre.as("administrator");
  CurriculumVersion content = parseCurriculum(kEverything, "test");
  content.modules[0].title = "Forearm: pronate to 60 degrees";
  content.arms[0].label = "20 min virtual, 20 min real arm";
  content.arms[0].phases[0].label = "virtual 0-20 min";
  const std::string id = addCurriculum(office.centre.session(), "Shipped", "", content);
  const std::string before = curriculumJson(curriculumDraft(office.centre.session(), id).content);
  auto page = office.open<CurriculaPage>("administrator");

  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  page->retranslate();
  browse(*page);
  for (const char* list : {"exercises", "groups"}) {
    page->findChild<QListWidget*>(QString::fromLatin1(list))->setCurrentRow(0);
  }
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // rows of the groups selected before
  QStringList shown;
  for (const QLineEdit* field : page->findChildren<QLineEdit*>()) {
    shown << field->text();
  }
  language.choose(Language::kEnglish);
  page->retranslate();

  for (const char* english :
       {"Forearm: pronate to 60 degrees", "20 min virtual, 20 min real arm", "virtual 0-20 min"}) {
    EXPECT_FALSE(shown.contains(QString::fromLatin1(english))) << english;
  }
  EXPECT_TRUE(shown.contains(QStringLiteral("\u524D\u81C2\uFF1A\u65CB\u524D 60 \u5EA6")));
  page->save();
  EXPECT_EQ(curriculumJson(curriculumDraft(office.centre.session(), id).content), before);
}

TEST(CurriculumEditor, ChangesOnlyTheFieldThatWasEdited) {
  AdministratorDesk office;
  const std::string id = addEverything(office);
  CurriculumVersion expected = curriculumDraft(office.centre.session(), id).content;
  auto page = office.open<CurriculaPage>("administrator");

  auto* title = named<QLineEdit>(*page, "Title");
  title->selectAll();
  QTest::keyClicks(title, QStringLiteral("Pronate gently"));
  ASSERT_TRUE(page->save());

  expected.modules[0].title = "Pronate gently";
  EXPECT_EQ(curriculumJson(curriculumDraft(office.centre.session(), id).content), curriculumJson(expected));
}

TEST_F(DraftInTheEditor, ShowsErrorsBesideTheirFields) {
  page->resize(1162, 716);
  page->show();
  auto& editor = child<CurriculumEditor>(*page, "editor");
  const auto hints = [&editor] {
    QList<QLabel*> shown = editor.findChildren<QLabel*>(QStringLiteral("fieldHint"));
    shown.removeIf([](const QLabel* hint) { return hint->isHidden(); });
    return shown;
  };
  ASSERT_TRUE(hints().isEmpty());

  auto* title = named<QLineEdit>(*page, "Title");
  title->selectAll();
  QTest::keyClick(title, Qt::Key_Delete);
  QApplication::processEvents();

  ASSERT_EQ(hints().size(), 1);
  const QLabel* hint = hints().front();
  EXPECT_TRUE(hint->text().contains(QLatin1String("has no title"))) << hint->text().toStdString();
  const int below = hint->mapTo(page.get(), QPoint()).y() - title->mapTo(page.get(), QPoint()).y();
  EXPECT_GE(below, title->height());
  EXPECT_LE(below, 2 * title->height());

  // It concerns only that exercise, and disappears when the title is restored.
  auto* exercises = editor.findChild<ExerciseEditor*>();
  ASSERT_NE(exercises, nullptr);
  exercises->select(1);
  EXPECT_TRUE(hints().isEmpty());
  exercises->select(0);
  EXPECT_EQ(hints().size(), 1);
  QTest::keyClicks(title, QStringLiteral("Pronate"));
  EXPECT_TRUE(hints().isEmpty());
}

TEST_F(DraftInTheEditor, PublishedVersionsPassThroughTheEditorUnchanged) {
  ASSERT_TRUE(page->publish("first"));
  ASSERT_TRUE(page->begin());
  const std::string first = curricula(office.centre.session()).front().versions.front().id;

  page->showVersion(first);
  browse(*page);
  ASSERT_TRUE(page->takeAsDraft());  // does not ask: the draft is identical
  ASSERT_TRUE(page->publish("second"));

  const auto versions = curricula(office.centre.session()).front().versions;
  ASSERT_EQ(versions.size(), 2U);
  EXPECT_EQ(versions[0].state, CurriculumState::kRunning);  // superseded, but not deleted
  EXPECT_EQ(curriculumJson(publishedContent(office.centre.session(), versions[0].id)),
            curriculumJson(publishedContent(office.centre.session(), versions[1].id)));
  EXPECT_EQ(curriculumJson(publishedContent(office.centre.session(), versions[0].id)),
            curriculumJson(parseCurriculum(kEverything, "test")));
}

TEST_F(DraftInTheEditor, SetsSeveralRulesPrerequisitesAndLimits) {
  child<QListWidget>(*page, "exercises").setCurrentRow(1);
  auto* rules = page->findChild<QTableWidget*>(QStringLiteral("mastery"));

  press(*page, QStringLiteral("Add rule"));
  press(*page, QStringLiteral("Add rule"));
  ASSERT_EQ(rules->rowCount(), 2);
  // As everywhere else: fractions in per cent, forces with their unit.
  EXPECT_EQ(cell<QComboBox>(rules, 0, 0)->currentText(), QStringLiteral("Twists on target"));
  cell<QDoubleSpinBox>(rules, 0, 2)->setValue(60.0);
  EXPECT_EQ(cell<QDoubleSpinBox>(rules, 0, 2)->text(), QStringLiteral("60 %"));
  cell<QDoubleSpinBox>(rules, 0, 2)->setValue(66.75);
  EXPECT_EQ(cell<QDoubleSpinBox>(rules, 0, 2)->text(), QStringLiteral("66.75 %"));
  cell<QDoubleSpinBox>(rules, 0, 2)->setValue(60.0);
  choose(cell<QComboBox>(rules, 1, 0), QStringLiteral("force.peak"));
  choose(cell<QComboBox>(rules, 1, 1), QStringLiteral("at_least"));
  cell<QDoubleSpinBox>(rules, 1, 2)->setValue(1.5);
  EXPECT_EQ(cell<QDoubleSpinBox>(rules, 1, 2)->text(), QStringLiteral("1.50 N"));
  cell<QSpinBox>(rules, 1, 3)->setValue(4);
  named<QDoubleSpinBox>(*page, "Force up to")->setValue(2.5);
  named<QDoubleSpinBox>(*page, "Torque up to")->setValue(0.25);
  named<QSpinBox>(*page, "Attempts")->setValue(9);
  auto* after = page->findChild<QListWidget*>(QStringLiteral("prerequisites"));
  ASSERT_EQ(after->count(), 2);  // the other two exercises
  after->item(0)->setCheckState(Qt::Checked);
  ASSERT_TRUE(page->save());

  const TrainingModule stored = curriculumDraft(office.centre.session(), id).content.modules[1];
  ASSERT_EQ(stored.mastery.size(), 2U);
  EXPECT_EQ(stored.mastery[0].metric, "twist.on_target");
  EXPECT_DOUBLE_EQ(stored.mastery[0].threshold, 0.6);
  EXPECT_EQ(stored.mastery[0].unit, "1");
  EXPECT_EQ(stored.mastery[1].metric, "force.peak");
  EXPECT_EQ(stored.mastery[1].comparison, "at_least");
  EXPECT_EQ(stored.mastery[1].threshold, 1.5);
  EXPECT_EQ(stored.mastery[1].unit, "N");
  EXPECT_EQ(stored.mastery[1].consecutive, 4);
  EXPECT_EQ(stored.maxForce_N, 2.5);
  EXPECT_EQ(stored.maxTorque_Nm, 0.25);
  EXPECT_EQ(stored.attemptLimit, 9);
  EXPECT_EQ(stored.requires_, std::vector<ModuleId>{"A1"});
  EXPECT_TRUE(child<CurriculumEditor>(*page, "editor").problems().empty());
}

TEST_F(DraftInTheEditor, MovesAndRenamesWithoutBreakingReferences) {
  child<QListWidget>(*page, "exercises").setCurrentRow(2);

  QWidget& exercises = *child<CurriculumEditor>(*page, "editor").widget(0);
  press(exercises, QStringLiteral("Up"));
  auto* code = named<QLineEdit>(exercises, "Code");
  code->setText(QStringLiteral("F1"));
  Q_EMIT code->editingFinished();
  code->setText(QStringLiteral("A1"));  // taken: refused with a message, nothing changed
  Q_EMIT code->editingFinished();
  EXPECT_EQ(code->text(), QStringLiteral("F1"));
  ASSERT_TRUE(page->save());

  const CurriculumVersion stored = curriculumDraft(office.centre.session(), id).content;
  EXPECT_EQ(stored.modules[1].code, "F1");
  EXPECT_EQ(stored.modules[2].code, "A2");
  EXPECT_EQ(stored.arms[0].phases[1].moduleId, "F1");
  EXPECT_TRUE(child<CurriculumEditor>(*page, "editor").problems().empty());
}

TEST_F(DraftInTheEditor, SetsGroupsPhasesRestAndOccasions) {
  child<QListWidget>(*page, "groups").setCurrentRow(1);
  auto* phases = page->findChild<QTableWidget*>(QStringLiteral("phases"));

  named<QDoubleSpinBox>(*page, "Rest")->setValue(10.0);
  press(*page, QStringLiteral("Add phase"));
  ASSERT_EQ(phases->rowCount(), 2);
  choose(cell<QComboBox>(phases, 1, 3), QStringLiteral("A2"));
  cell<QDoubleSpinBox>(phases, 1, 2)->setValue(15.0);
  press(*page, QStringLiteral("Earlier"));
  for (QCheckBox* box : page->findChildren<QCheckBox*>()) {
    if (box->text() == QStringLiteral("half-way")) {
      box->setChecked(true);
    }
  }
  ASSERT_TRUE(page->save());

  const CurriculumVersion stored = curriculumDraft(office.centre.session(), id).content;
  EXPECT_EQ(stored.arms[1].restAllowance_us, 600'000'000);
  ASSERT_EQ(stored.arms[1].phases.size(), 2U);
  EXPECT_EQ(stored.arms[1].phases[0].moduleId, "A2");
  EXPECT_EQ(stored.arms[1].phases[0].duration_us, 900'000'000);
  ASSERT_EQ(stored.plannedOccasions.size(), 3U);
  EXPECT_EQ(stored.plannedOccasions[1].code, "mid");
  EXPECT_EQ(stored.plannedOccasions[1].afterExposure_us, 1'200'000'000);  // 20 min, as in the paper
}

TEST(CurriculaPage, SaysForEachStateWhatMayBeChanged) {
  AdministratorDesk office;
  office.centre.addTrainees(3);
  addEverything(office);
  auto page = office.open<CurriculaPage>("administrator");
  EXPECT_TRUE(child<QLabel>(*page, "state").text().contains(QStringLiteral("version 1")));

  ASSERT_TRUE(page->publish("first"));
  child<QComboBox>(*page, "versions").setCurrentIndex(1);
  Q_EMIT child<QComboBox>(*page, "versions").activated(1);
  EXPECT_TRUE(child<QLabel>(*page, "state").text().contains(QStringLiteral("Begin it")));
  EXPECT_FALSE(named<QLineEdit>(*page, "Title")->isEnabled());
  press(*page, QStringLiteral("Begin"));
  EXPECT_TRUE(child<QLabel>(*page, "state").text().contains(QStringLiteral("running")));
  EXPECT_TRUE(child<QLabel>(*page, "state").text().contains(QStringLiteral("No cohort")));
  answer([](QDialog& dialog) { type(dialog, QStringLiteral("replaced")); });
  press(*page, QStringLiteral("Close"));

  EXPECT_TRUE(child<QLabel>(*page, "state").text().contains(QStringLiteral("closed")));
  press(*page, QStringLiteral("Edit as draft"));
  EXPECT_TRUE(named<QLineEdit>(*page, "Title")->isEnabled());
  EXPECT_TRUE(child<QLabel>(*page, "state").text().contains(QStringLiteral("version 2")));
}

/// Checks that every wrapped sentence of a dialog is fully visible.
::testing::AssertionResult sentencesWhole(QWidget& dialog) {
  dialog.show();
  QTest::qWait(1);
  for (const QLabel* label : dialog.findChildren<QLabel*>()) {
    if (label->isVisible() && label->wordWrap() && label->height() < label->heightForWidth(label->width())) {
      return ::testing::AssertionFailure() << label->text().toStdString();
    }
  }
  return ::testing::AssertionSuccess();
}

/// Everything of a trace, one step per line.
std::string linesOf(const TraceStep& step) {
  std::string all = step.what.str() + ": " + step.value + "\n";
  for (const TraceStep& part : step.madeOf) {
    all += linesOf(part);
  }
  return all;
}

// The dialog by its own widgets, then the report and the trace of what it prints.
TEST(CompetenceDialog, AnInterruptedRunIsExcusedAndReportAndTraceTellIt) {
  torsio::testing::TrainingCentre::Setup setup;
  setup.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 10 min", .duration_us = 600'000'000}};
  torsio::testing::TrainingCentre centre(setup);
  centre.attempt("first", "practice", 1.0);
  const std::string cut = centre.attempt("first", "practice", 1.0, 12.0, {}, 0.0, TrialOutcome::kInterrupted);
  AccessRepository(centre.connection(), PasswordCost::kTest)
      .addUser({.id = "the administrator", .login = "admin", .roles = {"administrator", "statistician"}},
               "a long enough password");
  centre.session().setActor(
      {.userId = "the administrator", .login = "admin", .roles = {"administrator", "statistician"}});
  const CurriculumVersionId version = centre.cohort().curriculumVersionId;
  const auto report = [&] {
    TrialDigests digests{std::filesystem::path()};
    return reportInputs(centre.session(), {.cohortId = centre.cohort().id}, digests);
  };
  const auto failed = [&](const CohortInputs& in) {
    const auto own =
        std::find_if(in.competence.begin(), in.competence.end(),
                     [](const CohortCompetence& one) { return one.attempts + std::ssize(one.excused) == 2; });
    return own == in.competence.end() ? -1 : own->failed;
  };
  EXPECT_EQ(failed(report()), 1);

  testing::WatchedShell watched(centre.session());
  watched.shell().readRights();
  CompetenceDialog dialog(watched.shell(), version, nullptr);
  dialog.show();
  auto& runs = child<QComboBox>(dialog, "interrupted");
  auto& reason = child<QLineEdit>(dialog, "excuse");
  auto& excuse = child<QPushButton>(dialog, "excuse-run");
  ASSERT_EQ(runs.count(), 1);
  EXPECT_TRUE(runs.isVisible());
  EXPECT_TRUE(runs.currentText().startsWith(QStringLiteral("T-01")));
  EXPECT_FALSE(excuse.isEnabled());  // without a reason
  QTest::keyClicks(&reason, QStringLiteral("power cut"));
  ASSERT_TRUE(excuse.isEnabled());
  QTest::mouseClick(&excuse, Qt::LeftButton);
  EXPECT_TRUE(watched.failures.isEmpty()) << watched.told.join(QLatin1Char('\n')).toStdString();
  EXPECT_TRUE(watched.notices.join(QLatin1Char(' ')).contains(QStringLiteral("Excused")));
  EXPECT_EQ(runs.count(), 0);
  EXPECT_FALSE(runs.isVisible());

  const CohortInputs in = report();
  EXPECT_EQ(failed(in), 0);
  const ReportModel said = cohortReport(in);
  EXPECT_NE(torsio::testing::paragraphsOf(said).find("1 interrupted run was excused with a reason"),
            std::string::npos);
  const ReportTable* table = torsio::testing::tableNamed(said, "table-competence");
  ASSERT_NE(table, nullptr);
  const auto excused = std::find(table->columns.begin(), table->columns.end(), "Excused");
  ASSERT_NE(excused, table->columns.end());
  EXPECT_EQ(table->rows.at(0).at(static_cast<std::size_t>(excused - table->columns.begin())), "1");
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    if (row.statistic == "excused_runs" && row.item == "T-01" && row.value == "1") {
      const TraceStep trace =
          traceNumber(centre.session(), centre.cohort().id, in, torsio::numberAddress(row));
      EXPECT_NE(linesOf(trace).find(cut), std::string::npos) << linesOf(trace);
      return;
    }
  }
  ADD_FAILURE() << "no row excused_runs of T-01";
}

TEST(CompetenceDialog, PreviewsBothErrorRatesBeforeADesignIsRegistered) {
  AdministratorDesk desk;
  const CurriculumVersionId version = desk.centre.runPaperCurriculum();
  desk.centre.as("administrator");
  desk.shell().readRights();
  CompetenceDialog dialog(desk.shell(), version, nullptr);
  auto* preview = &child<QLabel>(dialog, "preview");
  auto* store = &child<QPushButton>(dialog, "register");
  EXPECT_TRUE(child<QLabel>(dialog, "in-force").text().contains(QStringLiteral("Default competence rule")));
  EXPECT_TRUE(preview->text().contains(
      QStringLiteral("and 2.5\u00a0% are declared competent within the 80 runs planned")));
  EXPECT_TRUE(store->isEnabled());
  EXPECT_TRUE(sentencesWhole(dialog));
  EXPECT_EQ(child<QComboBox>(dialog, "interrupted").count(), 0);  // nothing to excuse
  EXPECT_FALSE(child<QPushButton>(dialog, "excuse-run").isEnabled());

  child<QDoubleSpinBox>(dialog, "inadequate").setValue(20.0);
  EXPECT_TRUE(preview->text().contains(QStringLiteral("35.2\u00a0%")));  // of competent trainees would fail
  EXPECT_FALSE(store->isEnabled());
  EXPECT_TRUE(sentencesWhole(dialog));
  EXPECT_LE(dialog.height(), 700);                            // on a small screen
  child<QDoubleSpinBox>(dialog, "inadequate").setValue(5.0);  // below that of the competent
  EXPECT_FALSE(store->isEnabled());
  child<QDoubleSpinBox>(dialog, "inadequate").setValue(40.0);
  child<QSpinBox>(dialog, "attempts").setValue(50);
  ASSERT_TRUE(store->isEnabled());
  child<QComboBox>(dialog, "source").setCurrentIndex(2);
  EXPECT_FALSE(store->isEnabled());  // set by hand: needs a reason
  child<QComboBox>(dialog, "source").setCurrentIndex(0);
  child<QSpinBox>(dialog, "valid-days").setValue(365);
  store->click();

  EXPECT_TRUE(child<QLabel>(dialog, "in-force").text().contains(QStringLiteral("version 1")));
  EXPECT_TRUE(child<QLabel>(dialog, "in-force").text().contains(QStringLiteral("expires after 365 days")));
  const ExerciseDesigns stored = competenceDesigns(desk.centre.session(), version).front();
  ASSERT_EQ(stored.registered.size(), 1U);
  EXPECT_EQ(stored.registered.front().attempts, 50);
  EXPECT_EQ(desk.centre.audited("competence.register"), 1);
}

// R: power.t.test(delta = 0.8, power = 0.8) n = 25.52; power.t.test(n = 10, delta = 0.8) 0.395;
// power.t.test(n = 10, power = 0.8) delta = 1.325.
TEST(PowerDialog, CalculatesSampleSizeAndPowerImmediately) {
  const LanguageSwitch english;  // for its plurals
  PowerDialog dialog(nullptr);
  EXPECT_EQ(child<QLabel>(dialog, "needed").text(),
            QStringLiteral("26 trainees in each group; 20 when scores are adjusted for the score before"));
  EXPECT_EQ(child<QLabel>(dialog, "shown").text(),
            QStringLiteral("power 0.40 for this effect; with power 0.80 they detect an effect of 1.32"));
  child<QComboBox>(dialog, "design").setCurrentIndex(1);
  EXPECT_EQ(child<QLabel>(dialog, "needed").text(), QStringLiteral("15 trainees"));  // type = "paired": 14.3
  EXPECT_TRUE(sentencesWhole(dialog));
}

TEST(StandardDialog, ShowsTheCutScoreAndErrorsInTheTable) {
  StandardDialog dialog(nullptr);
  auto& table = child<QPlainTextEdit>(dialog, "table");
  const auto said = [&] { return child<QLabel>(dialog, "answer").text().toStdString(); };
  const auto says = [&](const char* part) { return said().find(part) != std::string::npos; };
  EXPECT_TRUE(says("Paste")) << said();
  table.setPlainText(QStringLiteral("judge,item,percent\nA,grip,80\nA,turn,60\nB,grip,60\nB,turn,40\n"));
  // Judges expect 1.4 and 1.0 items: mean 1.2, standard deviation 0.28, standard error 0.2.
  EXPECT_TRUE(says("Pass from 1.20 of 2 items on (60.00 %)")) << said();
  EXPECT_TRUE(says("0.28 items (standard deviation), the cut is sure to 0.20")) << said();
  table.setPlainText(QStringLiteral("judge,item,percent\nA,grip,180\n"));
  EXPECT_TRUE(says("line 2")) << said();
  EXPECT_TRUE(sentencesWhole(dialog));
  table.setPlainText(QStringLiteral("judge,item,percent\nA,grip,80\nB,turn,60\n"));
  EXPECT_TRUE(says("no percentage")) << said();

  child<QComboBox>(dialog, "method").setCurrentIndex(1);
  table.setPlainText(QStringLiteral("subject,global,score\na,1,10\nb,2,12\nc,3,14\nd,4,16.4\n"));
  child<QDoubleSpinBox>(dialog, "borderline").setValue(2.5);
  EXPECT_TRUE(says("Pass from a score of 13.10 on")) << said();  // at the mean rating: 52.4 / 4

  child<QComboBox>(dialog, "method").setCurrentIndex(2);
  table.setPlainText(
      QStringLiteral("subject,group,score\na,novice,9\nb,novice,11\nc,master,15\nd,master,17\n"));
  EXPECT_TRUE(says("Pass from a score of 13.00 on: 2 % of 2 novices")) << said();
}

// Bonett (2002): 8 z^2 (1 - r)^2 (1 + (k - 1) r)^2 / (k (k - 1) w^2) + 1 trainees; with r = 0.7 and w = 0.3
// 30.5 for three raters, 25.6 for four, and never below 16.
TEST(PowerDialog, CalculatesTheNumberOfRatersForAgreement) {
  PowerDialog dialog(nullptr);
  child<QComboBox>(dialog, "design").setCurrentIndex(3);
  EXPECT_EQ(child<QLabel>(dialog, "needed").text(), QStringLiteral("26 trainees, each scored by 4 raters"));
  EXPECT_EQ(child<QLabel>(dialog, "shown").text(),
            QStringLiteral("too few trainees for this width, even with more raters"));
  child<QSpinBox>(dialog, "atHand").setValue(31);
  EXPECT_EQ(child<QLabel>(dialog, "shown").text(), QStringLiteral("3 raters are enough for this width"));
}

}  // namespace
}  // namespace torsio::gui
