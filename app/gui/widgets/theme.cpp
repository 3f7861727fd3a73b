// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/theme.h"

#include <algorithm>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QFont>
#include <QListWidget>
#include <QPainter>
#include <QPalette>
#include <QScreen>
#include <QStyle>
#include <QStyleFactory>
#include <QStyledItemDelegate>

#include "app/gui/widgets/data_table_model.h"
#include "app/outputs/charts/typeface.h"

namespace torsio::gui {

namespace {

Theme lightTheme() {
  Theme t;
  t.kind = ThemeKind::kLight;
  t.window = QColor(0xF3, 0xF5, 0xF7);
  t.surface = QColor(0xFF, 0xFF, 0xFF);
  t.raised = QColor(0xE9, 0xEE, 0xF2);
  t.line = QColor(0xDD, 0xE3, 0xE8);
  t.border = QColor(0x7E, 0x8C, 0x98);
  t.text = QColor(0x17, 0x22, 0x2B);
  t.quietText = QColor(0x51, 0x60, 0x6C);
  t.disabledText = QColor(0x5F, 0x6D, 0x78);
  t.accent = QColor(0x0B, 0x63, 0x84);
  t.onAccent = QColor(0xFF, 0xFF, 0xFF);
  t.good = QColor(0x1B, 0x7A, 0x4B);
  t.caution = QColor(0x9A, 0x5B, 0x00);
  t.recording = QColor(0xB4, 0x2A, 0x3C);
  t.track = QColor(0xDF, 0xE5, 0xEA);
  t.backdrop = QColor(0xC3, 0xD0, 0xD9);
  t.lattice = QColor(0x14, 0x3A, 0x4C);
  t.wire = QColor(0x20, 0x2E, 0x38);
  t.grasp = QColor(0x06, 0x5F, 0x7E);
  t.shaft = QColor(0x34, 0x3B, 0x42);
  return t;
}

Theme darkTheme() {
  Theme t;
  t.kind = ThemeKind::kDark;
  t.window = QColor(0x14, 0x19, 0x1E);
  t.surface = QColor(0x1C, 0x23, 0x2A);
  t.raised = QColor(0x29, 0x32, 0x3B);
  t.line = QColor(0x2F, 0x39, 0x42);
  t.border = QColor(0x71, 0x80, 0x8D);
  t.text = QColor(0xE8, 0xED, 0xF1);
  t.quietText = QColor(0xA3, 0xB1, 0xBC);
  t.disabledText = QColor(0x93, 0xA1, 0xAC);
  t.accent = QColor(0x62, 0xB9, 0xD8);
  t.onAccent = QColor(0x08, 0x1D, 0x27);
  t.good = QColor(0x63, 0xC4, 0x93);
  t.caution = QColor(0xF0, 0xB4, 0x4A);
  t.recording = QColor(0xF0, 0x7C, 0x8A);
  t.track = QColor(0x36, 0x41, 0x4B);
  t.backdrop = QColor(0x11, 0x16, 0x1B);
  t.lattice = QColor(0xDC, 0xF1, 0xFA);
  t.wire = QColor(0xD5, 0xE2, 0xEA);
  t.grasp = QColor(0x8A, 0xDD, 0xF5);
  t.shaft = QColor(0xA6, 0xAF, 0xB7);
  return t;
}

QPalette paletteOf(const Theme& t) {
  QPalette palette;
  palette.setColor(QPalette::Window, t.window);
  palette.setColor(QPalette::WindowText, t.text);
  palette.setColor(QPalette::Base, t.surface);
  palette.setColor(QPalette::AlternateBase, t.raised);
  palette.setColor(QPalette::Text, t.text);
  palette.setColor(QPalette::PlaceholderText, t.quietText);
  palette.setColor(QPalette::Button, t.raised);
  palette.setColor(QPalette::ButtonText, t.text);
  palette.setColor(QPalette::BrightText, t.onAccent);
  palette.setColor(QPalette::Highlight, t.accent);
  palette.setColor(QPalette::HighlightedText, t.onAccent);
  palette.setColor(QPalette::Link, t.accent);
  palette.setColor(QPalette::ToolTipBase, t.surface);
  palette.setColor(QPalette::ToolTipText, t.text);
  palette.setColor(QPalette::Light, t.surface);
  palette.setColor(QPalette::Midlight, t.raised);
  palette.setColor(QPalette::Mid, t.line);
  palette.setColor(QPalette::Dark, t.border);
  palette.setColor(QPalette::Shadow, t.line);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText}) {
    palette.setColor(QPalette::Disabled, role, t.disabledText);
  }
  return palette;
}

