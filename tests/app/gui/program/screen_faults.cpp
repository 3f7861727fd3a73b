// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/gui/program/screen_faults.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTextEdit>
#include <QWidget>

#include "app/gui/scene/scene_view.h"

namespace torsio::gui::testing {

namespace {

/// Returns the common bounding box of texts, fields, lists and cards of a page.
QRect contentOf(const QWidget& page) {
  QRect all;
  for (const QWidget* widget : page.findChildren<QWidget*>()) {
    if (!widget->isVisibleTo(&page) || widget->size().isEmpty()) {
      continue;
    }
    QRect place(widget->mapTo(&page, QPoint(0, 0)), widget->size());
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      if (label->text().isEmpty()) {
        continue;
      }
      // A sentence limits its line length in a wide place.
      place.setWidth(std::min(label->contentsRect().width(), label->sizeHint().width()));
    } else if (qobject_cast<const QAbstractButton*>(widget) == nullptr &&
               qobject_cast<const QLineEdit*>(widget) == nullptr &&
               qobject_cast<const QComboBox*>(widget) == nullptr &&
               qobject_cast<const QAbstractItemView*>(widget) == nullptr &&
               qobject_cast<const QTextEdit*>(widget) == nullptr &&
               qobject_cast<const SceneView*>(widget) == nullptr &&
               widget->objectName() != QLatin1String("card")) {
      continue;
    }
    all |= place;
  }
  return all;
}

}  // namespace

QStringList cutTexts(QWidget& window) {
  QStringList cut;
  const auto report = [&](const QWidget& widget, const QString& text, int wanted, int given) {
    cut << QStringLiteral("%1 \"%2\": %3 wanted, %4 given")
               .arg(QLatin1String(widget.metaObject()->className()), text)
               .arg(wanted)
               .arg(given);
  };
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisibleTo(&window)) {
      continue;
    }
    const auto* label = qobject_cast<QLabel*>(widget);
    const auto* button = qobject_cast<QAbstractButton*>(widget);
    if (label != nullptr && !label->text().isEmpty()) {
      const int wide = label->wordWrap() ? 0 : label->minimumSizeHint().width();
      if (wide > label->width() + 1) {
        report(*label, label->text(), wide, label->width());
      }
      const int high =
          label->wordWrap() ? label->heightForWidth(label->width()) : label->minimumSizeHint().height();
      if (high > label->height() + 1) {
        report(*label, label->text(), high, label->height());
      }
    }
    if (button != nullptr && !button->text().isEmpty()) {
      const int wide = button->minimumSizeHint().width();
      if (wide > button->width() + 1) {
        report(*button, button->text(), wide, button->width());
      }
    }
  }
  return cut;
}

QStringList doubledKeys(QWidget& window) {
  std::map<QString, QStringList> wanted;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisibleTo(&window)) {
      continue;  // disabled keys may be enabled at another time
    }
    const auto* label = qobject_cast<QLabel*>(widget);
    const auto* button = qobject_cast<QAbstractButton*>(widget);
    const QString text = label != nullptr && label->buddy() != nullptr ? label->text()
                         : button != nullptr                           ? button->text()
                                                                       : QString();
    if (const QKeySequence key = QKeySequence::mnemonic(text); !key.isEmpty()) {
      wanted[key.toString()] << text;
    }
  }
  QStringList doubled;
  for (const auto& [key, texts] : wanted) {
    if (texts.size() > 1) {
      doubled << key + QStringLiteral(": ") + texts.join(QStringLiteral(", "));
    }
  }
  return doubled;
}

QStringList doubledTitles(QWidget& window) {
  QStringList titles;
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (label->isVisibleTo(&window) && label->property("heading").toBool() && !label->text().isEmpty()) {
      titles << label->text();
    }
  }
  const auto* header = window.findChild<QWidget*>(QStringLiteral("header"));
  const QList<QLabel*> inHeader = header != nullptr ? header->findChildren<QLabel*>() : QList<QLabel*>();
  const bool above = std::any_of(inHeader.begin(), inHeader.end(), [&](const QLabel* label) {
    return label->property("heading").toBool() && label->isVisibleTo(&window);
  });
  QStringList doubled;
  if ((above && titles.size() > 1) || titles.removeDuplicates() > 0) {
    doubled << titles.join(QStringLiteral(", "));
  }
  return doubled;
}

QStringList roughNumbers(QWidget& window) {
  static const QRegularExpression kHyphen(QStringLiteral("(?<![^\\s(:\uff1a\uff08])-[0-9]"));
  static const QRegularExpression kUngrouped(
      QStringLiteral("(?<![\\w.,:/+-])(?!(?:19|20)[0-9]{2}(?![0-9]))[1-9][0-9]{3,}(?![\\w,:/-])"));
  static const QRegularExpression kTwoWays(QStringLiteral("(?<![0-9/])[0-9]{1,2}/[0-9]{1,2}/[0-9]{4}"));
  QStringList rough;
  const auto look = [&rough](const QString& text) {
    if (text.contains(kHyphen) || text.contains(kUngrouped) || text.contains(kTwoWays)) {
      rough << text;
    }
  };
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisibleTo(&window)) {
      continue;
    }
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      look(label->text());
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
      look(button->text());
    }
    if (const auto* field = qobject_cast<const QDateTimeEdit*>(widget)) {
      look(field->text());
    }
    const auto* view = qobject_cast<const QAbstractItemView*>(widget);
    const QAbstractItemModel* model = view != nullptr ? view->model() : nullptr;
    for (int row = 0; model != nullptr && row < model->rowCount(); ++row) {
      for (int column = 0; column < model->columnCount(); ++column) {
        look(model->index(row, column).data().toString());
      }
    }
  }
  return rough;
}

QString crowded(const QWidget& page) {
  constexpr double kUsed = 0.75;
  constexpr double kMiddle = 0.08;
  const QRect content = contentOf(page);
  const double wide = page.width();
  const double left = content.left() / wide;
  const double right = 1.0 - (content.right() + 1) / wide;
  if (content.width() / wide >= kUsed || std::abs(left - right) <= kMiddle) {
    return {};
  }
  return QStringLiteral("free at the left %1, at the right %2 of %3 px")
      .arg(left, 0, 'f', 2)
      .arg(right, 0, 'f', 2)
      .arg(page.width());
}

}  // namespace torsio::gui::testing
