// SPDX-License-Identifier: GPL-3.0-or-later
// What the study says about itself, and the items that three guidelines ask a report for: CONSORT 2025
// (randomised trials), GRRAS 2011 (reliability and agreement), Cheng et al. 2016 (simulation research,
// elements beyond CONSORT).
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "assessment/results/report_sections.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using Sentence = Text (*)(const CohortInputs& in);

/// An item of a guideline and what in the record answers it.
struct ChecklistItem {
  std::string_view number;
  Phrase asks;
  StudyItem stated = StudyItem::kEnd;  ///< this statement
  std::string_view where{};            ///< a section, table or figure with this id
  Sentence said = nullptr;             ///< a sentence; empty: not recorded
};
/// Answered by what the study says about itself.
constexpr ChecklistItem stated(std::string_view number, Phrase asks, StudyItem by) {
  return {.number = number, .asks = asks, .stated = by};
}
/// Answered by a part of the report.
constexpr ChecklistItem shown(std::string_view number, Phrase asks, std::string_view where) {
  return {.number = number, .asks = asks, .where = where};
}
/// Answered by a sentence, and by that part of the report.
constexpr ChecklistItem told(std::string_view number, Phrase asks, Sentence said,
                             std::string_view where = {}) {
  return {.number = number, .asks = asks, .where = where, .said = said};
}
/// Answered by nothing in the record.
constexpr ChecklistItem open(std::string_view number, Phrase asks) {
  return {.number = number, .asks = asks};
}

Text designOf(const CohortInputs& in) {
  const CohortAllocation& draw = in.allocation;
  if (draw.method.empty()) {
    return {};
  }
  const Text groups =
      draw.asDrawn()
          ? Text::tr("%1 parallel {group|groups}, drawn", in.groups.size())
          : Text::tr("%1 parallel {group|groups}, not as drawn (see the first page)", in.groups.size());
  return in.hasAnalysisPlan() ? Text::tr("%1; differences, and equivalence within a planned margin", groups)
                              : Text::tr("%1; differences", groups);
}
Text interimOf(const CohortInputs& in) {
  if (!in.freeze || in.freeze->sheetsAsked == 0) {
    return {};
  }
  return in.freeze->interim() ? Text::tr("this report is an interim look; see the first page")
                              : Text::tr("the data were frozen when every sheet was in");
}
Text randomisationOf(const CohortInputs& in) {
  return in.allocation.method;
}
Text concealmentOf(const CohortInputs& in) {
  const CohortAllocation& draw = in.allocation;
  if (draw.commitment.empty()) {
    return {};
  }
  return draw.lockedUtc_us == 0 || draw.allocatedBeforeLock > 0
             ? Text::tr("by a sealed seed, but nothing shows that it was sealed before the first allocation")
             : Text::tr("by a seed that was sealed, with its hash, before the first allocation");
}
Text implementationOf(const CohortInputs& in) {
  return in.allocation.commitment.empty() ? Text() : Text::tr("drawn by the program from the sealed seed");
}
Text blindedOf(const CohortInputs& in) {
  const MarkWays& ways = in.markWays;
  return ways.blinded + ways.live + ways.entered == 0
             ? Text()
             : Text::tr("raters: %1 of %2 {mark|marks} under case labels", ways.blinded,
                        ways.blinded + ways.live + ways.entered);
}
Text stationsOf(const CohortInputs& in) {
  const bool ours = std::any_of(in.trials.begin(), in.trials.end(),
                                [](const TrialSummaryRow& trial) { return trial.model != kForeignModel; });
  return ours ? Text::tr("the simulator of Torsio %1", in.softwareVersion) : Text();
}
Text unitOf(const CohortInputs& in) {
  return in.trainingMarks.empty() ? Text() : Text::tr("the trainee; repeated marks: see Methods");
}
Text independentlyOf(const CohortInputs& in) {
  const MarkWays& ways = in.markWays;
  const std::int64_t onSheets = ways.blinded + ways.live;
  return onSheets == 0 ? Text()
                       : Text::tr(
                             "%1 of %2 {mark was|marks were} given on sheets, whose raters do not see each "
                             "other's marks before submitting",
                             onSheets, onSheets + ways.entered);
}
Text dataOf(const CohortInputs& in) {
  return in.trainingMarks.empty() ? Text() : Text::tr("in the table of numbers (CSV)");
}

using Items = std::span<const ChecklistItem>;

