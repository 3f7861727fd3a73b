// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <QFrame>
#include <QString>

#include "app/gui/base/page.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

struct Theme;

/// A line of the navigation.
struct RailItem {
  PageId id;
  QString icon;
};

/// Lines of a group; the heading is shown only if there are several groups.
struct RailGroup {
  std::function<QString()> title;
  std::vector<RailItem> items;
};

/// The navigation at the left edge: icon and name of every page that the user may open; when narrow, only
/// icons with tool tips.
class Rail : public QFrame {
  Q_OBJECT

 public:
  Rail(const std::vector<RailGroup>& groups, QWidget* parent = nullptr);

  /// Marks the current page; pages without a line clear the mark.
  void setCurrent(std::optional<PageId> id);
  /// Shows how much waits on a page, behind its name; 0: nothing.
  void setWaiting(PageId id, std::size_t count);
  void setNarrow(bool narrow);
  [[nodiscard]] bool narrow() const noexcept { return narrow_; }
  void setTheme(const Theme& theme);
  void retranslate();

 Q_SIGNALS:
  void chosen(torsio::gui::PageId id);
  void narrowChanged(bool narrow);

 private:
  struct Line {
    RailItem item;
    QPushButton* button;
    std::size_t waiting = 0;
  };
  struct Heading {
    std::function<QString()> title;
    QLabel* label;
  };
  void addLine(const RailItem& item, QVBoxLayout* column);

  std::vector<Line> lines_;
  std::vector<Heading> headings_;
  QLabel* name_;
  QWidget* list_ = nullptr;
  QPushButton* fold_;
  std::optional<PageId> current_;
  bool narrow_ = false;
};

}  // namespace torsio::gui
