// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/case_page.h"

#include <algorithm>
#include <utility>

#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/base/page.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/sign_dialog.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/form.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/review_queue.h"
#include "assessment/domain/rating/written_words.h"

namespace torsio::gui {

namespace {

constexpr std::int64_t kSaveWatchedEvery_us = 5'000'000;

/// Settings key of automatic advance, for each user.
QString advanceKey(ShellContext& shell) {
  return QStringLiteral("users/%1/advance").arg(toQString(shell.session().actor().userId));
}

}  // namespace

CasePage::CasePage(ShellContext& shell, QWidget* parent)
    : Page(shell, parent),
      title_(new QLabel(this)),
      facts_(new QLabel(this)),
      saved_(new QLabel(this)),
      undo_(new QToolButton(this)),
      redo_(new QToolButton(this)),
      clear_(named(new QToolButton(this), "clearSheet")),
      advance_(named(new QToolButton(this), "advance")),
      amend_(new QPushButton(this)),
      submit_(primaryButton(this)),
      halves_(new QSplitter(Qt::Horizontal, this)),
      replay_(named(new ReplayPanel(shell.assets(), this), "replay")),
      sheet_(named(new SheetEditorPanel(false, this), "sheetPanel")),
      remarks_(named(sentence(this), "remarks")),
      remarkField_(named(new QLineEdit(this), "remarkField")),
      bookmark_(new QToolButton(this)),
      remark_(new QToolButton(this)) {
  QVBoxLayout* column =
      columnOf(this, {2 * kSpace, kSpace + kSpace / 2, 2 * kSpace, kSpace + kSpace / 2}, kSpace);
  createHead(column);
  auto* left = new QWidget(this);
  QVBoxLayout* leftColumn = columnOf(left, {0, 0, kSpace, 0});
  leftColumn->addWidget(replay_, 1);
  auto* marks = new QHBoxLayout;
  marks->addWidget(bookmark_);
  marks->addWidget(remark_);
  marks->addWidget(remarks_, 1);
  leftColumn->addLayout(marks);
  leftColumn->addWidget(remarkField_);
  remarks_->setTextFormat(Qt::RichText);
  remarkField_->hide();
  remarkField_->setMaxLength(static_cast<int>(kLongestRemark));
  halves_->addWidget(left);
  halves_->addWidget(sheet_);
  halves_->setStretchFactor(0, 3);
  halves_->setStretchFactor(1, 2);
  halves_->setChildrenCollapsible(false);
  halves_->setHandleWidth(kSpace);
  column->addWidget(halves_, 1);
  column->addWidget(createStrip());
  // A wrapping sentence requests the height of its narrowest shape, which would enlarge the window on a small
  // screen.
  for (QLabel* text : {remarks_, stripText_}) {
    text->setMinimumHeight(fontMetrics().height());
  }
  remarkField_->installEventFilter(this);
  connect(sheet_, &SheetPanel::edited, this, &CasePage::edited);
  connect(sheet_, &SheetEditorPanel::finishWanted, this,
          [this] { amending_ ? finishAmending() : askSubmit(); });
  connect(sheet_, &SheetEditorPanel::heldBack, this, [this] {
    this->shell().notify(tr("This is the next case. Watch it, or change its sheet, first"));
  });
  // On success the recording is shown afterwards; failure and cancellation end here.
  connect(&shell, &ShellContext::jobEnded, this, [this] {
    if (sheet_->editor() != nullptr && !opened_.shown.live && !replay_->ready()) {
      replay_->showSentence(tr("The recording could not be opened."));
    }
  });
  connect(bookmark_, &QToolButton::clicked, this, [this] { addBookmark(QString()); });
  connect(remark_, &QToolButton::clicked, this, &CasePage::askRemark);
  connect(remarks_, &QLabel::linkActivated, this,
          [this](const QString& id) { editRemark(id.toStdString()); });
  connect(replay_, &ReplayPanel::played, this, [this](qint64 from, qint64 to, double speed) {
    watched_.played(from, to, speed);
    sheet_->touched();
    noteWork();
    replay_->setWatched(watched_.spans());
    if (sheet_->asking() && !amending_) {
      showCheck();  // updates the question while the rater keeps watching
    }
    const bool crossed = from / kSaveWatchedEvery_us != to / kSaveWatchedEvery_us;
    if (crossed && opened_.state != SheetState::kSubmitted) {
      save();
    }
  });
}

CasePage::~CasePage() = default;

void CasePage::createHead(QVBoxLayout* column) {
  title_->setProperty("heading", true);
  facts_->setProperty("quiet", true);
  saved_.label()->setProperty("quiet", true);
  QHBoxLayout* head = rowOf({title_});
  head->addSpacing(kSpace);
  head->addWidget(facts_, 1);
  head->addWidget(saved_.label());
  advance_->setCheckable(true);
  connect(advance_, &QToolButton::toggled, this, [this](bool on) { sheet_->setAdvancing(on); });
  // Only on clicks: programmatic changes are not the user's choice.
  connect(advance_, &QToolButton::clicked, this,
          [this](bool on) { QSettings().setValue(advanceKey(shell()), on); });
  head->addWidget(advance_);
  head->addWidget(undo_);
  head->addWidget(redo_);
  head->addWidget(clear_);
  head->addWidget(amend_);
  head->addWidget(submit_);
  column->addLayout(head);
  connect(undo_, &QToolButton::clicked, sheet_, &SheetEditorPanel::undo);
  connect(redo_, &QToolButton::clicked, sheet_, &SheetEditorPanel::redo);
  connect(clear_, &QToolButton::clicked, sheet_, &SheetEditorPanel::clearAll);
  connect(amend_, &QPushButton::clicked, this, &CasePage::startAmending);
  connect(submit_, &QPushButton::clicked, this, &CasePage::askSubmit);
}

QWidget* CasePage::createStrip() {
  strip_ = named(new QFrame(this), "card");
  stripText_ = sentence(strip_, false);
  stripReason_ = new QLineEdit(strip_);
  stripReason_->setMaxLength(static_cast<int>(kLongestReason));
  stripGo_ = named(primaryButton(strip_), "stripGo");
  stripBack_ = new QPushButton(strip_);
  auto* row = new QHBoxLayout(strip_);
  row->setContentsMargins(2 * kSpace, kSpace, 2 * kSpace, kSpace);
  row->addWidget(stripText_, 2);
  row->addWidget(stripReason_, 2);
  row->addWidget(stripGo_);
  row->addWidget(stripBack_);
  strip_->hide();
  connect(stripGo_, &QPushButton::clicked, this, [this] { amending_ ? finishAmending() : submit(); });
  connect(stripBack_, &QPushButton::clicked, this, [this] {
    sheet_->setAsking(false);
    if (amending_) {
      amending_ = false;
      sheet_->beginSheet(opened_.rubric, opened_.sheet);
    }
    showAll();
    sheet_->takeFocus();
  });
  return strip_;
}

void CasePage::enter(const QVariant& argument) {
  const std::string id = argument.toString().toStdString();
  replay_->pause();
  replay_->show(nullptr);
  amending_ = false;
  rules_ = viewingRules(shell().session());
  opened_ = openSheet(shell().session(), id);
  watched_ = opened_.watched;
  kept_ = watched_;
  caseRemarks_ = caseRemarks(shell().session(), id);
  versions_ = sheetVersions(shell().session(), id);
  sheet_->beginSheet(opened_.rubric, opened_.sheet);
  if (std::exchange(sealed_, false)) {
    sheet_->waitForTouch();
  }
  advance_->setChecked(QSettings().value(advanceKey(shell())).toBool());
  replay_->setSpeeds(rules_.speeds);
  sinceKey_.start();
  saved_.say([found = opened_.state == SheetState::kDraft] {
    return found ? tr("Draft found and opened") : QString();
  });
  showAll();
  sheet_->takeFocus();
  load();
}

void CasePage::load() {
  const std::uint64_t ticket = ++loads_;
  if (opened_.shown.live) {
    replay_->showSentence(tr("This case is scored live; there is no recording."));
    return;
  }
  replay_->showSentence(tr("The recording is being opened. You may score meanwhile."));
  shell().run(
      this, tr("Opening case %1").arg(toQString(opened_.shown.label)),
      [id = opened_.shown.assignmentId, assets = shell().assets()](SessionContext& own,
                                                                   const ProgressCallback&) {
        return loadForShowing(loadBlindedRecording(own, id), assets);
      },
      [this, ticket](std::shared_ptr<LoadedRecording> loaded) {
        if (ticket != loads_) {
          return;
        }
        replay_->show(std::move(loaded));
        replay_->setWatched(watched_.spans());
        showRemarks();
      });
}

bool CasePage::leave() {
  replay_->pause();
  if (sheet_->editor() != nullptr && opened_.state == SheetState::kDraft) {
    save();
  }
  ++loads_;
  replay_->show(nullptr);
  return true;
}

void CasePage::noteWork() {
  if (sinceKey_.isValid()) {
    watched_.worked(std::min<std::int64_t>(sinceKey_.nsecsElapsed() / 1000, kLongestPause_us));
  }
  sinceKey_.start();
}

void CasePage::edited() {
  noteWork();
  if (!amending_) {
    save();
  }
  showAll();
}

void CasePage::customEvent(QEvent* event) {
  if (event->type() == databaseAnsweredEvent() && sheet_->unsaved()) {
    save();
  }
}

/// Replaces what was played here by what counts of it.
void CasePage::keepWatched() {
  watched_ = watchedInWindow(shell().session(), opened_.shown.assignmentId.text(), kept_, watched_);
  kept_ = watched_;
}

void CasePage::save() {
  if (opened_.state == SheetState::kSubmitted) {
    return;
  }
  sheet_->save(
      shell(), saved_, [] { return tr("Saved"); },
      [this] {
        SheetEditor& editor = *sheet_->editor();
        keepWatched();
        editor.saved(saveSheet(shell().session(), opened_.shown.assignmentId, editor.sheet(), watched_));
        opened_.state = SheetState::kDraft;
      });
}

void CasePage::addBookmark(const QString& text) {
  if (!replay_->ready()) {
    return;
  }
  attempt(shell(), [&] {
    addCaseRemark(shell().session(), opened_.shown.assignmentId,
                  {.time_us = replay_->position_us(), .text = text.toStdString()});
    caseRemarks_ = caseRemarks(shell().session(), opened_.shown.assignmentId);
  });
  showRemarks();
}

void CasePage::askRemark() {
  if (!replay_->ready()) {
    return;
  }
  edited_ = {};
  replay_->pause();
  remarkField_->show();
  remarkField_->setFocus(Qt::OtherFocusReason);
}

void CasePage::storeRemark() {
  const QString text = remarkField_->text().trimmed();
  if (text.isEmpty()) {
    return;
  }
  if (edited_.empty()) {
    return addBookmark(text);
  }
  const auto old = std::find_if(caseRemarks_.begin(), caseRemarks_.end(),
                                [this](const CaseRemark& one) { return one.id == edited_; });
  if (old != caseRemarks_.end() && toQString(old->text) == text) {
    return;
  }
  attempt(shell(), [&] {
    editCaseRemark(shell().session(), opened_.shown.assignmentId, edited_, text.toStdString());
    caseRemarks_ = caseRemarks(shell().session(), opened_.shown.assignmentId);
  });
  showRemarks();
}

void CasePage::askSubmit() {
  if (sheet_->editor() == nullptr || opened_.state == SheetState::kSubmitted) {
    return;
  }
  if (sheet_->asking()) {
    submit();
    return;
  }
  sheet_->setAsking(true);
  replay_->pause();
  showAll();
}

void CasePage::submit() {
  const SheetCheck check =
      checkSheet(opened_, sheet_->editor()->sheet(), watched_, rules_, shell().session().now_us());
  if (!check.mayBeSubmitted()) {
    if (!check.unanswered.empty()) {
      sheet_->setCurrentRow(check.unanswered.front());
    }
    sheet_->takeFocus();
    return;
  }
  if (!readyToSign(this, shell(), SignatureMeaning::kScored)) {
    return;
  }
  attempt(shell(), [&] {
    noteWork();
    keepWatched();
    submitSheet(shell().session(), opened_.shown.assignmentId, sheet_->editor()->sheet(), watched_);
    shell().notify(tr("Case %1 is submitted and sealed").arg(toQString(opened_.shown.label)));
    opened_.state = SheetState::kSubmitted;
    const auto next = reviewQueue(shell().session()).next;
    if (next) {
      sealed_ = true;
      shell().open(PageId::kCase, toQString(*next));
    } else {
      shell().open(PageId::kQueue);
    }
  });
}

void CasePage::startAmending() {
  amending_ = true;
  showAll();
  sheet_->takeFocus();
}

void CasePage::finishAmending() {
  if (!readyToSign(this, shell(), SignatureMeaning::kAmended)) {
    return;
  }
  if (!attempt(shell(), [&] {
        changeSubmitted(shell().session(), opened_.shown.assignmentId, sheet_->editor()->sheet(),
                        stripReason_->text().trimmed().toStdString());
        stripReason_->clear();
        shell().notify(tr("The new version is sealed; the one before is kept"));
        shell().open(PageId::kCase, toQString(opened_.shown.assignmentId));
      })) {
    stripReason_->setFocus(Qt::OtherFocusReason);
  }
}

void CasePage::keyPressEvent(QKeyEvent* event) {
  const Qt::KeyboardModifiers modifiers = event->modifiers();
  if (sheet_->handleCommand(event)) {
    return;
  }
  if (event->key() == Qt::Key_Escape && sheet_->asking()) {
    sheet_->setAsking(false);
    showAll();
    sheet_->takeFocus();
    return;
  }
  const bool plain = (modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0;
  if (plain && event->key() == Qt::Key_B) {
    return addBookmark(QString());
  }
  if (plain && event->key() == Qt::Key_R) {
    return (modifiers & Qt::ShiftModifier) != 0 ? editRemark({}) : askRemark();
  }
  if (plain && replay_->handleKey(event->key())) {
    return;
  }
  if (sheet_->handleKey(event->key(), modifiers)) {
    return;
  }
  Page::keyPressEvent(event);
}

bool CasePage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) {
    return Page::eventFilter(watched, event);
  }
  auto* key = static_cast<QKeyEvent*>(event);
  const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (watched == remarkField_ && (enter || key->key() == Qt::Key_Escape)) {
    if (enter) {
      storeRemark();
    }
    edited_ = {};
    remarkField_->clear();
    remarkField_->hide();
    sheet_->takeFocus();
    return true;
  }
  return Page::eventFilter(watched, event);
}

}  // namespace torsio::gui
