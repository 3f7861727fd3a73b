// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/provenance_line.h"

#include "sim/core/text.h"

namespace torsio {

Text provenanceLine(const Provenance& from) {
  std::vector<Text> parts;
  if (!from.formula.empty()) {
    parts.push_back(from.formulaVersion.empty() ? from.formula
                                                : Text::tr("%1 (%2)", from.formula, from.formulaVersion));
  }
  if (!from.n.empty()) {
    parts.push_back(Text::verbatim("n = %1", from.n.words()));
  }
  if (!from.missing.empty()) {
    parts.push_back(Text::tr("missing = %1", from.missing.words()));
  }
  parts.insert(parts.end(), from.flags.begin(), from.flags.end());
  return listed(parts, Text::tr("%1; %2"));
}

}  // namespace torsio
