// SPDX-License-Identifier: MIT
#include "contract/operator_table.h"

#include <algorithm>
#include <cmath>

namespace contract {

using graph::Op;

bool is_allowed(Op op, const Arguments& arguments) {
    return op != Op::ratio || std::isnan(arguments[0]) || std::isnan(arguments[1]) ||
           std::abs(arguments[0]) <= arguments[1];
}

bool is_promised(const Row& row, const Arguments& arguments) {
    std::array<numeric::Interval, graph::max_arity> box;
    std::ranges::transform(arguments, box.begin(),
                           [](float a) { return numeric::Interval(static_cast<double>(a)); });
    return is_allowed(row.op, arguments) && analysis::is_promised(row, box);
}

const char* name_of(Unit unit) {
    switch (unit) {
        case Unit::none:
            return "exact";
        case Unit::relative:
            return "relative";
        case Unit::absolute:
            return "absolute";
        case Unit::mixed:
            return "relative or absolute";
        case Unit::slope:
            return "of 1 + value^2";
        case Unit::power:
            return "of value (1 + |b| + |log value|)";
    }
    return "";
}

}  // namespace contract
