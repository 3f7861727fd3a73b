// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/mastery_table.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QPushButton>
#include <QSpinBox>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/curriculum/curriculum_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/signed_box.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/catalogue/quantity.h"

namespace torsio::gui {

namespace {

constexpr int kFewRules = 2;
constexpr int kMaxInARow = 1'000'000;

enum RuleColumn { kMetric, kDirection, kThreshold, kInARow };

/// Accepts more decimals than it shows by default: those of the metric, and any further ones of the value.
class ThresholdBox : public SignedBox {
 public:
  /// `quantity`: null if it is measured by a later version of Torsio.
  explicit ThresholdBox(const QuantityRow* quantity) {
    constexpr double kFarthest = 1e9;
    const ShownUnit shown = quantity != nullptr ? quantity->shown : ShownUnit{"", 1.0, 2};
    least_ = shown.decimals;
    const double from = quantity != nullptr ? shown.scale * quantity->traits.least : -kFarthest;
    setRange(std::max(-kFarthest, from), kFarthest);
    setDecimals(shown.decimals + kFiner);
    setButtonSymbols(QAbstractSpinBox::NoButtons);
    const bool close = shown.unit.empty() || shown.unit == "\u00b0";
    setSuffix((close ? QString() : QStringLiteral(" ")) + toQString(shown.unit));
  }

  [[nodiscard]] QString textFromValue(double value) const override {
    int shown = least_;
    while (shown < decimals() &&
           std::abs(value - rounded(value, shown)) > 0.5 * std::pow(10.0, -decimals())) {
      ++shown;
    }
    return numberText(value, shown);
  }

 private:
  static constexpr int kFiner = 2;
  static double rounded(double value, int decimals) {
    const double steps = std::pow(10.0, decimals);
    return std::round(value * steps) / steps;
  }

