// SPDX-License-Identifier: MIT
// From a document to a preset's text.
#include <charconv>

#include <fmt/format.h>

#include "scene/json.h"
#include "scene/preset.h"
#include "scene/preset_sections.h"

namespace scene {
namespace {

using Kind = Json::Kind;

/// The next part of a JSON pointer, which begins with '/'; it is cut off.
std::string next_key(std::string_view& pointer) {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    std::string key;
    for (std::size_t i = 0; i < end; ++i) {
        const bool escaped = pointer[i] == '~' && i + 1 < end;
        key += !escaped ? pointer[i] : pointer[i + 1] == '1' ? '/' : '~';
        if (escaped) ++i;
    }
    pointer.remove_prefix(end);
    return key;
}

Json* child(Json& json, const std::string& key) {
    if (json.kind == Kind::object) return json.find(key);
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(key.data(), key.data() + key.size(), index);
    const bool fine = json.kind == Kind::list && failure == std::errc() &&
                      end == key.data() + key.size() && index < json.elements.size();
    return fine ? &json.elements[index] : nullptr;
}

/// Adds an unknown field to the object that it belongs to, if that is there and has none of that
/// name.
void insert(Json& root, std::string_view pointer, const std::string& text) {
    base::Result<Json> value = parse_json(text);
    Json* place = &root;
    while (value && place && pointer.starts_with('/')) {
        const std::string key = next_key(pointer);
        if (pointer.empty()) {
            if (place->kind == Kind::object && !place->find(key))
                place->add(key, *std::move(value));
            return;
        }
        place = child(*place, key);
    }
}

bool has_unknown_below(const Document& document, std::string_view section) {
    const std::string pointer = fmt::format("/{}/", section);
    const auto at = document.unknown.lower_bound(pointer);
    return at != document.unknown.end() && at->first.starts_with(pointer);
}

}  // namespace

std::string write_preset(const Document& document) {
    Json json = Json::object();
    json.add("zeroset", Json::of(static_cast<double>(preset_version)));
    for (const Section& section : sections()) {
        std::optional<Json> part =
            section.write(document, has_unknown_below(document, section.name));
        if (part) json.add(std::string(section.name), *std::move(part));
    }
    for (const auto& [pointer, text] : document.unknown) insert(json, pointer, text);
    return print_json(json) + '\n';
}

}  // namespace scene
