// SPDX-License-Identifier: MIT
#include "render/background_program.h"

#include <utility>

namespace render {

const Program* BackgroundProgram::of(const Gl& gl, const Program& program, bool first_tile) {
    const auto& wanted = program.background();
    if (!wanted) return nullptr;
    if (!source_ || source_->fragment != wanted->fragment) {
        source_ = wanted;
        linked_.reset();
        is_rejected_ = false;
        return nullptr;
    }
    if (first_tile && !linked_ && !is_rejected_) {
        shader::ProgramSource source;
        source.vertex = source_->vertex;
        source.fragment = source_->fragment;
        auto linked = Program::link(gl, source);
        // The scene's own program draws everything then.
        is_rejected_ = !linked;
        if (linked) linked_ = std::move(*linked);
    }
    return linked_ ? &*linked_ : nullptr;
}

}  // namespace render
