// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/restore_page.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

constexpr int kWordWidth = 220;
constexpr int kNumberColumns = 4;

/// Returns whether the error is about the file, and not about the record or the user.
bool isAboutFile(const Error& error, const std::filesystem::path& file) {
  return error.where() == file.string();
}

QString number(std::int64_t value, const QLocale& locale) {
  return locale.toString(static_cast<qlonglong>(value));
}

}  // namespace

RestorePage::RestorePage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      back_(new QPushButton(this)),
      backup_(new Card(QString(), this)),
      backupText_(sentence(this)),
      fileLabel_(new QLabel(this)),
      file_(named(new QLineEdit(this), "file")),
      choose_(new QPushButton(this)),
      check_(named(primaryButton(this), "checkButton")),
      compare_(new Card(QString(), this)),
      loss_(named(sentence(this, false), "lossText")),
      confirm_(new Card(QString(), this)),
      confirmText_(sentence(this, false)),
      wordLabel_(new QLabel(this)),
      word_(named(new QLineEdit(this), "word")),
      restore_(named(primaryButton(this), "restoreButton")),
      checks_(new FieldChecks(this)) {
  layOut();
  connect(back_, &QPushButton::clicked, this, [this] { this->shell().open(PageId::kMaintenance); });
  connect(choose_, &QPushButton::clicked, this, &RestorePage::choose);
  connect(check_, &QPushButton::clicked, this, &RestorePage::check);
  connect(file_, &QLineEdit::returnPressed, this, &RestorePage::check);
  connect(file_, &QLineEdit::textChanged, this, &RestorePage::fileChanged);
  connect(word_, &QLineEdit::textChanged, this, &RestorePage::showButtons);
  connect(restore_, &QPushButton::clicked, this, &RestorePage::restore);
  connect(&shell, &ShellContext::jobStarted, this, &RestorePage::showButtons);
  connect(&shell, &ShellContext::jobEnded, this, &RestorePage::showButtons);
  retranslate();
}

void RestorePage::layOut() {
  heading_->addAction(back_);
  QVBoxLayout* column = scrolledColumn(this);
  column->addWidget(heading_);
  for (Card* card : {backup_, compare_, confirm_}) {
    column->addWidget(card);
  }
  column->addStretch(1);

  fileLabel_->setBuddy(file_);
  QHBoxLayout* fileRow = rowOf({fileLabel_});
  fileRow->addWidget(file_, 1);
  fileRow->addWidget(choose_);
  fileRow->addWidget(check_);
  backup_->content()->addWidget(backupText_);
  backup_->content()->addLayout(fileRow);
  checks_->add(backup_->content(), file_, [this] {
    if (file_->text().trimmed().isEmpty()) {
      return tr("Choose a backup, or type its path.");
    }
    return unusable_ ? translatedLine(*unusable_) : QString();
  });

  numbers_ = new QGridLayout;
  numbers_->setHorizontalSpacing(4 * kSpace);
  numbers_->setVerticalSpacing(kSpace / 2);
  numbers_->setColumnStretch(kNumberColumns, 1);
  compare_->content()->addLayout(numbers_);
  compare_->content()->addSpacing(kSpace / 2);
  compare_->content()->addWidget(loss_);

  wordLabel_->setBuddy(word_);
  word_->setMaximumWidth(kWordWidth);
  QHBoxLayout* wordRow = rowOf({wordLabel_, word_, restore_});
  wordRow->addStretch(1);
  confirm_->content()->addWidget(confirmText_);
  confirm_->content()->addLayout(wordRow);
  checks_->add(confirm_->content(), word_, [this] {
    return plan_ && word_->text().trimmed() != wantedWord()
               ? tr("This is not yet the word: %1, with the same capitals.").arg(wantedWord())
               : QString();
  });
}

void RestorePage::enter(const QVariant& argument) {
  file_->setText(argument.toString());
  fileChanged();
  file_->setFocus();
  check();
}

void RestorePage::choose() {
  const QString chosen = askFileToOpen(this, tr("Choose a backup"), tr("Backup (*.sqlite)"), file_->text());
  if (chosen.isEmpty()) {
    return;
  }
  file_->setText(chosen);
  check();
}

void RestorePage::fileChanged() {
  plan_.reset();
  unusable_.reset();
  word_->clear();
  showPlan();
}

void RestorePage::check() {
  if (file_->text().trimmed().isEmpty() || shell().working()) {
    return;
  }
  const std::filesystem::path file = toPath(file_->text().trimmed());
  const auto show = [this](std::optional<RestorePlan> plan, std::optional<Error> unusable) {
    plan_ = std::move(plan);
    unusable_ = std::move(unusable);
    showPlan();
    checks_->touch(file_);
    (plan_ ? word_ : file_)->setFocus();
  };
  shell().run(
      this, tr("Checking the backup"),
      [file](SessionContext& session, const ProgressCallback& progress) {
        return planRestore(session, file, progress);
      },
      [show](RestorePlan plan) { show(std::move(plan), std::nullopt); },
      [show, file](const Error& error) {
        const bool aboutFile = isAboutFile(error, file);
        if (aboutFile) {
          show(std::nullopt, error);
        }
        return aboutFile;
      });
}

