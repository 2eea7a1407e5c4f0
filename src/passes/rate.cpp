// SPDX-License-Identifier: MIT
#include "passes/rate.h"

#include <algorithm>

namespace passes {

Rate Rates::operator[](graph::NodeId id) {
    for (std::size_t i = known_.size(); i <= index(id); ++i) {
        const graph::Node& node = graph_[static_cast<graph::NodeId>(i)];
        Rate rate = Rate::never;
        if (node.op == graph::Op::parameter) rate = Rate::frame;
        if (node.op == graph::Op::variable) rate = node.symbol < 3 ? Rate::point : Rate::turn;
        for (const graph::NodeId argument : node.args()) {
            rate = std::max(rate, known_[index(argument)]);
        }
        known_.push_back(rate);
    }
    return known_[index(id)];
}

}  // namespace passes
