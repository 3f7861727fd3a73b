// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's question about a moment of a practice run, and the physician's answer, with real widgets.
// Training before being scored: stopped, or noted with a reason, and explained.

#include <functional>
#include <optional>
#include <string>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QString>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/questions_card.h"
#include "app/gui/trainee/remarks_page.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/theme.h"
#include "app/services/base/assets.h"
#include "app/services/review/case_remarks.h"
#include "app/services/training/questions.h"
#include "app/services/training/remarks.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/row_reader.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/servo_health.h"
#include "sim/core/spsc_ring.h"
#include "sim/record/recorder.h"
#include "sim/record/sample_codec.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/app/support/training_centre.h"

namespace torsio::gui {

namespace {

using torsio::testing::kMinute_us;
using torsio::testing::TrainingCentre;

class QuestionCards : public ::testing::Test {
 protected:
  QuestionCards() {
    PeopleRepository people(centre_.connection());
    people.setIdentity({.personId = chief_, .fullName = "Dr. Li Na"});
    people.setIdentity({.personId = centre_.person(), .fullName = "Chen Wei"});
  }

  TrainingCentre centre_;
  std::string trial_ = centre_.attempt("first", "practice", 1.0);
  std::string chief_ = PeopleRepository(centre_.connection()).raters().front().person.id;
  std::optional<ShellContext> shell_;
  QStringList said_;

  void addRemarkOfTheChief(ShellContext& shell) {
    const Actor& chief = shell.session().actor();
    RemarkRepository(centre_.connection())
        .add({.id = "11111111-1111-4111-8111-111111111111",
              .trialId = trial_,
              .author = chief.userId,
              .authorPersonId = chief.personId,
              .purpose = "remark",
              .text = "let go more gently"});
  }
  /// Signs somebody in.
  ShellContext& shellOf(const std::string& who) {
    shell_.reset();
    centre_.become(who);
    said_.clear();
    shell_.emplace(centre_.session(), assetsFolder(), ThemeKind::kLight);
    QObject::connect(&*shell_, &ShellContext::noticed, [this](const QString& text) { said_ << text; });
    QObject::connect(&*shell_, &ShellContext::failed, [this](const QString& text) { said_ << text; });
    return *shell_;
  }
  static QString textsOf(const QWidget& widget) {
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
      texts << label->text();
    }
    return texts.join(QLatin1Char('\n'));
  }
  static void settle() {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QApplication::processEvents();
  }
};

TEST_F(QuestionCards, ATraineeAsksAboutTheMomentShown) {
  AskCard card(shellOf("T-01"));
  card.retranslate();
  card.setRun(trial_);
  card.setMoment(3.5);
  std::optional<double> asked_s;
  QObject::connect(&card, &AskCard::asked, [&](double at_s) { asked_s = at_s; });
  ASSERT_FALSE(card.isHidden());
  EXPECT_EQ(child<QComboBox>(card, "whom").currentText(), QStringLiteral("Dr. Li Na"));
  auto* text = card.findChild<QLineEdit*>(QStringLiteral("question"));
  // Nothing can be sent without text.
  EXPECT_FALSE(child<QPushButton>(card, "ask").isEnabled());
  Q_EMIT text->returnPressed();
  EXPECT_FALSE(asked_s.has_value());
  text->setText(QStringLiteral("too fast?"));

  child<QPushButton>(card, "ask").click();
  settle();

  ASSERT_TRUE(asked_s.has_value());
  EXPECT_DOUBLE_EQ(*asked_s, 3.5);
  EXPECT_TRUE(text->text().isEmpty());
  ASSERT_EQ(card.questions().questions.size(), 1U);
  EXPECT_TRUE(textsOf(card).contains(QStringLiteral("with Dr. Li Na, waiting for")));
  EXPECT_TRUE(textsOf(card).contains(QStringLiteral("You: too fast?")));
  ASSERT_EQ(said_.size(), 1);
  EXPECT_TRUE(said_[0].startsWith(QStringLiteral("Sent to Dr. Li Na")));
}

TEST_F(QuestionCards, TheCardIsHiddenIfNobodyMayBeAsked) {
  const std::string graded = centre_.attempt("second", "graded", 1.0);
  AskCard card(shellOf("T-01"));

  card.setRun(graded);
  EXPECT_TRUE(card.isHidden());
  card.setRun(trial_);
  EXPECT_FALSE(card.isHidden());
  card.setRun({});
  EXPECT_TRUE(card.isHidden());
}

TEST_F(QuestionCards, ThePhysicianAnswersAndTheTraineeReadsItAtItsMoment) {
  askPhysician(centre_.session(), trial_, 3.5, chief_, "too fast?");
  centre_.passTime_us(90 * kMinute_us);
  {
    ShellContext& shell = shellOf("chief");
    QuestionsCard card(shell);
    EXPECT_TRUE(card.isHidden());
    card.read();
    ASSERT_FALSE(card.isHidden());
    EXPECT_TRUE(textsOf(card).contains(QStringLiteral("Chen Wei, Quarter turn, first")));
    bool seen = false;
    // The dialog appears when the run is loaded, and blocks the event loop.
    QTimer waiting;
    QObject::connect(&waiting, &QTimer::timeout, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) {
        return;
      }
      waiting.stop();
      seen = true;
      EXPECT_TRUE(textsOf(*dialog).contains(QStringLiteral("too fast?")));
      auto* buttons = dialog->findChild<QDialogButtonBox*>();
      QAbstractButton* send = nullptr;
      for (QAbstractButton* button : buttons->buttons()) {
        if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) {
          send = button;
        }
      }
      ASSERT_NE(send, nullptr);
      EXPECT_FALSE(send->isEnabled());  // no text yet
      dialog->findChild<QPlainTextEdit*>()->setPlainText(QStringLiteral("No, but let go later."));
      EXPECT_TRUE(send->isEnabled());
      send->click();
    });
    waiting.start(5);

    child<QPushButton>(card, "answerQuestion").click();
    shell.waitForJobs();
    settle();

    EXPECT_TRUE(seen);
    EXPECT_TRUE(card.questions().empty());  // no open questions left
    EXPECT_TRUE(textsOf(card).contains(QStringLiteral("You answered Chen Wei: No, but let go later.")));
    child<QPushButton>(card, "editWords").click();
    child<QPlainTextEdit>(card, "newWords").setPlainText(QStringLiteral("Let go later."));
    child<QPushButton>(card, "saveWords").click();
    settle();
    EXPECT_TRUE(textsOf(card).contains(QStringLiteral("You answered Chen Wei: Let go later.")));
    EXPECT_EQ(said_, QStringList{QStringLiteral("Your answer was sent to Chen Wei")});
  }

  AskCard card(shellOf("T-01"));
  card.setRun(trial_);

  EXPECT_TRUE(textsOf(card).contains(QStringLiteral("Dr. Li Na answered on")));
  EXPECT_TRUE(textsOf(card).contains(QStringLiteral("edited since")));
  EXPECT_TRUE(textsOf(card).contains(QStringLiteral("Let go later.")));
}

