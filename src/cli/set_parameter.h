// SPDX-License-Identifier: MIT
// The option --set.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "field/field.h"
#include "scene/document.h"

namespace cli {

/// Puts a value that was typed into the document: `a=0.5`; `c=0.1,0.2,0` for all components of a
/// vector or `c.x=0.1` for one; `shape=round` by a choice's label; `cut=on` or `off`; `t=2` for the
/// time, unless the formula has a parameter of this name.
base::Status set_parameter(const field::Field& field, std::string_view name, std::string_view value,
                           scene::Document& document);

}  // namespace cli
