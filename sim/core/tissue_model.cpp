// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/tissue_model.h"

#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::array<std::string_view, kTissueModels.size()> kModelIds{"twist", "fem", "msm"};

}  // namespace

std::string_view tissueModelId(TissueModel model) noexcept {
  return kModelIds[static_cast<std::size_t>(model)];
}

TissueModel tissueModelOf(const std::string& id) {
  for (const TissueModel model : kTissueModels) {
    if (tissueModelId(model) == id) {
      return model;
    }
  }
  throw Error(ErrorCode::kBadParameter, Text::tr("there is no model '%1'", id), Text::tr("the model"),
              Text::tr("Choose one of %1.", std::string("twist, fem, msm")));
}

}  // namespace torsio