/// Replaces `%name` by the theme's colour of that name.
// NOLINTNEXTLINE(readability-function-size): one long text
QString styleSheetOf(const Theme& t) {
  QString sheet = QStringLiteral(R"(
QMainWindow, QDialog { background: %window; }
QMenuBar { background: %window; color: %text; padding: 2px 8px; border-bottom: 1px solid %line; }
QMenuBar::item { padding: 6px 10px; border-radius: 4px; background: transparent; }
QMenuBar::item:selected { background: %raised; }
QMenu { background: %surface; color: %text; border: 1px solid %line; padding: 6px; }
QMenu::item { padding: 7px 28px 7px 28px; border-radius: 4px; }
QMenu::item:selected { background: %accent; color: %onAccent; }
QMenu::item:disabled { color: %disabledText; }
QMenu::separator { height: 1px; background: %line; margin: 6px 8px; }
QMenu::indicator { width: 14px; height: 14px; left: 8px; }
QToolBar { background: %window; border: none; border-bottom: 1px solid %line; spacing: 2px; padding: 3px 10px; }
QToolBar::separator { width: 1px; background: %line; margin: 6px 8px; }
QToolButton { color: %text; background: transparent; border: 1px solid transparent; border-radius: 6px;
  padding: 5px 8px; }
QToolButton[popupMode="2"] { padding-right: 22px; }
QToolButton::menu-indicator { image: url(%chevron); width: 10px; height: 10px; subcontrol-origin: padding;
  subcontrol-position: center right; right: 6px; }
QToolButton:hover { background: %raised; }
QToolButton:pressed { background: %track; }
QToolButton:checked { background: %raised; border-color: %accent; color: %accent; }
QToolButton:focus { border-color: %accent; }
QToolButton:disabled { color: %disabledText; }
QStatusBar { background: %window; color: %quietText; border-top: 1px solid %line; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: %quietText; padding: 4px 12px; }
QFrame[around="true"] { background: %border; border: none; }
QFrame[edge="true"] { background: %line; border: none; }
QFrame#card, QFrame[card="true"] { background: %surface; border: 1px solid %line; border-radius: 8px; }
QLabel#cardTitle { color: %text; font-weight: 600; }
QLabel[quiet="true"] { color: %quietText; }
QComboBox, QDoubleSpinBox, QSpinBox { background: %surface; color: %text; border: 1px solid %border;
  border-radius: 6px; padding: 4px 8px; min-height: 20px; selection-background-color: %accent;
  selection-color: %onAccent; }
QComboBox:focus, QDoubleSpinBox:focus, QSpinBox:focus { border: 2px solid %accent; padding: 3px 7px; }
QComboBox:disabled, QDoubleSpinBox:disabled, QSpinBox:disabled { color: %disabledText; border-color: %line; }
QComboBox { combobox-popup: 0; }
QComboBox::drop-down, QDateEdit::drop-down, QDateTimeEdit::drop-down { border: none; width: 24px; }
QComboBox::down-arrow { image: url(%chevron); width: 12px; height: 12px; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { subcontrol-origin: padding; border: none;
  background: transparent; width: 20px; }
QAbstractSpinBox::up-button { subcontrol-position: top right; }
QAbstractSpinBox::down-button { subcontrol-position: bottom right; }
QAbstractSpinBox::up-button:hover, QAbstractSpinBox::down-button:hover { background: %raised; }
QAbstractSpinBox::up-arrow { image: url(%upChevron); width: 10px; height: 10px; }
QAbstractSpinBox::down-arrow { image: url(%chevron); width: 10px; height: 10px; }
QComboBox QAbstractItemView::item { min-height: 28px; padding: 0 6px; border-radius: 4px; }
QComboBox QAbstractItemView::item:selected { background: %accent; color: %onAccent; }
QComboBox QAbstractItemView { background: %surface; color: %text; border: 1px solid %line; padding: 4px;
  selection-background-color: %accent; selection-color: %onAccent; outline: none; }
QLineEdit, QPlainTextEdit, QTextEdit, QDateEdit, QDateTimeEdit, QTimeEdit { background: %surface;
  border: 1px solid %border; border-radius: 6px; padding: 4px 8px; selection-background-color: %accent;
  selection-color: %onAccent; }
QLineEdit, QDateEdit, QDateTimeEdit, QTimeEdit { min-height: 20px; }
QLineEdit:focus, QPlainTextEdit:focus, QTextEdit:focus, QDateEdit:focus, QDateTimeEdit:focus, QTimeEdit:focus {
  border: 2px solid %accent; padding: 3px 7px; }
QLineEdit:disabled, QPlainTextEdit:disabled { border-color: %line; }
QLineEdit[readOnly="true"], QPlainTextEdit[readOnly="true"] { background: %window; }
QCheckBox, QRadioButton { spacing: 8px; }
QCheckBox::indicator, QListView::indicator, QTreeView::indicator, QRadioButton::indicator { width: 14px; height: 14px;
  background: %surface; border: 1px solid %border; border-radius: 4px; }
QRadioButton::indicator { border-radius: 8px; }
QCheckBox::indicator:checked, QListView::indicator:checked, QTreeView::indicator:checked { background: %accent;
  border-color: %accent; image: url(%tick); }
QRadioButton::indicator:checked { background: %onAccent; border: 5px solid %accent; width: 6px; height: 6px; }
QCheckBox::indicator:disabled, QRadioButton::indicator:disabled, QListView::indicator:disabled { background: %raised;
  border-color: %line; }
QCheckBox:focus, QRadioButton:focus { color: %accent; }
QSlider:horizontal { min-height: 24px; }
QSlider:vertical { min-width: 24px; }
QSlider::groove { background: %track; border-radius: 2px; }
QSlider::groove:horizontal { height: 4px; }
QSlider::groove:vertical { width: 4px; }
QSlider::sub-page:horizontal, QSlider::add-page:vertical { background: %accent; border-radius: 2px; }
QSlider::handle { width: 20px; height: 20px; border: none; background: %disc, stop: 0 %accent, stop: 0.76 %accent,
  stop: 0.82 transparent); }
QSlider::handle:horizontal { margin: -8px 0; }
QSlider::handle:vertical { margin: 0 -8px; }
QSlider::handle:hover, QSlider::handle:pressed { background: %disc, stop: 0 %accent, stop: 0.92 %accent,
  stop: 0.98 transparent); }
QSlider::handle:focus { background: %disc, stop: 0 %accent, stop: 0.54 %accent, stop: 0.6 %surface, stop: 0.7 %surface,
  stop: 0.76 %text, stop: 0.92 %text, stop: 0.98 transparent); }
