// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QToolButton>

#include "sim/scene/scene.h"

namespace torsio::gui {

/// A "?" beside a scene's title: shows what is measured, sourced and assumed in an untwisting. Hidden for
/// other scenes.
class ValidityButton : public QToolButton {
  Q_OBJECT

 public:
  explicit ValidityButton(QWidget* parent = nullptr);

  /// Takes the text of a scene; null: none.
  void setScene(const Scene* scene);
  void retranslate();

 private:
  void tell();

  std::string words_;  // as in the scene file
};

}  // namespace torsio::gui
