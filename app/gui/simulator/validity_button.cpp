// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/validity_button.h"

#include <QMessageBox>

#include "app/gui/base/translated_text.h"
#include "sim/scene/hollow_organ.h"

namespace torsio::gui {

ValidityButton::ValidityButton(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("validity"));
  setText(QStringLiteral("?"));
  setFocusPolicy(Qt::TabFocus);
  connect(this, &QToolButton::clicked, this, &ValidityButton::tell);
  retranslate();
  hide();
}

void ValidityButton::setScene(const Scene* scene) {
  words_.clear();
  if (scene != nullptr && scene->comesTwisted()) {
    words_ = scene->hollow->detorsion().validity;
  }
  setVisible(!words_.empty());
}

void ValidityButton::retranslate() {
  setToolTip(tr("What of this scene is measured, sourced and assumed"));
  setAccessibleName(toolTip());
}

void ValidityButton::tell() {
  QMessageBox box(QMessageBox::NoIcon, tr("How far this scene holds"), toQString(Text(words_)),
                  QMessageBox::Close, this);
  box.exec();
}

}  // namespace torsio::gui
