// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/trouble_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/shell/problem_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/window_events.h"

namespace torsio::gui {

namespace {

constexpr int kTroubleWidth = 720;

}  // namespace

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
