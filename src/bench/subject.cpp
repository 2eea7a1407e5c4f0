// SPDX-License-Identifier: MIT
#include "bench/subject.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "analysis/facts.h"
#include "base/file.h"
#include "bench/generated.h"
#include "compile/visible_region.h"
#include "scene/preset.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

base::Diagnostics of_file(const fs::path& path, const base::Diagnostics& problems) {
    base::Diagnostics list;
    for (const base::Diagnostic& problem : problems) {
        if (problem.severity != base::Severity::error) continue;
        list.push_back(base::error(fmt::format("{}: {}", path.string(), problem.message)));
    }
    return list;
}

/// "surfaces/heart" for a shipped preset, the path without its ending for others.
std::string name_of(const fs::path& path, const fs::path& shipped) {
    const fs::path relative = shipped.empty() ? path : path.lexically_relative(shipped);
    const bool is_shipped = !relative.empty() && *relative.begin() != "..";
    return fs::path(is_shipped ? relative : path).replace_extension().generic_string();
}

bool is_smooth(const Subject& subject) {
    const field::Field& field = subject.formula.field;
    const auto facts = analysis::find_facts(field, compile::visible_region(subject.document.bounds),
                                            compile::parameter_values(field, subject.document));
    return std::ranges::all_of(facts.objects, [](const analysis::Facts& object) {
        return object.regularity.smoothness == analysis::Smoothness::smooth &&
               !object.regularity.partial;
    });
}

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

base::Result<scene::Document> read_document(const fs::path& path, const std::string& name) {
    if (auto scene = generated_scene(name)) return std::move(*scene);
    const auto text = base::read_text(path, scene::largest_preset);
    if (!text) return text.problems();
    auto preset = scene::read_preset(*text);
    if (!preset) return of_file(path, preset.problems());
    return std::move(preset->document);
}

}  // namespace

base::Result<Subject> read_subject(const fs::path& path, const std::string& name, double aspect) {
    auto document = read_document(path, name);
    if (!document) return document.problems();
    Subject subject{name, std::move(*document), {}, false};
    auto formula = compile::compile_formula(subject.document.formula);
    if (!formula) return of_file(path, formula.problems());
    const auto problems =
        compile::check_parameters(formula->field, subject.document.parameters, {});
    if (base::has_errors(problems)) return of_file(path, problems);
    subject.formula = std::move(*formula);
    subject.document.camera = scene::camera_of(subject.document, aspect);
    subject.document.settings.grid = false;
    subject.document.settings.show_steps = false;
    subject.document.settings.show_certificate = false;
    subject.smooth = !generated_scene(name) && is_smooth(subject);
    return subject;
}

base::Result<std::vector<NamedFile>> find_subjects(const std::vector<std::string>& names) {
    const fs::path shipped = scene::shipped_presets_folder();
    std::vector<NamedFile> list;
    const auto add = [&](const fs::path& path) {
        if (std::ranges::find(list, path, &NamedFile::path) != list.end()) return;
        list.push_back({path, name_of(path, shipped)});
    };
    const auto add_folder = [&](const fs::path& folder) {
        for (const fs::path& relative : scene::list_presets(folder)) add(folder / relative);
    };
    if (names.empty()) {
        add_folder(shipped);
        for (const std::string_view name : {few_name, many_name}) {
            list.push_back({fs::path(name), std::string(name)});
        }
    }
    for (const std::string& name : names) {
        if (generated_scene(name)) {
            list.push_back({fs::path(name), name});
        } else if (is_folder(shipped / name)) {
            add_folder(shipped / name);
        } else if (is_folder(name)) {
            add_folder(name);
        } else if (auto path = scene::find_preset(name)) {
            add(*path);
        } else {
            return path.problems();
        }
    }
    if (list.empty()) return base::error("there is no preset to measure; name one");
    return list;
}

}  // namespace bench