QSlider::handle:disabled { background: %disc, stop: 0 %raised, stop: 0.58 %raised, stop: 0.64 %border, stop: 0.76 %border,
  stop: 0.82 transparent); }
QSlider::sub-page:horizontal:disabled, QSlider::add-page:vertical:disabled { background: %border; }
QProgressBar { background: %track; color: %text; border: none; border-radius: 4px; max-height: 8px; min-height: 8px; }
QProgressBar::chunk { background: %accent; border-radius: 4px; }
QTabWidget::pane { border: none; border-top: 1px solid %line; }
QTabBar::tab { background: transparent; color: %quietText; padding: 8px 14px; border: none;
  border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: %accent; border-bottom: 2px solid %accent; font-weight: 600; }
QTabBar::tab:hover { color: %text; }
QTabBar::tab:focus { color: %accent; }
QTableView, QTreeView, QListView { background: %surface; alternate-background-color: %window; color: %text;
  border: 1px solid %line; border-radius: 6px; gridline-color: %line; selection-background-color: %accent;
  selection-color: %onAccent; }
QTableView:focus, QTreeView:focus, QListView:focus { border-color: %accent; }
QTableView::item, QListView::item, QTreeView::item { padding: 4px 8px; }
QListView[checkable="true"]::item { padding: 4px 0; }
QFileDialog QTreeView::item, QFileDialog QListView::item { padding: 4px 0; }
QHeaderView { background: %window; border: none; border-bottom: 1px solid %line; }
QHeaderView::section { background: %window; color: %quietText; border: none; padding: 7px 8px;
  font-weight: 600; }