TEST_F(QuestionCards, ALongQueueShowsTheThreeOldest) {
  for (const char* text : {"one", "two", "three", "four"}) {
    askPhysician(centre_.session(), trial_, 2.0, chief_, text);
    centre_.passTime_us(kMinute_us);
  }
  QuestionsCard card(shellOf("chief"));

  card.read();

  EXPECT_EQ(card.questions().size(), 4U);
  EXPECT_EQ(card.questions().front().text, "one");
  EXPECT_EQ(card.findChildren<QPushButton*>(QStringLiteral("answerQuestion")).size(), 3);
}

TEST_F(QuestionCards, AReplyToARemarkIsShownUntilRead) {
  ShellContext& shell = shellOf("chief");
  addRemarkOfTheChief(shell);
  RemarkRepository(centre_.connection())
      .add({.id = "22222222-2222-4222-8222-222222222222",
            .trialId = trial_,
            .author = "T-01",
            .purpose = "reply",
            .replyTo = "11111111-1111-4111-8111-111111111111",
            .text = "I will"});
  RepliesCard card(shell);

  card.read();

  ASSERT_FALSE(card.isHidden());
  EXPECT_TRUE(textsOf(card).contains(QStringLiteral("I will (you wrote: let go more gently)")))
      << textsOf(card).toStdString();
  EXPECT_FALSE(textsOf(card).contains(QStringLiteral("Chen")));
  child<QPushButton>(card, "readReply").click();
  settle();
  EXPECT_TRUE(card.isHidden());
  EXPECT_TRUE(repliesToMe(shell.session()).empty());
  EXPECT_TRUE(said_.isEmpty()) << said_.join('\n').toStdString();
}

