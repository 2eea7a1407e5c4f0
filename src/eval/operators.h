// SPDX-License-Identifier: MIT
// One operator of the graph on numbers of any type that has the overloads of numeric/.
#pragma once

#include <cassert>
#include <span>

#include "graph/operator.h"
#include "numeric/interval.h"
#include "numeric/jet_operators.h"
#include "numeric/real.h"

namespace eval {

/// The operator's value; arguments beyond its arity are not looked at. Not for leaves (constant,
/// variable, parameter). T is double,
/// numeric::Interval, or numeric::Jet over one of them.
template <class T>
T apply(graph::Op op, const T& a, const T& b, const T& c, const T& d) {
    // The table gives the arity as a number; each row picks its call.
#define ZEROSET_CALL_1(name) numeric::name(a)
#define ZEROSET_CALL_2(name) numeric::name(a, b)
#define ZEROSET_CALL_3(name) numeric::name(a, b, c)
#define ZEROSET_CALL_4(name) numeric::name(a, b, c, d)
    switch (op) {
        case graph::Op::constant:
        case graph::Op::variable:
        case graph::Op::parameter:
            break;
#define OPERATOR(name, arity, glsl, file) \
    case graph::Op::name:                 \
        return ZEROSET_CALL_##arity(name);
#include "graph/operators.def"
    }
#undef ZEROSET_CALL_1
#undef ZEROSET_CALL_2
#undef ZEROSET_CALL_3
#undef ZEROSET_CALL_4
    assert(false);
    return a;
}

/// The same with the arguments in a row, at least as many as the operator's arity.
template <class T>
T apply(graph::Op op, std::span<const T> arguments) {
    assert(!arguments.empty() && static_cast<int>(arguments.size()) >= graph::facts(op).arity);
    const auto argument = [&](std::size_t i) -> const T& {
        return i < arguments.size() ? arguments[i] : arguments[0];
    };
    return apply(op, argument(0), argument(1), argument(2), argument(3));
}

}  // namespace eval
