// SPDX-License-Identifier: MIT
// One visitor made of several functions.
#pragma once

namespace field {

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace field