TEST_F(QuestionCards, AReplyIsEditedInPlaceAndEarlierVersionsUnfold) {
  addRemarkOfTheChief(shellOf("chief"));
  RemarksPage page(shellOf("T-01"));
  page.retranslate();
  page.enter({});
  page.show();
  child<QLineEdit>(page, "reply").setText(QStringLiteral("I will"));
  child<QPushButton>(page, "send").click();
  settle();
  const auto visible = [&page](const char* name) {
    QList<QPushButton*> found = page.findChildren<QPushButton*>(QString::fromLatin1(name));
    found.removeIf([](const QPushButton* button) { return !button->isVisible(); });
    return found;
  };
  ASSERT_EQ(visible("editWords").size(), 1);  // one's own only
  EXPECT_TRUE(visible("edited").isEmpty());

  visible("editWords").front()->click();
  QPlainTextEdit* field = nullptr;
  for (auto* one : page.findChildren<QPlainTextEdit*>(QStringLiteral("newWords"))) {
    field = one->isVisible() ? one : field;
  }
  ASSERT_NE(field, nullptr);
  EXPECT_EQ(field->toPlainText(), QStringLiteral("I will"));
  field->setPlainText(QStringLiteral("I will try"));
  QTest::keyClick(field, Qt::Key_Return, Qt::ControlModifier);
  settle();

  EXPECT_TRUE(textsOf(page).contains(QStringLiteral("I will try")));
  ASSERT_EQ(visible("edited").size(), 1);
  visible("edited").front()->click();
  bool unfolded = false;
  for (const auto* earlier : page.findChildren<QLabel*>(QStringLiteral("earlierWords"))) {
    unfolded = unfolded || (earlier->isVisible() && earlier->text().endsWith(QStringLiteral(": I will")));
  }
  EXPECT_TRUE(unfolded);
  EXPECT_TRUE(said_.isEmpty()) << said_.join('\n').toStdString();
}

TEST_F(QuestionCards, OnesOwnSheetIsEmptyUntilFilledIn) {
  addRemarkOfTheChief(shellOf("chief"));
  RemarksPage page(shellOf("T-01"));
  page.retranslate();
  page.enter({});
  auto* save = page.findChild<QPushButton*>(QStringLiteral("selfScore"));
  ASSERT_NE(save, nullptr) << textsOf(page).toStdString();
  const auto fields = page.findChildren<QDoubleSpinBox*>();
  ASSERT_FALSE(fields.isEmpty());

  for (QDoubleSpinBox* field : fields) {
    EXPECT_EQ(field->text(), QStringLiteral("\u2013")) << field->accessibleName().toStdString();
    EXPECT_FALSE(save->isEnabled());
    field->setValue(field->maximum());
  }
  EXPECT_TRUE(save->isEnabled());
  save->click();
  settle();

  EXPECT_TRUE(scoreGap(centre_.session(), trial_).selfScored);
  EXPECT_TRUE(said_.isEmpty()) << said_.join('\n').toStdString();
}

/// Asks ten chiefs for the live sheet of T-01 before training.
void askTenChiefsForFirstSheet(torsio::testing::TrainingCentre& centre) {
  std::vector<Rater> chiefs(10);
  std::vector<Assignment> sheets;
  centre.connection().execute(insertInto("curriculum_occasion", "version_id, occasion, after_exposure_us"),
                              {centre.cohort().curriculumVersionId, "pre", 0});
  SheetRepository repository(centre.connection());
  RubricRepository rubrics(centre.connection());
  rubrics.addRubric("rubric", "Twist", 1, false);
  rubrics.addRevision({.id = "revision", .rubricId = "rubric", .number = 1, .overall = {0, 100, 10}});
  for (std::size_t i = 0; i < chiefs.size(); ++i) {
    const std::string number = std::to_string(i + 11);
    chiefs[i].person = {.id = "chief-" + number, .code = "R-" + number, .createdUtc_us = 1};
    chiefs[i].classCode = "chief";
    sheets.push_back({.id = "sheet-" + number,
                      .raterId = chiefs[i].person.id,
                      .enrolmentId = centre.enrolment(),
                      .occasionCode = "pre",
                      .rubricRevisionId = "revision",
                      .caseLabel = "7L",
                      .position = 1,
                      .assignedBy = "office",
                      .assignedUtc_us = 1});
  }
  PeopleRepository(centre.connection()).addRaters(chiefs);
  repository.assign(sheets);
}

