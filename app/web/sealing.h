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

/// Answers with a gzipped container, unpacked if the browser requires.
[[nodiscard]] HttpResponse binaryAnswer(const Call& call, const std::string& packed);
/// Answers with the organ of a picture; 404 if it is not on this machine.
[[nodiscard]] HttpResponse organAnswer(const Call& call, const CasePicture& picture);

}  // namespace torsio::web
