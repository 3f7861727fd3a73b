// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/printed_consent.h"

#include <QCoreApplication>

#include "app/gui/administrator/base/centre_headline.h"
#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/base/translated_text.h"

namespace torsio::gui {

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