constexpr std::array kConsort{
    open("1a", Text::tr("Title names a randomised study")),
    shown("1b", Text::tr("Structured summary"), "summary"),
    stated("2", Text::tr("Registration"), StudyItem::kRegistration),
    stated("3", Text::tr("Protocol and plan of the analysis"), StudyItem::kProtocol),
    stated("4", Text::tr("Sharing of data and programs"), StudyItem::kDataAccess),
    stated("5a", Text::tr("Funding and the part of funders"), StudyItem::kFunding),
    stated("5b", Text::tr("Conflicts of interest"), StudyItem::kInterests),
    open("6", Text::tr("Background and rationale")),
    open("7", Text::tr("Objectives: benefits and harms")),
    stated("8", Text::tr("Involvement of patients or the public"), StudyItem::kInvolvement),
    told("9", Text::tr("Design: type, ratio, framework"), designOf),
    shown("10", Text::tr("Changes after the start"), "deviations"),
    stated("11", Text::tr("Setting and places"), StudyItem::kPlace),
    stated("12a", Text::tr("Eligibility of participants"), StudyItem::kEligibility),
    open("12b", Text::tr("Eligibility of sites and of those who teach")),
    shown("13", Text::tr("Interventions, to be repeated by others"), "table-participants"),
    shown("14", Text::tr("Outcomes, planned, with their times"), "training"),
    stated("15", Text::tr("How harms were defined and looked for"), StudyItem::kHarms),
    stated("16a", Text::tr("Sample size and its assumptions"), StudyItem::kSampleSize),
    told("16b", Text::tr("Interim analyses and stopping"), interimOf),
    shown("17a", Text::tr("Who made the sequence, and how"), "participants"),
    told("17b", Text::tr("Kind of randomisation and restrictions"), randomisationOf, "participants"),
    told("18", Text::tr("Concealment of the allocation"), concealmentOf),
    told("19", Text::tr("Whether those who enrolled or assigned knew the sequence"), implementationOf),
    told("20a", Text::tr("Who was blinded"), blindedOf),
    told("20b", Text::tr("How blinding was done, and how alike the interventions were"), blindedOf,
         "methods"),
    shown("21a", Text::tr("Statistical methods"), "methods"),
    shown("21b", Text::tr("Who is in each analysis"), "comparisons"),
    shown("21c", Text::tr("How missing data were handled"), "comparisons"),
    shown("21d", Text::tr("Additional analyses, planned or not"), "comparisons"),
    shown("22a", Text::tr("Flow of participants"), "table-flow"),
    shown("22b", Text::tr("Losses and exclusions, with reasons"), "table-flow"),
    stated("23a", Text::tr("Dates of recruitment and follow-up"), StudyItem::kRecruitment),
    open("23b", Text::tr("Why the study ended")),
    shown("24a", Text::tr("Interventions as delivered"), "table-dose"),
    shown("24b", Text::tr("Other training during the study"), "deviations"),
    shown("25", Text::tr("Baseline data by group"), "table-participants"),
    shown("26", Text::tr("Numbers analysed, effects and precision"), "figure-answer"),
    stated("27", Text::tr("Harms in each group"), StudyItem::kHarms),
    shown("28", Text::tr("Other analyses"), "table-mixed-anova"),
    open("29", Text::tr("Interpretation")),
    shown("30", Text::tr("Limitations"), "summary"),
};

constexpr std::array kGrras{
    open("1", Text::tr("Title or abstract names reliability or agreement")),
    shown("2", Text::tr("The instrument of measurement"), "criteria"),
    stated("3", Text::tr("Population of subjects"), StudyItem::kEligibility),
    shown("4", Text::tr("Population of raters"), "raters"),
    open("5", Text::tr("What is known, and why this study")),
    stated("6", Text::tr("How the numbers of raters, subjects and replicates were chosen"),
           StudyItem::kSampleSize),
    stated("7", Text::tr("How subjects and raters were sampled"), StudyItem::kRecruitment),
    told("8", Text::tr("Process of rating, with blinding"), blindedOf, "methods"),
    told("9", Text::tr("Whether ratings were independent"), independentlyOf),
    shown("10", Text::tr("Statistical analysis"), "methods"),
    shown("11", Text::tr("Actual numbers of raters, subjects and replicates"), "raters"),
    shown("12", Text::tr("Characteristics of raters and subjects"), "table-participants"),
    shown("13", Text::tr("Reliability and agreement with their uncertainty"), "table-agreement"),
    shown("14", Text::tr("Practical relevance"), "table-raters-needed"),
    told("15", Text::tr("Detailed results"), dataOf),
};