  int least_ = 0;
};

/// Changes a rule to another quantity, with its better direction and stored unit.
MasteryCriterion ruleAbout(const QuantityRow& row, MasteryCriterion rule) {
  rule.metric = row.id;
  rule.comparison = row.direction == Direction::kLowerIsBetter ? "at_most" : "at_least";
  rule.unit = row.unit;
  return rule;
}

}  // namespace

MasteryTable::MasteryTable(QWidget* parent)
    : QTableWidget(0, 4, parent), add_(new QPushButton), remove_(new QPushButton) {
  setObjectName(QStringLiteral("mastery"));
  prepareFieldTable(this);
  horizontalHeader()->setSectionResizeMode(kMetric, QHeaderView::Stretch);
  setColumnWidth(kDirection, 15 * kSpace);
  for (const int column : {kThreshold, kInARow}) {
    setColumnWidth(column, 12 * kSpace);
  }
  connect(add_, &QPushButton::clicked, this, &MasteryTable::addRule);
  connect(remove_, &QPushButton::clicked, this, &MasteryTable::removeRule);
  retranslate();
}

QBoxLayout* MasteryTable::buttons() {
  return buttonRow({add_, remove_});
}

void MasteryTable::setRules(const std::vector<MasteryCriterion>& rules) {
  rules_ = rules;
  fill();
}

void MasteryTable::setEditable(bool editable) {
  editable_ = editable;
  setEnabled(editable);
  enableButtons();
}

void MasteryTable::enableButtons() {
  add_->setEnabled(editable_);
  remove_->setEnabled(editable_ && !rules_.empty());
}

void MasteryTable::fill() {
  setFieldRows(this, static_cast<int>(rules_.size()));
  for (int row = 0; row < rowCount(); ++row) {
    addFields(row, rules_[static_cast<std::size_t>(row)]);
  }
  fitRows(this, kFewRules);
  enableButtons();
}

void MasteryTable::addFields(int row, const MasteryCriterion& rule) {
  auto* metric = new QComboBox;
  for (const QuantityRow& known : quantityRows()) {
    if (known.traits.asked) {
      const QString name = toQString(Text(known.name));
      metric->addItem(known.traits.kind == QuantityKind::kAnswer ? tr("%1 (1 yes, 0 no)").arg(name) : name,
                      toQString(known.id));
    }
  }
  chooseOrAdd(metric, rule.metric);
  auto* direction = new QComboBox;
  direction->addItem(tr("at least"), QStringLiteral("at_least"));
  direction->addItem(tr("at most"), QStringLiteral("at_most"));
  chooseOrAdd(direction, rule.comparison);
  const std::optional<Quantity> quantity = quantityOf(rule.metric);
  const QuantityRow* asked = quantity ? &rowOf(*quantity) : nullptr;
  const double scale = asked != nullptr ? asked->shown.scale : 1.0;
  auto* threshold = new ThresholdBox(asked);
  threshold->setValue(scale * rule.threshold);
  auto* inARow = new QSpinBox;
  inARow->setRange(1, kMaxInARow);
  inARow->setValue(static_cast<int>(rule.consecutive));
  inARow->setButtonSymbols(QAbstractSpinBox::NoButtons);
  setCellWidget(row, kMetric, metric);
  setCellWidget(row, kDirection, direction);
  setCellWidget(row, kThreshold, threshold);
  setCellWidget(row, kInARow, inARow);
  nameFields(row);
  connect(metric, &QComboBox::activated, this, [this, metric] { takeMetric(metric, chosenId(metric)); });
  connect(direction, &QComboBox::activated, this, [this, direction] {
    take(direction, [direction](MasteryCriterion& changed) { changed.comparison = chosenId(direction); });
  });
  connect(threshold, &QDoubleSpinBox::valueChanged, this, [this, threshold, scale](double value) {
    take(threshold, [value, scale](MasteryCriterion& changed) { changed.threshold = value / scale; });
  });
  connect(inARow, &QSpinBox::valueChanged, this, [this, inARow](int value) {
    take(inARow, [value](MasteryCriterion& changed) { changed.consecutive = value; });
  });
}

void MasteryTable::nameFields(int row) {
  cellWidget(row, kMetric)->setAccessibleName(tr("What rule %1 is about").arg(row + 1));
  cellWidget(row, kDirection)->setAccessibleName(tr("Direction of rule %1").arg(row + 1));
  cellWidget(row, kThreshold)->setAccessibleName(tr("Threshold of rule %1").arg(row + 1));
  cellWidget(row, kInARow)->setAccessibleName(tr("Attempts in a row of rule %1").arg(row + 1));
}

void MasteryTable::take(const QWidget* cell, const std::function<void(MasteryCriterion&)>& change) {
  const int row = rowOf(this, cell);
  if (row < 0 || row >= std::ssize(rules_)) {
    return;
  }
  change(rules_[static_cast<std::size_t>(row)]);
  Q_EMIT edited();
}

void MasteryTable::takeMetric(const QWidget* cell, const std::string& metric) {
  take(cell, [&metric](MasteryCriterion& changed) {
    if (changed.metric == metric) {
      return;
    }
    changed = ruleAbout(rowOf(quantityOf(metric).value()), changed);
  });
  fill();
}

void MasteryTable::addRule() {
  for (const QuantityRow& row : quantityRows()) {
    const bool used = std::any_of(rules_.begin(), rules_.end(),
                                  [&row](const MasteryCriterion& known) { return known.metric == row.id; });
    if (used || !row.traits.asked) {
      continue;
    }
    rules_.push_back(ruleAbout(row, {}));
    Q_EMIT edited();
    fill();
    break;  // every metric has its rule: nothing to add
  }
  if (rowCount() > 0) {
    cellWidget(rowCount() - 1, kMetric)->setFocus();
  }
}

void MasteryTable::removeRule() {
  const int row = currentRow() >= 0 ? currentRow() : rowCount() - 1;
  if (row < 0 || row >= std::ssize(rules_)) {
    return;
  }
  rules_.erase(rules_.begin() + row);
  Q_EMIT edited();
  fill();
}

void MasteryTable::retranslate() {
  setAccessibleName(tr("Rules of mastery"));
  add_->setText(tr("Add rule"));
  remove_->setText(tr("Remove rule"));
  setHorizontalHeaderLabels({tr("Metric"), tr("is"), tr("Threshold"), tr("In a row")});
  fill();
}

}  // namespace torsio::gui
