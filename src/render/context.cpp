// SPDX-License-Identifier: MIT
// What all contexts have in common.
#include "render/context.h"

#include <fmt/format.h>

namespace render {

std::string Context::renderer() const {
    const GLubyte* text = gl_.GetString(GL_RENDERER);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

std::string Context::version() const {
    const GLubyte* text = gl_.GetString(GL_VERSION);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

int Context::largest_size() const {
    GLint size = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    return size;
}

base::Result<std::unique_ptr<Context>> open_headless(std::string_view backend) {
    if (backend == "osmesa") return open_osmesa();
    if (backend == "egl") return open_egl();
    return base::error(fmt::format("no backend is named {}; take osmesa or egl", backend));
}

}  // namespace render
