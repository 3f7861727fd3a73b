// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/web/case_picture.h"
#include "app/web/router.h"
#include "assessment/domain/people/signature.h"

namespace torsio::web {

/// Runs an act that seals, after the password that came with it; one that is due is asked for with what its
/// signature means (403, "need_password").
[[nodiscard]] HttpResponse sealing(Call& call, SignatureMeaning meaning,
                                   const std::function<HttpResponse()>& act);

/// A packed container, as the browser takes it.
[[nodiscard]] HttpResponse binaryAnswer(const Call& call, const std::string& packed);
/// The organ of a picture; 404 when it is not on this machine.
[[nodiscard]] HttpResponse organAnswer(const Call& call, const CasePicture& picture);

}  // namespace torsio::web
