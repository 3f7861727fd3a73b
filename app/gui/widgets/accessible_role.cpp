// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/accessible_role.h"

#include <QAbstractButton>
#include <QAccessibleWidget>
#include <QStringList>
#include <QVariant>
#include <QWidget>

namespace torsio::gui {

namespace {

constexpr const char* kRole = "accessibleRole";

class WithRole final : public QAccessibleWidget {
 public:
  WithRole(QWidget* widget, QAccessible::Role role) : QAccessibleWidget(widget, role) {}

  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    return QAccessibleWidget::text(kind == QAccessible::Value ? QAccessible::Description : kind);
  }
  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    if (const QAbstractButton* line = button()) {
      state.selectable = true;
      state.selected = line->isChecked();
      state.checkable = line->isCheckable();
      state.checked = line->isChecked();
    }
    return state;
  }
  [[nodiscard]] QStringList actionNames() const override {
    QStringList names = QAccessibleWidget::actionNames();
    if (button() != nullptr && widget()->isEnabled()) {
      names.prepend(pressAction());
    }
    return names;
  }
  void doAction(const QString& action) override {
    if (action == pressAction() && button() != nullptr) {
      button()->click();
      return;
    }
    QAccessibleWidget::doAction(action);
  }

 private:
  [[nodiscard]] QAbstractButton* button() const { return qobject_cast<QAbstractButton*>(widget()); }
};

QAccessibleInterface* withRole(const QString&, QObject* object) {
  const QVariant role = object != nullptr ? object->property(kRole) : QVariant();
  return role.isValid()
             ? new WithRole(static_cast<QWidget*>(object), static_cast<QAccessible::Role>(role.toInt()))
             : nullptr;
}

}  // namespace

void setAccessibleRole(QWidget* widget, QAccessible::Role role) {
  QAccessible::installFactory(withRole);  // only once, however often it is called
  widget->setProperty(kRole, static_cast<int>(role));
}

}  // namespace torsio::gui
