// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/support/visible_texts.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTextBoundaryFinder>
#include <QTextDocumentFragment>
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

constexpr int kRounding_px = 1;

class Looker {
 public:
  explicit Looker(QWidget& window) : window_(window) {}

  QStringList clipped() {
    look();
    // Hidden pages of tab widgets.
    for (QTabWidget* tabs : window_.findChildren<QTabWidget*>()) {
      if (!tabs->isVisibleTo(&window_)) {
        continue;
      }
      const QSignalBlocker quiet(tabs);  // a page notified of its tab may start loading
      const int before = tabs->currentIndex();
      for (int i = 0; i < tabs->count(); ++i) {
        if (i != before) {
          tabs->setCurrentIndex(i);
          settle();
          look();
        }
      }
      tabs->setCurrentIndex(before);
    }
    settle();
    found_.removeDuplicates();
    return found_;
  }

 private:
  static void settle() {
    QCoreApplication::processEvents();
    for (int depth = 0; depth < 4; ++depth) {
      QCoreApplication::sendPostedEvents();
    }
  }

  void report(const QWidget& widget, const QString& text, int wanted, int given) {
    if (wanted <= given + kRounding_px) {
      return;
    }
    found_ << QStringLiteral("%1 %2 \"%3\": %4 wanted, %5 given")
                  .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(), text.left(60))
                  .arg(wanted)
                  .arg(given);
  }

  static int widthOf(const QWidget& widget, const QString& text) {
    return widget.fontMetrics().horizontalAdvance(text);
  }

  void look() {
    for (QWidget* widget : window_.findChildren<QWidget*>()) {
      if (!widget->isVisibleTo(&window_) || widget->size().isEmpty()) {
        continue;
      }
      if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        lookAt(*label);
      } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
        lookAt(*button);
      } else if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
        lookAt(*combo);
      } else if (const auto* field = qobject_cast<const QLineEdit*>(widget)) {
        lookAt(*field);
      } else if (const auto* box = qobject_cast<const QGroupBox*>(widget)) {
        report(*box, box->title(), widthOf(*box, box->title()), box->width());
      } else if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
        report(*tabs, tabs->tabText(0), tabs->sizeHint().width(), tabs->width());
      } else if (const auto* list = qobject_cast<const QListWidget*>(widget)) {
        lookAt(*list);
      } else if (const auto* table = qobject_cast<const QTableView*>(widget)) {
        lookAt(*table);
      }
    }
  }

  void lookAt(const QLabel& label) {
    if (label.text().isEmpty()) {
      return;
    }
    const QString text = Qt::mightBeRichText(label.text())
                             ? QTextDocumentFragment::fromHtml(label.text()).toPlainText()
                             : label.text();
    if (!label.wordWrap()) {
      report(label, text, label.minimumSizeHint().width(), label.width());
      report(label, text, label.minimumSizeHint().height(), label.height());
    } else {
      report(label, text, label.heightForWidth(label.width()), label.height());
      QTextBoundaryFinder breaks(QTextBoundaryFinder::Line, text);
      for (qsizetype from = 0, to = breaks.toNextBoundary(); to > from; to = breaks.toNextBoundary()) {
        const QString piece = text.mid(from, to - from).trimmed();
        report(label, piece, widthOf(label, piece), label.width());
        from = to;
      }
    }
    lookAtEdges(label, text);
  }

  void lookAt(const QAbstractButton& button) {
    if (button.text().isEmpty()) {
      return;
    }
    report(button, button.text(), button.minimumSizeHint().width(), button.width());
    report(button, button.text(), button.fontMetrics().height(), button.height());
    lookAtEdges(button, button.text());
  }

  void lookAt(const QComboBox& combo) {
    QStyleOptionComboBox option;
    option.initFrom(&combo);
    option.editable = combo.isEditable();
    option.subControls = QStyle::SC_All;
    const int room = combo.style()
                         ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo)
                         .width();
    const QString text = combo.currentIndex() < 0 ? combo.placeholderText() : combo.currentText();
    report(combo, text, widthOf(combo, text), room);
    lookAtEdges(combo, text);
  }

  void lookAt(const QLineEdit& field) {
    const QMargins margins = field.textMargins();
    const int room = field.contentsRect().width() - margins.left() - margins.right();
    if (field.text().isEmpty()) {
      report(field, field.placeholderText(), widthOf(field, field.placeholderText()), room);
    } else if (qobject_cast<const QAbstractSpinBox*>(field.parentWidget()) != nullptr) {
      report(field, field.text(), widthOf(field, field.text()), room);
    }
    lookAtEdges(field, field.text());
  }

  void lookAt(const QListWidget& list) {
    if (list.wordWrap() || list.horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) {
      return;  // wraps, or can be moved
    }
    for (int i = 0; i < list.count(); ++i) {
      report(list, list.item(i)->text(), list.sizeHintForColumn(0), list.viewport()->width());
    }
  }

  void lookAt(const QTableView& table) {
    const QHeaderView* header = table.horizontalHeader();
    if (header->isHidden()) {
      return;
    }
    QFont bold = header->font();
    for (int i = 0; i < table.model()->columnCount(); ++i) {
      if (table.isColumnHidden(i)) {
        continue;
      }
      const QString title = table.model()->headerData(i, Qt::Horizontal).toString();
      const int margin = header->style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, header);
      report(*header, title, QFontMetrics(bold).horizontalAdvance(title) + 2 * margin,
             header->sectionSize(i));
    }
  }

  /// Checks whether a widget extends beyond its parent without scrolling.
  void lookAtEdges(const QWidget& widget, const QString& text) {
    const QWidget* below = &widget;
    for (const QWidget* holder = widget.parentWidget(); holder != nullptr && below != &window_;
         below = holder, holder = holder->parentWidget()) {
      const QRect place(widget.mapTo(holder, QPoint(0, 0)), widget.size());
      report(widget, text + QStringLiteral(" (right edge)"), place.right() + 1, holder->width());
      report(widget, text + QStringLiteral(" (left edge)"), -place.left(), 0);
      const auto* area = qobject_cast<const QAbstractScrollArea*>(holder->parentWidget());
      if (area != nullptr && area->viewport() == holder) {
        return;  // reached by scrolling
      }
      report(widget, text + QStringLiteral(" (lower edge)"), place.bottom() + 1, holder->height());
    }
  }

  QWidget& window_;
  QStringList found_;
};

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

namespace torsio::gui::testing {

QStringList clippedTexts(QWidget& window) {
  return Looker(window).clipped();
}

}  // namespace torsio::gui::testing
