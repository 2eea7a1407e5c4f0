// SPDX-License-Identifier: MIT
#include "formula/report.h"

#include <algorithm>

#include "formula/limits.h"

namespace formula {

base::Diagnostics in_order(base::Diagnostics diagnostics) {
    std::ranges::stable_sort(diagnostics, {}, [](const base::Diagnostic& it) {
        return it.span.value_or(base::SourceSpan{}).begin;
    });
    if (diagnostics.size() > max_errors) diagnostics.resize(max_errors);
    return diagnostics;
}

}  // namespace formula
