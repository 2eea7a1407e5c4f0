// SPDX-License-Identifier: MIT
// Joins parts of shaders/ and generated code into one flat text.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "shader/precision.h"

namespace shader {

/// A program's text as it grows. Every part stands in it once, after the parts that it includes;
/// comments and blank lines are left out.
class Assembly {
public:
    /// In double precision a part is taken from the folder double/ beside it where there is one.
    explicit Assembly(Precision precision = Precision::single) : precision_(precision) {}

    /// Adds a part by its path below shaders/, which must exist.
    void add_part(std::string_view path);
    /// Adds generated code.
    void add_code(std::string_view code) { text_ += code; }

    const std::string& text() const { return text_; }

private:
    Precision precision_;
    std::string text_;
    std::set<std::string, std::less<>> added_;
};

}  // namespace shader
