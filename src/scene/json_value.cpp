// SPDX-License-Identifier: MIT
// Building and looking into JSON values.
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "scene/json.h"

namespace scene {

Json Json::of(bool truth) {
    Json json;
    json.kind = Kind::boolean;
    json.truth = truth;
    return json;
}

Json Json::of(double number) {
    assert(std::isfinite(number));
    Json json;
    json.kind = Kind::number;
    json.number = number;
    json.text = fmt::format("{}", number);
    return json;
}

Json Json::of(std::string text) {
    Json json;
    json.kind = Kind::text;
    json.text = std::move(text);
    return json;
}

Json Json::of(std::vector<Json> elements) {
    Json json;
    json.kind = Kind::list;
    json.elements = std::move(elements);
    return json;
}

Json Json::object() {
    Json json;
    json.kind = Kind::object;
    return json;
}

Json* Json::find(std::string_view key) {
    for (JsonMember& member : members) {
        if (member.key == key) return &member.value;
    }
    return nullptr;
}

const Json* Json::find(std::string_view key) const { return const_cast<Json*>(this)->find(key); }

void Json::add(std::string key, Json value) {
    members.push_back({std::move(key), {}, std::move(value)});
}

}  // namespace scene
