// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/web/case_picture.h"
#include "app/web/router.h"
#include "assessment/domain/people/signature.h"

namespace torsio::web {

/// Performs a sealing act after checking the password sent with it. If a password is required, answers 403
/// "need_password" with the meaning of the signature.
[[nodiscard]] HttpResponse sealing(Call& call, SignatureMeaning meaning,
                                   const std::function<HttpResponse()>& act);

/// Returns `routes` with those of a recording and of its organ below `path`.
[[nodiscard]] std::vector<Route> withPicture(std::vector<Route> routes, const std::string& path,
                                             std::shared_ptr<const CasePicture> (*picture)(Call&));
/// Answers with a gzipped container, unpacked if the browser requires.
[[nodiscard]] HttpResponse binaryAnswer(const Call& call, const std::string& packed);

}  // namespace torsio::web
