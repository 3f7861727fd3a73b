// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QWidget>

#include "app/connectors/tracker/tracker_link.h"
#include "app/gui/widgets/page_parts.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace torsio::gui {

class ShellContext;

/// The tracker on the real arm's instrument: its address, whether poses arrive, and their quality. GUI
/// thread; the connection has its own thread.
class TrackerPanel : public Card {
  Q_OBJECT

 public:
  explicit TrackerPanel(ShellContext& shell, QWidget* parent = nullptr);

  /// Shows this address and connects; empty: the default one, without connecting.
  void begin(const std::optional<TrackerPlace>& place);
  /// Returns the link; null: not connected.
  [[nodiscard]] TrackerLink* link() const noexcept { return link_.get(); }
  /// Updates the status; call it a few times per second.
  void follow(bool recording);
  void retranslate();

 Q_SIGNALS:
  /// The link is about to be destroyed.
  void lettingGo();

 private:
  void toggle();
  void showPlace(const TrackerPlace& place);
  [[nodiscard]] TrackerPlace shownPlace() const;
  void showLink(bool recording);

  ShellContext& shell_;
  std::unique_ptr<TrackerLink> link_;
  bool recording_ = false;
  QLabel* addressLabel_ = nullptr;
  QLineEdit* address_;
  QLabel* portLabel_ = nullptr;
  QSpinBox* port_;
  QLabel* instrumentLabel_ = nullptr;
  QLineEdit* instrument_;
  QCheckBox* listens_;
  QPushButton* connect_;
  QLabel* status_;
  QLabel* pose_;
  QLabel* counts_;
};

}  // namespace torsio::gui
