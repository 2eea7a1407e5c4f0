// SPDX-License-Identifier: MIT
// Reading and writing of the bounds.
#include "scene/preset_bounds.h"

#include "scene/preset_object.h"

namespace scene {
namespace {

using Kind = Json::Kind;
using Shape = Bounds::Shape;

/// A centre comes first where there is one; the sizes are the last `sizes` numbers.
template <std::size_t sizes>
Range range_of(std::size_t index, std::size_t count) {
    return index + sizes < count ? position_range : size_range;
}

void read_sphere(const Json& json, const Place& place, Reading& reading, Bounds& bounds) {
    if (json.kind == Kind::number) {
        double radius = 0;
        if (!read_value(json, size_range, place, reading, radius)) return;
        bounds = {Shape::sphere, glm::dvec3(0), glm::dvec3(radius)};
        return;
    }
    const std::vector<double> n = read_numbers(
        json, place, reading, "a radius or a list [x, y, z, radius]", 4, 4, range_of<1>);
    if (!n.empty()) bounds = {Shape::sphere, {n[0], n[1], n[2]}, glm::dvec3(n[3])};
}

void read_box(const Json& json, const Place& place, Reading& reading, Bounds& bounds) {
    const std::vector<double> n = read_numbers(
        json, place, reading, "a list [hx, hy, hz] of half extents or [x, y, z, hx, hy, hz]", 3, 6,
        range_of<3>);
    if (n.size() == 3) bounds = {Shape::box, glm::dvec3(0), {n[0], n[1], n[2]}};
    if (n.size() == 6) bounds = {Shape::box, {n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

}  // namespace

void read_bounds(const Json& json, const Place& place, Reading& reading, Document& document) {
    if (json.kind == Kind::text && json.text == "none") {
        document.bounds.shape = Shape::none;
        return;
    }
    const Json* sphere = json.find("sphere");
    const Json* box = json.find("box");
    if (json.kind != Kind::object || (!sphere && !box)) {
        reading.expect(json, place, "{\"sphere\": ...}, {\"box\": ...} or \"none\"");
        return;
    }
    reading.reject_duplicates(json, place);
    if (sphere && box) {
        reading.fail(json, "'bounds' has both 'sphere' and 'box'; keep one of them");
    }
    if (sphere) read_sphere(*sphere, place.member("sphere"), reading, document.bounds);
    if (box) read_box(*box, place.member("box"), reading, document.bounds);
    for (const JsonMember& member : json.members) {
        if (member.key == "sphere" || member.key == "box") continue;
        reading.keep_unknown(member, place.member(member.key), {"sphere", "box"});
    }
}

std::optional<Json> write_bounds(const Document& document, bool asked_for) {
    const Bounds& b = document.bounds;
    if (b.shape == Shape::none) return Json::of(std::string("none"));
    if (!is_writable(b.centre) || !is_writable(b.half) || (b == Bounds{} && !asked_for)) {
        return std::nullopt;
    }
    const bool sphere = b.shape == Shape::sphere;
    Json json = Json::object();
    if (sphere && b.centre == glm::dvec3(0)) {
        json.add("sphere", Json::of(b.half.x));
        return json;
    }
    Json numbers = Json::of(std::vector<Json>());
    if (b.centre != glm::dvec3(0)) numbers = to_json(b.centre);
    for (int i = 0; i < (sphere ? 1 : 3); ++i) numbers.elements.push_back(Json::of(b.half[i]));
    json.add(sphere ? "sphere" : "box", std::move(numbers));
    return json;
}

}  // namespace scene
