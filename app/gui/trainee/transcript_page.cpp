// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/transcript_page.h"

#include <map>
#include <system_error>

#include <QBuffer>
#include <QPageLayout>
#include <QPdfWriter>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/pdf/pdf_structure.h"
#include "app/outputs/wording/joined_sentences.h"
#include "app/services/recording/competence.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio::gui {

namespace {

constexpr int kLeast = 420;
constexpr int kAboveModule_px = 22;
const QMarginsF kPaperMargins_mm(20.0, 20.0, 20.0, 20.0);

QString cell(const QString& text) {
  return QStringLiteral("<td style='padding: 3px 14px 3px 0'>%1</td>").arg(text.toHtmlEscaped());
}

}  // namespace

TranscriptPage::TranscriptPage(ShellContext& context, QWidget* parent) : Page(context, parent) {
  const PageColumn page = pageColumn(this, 900);
  heading_ = page.heading;
  text_ = new QTextBrowser(this);
  text_->setMinimumHeight(kLeast);
  page.column->addWidget(text_, 1);
  print_ = new QPushButton(this);
  pdf_ = primaryButton(this);
  heading_->addAction(print_);
  heading_->addAction(pdf_);
  connect(pdf_, &QPushButton::clicked, this, &TranscriptPage::choosePdf);
  connect(print_, &QPushButton::clicked, this, &TranscriptPage::print);
}

void TranscriptPage::enter(const QVariant&) {
  attempt(shell(), [&] {
    transcript_ = torsio::transcript(shell().session(), shell().session().actor().personId);
    read_ = true;
  });
  retranslate();
}

void TranscriptPage::retranslate() {
  heading_->setTexts(tr("Every module and attempt"), tr("Save it as PDF or print it, and take it with you."));
  pdf_->setText(tr("Save as &PDF\u2026"));
  print_->setText(tr("P&rint\u2026"));
  pdf_->setEnabled(read_);
  print_->setEnabled(read_);
  text_->setHtml(read_ ? html(false) : QString());
}

QString TranscriptPage::html(bool paper) const {
  const Transcript& t = transcript_;
  QString page;
  const auto line = [&page](const QString& text) {
    page += QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
  };
  page += QStringLiteral("<h2>%1</h2>").arg(tr("Transcript of twist training").toHtmlEscaped());
  if (t.demonstration) {
    line(tr("Demonstration: these people and runs are simulated."));
  }
  const QString name = toQString(t.fullName);
  const QString code = toQString(t.traineeCode);
  line(name.isEmpty() ? tr("Trainee %1").arg(code) : tr("%1 (trainee %2)").arg(name, code));
  const QString cohort = toQString(Text(t.cohortName));
  line(t.centre.empty() ? cohort : tr("%1, %2").arg(toQString(t.centre), cohort));
  if (!t.armLabel.empty()) {
    line(tr("Programme: %1").arg(toQString(t.armLabel)));
  }
  line(tr("Time trained: %1 min on the simulator, %2 min on the real arm, %3 min of rest.")
           .arg(t.virtual_min, 0, 'f', 1)
           .arg(t.real_min, 0, 'f', 1)
           .arg(t.rest_min, 0, 'f', 1));
  std::map<QString, QString> judgedAs;  // first module with this text
  for (const TranscriptModule& module : t.modules) {
    const QString title = toQString(Text(module.step.module.title));
    page += QStringLiteral("<h3 style='margin-top: %1px'>%2</h3>")
                .arg(kAboveModule_px)
                .arg(title.toHtmlEscaped());
    line(tr("%1. Level: %2. %3")
             .arg(StationLabels::state(module.step.state), StationLabels::level(module.competence),
                  toQString(competenceMadeText(module.competence))));
    const QString judgedHow = joinedSentences({StationLabels::competenceRule(module.competence),
                                               toQString(competenceErrorText(module.competence.design))});
    const auto [first, isNew] = judgedAs.try_emplace(judgedHow, title);
    line(isNew ? judgedHow : tr("Competence is judged as in \u201c%1\u201d.").arg(first->second));
    if (module.attempts.empty()) {
      continue;
    }
    page += QStringLiteral("<table style='margin-top: 8px'><tr>");
    for (const QString& head :
         {tr("When"), tr("Mode"), tr("Length"), tr("Result"), tr("Verdict"), tr("Note")}) {
      page += QStringLiteral("<th align='left' style='padding: 3px 14px 3px 0'>%1</th>")
                  .arg(head.toHtmlEscaped());
    }
    page += QStringLiteral("</tr>");
    for (const Attempt& attempt : module.attempts) {
      page += QStringLiteral("<tr>%1%2%3%4%5%6</tr>")
                  .arg(cell(shownTime(attempt.startedUtc_us)),
                       cell(attempt.mode == AttemptMode::kGraded ? tr("Graded") : tr("Practice")),
                       cell(clockTenths(attempt.duration_s)), cell(toQString(attempt.result())),
                       cell(attempt.ended ? toQString(wordOf(attempt.verdict.outcome)) : tr("running")),
                       cell(attempt.forceCuts == 0
                                ? QString()
                                : tr("force cut by the machine, times: %1").arg(attempt.forceCuts)));
    }
    page += QStringLiteral("</table><p></p>");
  }
  if (!t.realArm.empty()) {
    page += QStringLiteral("<h3 style='margin-top: %1px'>%2</h3>")
                .arg(kAboveModule_px)
                .arg(tr("Movements recorded outside the simulator").toHtmlEscaped());
    for (const RealArmRun& run : t.realArm) {
      QStringList sentences;
      for (const Text& one : run.sentences) {
        sentences << toQString(one);
      }
      line(tr("%1, %2: %3", "when, how long, what was measured")
               .arg(shownTime(run.startedUtc_us), clockTenths(run.duration_s), joinedSentences(sentences)));
    }
  }
  if (paper) {
    line(tr("Made on %1 with Torsio %2. A training record, no certificate of clinical competence.")
             .arg(shownTime(t.madeUtc_us), toQString(t.softwareVersion)));
    line(tr("Signature: ______________________________"));
  }
  return page;
}

void TranscriptPage::writePdf(const std::filesystem::path& file) const {
  QBuffer out;
  out.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&out);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(kPaperMargins_mm, QPageLayout::Millimeter);
    writer.setTitle(tr("Transcript of twist training"));
    QTextDocument document;
    document.setHtml(html(true));
    document.print(&writer);
  }
  writeFileAtomically(file, searchablePdf(out.data().toStdString()));
}

void TranscriptPage::choosePdf() {
  const QString proposal = tr("transcript-%1.pdf").arg(toQString(transcript_.traineeCode));
  const QString file = askFileToSave(this, tr("Save transcript"), proposal, tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  attempt(shell(), [&] {
    writePdf(toPath(file));
    shell().notify(tr("Saved to %1").arg(file));
  });
}

void TranscriptPage::print() {
  QPrinter printer;
  QPrintDialog dialog(&printer, this);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  QTextDocument document;
  document.setHtml(html(true));
  document.print(&printer);
}

}  // namespace torsio::gui