void RestorePage::restore() {
  if (!plan_ || shell().working()) {
    return;
  }
  bool asked = false;
  const bool ready = attempt(shell(), [&] {
    if (!mayRestoreNow(shell().session(), *plan_)) {
      asked = true;
      askSecond();
    }
  });
  if (!ready || asked) {
    return;
  }
  RestorePlan meant = *plan_;
  meant.otherCentreMeant = meant.otherCentre;  // its name was typed
  shell().run(
      this, tr("Restoring the backup"),
      [plan = std::move(meant)](SessionContext& session, const ProgressCallback& progress) {
        return std::shared_ptr<PreparedRestore>(prepareRestore(session, plan, progress));
      },
      [this, name = QFileInfo(toQString(plan_->backup)).fileName()](
          const std::shared_ptr<PreparedRestore>& prepared) {
        const QString kept = toQString(prepared->safety());
        RecordChange change;
        change.swap = [prepared] { prepared->takeOver(); };
        change.sentence =
            tr("The record was restored from %1. As it was before, it is kept in %2").arg(name, kept);
        shell().changeRecord(change);
      });
}

void RestorePage::askSecond() {
  const std::optional<std::string> reason =
      askReason(this, tr("Restore a backup"), tr("Why is it restored? Another administrator confirms it."));
  if (reason) {
    (void)offerToAsk(this, shell(), wishFor(*plan_, *reason));
  }
}

void RestorePage::showPlan() {
  while (QLayoutItem* item = numbers_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  compare_->setVisible(plan_.has_value());
  confirm_->setVisible(plan_.has_value());
  showButtons();
  if (!plan_) {
    return;
  }
  const RestorePlan& plan = *plan_;
  using Line = std::array<QString, kNumberColumns>;
  const auto line = [this](const QString& what, std::int64_t now, std::int64_t then, std::int64_t lost) {
    return Line{what, number(now, locale()), number(then, locale()), number(lost, locale())};
  };
  const std::vector<Line> lines = {
      {QString(), tr("Now"), tr("In the backup"), tr("Lost")},
      {tr("Centre"), orDash(plan.presentCentre), orDash(plan.backupCentre), QString()},
      line(tr("Recordings"), plan.present.trials, plan.restored.trials, plan.lostTrials),
      line(tr("Marks"), plan.present.marks, plan.restored.marks, plan.lostMarks),
      line(tr("People"), plan.present.people, plan.restored.people, plan.lostPeople),
      {tr("Newest recording or mark"), shownTime(plan.present.newestUtc_us, locale()),
       shownTime(plan.restored.newestUtc_us, locale()), QString()}};
  for (std::size_t row = 0; row < lines.size(); ++row) {
    for (std::size_t place = 0; place < lines[row].size(); ++place) {
      auto* label = new QLabel(lines[row][place], compare_);
      if (row == 0 || place == 0) {
        setLook(label, "quiet", true);
      }
      numbers_->addWidget(label, static_cast<int>(row), static_cast<int>(place),
                          place == 0 ? Qt::AlignLeft : Qt::AlignRight);
    }
  }
  const bool loses = plan.lostTrials + plan.lostMarks + plan.lostPeople > 0;
  QString words =
      loses ? tr("What was added after the backup is no longer in the record: recordings %1, marks %2, "
                 "people %3. It stays in the safety backup.")
                  .arg(number(plan.lostTrials, locale()), number(plan.lostMarks, locale()),
                       number(plan.lostPeople, locale()))
            : tr("Nothing recorded is lost: the backup has every recording, mark and person of today.");
  if (plan.otherCentre) {
    words.prepend(tr("! This is the backup of another centre: %1. The record of %2 would be gone from here.")
                      .arg(orDash(plan.backupCentre), orDash(plan.presentCentre)) +
                  QLatin1Char('\n'));
  }
  words +=
      QLatin1Char('\n') +
      tr("Passwords, accounts, settings and consents are those of the backup. Look at consents afterwards.");
  if (plan.erasedSince > 0) {
    words += QLatin1Char('\n') + tr("Erased after this backup: %n person(s). They stay erased.", nullptr,
                                    static_cast<int>(plan.erasedSince));
  }
  loss_->setText(words);
  setLook(loss_, "caution", loses || plan.otherCentre);
  nameWord();
}

QString RestorePage::wantedWord() const {
  const bool other = plan_ && plan_->otherCentre && !plan_->backupCentre.empty();
  return other ? toQString(plan_->backupCentre) : tr("RESTORE");
}

void RestorePage::nameWord() {
  nameField(wordLabel_,
            tr("&Type %1 to go on").arg(wantedWord().replace(QLatin1Char('&'), QStringLiteral("&&"))));
}

void RestorePage::showButtons() {
  const bool free = !shell().working();
  const bool given = !file_->text().trimmed().isEmpty();
  check_->setEnabled(free && given);
  choose_->setEnabled(free);
  file_->setEnabled(free);
  word_->setEnabled(free);
  restore_->setEnabled(free && plan_ && word_->text().trimmed() == wantedWord());
}

void RestorePage::retranslate() {
  heading_->setTexts(tr("Restore from a backup"),
                     tr("The record of all people at all stations goes back to the day of the backup."));
  back_->setText(tr("&Back to maintenance"));
  backup_->setTitle(tr("1  The backup"));
  backupText_->setText(
      tr("It is first read from end to end in a copy; your record is not touched. Nobody may be working: "
         "close Torsio at all other stations."));
  nameField(fileLabel_, tr("Backup &file"));
  choose_->setText(tr("C&hoose\u2026"));
  check_->setText(tr("&Check this backup"));
  compare_->setTitle(tr("2  What is kept and what is lost"));
  confirm_->setTitle(tr("3  Restore"));
  confirmText_->setText(
      tr("A safety backup of the record as it is now is made first, beside the record. Then the backup takes "
         "its place, and everybody signs in again."));
  nameWord();
  restore_->setText(tr("&Restore now"));
  showPlan();
}

}  // namespace torsio::gui
