// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/detorsion_card.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/detorsion_plot.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/training/detorsion_story.h"

namespace torsio::gui {

namespace {

constexpr double kWorthTelling_s = 0.05;

}  // namespace

DetorsionCard::DetorsionCard(QWidget* parent)
    : QWidget(parent),
      line_(new Card(QString(), this)),
      spent_(new Card(QString(), this)),
      measures_(new Card(QString(), this)),
      plot_(new DetorsionPlot(line_)),
      spentText_(plainLabel(spent_)),
      measuresText_(plainLabel(measures_)) {
  setObjectName(QStringLiteral("untwisting"));
  spentText_->setObjectName(QStringLiteral("secondsSpent"));
  measuresText_->setObjectName(QStringLiteral("untwistingVerdicts"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2 * kSpace);
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * kSpace);
  measures_->content()->addWidget(measuresText_);
  measures_->content()->addStretch(1);
  spent_->content()->addWidget(spentText_);
  spent_->content()->addStretch(1);
  row->addWidget(measures_, 2);
  row->addWidget(spent_, 1);
  column->addLayout(row);
  line_->content()->addWidget(plot_, 1);
  column->addWidget(line_, 1);
  retranslate();
}

void DetorsionCard::setStory(const DetorsionStory& story) {
  story_ = story;
  plot_->setStory(story);
  retranslate();
}

void DetorsionCard::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

void DetorsionCard::retranslate() {
  line_->setTitle(tr("Over tissue time"));
  spent_->setTitle(tr("How the time was spent"));
  measures_->setTitle(tr("Findings"));
  spentText_->setText(secondsText(story_).join(QLatin1Char('\n')));
  measuresText_->setText(findings(story_).join(QLatin1Char('\n')));
  plot_->retranslate();
}

QStringList DetorsionCard::secondsText(const DetorsionStory& story) {
  const QString names[kDetorsionDoings] = {tr("Searching, not holding"), tr("Turning in the jaw"),
                                           tr("Held by the clip alone"), tr("Checking the blood flow"),
                                           tr("Waiting with hands off")};
  const double whole_s = std::accumulate(story.spent_s.begin(), story.spent_s.end(), 0.0);
  std::vector<std::size_t> order(kDetorsionDoings);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&story](std::size_t a, std::size_t b) { return story.spent_s[a] > story.spent_s[b]; });
  QStringList out;
  const QLocale locale;
  for (const std::size_t doing : order) {
    const double spent_s = story.spent_s[doing];
    if (spent_s >= kWorthTelling_s) {
      out << tr("%1: %2 (%3 %)")
                 .arg(names[doing], clockTenths(spent_s), locale.toString(100.0 * spent_s / whole_s, 'f', 0));
    }
  }
  return out;
}

QStringList DetorsionCard::findings(const DetorsionStory& story) {
  QStringList out;
  for (const UntwistingFinding& finding : findingsOf(story)) {
    out << toQString(finding.text());
  }
  return out;
}

}  // namespace torsio::gui
