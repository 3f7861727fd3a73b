// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/base/printed_sheets.h"

#include <algorithm>

#include <QBuffer>
#include <QCoreApplication>
#include <QLocale>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/outputs/charts/typeface.h"
#include "app/outputs/pdf/pdf_structure.h"
#include "assessment/domain/rating/rubric.h"
#include "sim/core/file_io.h"

namespace torsio::gui {

namespace {

constexpr int kSheetDots = 150;
constexpr double kSheetMargin_mm = 15.0;
constexpr double kLetters_pt = 10.0;
constexpr std::int64_t kMaxBoxes = 25;

struct PrintedSheets {
  Q_DECLARE_TR_FUNCTIONS(PrintedSheets)
};

QString cell(const QString& text, const char* tag = "td") {
  const QString name = QString::fromLatin1(tag);
  return QStringLiteral("<%1>%2</%1>").arg(name, text.isEmpty() ? QStringLiteral("&nbsp;") : text);
}

QString safe(const std::string& text) {
  return toQString(text).toHtmlEscaped();
}

/// Returns the text in the window's language if it has a translation, HTML-escaped.
QString safeTranslated(const std::string& text) {
  return toQString(Text(text)).toHtmlEscaped();
}

QString pointsText(std::int64_t steps, const ScoreScale& scale) {
  return QLocale().toString(pointsFromSteps(steps, scale), 'g', 6);
}

/// Returns boxes to mark for the whole points of a scale, and a blank line for values between.
QString boxes(const ScoreScale& scale) {
  QString row;
  const bool narrow = (scale.hi - scale.lo) / scale.stepsPerPoint < kMaxBoxes;
  for (std::int64_t steps = scale.lo; narrow && steps <= scale.hi; steps += scale.stepsPerPoint) {
    row += QStringLiteral("\u25A1\u00A0%1 &nbsp; ").arg(pointsText(steps, scale));
  }
  return row + PrintedSheets::tr("or exactly: ______") + QStringLiteral("<br>\u25A1\u00A0") +
         PrintedSheets::tr("cannot be assessed, because: ____________________");
}

QString criterion(const QString& label, const ScoreScale& scale, const std::vector<RubricAnchor>& anchors) {
  QString html =
      QStringLiteral(
          "<p style='margin-top:14px; margin-bottom:2px'><b>%1</b> <font color='#555'>%2"
          "</font></p><p style='margin:0; line-height:150%'>%3</p>")
          .arg(label,
               PrintedSheets::tr("%1 to %2").arg(pointsText(scale.lo, scale), pointsText(scale.hi, scale)),
               boxes(scale));
  for (const RubricAnchor& anchor : anchors) {
    html += QStringLiteral("<p style='margin:0; margin-left:14px'><font color='#333'>%1: %2</font></p>")
                .arg(pointsText(anchor.score_steps, scale), safeTranslated(anchor.meaning));
  }
  return html;
}

QString sheetHtml(const PaperSheet& sheet, const QString& centre, bool first) {
  QString html =
      QStringLiteral("<h2%1>%2</h2><p>%3</p>")
          .arg(
              first ? QString() : QStringLiteral(" style='page-break-before:always'"),
              PrintedSheets::tr("Sheet: case %1, rater %2").arg(safe(sheet.caseLabel), safe(sheet.raterCode)),
              PrintedSheets::tr("%1. Mark one box in each row. Do not write any name on this sheet.")
                  .arg(centreHeadline(centre).toHtmlEscaped()));
  for (const RubricLine& row : sheet.rubric.rows) {
    html += criterion(safeTranslated(row.label), row.scale, row.anchors);
  }
  html += criterion(PrintedSheets::tr("Overall mark"), sheet.rubric.overall, {});
  html +=
      QStringLiteral(
          "<p style='margin-top:18px'>%1</p><p style='margin-top:22px'>%2</p>"
          "<p style='margin-top:26px'><font color='#555'>%3</font></p>")
          .arg(
              PrintedSheets::tr("Comment: ______________________________________________________________"),
              PrintedSheets::tr("Date, time: __________________   Signature: ______________________________"),
              PrintedSheets::tr("Revision %1 of the scoring sheet. Typed in by (1) ______________ and (2) "
                                "______________, independently of each other.")
                  .arg(sheet.rubric.number));
  return html;
}

}  // namespace

void printHtml(const QString& html, const QString& title, QPageLayout::Orientation orientation,
               const std::filesystem::path& file) {
  QBuffer out;
  out.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&out);
    writer.setResolution(kSheetDots);
    writer.setTitle(title);
    writer.setPageLayout(
        QPageLayout(QPageSize(QPageSize::A4), orientation,
                    QMarginsF(kSheetMargin_mm, kSheetMargin_mm, kSheetMargin_mm, kSheetMargin_mm),
                    QPageLayout::Millimeter));
    QTextDocument document;
    QFont font = printedTypeface();
    font.setPointSizeF(kLetters_pt);
    document.setDefaultFont(font);
    document.setHtml(html);
    document.setDocumentMargin(0.0);
    document.print(&writer);
  }
  writeFileAtomically(file, searchablePdf(out.data().toStdString()));
}

