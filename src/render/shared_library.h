// SPDX-License-Identifier: MIT
// Libraries that are opened at run time, so that a program starts without them and their symbols
// never mix with those of the window's driver.
#pragma once

#include <initializer_list>
#include <string_view>

#include "base/result.h"

namespace render {

/// An open library. It stays in the process for good: drivers keep threads and thread-local state
/// that do not survive unloading.
class SharedLibrary {
public:
    /// Opens the first of these names that can be opened. An error holds the loader's reason and
    /// names the Debian package to install.
    static base::Result<SharedLibrary> open(std::initializer_list<const char*> names,
                                            std::string_view package);

    /// The function of this name, or null.
    template <class Function>
    Function function(const char* name) const {
        return reinterpret_cast<Function>(symbol(name));
    }

private:
    explicit SharedLibrary(void* handle) : handle_(handle) {}
    void* symbol(const char* name) const;

    void* handle_;
};

}  // namespace render
