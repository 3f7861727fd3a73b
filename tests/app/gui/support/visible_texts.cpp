// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/support/visible_texts.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPlainTextEdit>
#include <QWidget>

#include "app/gui/widgets/data_table.h"
#include "sim/core/text.h"

namespace torsio::gui {

namespace {

/// Collects texts and ignores all other drawing.
class TextCatcher : public QPaintEngine {
 public:
  TextCatcher() : QPaintEngine(QPaintEngine::AllFeatures) {}
  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState&) override {}
  void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
  void drawTextItem(const QPointF&, const QTextItem& item) override { texts << item.text(); }
  void drawPath(const QPainterPath&) override {}
  void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
  [[nodiscard]] Type type() const override { return QPaintEngine::User; }

  QStringList texts;
};

class TextPaper : public QPaintDevice {
 public:
  explicit TextPaper(QSize size) : size_(size) {}
  [[nodiscard]] QPaintEngine* paintEngine() const override { return &catcher; }
  mutable TextCatcher catcher;

 protected:
  [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
    constexpr int kDpi = 96;
    switch (metric) {
      case PdmWidth:
      case PdmWidthMM:
        return size_.width();
      case PdmHeight:
      case PdmHeightMM:
        return size_.height();
      case PdmNumColors:
        return 0;
      case PdmDepth:
        return 32;
      case PdmDevicePixelRatio:
        return 1;
      case PdmDevicePixelRatioScaled:
        return static_cast<int>(devicePixelRatioFScale());
      default:
        return kDpi;
    }
  }

 private:
  QSize size_;
};

void addCells(const QAbstractItemView& view, QStringList& found) {
  const QAbstractItemModel* model = view.model();
  if (model == nullptr) {
    return;
  }
  const int roles[] = {Qt::DisplayRole,   Qt::ToolTipRole,        Qt::StatusTipRole,
                       Qt::WhatsThisRole, Qt::AccessibleTextRole, Qt::AccessibleDescriptionRole,
                       Qt::EditRole};
  for (const int role : roles) {
    for (int column = 0; column < model->columnCount(); ++column) {
      found << model->headerData(column, Qt::Horizontal, role).toString();
      for (int row = 0; row < model->rowCount(); ++row) {
        found << model->data(model->index(row, column), role).toString();
      }
    }
  }
}

void addAccessible(QWidget& widget, QStringList& found) {
  QAccessibleInterface* one = QAccessible::queryAccessibleInterface(&widget);
  if (one == nullptr) {
    return;
  }
  for (const QAccessible::Text kind : {QAccessible::Name, QAccessible::Description, QAccessible::Value,
                                       QAccessible::Help, QAccessible::Accelerator}) {
    found << one->text(kind);
  }
}

void addTexts(const QWidget& widget, QStringList& found) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    found << label->text();
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
    found << button->text();
  }
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) {
    found << line->text() << line->placeholderText();
  }
  if (const auto* text = qobject_cast<const QPlainTextEdit*>(&widget)) {
    found << text->toPlainText() << text->placeholderText();
  }
  if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) {
    found << box->title();
  }
  if (const auto* spin = qobject_cast<const QAbstractSpinBox*>(&widget)) {
    found << spin->text();
  }
  if (const auto* table = qobject_cast<const DataTable*>(&widget)) {
    found << table->asText();
  }
  if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) {
    addCells(*view, found);
  }
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    for (int i = 0; i < box->count(); ++i) {
      found << box->itemText(i) << box->itemData(i, Qt::ToolTipRole).toString();
    }
  }
}

}  // namespace

QStringList paintedWordsOf(QWidget& page) {
  TextPaper paper(page.size());
  page.render(&paper);
  return paper.catcher.texts;
}

QStringList wordsOf(QWidget& page) {
  QStringList found{page.window()->windowTitle(), page.window()->windowRole(),
                    page.window()->windowFilePath(), page.window()->windowIconText()};
  QList<QWidget*> all = page.findChildren<QWidget*>();
  all << &page;
  for (QWidget* widget : all) {
    found << widget->windowTitle() << widget->toolTip() << widget->statusTip() << widget->whatsThis()
          << widget->accessibleName() << widget->accessibleDescription() << widget->objectName();
    for (const QAction* action : widget->actions()) {
      found << action->text() << action->toolTip() << action->statusTip();
    }
    addTexts(*widget, found);
    addAccessible(*widget, found);
  }
  return found + paintedWordsOf(page);
}

}  // namespace torsio::gui
