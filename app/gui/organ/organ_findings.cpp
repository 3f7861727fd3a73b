// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/organ_findings.h"

#include <algorithm>

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

QString weightName(FindingWeight weight) {
  switch (weight) {
    case FindingWeight::kRefusal:
      return OrganFindings::tr("refused");
    case FindingWeight::kWarning:
      return OrganFindings::tr("warning");
    case FindingWeight::kNote:
      break;
  }
  return OrganFindings::tr("for your information");
}

/// Returns a finding without its code, with which refusals of the reader begin.
QString wordsOf(const OrganFinding& finding) {
  QString sentence = toQString(finding.what);
  const QString code = toQString(finding.code);
  if (sentence.startsWith(code)) {
    sentence = sentence.mid(code.size()).trimmed();
  }
  return capitalised(sentence);
}

QString number(double value, int decimals) {
  return numberText(value, decimals);
}

}  // namespace

OrganFindings::OrganFindings(QWidget* parent)
    : QWidget(parent), verdict_(new QLabel(this)), measures_(sentence(this)), lines_(new QVBoxLayout) {
  auto* column = bareLayout<QVBoxLayout>(this);
  verdict_->setObjectName(QStringLiteral("verdict"));
  verdict_->setWordWrap(true);
  QFont large = verdict_->font();
  large.setPointSizeF(kTitleText_pt);
  large.setBold(true);
  verdict_->setFont(large);
  column->addWidget(verdict_);
  column->addWidget(measures_);
  lines_->setSpacing(kSpace / 2);
  column->addLayout(lines_);
}

void OrganFindings::show(const OrganImport& import) {
  import_ = import;
  import_->organ.mesh.vertices_m.clear();  // only its measurements are shown
  import_->organ.mesh.vertices_m.shrink_to_fit();
  fill();
}

void OrganFindings::retranslate() {
  fill();
}

void OrganFindings::fillVerdict(const OrganImport& import) {
  const auto warnings = static_cast<int>(import.organ.warnings.size());
  setLook(verdict_, "good", import.accepted && warnings == 0);
  setLook(verdict_, "caution", !import.accepted || warnings > 0);
  verdict_->setText(!import.accepted ? tr("Refused")
                    : warnings == 0
                        ? tr("Accepted")
                        : tr("Accepted with %n warning(s), which stay with the organ", nullptr, warnings));
  QStringList measures;
  if (const std::size_t triangles = import.organ.mesh.triangles.size(); triangles > 0) {
    measures << tr("%1 triangles").arg(QLocale().toString(static_cast<qulonglong>(triangles)));
  }
  if (import.volume_ml) {
    measures << tr("%1 ml").arg(number(*import.volume_ml, 0));
  }
  if (const OrganMeasures& m = import.measures; m.length_m > 0.0) {
    measures << tr("axis %1 mm").arg(number(1000.0 * m.length_m, 0))
             << tr("%1 times as long as wide").arg(number(m.elongation, 1));
  }
  if (!import.patterns.empty()) {
    measures << tr("stays whole in %1 of %2 patterns")
                    .arg(QLocale().toString(static_cast<qulonglong>(acceptedAmong(import.patterns).size())),
                         QLocale().toString(static_cast<qulonglong>(import.patterns.size())));
  }
  measures_->setText(measures.join(QStringLiteral(" \u00b7 ")));
  measures_->setVisible(!measures.isEmpty());
}

QLabel* OrganFindings::addLine(const QString& text, bool quiet) {
  QLabel* line = sentence(this, quiet);
  line->setText(text);
  line->setTextInteractionFlags(Qt::TextSelectableByMouse);
  lines_->addWidget(line);
  shown_.push_back(line);
  return line;
}

void OrganFindings::addFinding(const OrganFinding& finding) {
  QLabel* head = addLine(tr("%1 \u00b7 %2").arg(toQString(finding.code), weightName(finding.weight)), false);
  setLook(head, "caution", finding.weight != FindingWeight::kNote);
  QFont bold = head->font();
  bold.setBold(true);
  head->setFont(bold);
  addLine(tr("%1.").arg(wordsOf(finding)), false);
  if (!finding.where.empty()) {
    addLine(tr("Where: %1").arg(toQString(finding.where)), true);
  }
  if (!finding.remedy.empty()) {
    QString remedy = toQString(finding.remedy);
    if (!remedy.endsWith(QLatin1Char('.')) && !remedy.endsWith(QChar(0x3002))) {
      remedy = tr("%1.").arg(remedy);
    }
    addLine(remedy, true);
  }
}

void OrganFindings::fill() {
  for (QWidget* line : shown_) {
    lines_->removeWidget(line);
    delete line;
  }
  shown_.clear();
  if (!import_) {
    verdict_->clear();
    measures_->hide();
    return;
  }
  fillVerdict(*import_);
  for (const OrganFinding& finding : import_->findings) {
    addFinding(finding);
  }
  if (import_->findings.empty()) {
    addLine(tr("No repairs were needed; nothing to report."), true);
  }
}

}  // namespace torsio::gui
