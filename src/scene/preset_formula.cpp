// SPDX-License-Identifier: MIT
// Reading and writing of the formula, line by line.
#include "scene/preset_formula.h"

#include <algorithm>

namespace scene {
namespace {

using Kind = Json::Kind;

/// Appends a line and the places of its bytes and of its end, which is the line break's place.
void append_line(const Json& line, Reading& reading, std::string& formula) {
    formula += line.text;
    const std::vector<std::uint32_t> places = text_places(reading.text, line.span);
    reading.formula_places.insert(reading.formula_places.end(), places.begin(), places.end());
}

}  // namespace

void read_formula(const Json& json, const Place& place, Reading& reading, Document& document) {
    std::string formula;
    reading.formula_places.clear();
    if (json.kind == Kind::text) {
        append_line(json, reading, formula);
    } else if (json.kind == Kind::list) {
        for (std::size_t i = 0; i < json.elements.size(); ++i) {
            const Json& line = json.elements[i];
            if (line.kind != Kind::text) {
                reading.expect(line, place.element(i), "text in quotes");
                continue;
            }
            if (!reading.formula_places.empty()) formula += '\n';
            append_line(line, reading, formula);
        }
    } else {
        reading.expect(json, place, "text in quotes or a list of lines");
        return;
    }
    if (formula.find_first_not_of(" \t\r\n") == std::string::npos && reading.problems.empty()) {
        reading.fail(json, "the formula is empty; write one, such as \"x^2 + y^2 + z^2 = 1\"");
    }
    document.formula = std::move(formula);
}

std::optional<Json> write_formula(const Document& document, bool) {
    const std::string& formula = document.formula;
    if (formula.find('\n') == std::string::npos) return Json::of(formula);
    std::vector<Json> lines;
    for (std::size_t begin = 0; begin <= formula.size();) {
        const std::size_t end = std::min(formula.find('\n', begin), formula.size());
        lines.push_back(Json::of(formula.substr(begin, end - begin)));
        begin = end + 1;
    }
    return Json::of(std::move(lines));
}

}  // namespace scene
