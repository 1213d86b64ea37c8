// SPDX-License-Identifier: Apache-2.0
// The lights of a scene file. Keys and ranges: docs/models.md.
#pragma once

#include "host/base/light.hpp"
#include "host/base/result.hpp"
#include "host/scene/entries.hpp"

namespace gnomon::scene {

/// One entry of `lights`, in world coordinates. Errors are one line, "path:line: error: ...".
Result<Light> read_light(const config::Document& document, const Pointer& at);

}  // namespace gnomon::scene