QSplitter::handle { background: transparent; }
QGroupBox { border: 1px solid %line; border-radius: 8px; margin-top: 12px; padding: 12px; }
QGroupBox::title { subcontrol-origin: margin; left: 12px; padding: 0 4px; color: %quietText; }
QLabel[figure="true"] { font-size: 21pt; font-weight: 600; }
QLabel[heading="true"] { font-size: 15pt; font-weight: 600; }
QLabel[subheading="true"] { font-size: 12pt; font-weight: 600; }
QLabel[small="true"] { font-size: 9pt; }
QLabel[good="true"] { color: %good; }
QLabel[caution="true"] { color: %caution; }
QPushButton { background: %raised; color: %text; border: 1px solid %border; border-radius: 6px;
  padding: 7px 16px; min-height: 20px; }
QPushButton::menu-indicator { image: url(%chevron); width: 10px; height: 10px; subcontrol-origin: padding;
  subcontrol-position: center right; right: 4px; }
QPushButton:hover { background: %track; }
QPushButton:checked { background: %accent; color: %onAccent; border-color: %accent; }
QPushButton:default { background: %accent; color: %onAccent; border-color: %accent; }
QPushButton:focus { border: 2px solid %accent; padding: 6px 15px; outline: none; }
QPushButton:disabled, QPushButton:default:disabled { background: %raised; color: %disabledText; border-color: %line; }
QFrame#rail { background: %surface; border: none; border-right: 1px solid %line; }
QFrame#rail QPushButton { background: transparent; border: 1px solid transparent; border-radius: 6px; color: %text;
  text-align: left; padding: 8px 12px; }
QFrame#rail QPushButton:hover { background: %raised; }
QFrame#rail QPushButton:checked { background: %raised; color: %accent; font-weight: 600; border-left: 3px solid %accent; }
QFrame#rail QPushButton:focus { border-color: %accent; }
QFrame#header { background: %surface; border: none; border-bottom: 1px solid %line; }
QFrame#problem { margin: 8px 16px 0 16px; background: %surface; border: 1px solid %caution; border-left: 4px solid %caution; border-radius: 8px; }
QFrame#job { margin: 0 16px 8px 16px; background: %surface; border: 1px solid %accent; border-radius: 8px; }
QLabel#idleWarning { background: %caution; color: %window; padding: 8px 16px; border-radius: 6px; font-weight: 600; }
QFrame#visit { background: %raised; border-bottom: 1px solid %line; }
QLabel#databaseAway { background: %raised; color: %caution; border: 1px solid %caution; border-radius: 6px; padding: 8px 16px;
  font-weight: 600; }
QLabel#movedRecord { background: %raised; color: %caution; border-bottom: 1px solid %caution; padding: 6px 24px; font-weight: 600; }
QLabel#toast { background: %text; color: %window; border-radius: 6px; padding: 10px 16px; }
QPushButton[primary="true"] { background: %accent; color: %onAccent; border-color: %accent; font-weight: 600; }
QPushButton[primary="true"]:hover { border-color: %text; }
QPushButton[primary="true"]:focus { border: 2px solid %text; padding: 6px 15px; }
QPushButton[primary="true"]:disabled { background: %raised; color: %disabledText; border-color: %line; }
QPushButton[link="true"] { background: transparent; color: %accent; border: 1px solid transparent; padding: 7px 8px; }
QPushButton[link="true"]:hover { text-decoration: underline; }
QPushButton[link="true"]:focus { border: 1px solid %accent; padding: 7px 8px; }
QPushButton[link="true"]:disabled { color: %disabledText; }
QScrollArea { background: transparent; border: none; }
QScrollArea > QWidget > QWidget { background: transparent; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar::handle:vertical { background: %border; border-radius: 4px; min-height: 32px; margin: 0 1px; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle:horizontal { background: %border; border-radius: 4px; min-width: 32px; margin: 1px 0; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; width: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QMessageBox { messagebox-text-interaction-flags: 5; }
QToolTip { background: %surface; color: %text; border: 1px solid %border; padding: 4px 8px; }
)");
  const bool dark = t.kind == ThemeKind::kDark;
  const QString kind = dark ? QStringLiteral("dark") : QStringLiteral("light");
  for (const auto& [name, drawing] :
       {std::pair{"%upChevron", "chevron-up"}, {"%chevron", "chevron"}, {"%tick", "tick"}}) {
    sheet.replace(QLatin1String(name),
                  QStringLiteral(":/torsio/icons/%1-%2.svg").arg(QLatin1String(drawing), kind));
  }
  sheet.replace(QLatin1String("%disc"),
                QStringLiteral("qradialgradient(cx: 0.5, cy: 0.5, radius: 0.5, fx: 0.5, fy: 0.5"));
  const std::pair<const char*, QColor> colours[] = {
      {"%window", t.window},       {"%surface", t.surface},
      {"%raised", t.raised},       {"%line", t.line},
      {"%border", t.border},       {"%text", t.text},
      {"%quietText", t.quietText}, {"%disabledText", t.disabledText},
      {"%accent", t.accent},       {"%onAccent", t.onAccent},
      {"%track", t.track},         {"%good", t.good},
      {"%caution", t.caution},
  };

  for (const auto& [name, colour] : colours) {
    sheet.replace(QLatin1String(name), colour.name());
  }
  return sheet;
}

}  // namespace

