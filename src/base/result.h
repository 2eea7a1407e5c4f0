// SPDX-License-Identifier: MIT
// A value, or the reasons why there is none. Libraries return it; only the command line and the
// studio show the reasons.
#pragma once

#include <cassert>
#include <utility>
#include <variant>

#include "base/diagnostic.h"

namespace base {

/// Holds a T, or at least one diagnostic of severity error.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::move(value)) {}
    Result(Diagnostic problem) : state_(Diagnostics{std::move(problem)}) {}
    Result(Diagnostics problems) : state_(std::move(problems)) {}

    explicit operator bool() const { return std::holds_alternative<T>(state_); }

    T& operator*() & { return value(); }
    const T& operator*() const& { return const_cast<Result*>(this)->value(); }
    T&& operator*() && { return std::move(value()); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &**this; }

    /// Why there is no value; empty if there is one.
    Diagnostics problems() const {
        const auto* list = std::get_if<Diagnostics>(&state_);
        return list ? *list : Diagnostics{};
    }

private:
    T& value() {
        assert(std::holds_alternative<T>(state_));
        return *std::get_if<T>(&state_);
    }

    std::variant<T, Diagnostics> state_;
};

/// Done, or the reasons why not.
struct Done {};
using Status = Result<Done>;

}  // namespace base