void writeCallList(const std::vector<CallLine>& lines, const QString& cohort, const QString& room,
                   const std::filesystem::path& file) {
  const QString title = PrintedSheets::tr("Call list: %1").arg(cohort);
  QString html =
      QStringLiteral(
          "<h2>%1</h2><p>%2</p><table border='1' cellspacing='0' cellpadding='5' "
          "width='100%'><tr>")
          .arg(title.toHtmlEscaped(),
               PrintedSheets::tr(
                   "Room: %1. For administrators only. Raters see the case label, never this list.")
                   .arg(room.isEmpty() ? QStringLiteral("______________") : room.toHtmlEscaped()));
  for (const QString& column :
       {PrintedSheets::tr("No."), PrintedSheets::tr("Trainee"), PrintedSheets::tr("Group"),
        PrintedSheets::tr("Now at"), PrintedSheets::tr("Scoring due"), PrintedSheets::tr("Sheets missing"),
        PrintedSheets::tr("Called at"), PrintedSheets::tr("Left at"), PrintedSheets::tr("Remarks")}) {
    html += cell(column.toHtmlEscaped(), "th");
  }
  html += QStringLiteral("</tr>");
  int number = 0;
  for (const CallLine& line : lines) {
    html += QStringLiteral("<tr>") + cell(QString::number(++number)) + cell(line.trainee.toHtmlEscaped()) +
            cell(line.group.toHtmlEscaped()) + cell(line.now.toHtmlEscaped()) +
            cell(line.occasion.toHtmlEscaped()) + cell(QString::number(line.missing)) + cell({}) + cell({}) +
            cell({}) + QStringLiteral("</tr>");
  }
  printHtml(html + QStringLiteral("</table>"), title, QPageLayout::Landscape, file);
}

void writePaperSheets(const std::vector<PaperSheet>& sheets, const QString& centre,
                      const std::filesystem::path& file) {
  QString html;
  for (const PaperSheet& sheet : sheets) {
    html += sheetHtml(sheet, centre, &sheet == &sheets.front());
  }
  printHtml(html, PrintedSheets::tr("Sheets on paper"), QPageLayout::Portrait, file);
}

namespace {

struct PrintedConsent {
  Q_DECLARE_TR_FUNCTIONS(PrintedConsent)
};

QString printable(const std::string& text) {
  return toQString(text).toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br/>"));
}

QString purposeHtml(const ConsentText& text) {
  return QStringLiteral(
             "<p style='margin-top:14px; margin-bottom:2px'><b>%1</b></p><p style='margin:0'>%2</p>"
             "<p style='margin-top:5px'>\u25A1\u00A0%3 &nbsp;&nbsp;&nbsp; \u25A1\u00A0%4</p>")
      .arg(printable(text.title), printable(text.text), PrintedConsent::tr("I agree"),
           PrintedConsent::tr("I do not agree"));
}

QString formHtml(const ConsentVersion& version, const ConsentWords& words, const std::string& code,
                 const QString& centre, bool first) {
  QString html =
      QStringLiteral("<h2%1>%2</h2><p>%3</p><p>%4</p>")
          .arg(first ? QString() : QStringLiteral(" style='page-break-before:always'"),
               PrintedConsent::tr("Consent"),
               PrintedConsent::tr("%1. Code: %2")
                   .arg(centreHeadline(centre).toHtmlEscaped(),
                        code.empty() ? QStringLiteral("______________") : printable(code)),
               PrintedConsent::tr("Mark one box in each row. Nothing is recorded before you agree to the "
                                  "training record; the other answers are free. You can withdraw each of "
                                  "them later at any time."));
  for (const ConsentText& text : words.texts) {
    html += purposeHtml(text);
  }
  return html +
         QStringLiteral(
             "<p style='margin-top:26px'>%1</p><p style='margin-top:24px'>%2</p>"
             "<p style='margin-top:26px'><font color='#555'>%3</font></p>")
             .arg(PrintedConsent::tr("Name: ________________________________________"),
                  PrintedConsent::tr("Date: ________________   Signature: ______________________________"),
                  PrintedConsent::tr("Text %1. Entered by ______________ on ______________")
                      .arg(printable(version.id)));
}

}  // namespace

void writeConsentForms(const ConsentVersion& version, const ConsentWords& words,
                       const std::vector<std::string>& codes, const QString& centre,
                       const std::filesystem::path& file) {
  QString html;
  for (const std::string& code : codes) {
    html += formHtml(version, words, code, centre, &code == &codes.front());
  }
  printHtml(html, PrintedConsent::tr("Consent"), QPageLayout::Portrait, file);
}

}  // namespace torsio::gui