const Theme& theme(ThemeKind kind) {
  static const Theme kLight = lightTheme();
  static const Theme kDark = darkTheme();
  return kind == ThemeKind::kDark ? kDark : kLight;
}

namespace {

/// Draws list entries with the padding of table cells. Padding in the style sheet would widen an entry
/// without moving its content.
class PaddedEntries final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    const QStyle* style = ground.widget != nullptr ? ground.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &ground, painter, ground.widget);
    QStyleOptionViewItem narrower = inside(option);
    narrower.state.setFlag(QStyle::State_HasFocus, false);
    QStyledItemDelegate::paint(painter, narrower, index);
    if (option.state.testFlag(QStyle::State_HasFocus) && !option.state.testFlag(QStyle::State_Selected)) {
      paintRowFocus(*painter, option.rect, option.palette, false);
    }
  }
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return QStyledItemDelegate::sizeHint(inside(option), index) + QSize(2 * kBeside, 0);
  }

 private:
  static constexpr int kBeside = kSpace - 3;  // the style itself leaves three pixels

  static QStyleOptionViewItem inside(const QStyleOptionViewItem& option) {
    QStyleOptionViewItem narrower = option;
    if (option.rect.width() > 2 * kBeside) {
      narrower.rect.adjust(kBeside, 0, -kBeside, 0);
    }
    return narrower;
  }
};

/// Makes the lists of combo boxes follow the style sheet: their default delegate paints the current entry's
/// text, but not its background. Entries are not clipped. Entries of other lists get padding.
class ChoiceLists final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Polish) {
      if (auto* box = qobject_cast<QComboBox*>(watched);
          box != nullptr && box->itemDelegate()->metaObject() != &QStyledItemDelegate::staticMetaObject) {
        box->setItemDelegate(new QStyledItemDelegate(box));
      } else if (auto* list = qobject_cast<QListWidget*>(watched);
                 list != nullptr &&
                 list->itemDelegate()->metaObject() == &QStyledItemDelegate::staticMetaObject &&
                 dynamic_cast<PaddedEntries*>(list->itemDelegate()) == nullptr) {
        list->setItemDelegate(new PaddedEntries(list));
      }
    } else if (event->type() == QEvent::Show) {
      if (auto* list = qobject_cast<QAbstractItemView*>(watched); list != nullptr && belongsToChoice(*list)) {
        constexpr int kBeside = 40;  // padding, frame and scroll bar
        const int wanted = list->sizeHintForColumn(0) + kBeside;
        list->window()->setMinimumWidth(std::min(wanted, list->screen()->availableGeometry().width()));
      }
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  static bool belongsToChoice(const QAbstractItemView& list) {
    const QWidget* popup = list.parentWidget();
    return popup != nullptr && popup->isWindow() && qobject_cast<QComboBox*>(popup->parent()) != nullptr;
  }
};

}  // namespace

void applyTheme(QApplication& application, const Theme& chosen) {
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QFont font = typeface();
  font.setPointSizeF(kBodyText_pt);
  application.setFont(font);
  application.setPalette(paletteOf(chosen));
  application.setStyleSheet(styleSheetOf(chosen));
  constexpr const char* kName = "choiceLists";
  if (application.findChild<QObject*>(QLatin1String(kName), Qt::FindDirectChildrenOnly) == nullptr) {
    auto* lists = new ChoiceLists(&application);
    lists->setObjectName(QLatin1String(kName));
    application.installEventFilter(lists);
  }
}

}  // namespace torsio::gui