constexpr std::array kSimulation{
    open("1", Text::tr("Title, abstract or key words say simulation")),
    open("2", Text::tr("Simulation as the subject or as the method of research")),
    open("5", Text::tr("Rationale of the training, exposures and confounders")),
    shown("6", Text::tr("Assessment: setting, instrument, simulator, timing"), "criteria"),
    shown("6", Text::tr("Validity and reliability of the assessment"), "table-agreement"),
    told("11", Text::tr("Against bias where blinding is impossible"), blindedOf, "methods"),
    told("12", Text::tr("Unit of analysis and repeated measures"), unitOf),
    shown("15", Text::tr("Earlier experience of participants"), "table-participants"),
    shown("17", Text::tr("Agreement between raters"), "table-agreement"),
    shown("20", Text::tr("Limits of research by simulation"), "methods"),
    open("21", Text::tr("From simulation to patients")),
    stated("25", Text::tr("Simulator, and interests in it"), StudyItem::kInterests),
    open("-", Text::tr("Participants' orientation to simulator and environment")),
    told("-", Text::tr("Simulator type"), stationsOf),
    stated("-", Text::tr("Environment: place, equipment, outside stimuli"), StudyItem::kPlace),
    shown("-", Text::tr("Scenario: events, objectives, alone or in groups, operators, pilot"), "runs"),
    shown("-", Text::tr("Instructional design or exposure: duration, timing, repetitions, variation"),
          "table-dose"),
    open("-", Text::tr("Feedback and debriefing: source, duration, structure, timing")),
};

/// Returns the title of the section, table or figure with this id; empty if the report has none.
Text titleIn(const ReportModel& report, std::string_view id) {
  for (const ReportSection& section : report.sections) {
    if (section.id == id) {
      return section.title;
    }
    for (const ReportTable& table : section.tables) {
      if (table.id == id) {
        return table.title;
      }
    }
    for (const ReportFigure& figure : section.figures) {
      if (figure.id == id) {
        return figure.title;
      }
    }
  }
  return {};
}

/// Returns what answers an item, and where; empty: nothing.
Text answerOf(const ChecklistItem& item, const CohortInputs& in, const ReportModel& report,
              const Text& statements) {
  const Text said = item.said == nullptr ? Text() : item.said(in);
  if (item.said != nullptr && said.empty()) {
    return {};
  }
  const Text title = item.stated != StudyItem::kEnd
                         ? (in.statements.contains(item.stated) ? statements : Text())
                         : titleIn(report, item.where);
  if (title.empty()) {
    return said;
  }
  return said.empty() ? Text::tr("see \"%1\"", title) : Text::tr("%1; see \"%2\"", said, title);
}

ReportTable statementsTable(const CohortInputs& in) {
  ReportTable table;
  table.id = "table-statements";
  table.annex = true;
  table.title = Text::tr("What the study says about itself");
  table.columns = {Text::tr("Item"), Text::tr("Statement")};
  for (const Term<StudyItem>& item : kStudyItems) {
    const auto stated = in.statements.find(item.value);
    table.rows.push_back({Text(item.label), stated == in.statements.end()
                                                ? Text::tr("not recorded: %1", Text(hintOf(item.value)))
                                                : Text(stated->second)});
  }
  if (!in.statements.empty()) {
    table.notes = {Text::tr("As entered by the centre; the program cannot check it.")};
  }
  table.provenance.flags = commonFlags(in);
  return table;
}

ReportTable checklist(const std::string& id, const Text& title, Items items, const CohortInputs& in,
                      const ReportModel& report, const Text& statements) {
  ReportTable table;
  table.id = id;
  table.title = title;
  table.annex = true;
  table.columns = {Text::tr("Item"), Text::tr("Asks for"), Text::tr("In this report")};
  for (const ChecklistItem& item : items) {
    const Text answer = answerOf(item, in, report, statements);
    table.rows.push_back({Text(std::string(item.number)), Text(item.asks),
                          answer.empty() ? Text::tr("not recorded") : answer});
  }
  table.provenance.flags = commonFlags(in);
  return table;
}

}  // namespace

ReportSection statementsSection(const CohortInputs& in) {
  ReportSection section{"statements", Text::tr("Study")};
  section.tables = {statementsTable(in)};
  return section;
}

ReportSection checklistSection(const CohortInputs& in, const ReportModel& report) {
  ReportSection section{"checklists", Text::tr("Checklists")};
  section.startsPage = true;
  const Text statements = titleIn(report, "table-statements");
  section.tables = {
      checklist("table-checklist-consort", Text::tr("CONSORT 2025: a randomised study"), kConsort, in, report,
                statements),
      checklist("table-checklist-grras", Text::tr("GRRAS 2011: reliability and agreement"), kGrras, in,
                report, statements),
      checklist("table-checklist-simulation", Text::tr("Cheng et al. 2016: research by simulation"),
                kSimulation, in, report, statements)};
  return section;
}

}  // namespace torsio
