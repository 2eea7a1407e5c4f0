// SPDX-License-Identifier: MIT
#include "studio/document_file.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/file.h"
#include "compile/compile.h"
#include "scene/preset.h"

namespace studio {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

bool is_below(const fs::path& file, const fs::path& folder) {
    if (folder.empty()) return false;
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(file, failed);
    const fs::path root = fs::weakly_canonical(folder, failed);
    const auto [end, _] = std::mismatch(root.begin(), root.end(), whole.begin(), whole.end());
    return end == root.end();
}

/// A problem of a file, with the place in it.
std::string in_file(const base::Diagnostic& problem, const fs::path& file, std::string_view text) {
    if (!problem.span) return problem.message;
    const base::LineColumn place = base::line_column(text, problem.span->begin);
    return fmt::format("{}:{}:{}: {}", file.string(), place.line, place.column, problem.message);
}

std::string trimmed(std::string_view text) {
    const auto blank = [](unsigned char c) { return std::isspace(c) != 0; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return std::string(text);
}

base::Result<fs::path> path_of(std::string_view typed, const fs::path& folder,
                               const char* extension) {
    const std::string name = trimmed(typed);
    if (name.empty()) return base::error("the name is empty; type one");
    if (name.back() == '/') return base::error("this is a folder; add a name for the file");
    fs::path path = name;
    if (name.starts_with("~/")) {
        path = fs::path(environment("HOME")) / name.substr(2);
    } else if (name.starts_with("./") || name.starts_with("../")) {
        path = fs::absolute(path);
    } else if (!path.is_absolute()) {
        path = folder / path;
    }
    if (path.extension() != extension) path += extension;
    return path.lexically_normal();
}

/// Letters, digits and what is harmless in a file's name; the rest becomes '-'.
std::string file_name(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool harmless = std::isalnum(byte) || byte >= 0x80 || c == '-' || c == '_';
        if (harmless) {
            result += c;
        } else if (!result.empty() && result.back() != '-') {
            result += '-';
        }
    }
    while (!result.empty() && result.back() == '-') result.pop_back();
    return result.empty() ? "picture" : result;
}

/// Values that the formula has no use for would only confuse the file's readers.
void drop_useless_parameters(Workspace& workspace) {
    const Compilation& compilation = workspace.compilation;
    if (compilation.text != workspace.document.formula) return;
    if (base::has_errors(compilation.diagnostics)) return;
    std::erase_if(workspace.document.parameters, [&](const auto& entry) {
        const auto& [name, value] = entry;
        const auto place = std::ranges::find(compilation.parameters, name, &field::Parameter::name);
        return place == compilation.parameters.end() || !compile::components(*place, value);
    });
}

/// Says which values do not suit the formula, if that is understood.
void note_parameters(Workspace& workspace, const scene::Preset& preset, const fs::path& file,
                     std::string_view text) {
    if (preset.document.parameters.empty()) return;
    const auto formula = compile::compile_formula(preset.document.formula);
    if (!formula) return;
    for (const auto& problem : compile::check_parameters(formula->field, preset.document.parameters,
                                                         preset.parameter_places)) {
        workspace.note(in_file(problem, file, text));
    }
}

}  // namespace

base::Status open_file(Workspace& workspace, const fs::path& file) {
    const auto text = base::read_text(file, scene::largest_preset);
    if (!text) return text.problems();
    auto preset = scene::read_preset(*text);
    if (!preset) {
        base::Diagnostics problems;
        for (const auto& problem : preset.problems()) {
            problems.push_back(base::error(in_file(problem, file, *text)));
        }
        return problems;
    }
    for (const auto& warning : preset->warnings) workspace.note(in_file(warning, file, *text));
    note_parameters(workspace, *preset, file, *text);
    const bool shipped = is_below(file, scene::shipped_presets_folder());
    workspace.replace(std::move(preset->document), fs::absolute(file), shipped);
    return base::Done{};
}

base::Status save_file(Workspace& workspace, const fs::path& file) {
    if (auto status = make_parent_folder(file); !status) return status;
    drop_useless_parameters(workspace);
    const std::string text = scene::write_preset(workspace.document);
    if (auto status = base::write_atomically(file, text); !status) return status;
    workspace.saved = workspace.document;
    workspace.file = file;
    workspace.shipped = is_below(file, scene::shipped_presets_folder());
    workspace.presets = list_all_presets();
    workspace.note(fmt::format("saved '{}'", file.string()));
    return base::Done{};
}

base::Result<fs::path> preset_path(std::string_view name) {
    return path_of(name, scene::user_presets_folder(), ".json");
}

base::Result<fs::path> picture_path(std::string_view name) {
    return path_of(name, pictures_folder(), ".png");
}

fs::path pictures_folder() {
    std::error_code none;
    const fs::path pictures = fs::path(environment("HOME")) / "Pictures";
    if (fs::is_directory(pictures, none)) return pictures / "zeroset";
    return scene::user_presets_folder().parent_path() / "screenshots";
}

fs::path fresh_picture_path(const std::string& name) {
    const fs::path folder = pictures_folder();
    std::error_code none;
    for (int number = 1;; ++number) {
        fs::path path = folder / fmt::format("{}-{}.png", file_name(name), number);
        if (!fs::exists(path, none)) return path;
    }
}

base::Status make_parent_folder(const fs::path& file) {
    std::error_code failed;
    const fs::path folder = file.parent_path();
    if (folder.empty()) return base::Done{};
    fs::create_directories(folder, failed);
    if (!failed) return base::Done{};
    return base::error(fmt::format("cannot make the folder '{}': {}; choose another place",
                                   folder.string(), failed.message()));
}

}  // namespace studio
