// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
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
inline constexpr QColor kWarningInk{0xA0, 0x4A, 0x00};  ///< for warnings

/// Places blocks one below the other on A4 pages and draws them in a second pass, when the number of pages is
/// known ("page 3 of 7"). All lengths in millimetres.
class PageFlow {
 public:
  struct Style {
    double marginSide_mm = 20.0;
    double marginTop_mm = 20.0;
    double marginBottom_mm = 20.0;
    QString headerText;  ///< small, on every page except the first
    QString footerText;  ///< left
    QString reference;   ///< below it, on every page: the report's reference; may be empty
    QString watermark;   ///< at the top of every page, such as that the data are simulated; may be empty
    std::function<QString(std::size_t page, std::size_t pages)> pageText;  ///< right; from 1
  };

  PageFlow(QPdfWriter& writer, Style style);

  /// Usable width, of the column if there are two.
  [[nodiscard]] double width_mm() const;
  /// Returns the width of each of two columns.
  [[nodiscard]] double columnWidth_mm() const;
  /// Places what follows in the left of two columns, until nextColumn() and endColumns(). `height_mm`: of the
  /// taller column, which must fit on a page; moves to the next page if it does not fit on this one.
  void beginColumns(double height_mm);
  void nextColumn();
  void endColumns();
  /// Draws within a rectangle of the page (device units); `unit`: device units per millimetre.
  using Draw = std::function<void(QPainter&, const QRectF& area, double unit)>;

  /// Adds a block that is never split; moves to the next page if it does not fit. `keepWithNext_mm`:
  /// additional room required below (headings). `part`: its role for screen readers.
  void add(double height_mm, Draw draw, double keepWithNext_mm = 0.0, PdfPart part = {});
  /// Returns the height left on the current page.
  [[nodiscard]] double room_mm() const;
  void space(double height_mm);
  void newPage();
  /// Adds wrapped text; split between lines only if taller than a page.
  void text(const QString& content, double points, bool bold = false,
            const QColor& colour = QColor(0x26, 0x32, 0x38), double keepWithNext_mm = 0.0);
  /// Bookmarks the last block and makes it a title. `level`: 0, or 1 for an entry below the last level 0.
  void bookmark(const QString& title, int level);
  [[nodiscard]] const std::vector<PdfBookmark>& bookmarks() const noexcept { return bookmarks_; }
  /// Returns the height that text() will need.
  [[nodiscard]] double textHeight_mm(const QString& content, double points, bool bold = false) const {
    return textHeight_mm(content, points, bold, width_mm());
  }
  [[nodiscard]] double textHeight_mm(const QString& content, double points, bool bold, double width_mm) const;
  /// Adds a table with repeated header; column widths and font size follow the contents.
  void table(const PlainTable& table);
  /// `keepWithLast_mm`: room required below the last row (for its notes).
  void table(const PlainTable& table, const TableLayout& layout, double keepWithLast_mm = 0.0);
  /// Adds a narrow table in both columns, down the left and then down the right. `layout`: for
  /// columnWidth_mm().
  void tableInColumns(const PlainTable& table, const TableLayout& layout);
  [[nodiscard]] TableLayout layOut(const PlainTable& table) const { return layOut(table, width_mm()); }
  [[nodiscard]] TableLayout layOut(const PlainTable& table, double width_mm) const;

  /// Draws everything. `painter` is active on the writer. `progress` is called after every page.
  void render(QPainter& painter,
              const std::function<void(std::size_t page, std::size_t pages)>& progress = {});
  /// Returns the parts in the order in which they were drawn.
  [[nodiscard]] const std::vector<PdfPart>& parts() const noexcept { return parts_; }

 private:
  struct Block {
    double left_mm;
    double width_mm;
    double top_mm;
    double height_mm;
    Draw draw;
    PdfPart part;
  };
  /// Adds the header, or a row, of the table with this number.
  void addHeader(const PlainTable& table, const TableLayout& layout, std::size_t number, PdfRole role);
  void addRow(const PlainTable& table, const TableLayout& layout, std::size_t number, std::size_t row);
  /// Returns how a row of cells is drawn. `row`: 0 for the header.
  [[nodiscard]] Draw drawnRow(const std::vector<QString>& cells, const TableLayout& layout,
                              std::size_t number, PdfRole role, std::size_t row);
  /// Begins a part of the current page.
  void begin(QPainter& painter, PdfPart part);
  void drawFrame(QPainter& painter, std::size_t page, double unit);
  [[nodiscard]] double bottom_mm() const;
  [[nodiscard]] QFont font(double points, bool bold) const;

  QPdfWriter& writer_;
  Style style_;
  double unit_;  // device units per millimetre
  double cursor_mm_;
  /// The two columns, while they are filled.
  struct Columns {
    bool right = false;
    double top_mm = 0.0;
    double lowest_mm = 0.0;
  };
  std::optional<Columns> columns_;
  std::vector<std::vector<Block>> pages_;
  std::vector<PdfBookmark> bookmarks_;
  std::vector<PdfPart> parts_;
  std::size_t page_ = 0;    // being drawn
  std::size_t tables_ = 0;  // added so far
};

}  // namespace torsio
