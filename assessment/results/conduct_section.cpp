// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <map>
#include <string>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_sections.h"

namespace torsio {

ReportSection deviationsSection(const CohortInputs& in) {
  ReportSection section{"deviations", Text::tr("Deviations")};
  if (in.deviations.empty()) {
    section.paragraphs.push_back(Text::tr("No deviation from the protocol was reported."));
    return section;
  }
  std::map<std::string, std::int64_t> kinds;
  for (const CohortDeviation& deviation : in.deviations) {
    ++kinds[deviation.kind];
  }
  section.paragraphs.push_back(
      Text::tr("%1 {deviation from the protocol was|deviations from the protocol were} reported: %2.",
               in.deviations.size(), countsText({kinds.begin(), kinds.end()}, in.identity)));
  ReportTable table;
  table.id = "table-deviations";
  table.title = Text::tr("Deviations from the protocol");
  table.individual = true;
  table.columns = {Text::tr("When"), Text::tr("Trainee"), Text::tr("Kind"), Text::tr("What happened")};
  for (const CohortDeviation& deviation : in.deviations) {
    table.rows.push_back({formatUtc(deviation.happenedUtc_us),
                          deviation.trainee.empty() ? Text::tr("whole cohort") : Text(deviation.trainee),
                          deviation.kind, deviation.description});
  }
  table.provenance.n = std::ssize(in.deviations);
  table.provenance.flags = commonFlags(in);
  section.tables.push_back(table);
  return section;
}

/// Name, meaning and time with the signed object, as required by 21 CFR 11.50.
ReportSection signaturesSection(const CohortInputs& in) {
  ReportSection section{"signatures", Text::tr("Signatures of the marks")};
  section.paragraphs.push_back(
      Text::tr("%1 {mark was|marks were} signed with the password of their rater, %2 {was|were} not.",
               in.signatures.size(), in.unsignedMarks));
  ReportTable table;
  table.id = "table-mark-signatures";
  table.title = Text::tr("Who signed which mark");
  table.individual = true;
  table.columns = {Text::tr("Signed by"), Text::tr("Trainee"), Text::tr("Occasion"), Text::tr("Version"),
                   Text::tr("Meaning"),   Text::tr("When"),    Text::tr("Why")};
  for (const CohortSignature& one : in.signatures) {
    table.rows.push_back({one.signer, one.trainee, one.occasion, std::to_string(one.version), one.meaning,
                          formatUtc(one.signedUtc_us),
                          in.singleMarks ? Text(one.reason) : Text()});  // a reason may reveal the mark
  }
  table.provenance.n = std::ssize(in.signatures);
  table.provenance.flags = commonFlags(in);
  section.tables.push_back(table);
  return section;
}

}  // namespace torsio
