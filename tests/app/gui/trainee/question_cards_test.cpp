// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's question about a moment of a practice run, and the physician's answer, with real widgets.
#include <optional>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/base/shell_context.h"
#include "app/gui/physician/questions_card.h"
#include "app/gui/trainee/remarks_page.h"
#include "app/gui/widgets/theme.h"
#include "app/services/base/assets.h"
#include "app/services/review/case_remarks.h"
#include "app/services/training/questions.h"
#include "app/services/training/remarks.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/trial/remark_repository.h"
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
  EXPECT_EQ(card.findChild<QComboBox*>(QStringLiteral("whom"))->currentText(), QStringLiteral("Dr. Li Na"));
  auto* text = card.findChild<QLineEdit*>(QStringLiteral("question"));
  // Nothing can be sent without text.
  EXPECT_FALSE(card.findChild<QPushButton*>(QStringLiteral("ask"))->isEnabled());
  Q_EMIT text->returnPressed();
  EXPECT_FALSE(asked_s.has_value());
  text->setText(QStringLiteral("too fast?"));

  card.findChild<QPushButton*>(QStringLiteral("ask"))->click();
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

    card.findChild<QPushButton*>(QStringLiteral("answerQuestion"))->click();
    shell.waitForJobs();
    settle();

    EXPECT_TRUE(seen);
    EXPECT_TRUE(card.questions().empty());  // no open questions left
    EXPECT_TRUE(textsOf(card).contains(QStringLiteral("You answered Chen Wei: No, but let go later.")));
    card.findChild<QPushButton*>(QStringLiteral("editWords"))->click();
    card.findChild<QPlainTextEdit*>(QStringLiteral("newWords"))
        ->setPlainText(QStringLiteral("Let go later."));
    card.findChild<QPushButton*>(QStringLiteral("saveWords"))->click();
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
  const Actor& actor = shell.session().actor();
  RemarkRepository remarks(centre_.connection());
  remarks.add({.id = "11111111-1111-4111-8111-111111111111",
               .trialId = trial_,
               .author = actor.userId,
               .authorPersonId = actor.personId,
               .purpose = "remark",
               .text = "let go more gently"});
  remarks.add({.id = "22222222-2222-4222-8222-222222222222",
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
  card.findChild<QPushButton*>(QStringLiteral("readReply"))->click();
  settle();
  EXPECT_TRUE(card.isHidden());
  EXPECT_TRUE(repliesToMe(shell.session()).empty());
  EXPECT_TRUE(said_.isEmpty()) << said_.join('\n').toStdString();
}

TEST_F(QuestionCards, AReplyIsEditedInPlaceAndEarlierVersionsUnfold) {
  ShellContext& chief = shellOf("chief");
  RemarkRepository remarks(centre_.connection());
  remarks.add({.id = "11111111-1111-4111-8111-111111111111",
               .trialId = trial_,
               .author = chief.session().actor().userId,
               .authorPersonId = chief.session().actor().personId,
               .purpose = "remark",
               .text = "let go more gently"});
  RemarksPage page(shellOf("T-01"));
  page.retranslate();
  page.enter({});
  page.show();
  page.findChild<QLineEdit*>(QStringLiteral("reply"))->setText(QStringLiteral("I will"));
  page.findChild<QPushButton*>(QStringLiteral("send"))->click();
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
  ShellContext& chief = shellOf("chief");
  RemarkRepository(centre_.connection())
      .add({.id = "11111111-1111-4111-8111-111111111111",
            .trialId = trial_,
            .author = chief.session().actor().userId,
            .authorPersonId = chief.session().actor().personId,
            .purpose = "remark",
            .text = "let go more gently"});
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

}  // namespace
}  // namespace torsio::gui
