// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/problem_panel.h"

#include <algorithm>

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/window_events.h"

namespace torsio::gui {

namespace {

constexpr int kDetailLines = 4;

constexpr int kTroubleWidth = 720;

}  // namespace

ProblemPanel::ProblemPanel(QWidget* parent)
    : QFrame(parent),
      sign_(new QLabel(this)),
      happened_(new QLabel(this)),
      remedy_(new QLabel(this)),
      details_(new QPlainTextEdit(this)),
      fold_(linkButton(this)),
      copy_(linkButton(this)),
      close_(linkButton(this)) {
  setObjectName(QStringLiteral("problem"));
  QFont bold = happened_->font();
  bold.setWeight(QFont::DemiBold);
  happened_->setFont(bold);
  for (QLabel* label : {happened_, remedy_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label->setTextFormat(Qt::PlainText);
  }
  details_->setReadOnly(true);
  details_->setMaximumHeight(details_->fontMetrics().lineSpacing() * kDetailLines + 2 * kSpace);
  details_->hide();

  auto* texts = new QVBoxLayout;
  texts->setSpacing(4);
  texts->addWidget(happened_);
  texts->addWidget(remedy_);
  texts->addWidget(details_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * kSpace, kSpace, kSpace, kSpace);
  row->setSpacing(kSpace + 4);
  row->addWidget(sign_, 0, Qt::AlignTop);
  row->addLayout(texts, 1);
  for (QPushButton* button : {fold_, copy_, close_}) {
    row->addWidget(button, 0, Qt::AlignTop);
  }
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);

  connect(fold_, &QPushButton::clicked, this, [this] { showDetails(details_->isHidden()); });
  connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(wholeText()); });
  connect(close_, &QPushButton::clicked, this, &QWidget::hide);
  followLanguage(this, [this] { retranslate(); });
}

void ProblemPanel::tell(const Problem& problem) {
  problem_ = problem;
  say();
  showDetails(false);
  setVisible(true);
}

void ProblemPanel::floatAtTop() {
  floats_ = true;
  parentWidget()->installEventFilter(this);
  hide();
}

bool ProblemPanel::event(QEvent* event) {
  const bool done = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show) {
    place();
  }
  return done;
}

bool ProblemPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) {
    place();
  }
  return QFrame::eventFilter(watched, event);
}

void ProblemPanel::place() {
  if (!floats_ || isHidden()) {
    return;
  }
  const int width = parentWidget()->width();
  const int wanted = hasHeightForWidth() ? heightForWidth(width) : sizeHint().height();
  setGeometry(0, 0, width, std::min(wanted, parentWidget()->height()));
  raise();
}

void ProblemPanel::say() {
  TranslatedError said = problem_();
  // Errors begin in lower case, because they also appear within lines of the command line.
  if (!said.happened.isEmpty()) {
    said.happened[0] = said.happened[0].toUpper();
  }
  happened_->setText(said.happened);
  remedy_->setText(said.remedy);
  remedy_->setVisible(!said.remedy.isEmpty());
  details_->setPlainText(said.details);
  fold_->setVisible(!said.details.isEmpty());
  setAccessibleDescription(wholeText());
}

void ProblemPanel::setClosable(bool closable) {
  close_->setVisible(closable);
}

QString ProblemPanel::wholeText() const {
  QStringList parts{happened_->text()};
  for (const QString& part : {remedy_->text(), details_->toPlainText()}) {
    if (!part.isEmpty()) {
      parts << part;
    }
  }
  return parts.join(QLatin1Char('\n'));
}

void ProblemPanel::setTheme(const Theme& theme) {
  sign_->setPixmap(icon(QStringLiteral("warning"), theme.caution).pixmap(20, 20));
}

void ProblemPanel::showDetails(bool shown) {
  details_->setVisible(shown);
  fold_->setText(shown ? tr("Hide details") : tr("Details"));
}

void ProblemPanel::retranslate() {
  setAccessibleName(tr("A problem"));
  details_->setAccessibleName(tr("Details"));
  copy_->setText(tr("Copy"));
  close_->setText(tr("Close"));
  if (problem_) {
    say();
  }
  showDetails(!details_->isHidden());
}

TroublePanel::TroublePanel(QWidget* parent) : QWidget(parent), problem_(new ProblemPanel(this)) {
  QVBoxLayout* column = centredCard(this, kTroubleWidth);
  problem_->setClosable(false);
  retry_ = primaryButton(this);
  other_ = linkButton(this);
  column->addWidget(problem_);
  column->addSpacing(kSpace);
  auto* row = new QHBoxLayout;
  row->addWidget(other_);
  row->addStretch(1);
  row->addWidget(retry_);
  column->addLayout(row);
  connect(retry_, &QPushButton::clicked, this, &TroublePanel::retryWanted);
  connect(other_, &QPushButton::clicked, this, &TroublePanel::otherDatabaseWanted);
  followLanguage(this, [this] { retranslate(); });
}

void TroublePanel::tell(const std::exception_ptr& problem) {
  problem_->tell(
      problemOf(problem, {[] { return tr("The database cannot be used"); },
                          [] { return tr("Try again; if it stays so, ask your administrator"); }}));
}

void TroublePanel::setTheme(const Theme& theme) {
  problem_->setTheme(theme);
}

void TroublePanel::retranslate() {
  retry_->setText(tr("Try again"));
  other_->setText(tr("Use another database\u2026"));
}

}  // namespace torsio::gui