TEST(StationPages, TrainingBeforeAnySheetIsExplainedAndStartsOnlyWithANotedReason) {
  torsio::testing::TrainingCentre centre;
  askTenChiefsForFirstSheet(centre);
  Station station(centre);
  QStringList read;
  const auto begin = [&](const std::function<void(QInputDialog&)>& answer) {
    station.open(PageId::kNextStep);
    station.press("begin");
    if (station.pageId == PageId::kDeviceCheck) {  // once a day
      station.press("goOn");
    }
    QTimer::singleShot(0, [&read, answer] {
      auto* asked = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(asked, nullptr);
      read << asked->labelText();
      answer(*asked);
    });
    station.press("start");
  };
  const auto noted = [&] { return StudyRepository(centre.connection()).deviations(centre.cohort().id); };

  begin([](QInputDialog& asked) {
    QPushButton* anyway = asked.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    EXPECT_FALSE(anyway->isEnabled()) << "without a reason nothing begins";
    asked.setTextValue(QStringLiteral("   "));
    EXPECT_FALSE(anyway->isEnabled());
    asked.reject();
  });

  ASSERT_EQ(read.size(), 1);
  EXPECT_TRUE(read[0].contains(QStringLiteral("Only 0 of 10 sheet(s) for this occasion are in")))
      << read[0].toStdString();
  EXPECT_TRUE(testing::eventually([&] { return station.pageId == PageId::kNextStep; }));
  EXPECT_TRUE(noted().empty());
  EXPECT_TRUE(StudyRepository(centre.connection()).trialIds(centre.cohort().id).empty());

  begin([](QInputDialog& asked) {
    asked.setTextValue(QStringLiteral("the arm is out of order"));
    asked.accept();
  });

  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  ASSERT_EQ(noted().size(), 1U);
  EXPECT_EQ(noted()[0].kind, "trained before scoring");
  EXPECT_TRUE(noted()[0].description.ends_with("0 of 10 sheets were in: the arm is out of order"))
      << noted()[0].description;
  EXPECT_EQ(noted()[0].enrolmentId, centre.enrolment());
}

/// Copies a trial as recorded by a busy computer: 50 ms of each twist are missing.
TrialId tornCopy(TrainingCentre& centre, const TrialId& trialId) {
  TrialRepository trials(centre.connection());
  const Trial trial = trials.load(trialId);
  TrialHeader header = trial.header;
  header.trialId = "00000000-0000-4000-8000-00000000707a";
  SpscRing<Sample> ring(kRecordingRing);
  TrialRepository sink(centre.connection(), {.station = "station 1",
                                             .enrolmentId = centre.enrolment(),
                                             .moduleId = centre.module("first"),
                                             .attemptMode = AttemptMode::kPractice});
  Recorder recorder(ring, sink, header);
  int gripped = 0;
  for (const Sample& sample : decodeTrial(trial)) {
    gripped = sample.phase == ExercisePhase::kTwisting ? gripped + 1 : 0;
    if (gripped > 100 && gripped <= 150) {
      continue;
    }
    EXPECT_TRUE(ring.push(sample));
    recorder.pump();
  }
  static_cast<void>(recorder.finish(TrialOutcome::kCompleted, 0, ServoHealth{true, true, 50, 1}));
  return header.trialId;
}

TEST(StationPages, TheDebriefSaysThatTheComputerWasTooBusyAndNotTheTraineesFault) {
  TrainingCentre centre({.mastery = {{.metric = "force.violations", .comparison = "at_most"}}});
  const TrialId whole = centre.attempt("first", "practice", 1.0);
  const TrialId torn = tornCopy(centre, whole);
  Station station(centre);
  station.desk().lastScene = borrowed(torsio::testing::trainingBar());

  station.open(PageId::kDebrief, toQString(whole));
  EXPECT_FALSE(station.allText().contains(QStringLiteral("too busy"))) << station.allText().toStdString();
  station.open(PageId::kDebrief, toQString(torn));

  const QString told = station.allText();
  EXPECT_TRUE(told.contains(QStringLiteral("Not judged: the computer was too busy"))) << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("This is not your fault"))) << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("Close other programs"))) << told.toStdString();
  EXPECT_FALSE(told.contains(QStringLiteral("Not passed yet"))) << told.toStdString();
  EXPECT_FALSE(told.contains(QStringLiteral("Too little of this run"))) << told.toStdString();

  station.open(PageId::kTrend, QString::fromStdString(centre.module("first")));
  const QString trend = station.page->findChild<DataTable*>()->asText();
  EXPECT_TRUE(trend.contains(QStringLiteral("Not judged"))) << trend.toStdString();
  EXPECT_FALSE(trend.contains(QStringLiteral("Not passed"))) << trend.toStdString();
  station.open(PageId::kTranscript);
  EXPECT_TRUE(station.page->findChild<QTextBrowser*>()->toPlainText().contains(QStringLiteral("not judged")));
}

}  // namespace

}  // namespace torsio::gui
