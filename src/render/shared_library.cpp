// SPDX-License-Identifier: MIT
// Opens libraries at run time.
#include "render/shared_library.h"

#include <string>

#include <dlfcn.h>
#include <fmt/format.h>

namespace render {

base::Result<SharedLibrary> SharedLibrary::open(std::initializer_list<const char*> names,
                                                std::string_view package) {
    std::string reasons;
    for (const char* name : names) {
        if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE))
            return SharedLibrary(handle);
        const char* reason = dlerror();
        reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", reason ? reason : name);
    }
    return base::error(fmt::format("cannot open {} ({}); install the package {}", *names.begin(),
                                   reasons, package));
}

void* SharedLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace render
