// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>

#include "app/outputs/pdf/pdf_structure.h"
#include "app/outputs/pdf/table_layout.h"

class QPdfWriter;

namespace torsio {

inline constexpr QColor kQuietInk{0x60, 0x6E, 0x76};    ///< of notes and captions
inline constexpr QColor kWarningInk{0xA0, 0x4A, 0x00};  ///< of what the reader must not miss

/// Places blocks one below the other on A4 pages and draws them in a second pass, when the number of pages is
/// known ("page 3 of 7"). All lengths in millimetres.
class PageFlow {
 public:
  struct Style {
    double marginSide_mm = 20.0;
    double marginTop_mm = 20.0;
    double marginBottom_mm = 20.0;
    QString headerText;  ///< small, every page but the first
    QString footerText;  ///< left
    QString reference;   ///< below it, on every page: what the report is known by; may be empty
    QString watermark;   ///< in the head of every page, e.g. that the data are simulated; may be empty
    std::function<QString(std::size_t page, std::size_t pages)> pageText;  ///< right; from 1
  };

  PageFlow(QPdfWriter& writer, Style style);

  /// Usable width.
  [[nodiscard]] double width_mm() const;
  /// Draws within a rectangle of the page (device units); `unit` is device units in a millimetre.
  using Draw = std::function<void(QPainter&, const QRectF& area, double unit)>;

  /// A block that is never split; goes to the next page when it does not fit. `keepWithNext_mm` asks for that
  /// much more room (headings). `part`: what it is to somebody who cannot see it.
  void add(double height_mm, Draw draw, double keepWithNext_mm = 0.0, PdfPart part = {});
  /// What a whole page holds.
  [[nodiscard]] double page_mm() const;
  /// What is left of the current page.
  [[nodiscard]] double room_mm() const;
  void space(double height_mm);
  void newPage();
  /// Wrapped text; splits between lines of a page only when taller than a page.
  void text(const QString& content, double points, bool bold = false,
            const QColor& colour = QColor(0x26, 0x32, 0x38), double keepWithNext_mm = 0.0);
  /// Names the block that was added last, for the list of bookmarks, and makes it a title. `level`: 0, or 1
  /// below the last 0.
  void bookmark(const QString& title, int level);
  [[nodiscard]] const std::vector<PdfBookmark>& bookmarks() const noexcept { return bookmarks_; }
  /// What text() will take.
  [[nodiscard]] double textHeight_mm(const QString& content, double points, bool bold = false) const;
  /// A table with repeated header; column widths and the size of the letters follow the contents.
  void table(const PlainTable& table);
  /// `keepWithLast_mm`: room that must be left under the last row (its notes).
  void table(const PlainTable& table, const TableLayout& layout, double keepWithLast_mm = 0.0);
  [[nodiscard]] TableLayout layOut(const PlainTable& table) const;

  /// Draws everything. `painter` is active on the writer. `progress` is told after every page.
  void render(QPainter& painter,
              const std::function<void(std::size_t page, std::size_t pages)>& progress = {});
  /// Every part that was drawn, in this order.
  [[nodiscard]] const std::vector<PdfPart>& parts() const noexcept { return parts_; }

 private:
  struct Block {
    double top_mm;
    double height_mm;
    Draw draw;
    PdfPart part;
  };
  /// A part of the page that is drawn now begins.
  void begin(QPainter& painter, PdfPart part);
  void drawFrame(QPainter& painter, std::size_t page, double unit);
  [[nodiscard]] double bottom_mm() const;
  [[nodiscard]] QFont font(double points, bool bold) const;

  QPdfWriter& writer_;
  Style style_;
  double unit_;  // device units in a millimetre
  double cursor_mm_;
  std::vector<std::vector<Block>> pages_;
  std::vector<PdfBookmark> bookmarks_;
  std::vector<PdfPart> parts_;
  std::size_t page_ = 0;    // that is drawn now
  std::size_t tables_ = 0;  // that were added
};

}  // namespace torsio
