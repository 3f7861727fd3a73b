// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/detorsion_card.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "app/gui/base/clock_time.h"
#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/trainee/detorsion_plot.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/card.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr double kWorthTelling_s = 0.05;

std::optional<double> measureOf(const DetorsionStory& story, std::string_view id) {
  const auto at = std::find_if(story.metrics.begin(), story.metrics.end(),
                               [id](const MetricValue& metric) { return metric.id == id; });
  return at == story.metrics.end() || !at->value ? std::nullopt : std::optional<double>(at->value.value());
}

QString shown(const char* id, double value) {
  return StationLabels::quantity(id, value);
}

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
  measuresText_->setText(verdicts(story_).join(QLatin1Char('\n')));
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

QStringList DetorsionCard::verdicts(const DetorsionStory& story) {
  QStringList out;
  if (const auto right = measureOf(story, "detorse.first_direction")) {
    out << (*right != 0.0 ? tr("The first turn went the right way.")
                          : tr("The first turn went the wrong way."));
  }
  if (const auto wrong = measureOf(story, "detorse.wrong_way"); wrong && *wrong > 0.02) {
    out << tr("The organ was twisted %1 further than at the start.").arg(shown("detorse.wrong_way", *wrong));
  }
  if (const auto back_s = measureOf(story, "detorse.time_to_flow"); back_s && *back_s <= 0.0) {
    out << tr("Blood flow was sufficient from the start.");
  } else if (back_s) {
    out << tr("Blood flow returned after %1; %2 for the tissue.")
               .arg(clockTenths(*back_s), DetorsionPanel::clockText(*back_s * story.timeScale));
  } else {
    out << tr("Blood flow did not return in this run.");
  }
  if (const auto dose = measureOf(story, "detorse.dose")) {
    const QString size = shown("detorse.dose", *dose);
    out << (*dose >= 1.0
                ? tr("The ischaemic dose reached %1: from 1 the tissue is lost.").arg(size)
                : tr("The ischaemic dose reached %1: the tissue survives; at 1 it would be lost.").arg(size));
  }
  const auto regrips = measureOf(story, "detorse.regrips");
  const auto least = measureOf(story, "detorse.least_regrips");
  if (regrips && least) {
    out << tr("Re-grips: %1; a hand with the usual range of motion needs at least %2.")
               .arg(*regrips, 0, 'f', 0)
               .arg(*least, 0, 'f', 0);
  }
  if (const auto slip = measureOf(story, "detorse.slip_back"); slip && *slip > 0.02) {
    out << tr("%1 were lost again between grips: set the clip before releasing.")
               .arg(shown("detorse.slip_back", *slip));
  }
  const auto stage = measureOf(story, "detorse.longest_stage");
  if (const auto staged = measureOf(story, "detorse.in_stages"); staged && stage) {
    const QString size = shown("detorse.longest_stage", *stage);
    out << (*staged != 0.0
                ? tr("Untwisted in stages: at most %1 without a rest.").arg(size)
                : tr("Turned back by %1 without a rest: let blood flow return in stages.").arg(size));
  }
  if (const auto over_s = measureOf(story, "detorse.overload_time"); over_s && *over_s > 0.0) {
    out << tr("For %1, jaw pressure or force exceeded what the ischaemic wall bears.")
               .arg(clockTenths(*over_s));
  }
  const auto count = [&story](DetorsionMoment what) {
    return std::count_if(story.events.begin(), story.events.end(),
                         [what](const DetorsionStory::Event& event) { return event.what == what; });
  };
  if (const auto tears = count(DetorsionMoment::kTear); tears > 0) {
    out << tr("Tears in the wall: %1. A torn organ does not count as untwisted.").arg(tears);
  }
  if (const auto bruises = count(DetorsionMoment::kBruise); bruises > 0) {
    out << tr("Bruises from the jaw: %1. Grip more gently: ischaemic tissue bears only half the pressure.")
               .arg(bruises);
  }
  if (const auto slips = count(DetorsionMoment::kSlip); slips > 0) {
    out << tr("Slips of the instrument: %1.").arg(slips);
  }
  if (const auto relapse = measureOf(story, "detorse.relapse"); relapse && *relapse != 0.0) {
    out << tr("The organ twisted again after it had been untwisted.");
  }
  if (const auto residual = measureOf(story, "detorse.residual")) {
    out << tr("Remaining twist: %1.").arg(shown("detorse.residual", *residual));
  }
  if (!story.mishapsKnown) {
    out << tr(
        "Bruises, tears, slips and relapses are not marked: the organ of this run is not on this machine.");
  }
  return out;
}

}  // namespace torsio::gui
