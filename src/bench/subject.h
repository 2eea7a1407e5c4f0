// SPDX-License-Identifier: MIT
// A scene that is measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "compile/compile.h"
#include "scene/document.h"

namespace bench {

struct Subject {
    std::string name;          ///< "fractals/mandelbulb"
    scene::Document document;  ///< with a camera, without the ground grid
    compile::Formula formula;
    /// Proven: each object's field is smooth and defined all over the bounds.
    bool smooth = false;
};

/// Reads and compiles a preset, or a scene of bench/generated.h. Errors name the file.
base::Result<Subject> read_subject(const std::filesystem::path& path, const std::string& name,
                                   double aspect);

/// A preset's file and the name that it goes by in tables.
struct NamedFile {
    std::filesystem::path path;
    std::string name;
};

/// The files that some names mean: a preset each, or a folder of them, shipped or by its path;
/// without names all shipped presets and the
/// generated scenes. Each once, in the order of the names.
base::Result<std::vector<NamedFile>> find_subjects(const std::vector<std::string>& names);

}  // namespace bench
