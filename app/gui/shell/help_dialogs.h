// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QDialog>
#include <QString>

class QWidget;

namespace torsio::gui {

class Desk;

/// Action and key.
using KeyLine = std::pair<QString, QString>;

/// Returns the keys found in a page's commands, in order of creation.
[[nodiscard]] std::vector<KeyLine> keysOf(const QWidget& page);

/// The keys of the program and the current page. Opened by `?` and F1.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  /// `desk`: null before sign-in.
  explicit ShortcutSheet(Desk* desk, QWidget* parent = nullptr);
};

/// Version, build, licence, and the disclaimers: not a medical device, not for patient data.
[[nodiscard]] QString aboutText();
void showAboutBox(QWidget* parent);

}  // namespace torsio::gui
