// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QToolButton>

#include "sim/scene/scene.h"

namespace torsio::gui {

/// A "?" beside the title of a scene: opens what of an untwisting is measured, sourced and assumed. Hidden
/// for other scenes.
class ValidityButton : public QToolButton {
  Q_OBJECT

 public:
  explicit ValidityButton(QWidget* parent = nullptr);

  /// Takes the words of a scene; null: none.
  void setScene(const Scene* scene);
  void retranslate();

 private:
  void tell();

  std::string words_;  // as the scene file has them
};

}  // namespace torsio::gui
