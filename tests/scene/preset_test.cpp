// SPDX-License-Identifier: MIT
// Documents to presets and back.
#include "scene/preset.h"

#include <locale.h>

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using scene::Document;

/// Random documents, all of which a preset can hold.
class Dice {
public:
    explicit Dice(unsigned seed) : random_(seed) {}

    bool coin() { return random_() % 2 == 0; }
    int upto(int most) { return static_cast<int>(random_() % static_cast<unsigned>(most + 1)); }
    /// A number that is sometimes simple and sometimes has all its digits.
    double number(double least, double greatest) {
        if (coin()) return std::uniform_real_distribution<double>(least, greatest)(random_);
        const double part = upto(16) / 16.0;
        return least + (greatest - least) * part;
    }
    glm::dvec3 vector(double least, double greatest) {
        return {number(least, greatest), number(least, greatest), number(least, greatest)};
    }
    std::string text() {
        static const char* const pieces[] = {
            "x^2",  " ", "\"", "\\", "/",   "\t", "\xC3\xA4", "= 1", "\xF0\x9F\x98\x80",
            "\x01", "'", "\r", "{",  "\x7F"};
        std::string out;
        for (int i = upto(8); i-- > 0;) out += pieces[upto(13)];
        return out;
    }

    Document document() {
        Document d;
        if (coin()) d.title = text();
        if (coin()) d.description = text() + '\n' + text();
        d.formula = "x" + text();
        for (int i = upto(3); i-- > 0;) d.formula += '\n' + text();
        for (int i = upto(3); i-- > 0;) d.parameters[text()] = parameter();
        if (coin()) d.time = number(-100, 100);
        if (coin()) d.bounds = bounds();
        if (coin()) d.camera = {vector(-5, -1), vector(1, 5), vector(0.5, 1), number(1, 170)};
        if (coin()) lights(d);
        if (coin()) materials(d);
        if (coin()) d.environment = {vector(0, 1), vector(0, 1), vector(0, 1), vector(0, 1)};
        if (coin()) d.settings = settings();
        if (coin()) unknown(d);
        return d;
    }

private:
    scene::ParameterValue parameter() {
        switch (upto(3)) {
            case 0:
                return text();
            case 1:
                return coin();
            case 2: {
                std::vector<double> components(2 + static_cast<std::size_t>(upto(2)));
                for (double& component : components) component = number(-10, 10);
                return components;
            }
            default:
                return number(-10, 10);
        }
    }
    scene::Bounds bounds() {
        scene::Bounds b;
        const glm::dvec3 centre = coin() ? vector(-5, 5) : glm::dvec3(0);
        switch (upto(2)) {
            case 0:
                b = {scene::Bounds::Shape::sphere, centre, glm::dvec3(number(0.1, 9))};
                break;
            case 1:
                b = {scene::Bounds::Shape::box, centre, vector(0.1, 9)};
                break;
            default:
                b.shape = scene::Bounds::Shape::none;
        }
        return b;
    }
    void lights(Document& d) {
        d.lights.clear();
        for (int i = upto(8); i-- > 0;) {
            d.lights.push_back({vector(0.1, 1), vector(0, 1), coin() ? 1 : number(0, 3)});
        }
    }
    void materials(Document& d) {
        for (int i = upto(15); i-- > 0;) {
            d.materials.push_back({vector(0, 1), coin() ? 0.35 : number(0, 1), number(1, 200)});
        }
    }
    scene::Settings settings() {
        scene::Settings s;
        if (coin()) s.tracer = "certified";
        if (coin()) s.steps = 1 + upto(9999);
        if (coin()) s.lipschitz = number(0.5, 4);
        if (coin()) s.epsilon = number(0.01, 1);
        if (coin()) s.shadow = number(1, 64);
        s.shadows = coin();
        s.ambient_occlusion = coin();
        s.grid = coin();
        s.show_steps = coin();
        s.show_certificate = coin();
        if (coin()) s.exposure = number(0.1, 4);
        return s;
    }
    void unknown(Document& d) {
        d.unknown["/sparkle"] = "{\"a\": [1, 2.50, \"x\"], \"b\": {}}";
        d.unknown["/settings/glitter"] = "null";
        d.unknown["/environment/stars~1~0"] = "12345678901234567890";
        if (d.camera) d.unknown["/camera/shutter"] = "0.5";
        if (d.lights.size() > 1) d.unknown["/lights/1/name"] = "\"key\"";
        d.unknown["/materials/0/gloss"] = "true";
        if (d.bounds.shape != scene::Bounds::Shape::none) d.unknown["/bounds/soft"] = "[]";
    }

    std::mt19937 random_;
};

TEST(Preset, comes_back_as_the_same_document) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        const Document document = Dice(seed).document();
        const std::string text = scene::write_preset(document);
        const auto preset = scene::read_preset(text);
        ASSERT_TRUE(preset) << "seed " << seed << '\n'
                            << base::format(preset.problems()[0], "preset", text) << text;
        EXPECT_EQ(preset->document, document) << "seed " << seed << '\n' << text;
        EXPECT_EQ(scene::write_preset(preset->document), text) << "seed " << seed;
        EXPECT_EQ(preset->warnings.size(), document.unknown.size()) << "seed " << seed;
        EXPECT_EQ(preset->formula_places.size(), document.formula.size() + 1) << "seed " << seed;
    }
}

TEST(Preset, holds_only_what_differs_from_the_defaults) {
    Document document;
    document.formula = "x = 0";
    EXPECT_EQ(scene::write_preset(document), "{\n  \"zeroset\": 1,\n  \"formula\": \"x = 0\"\n}\n");
}

TEST(Preset, has_its_fields_in_a_fixed_order_and_short_lists_on_one_line) {
    Document document;
    document.title = "Ball";
    document.description = "A ball.";
    document.formula = "param a = 1 in [0, 2]\nx^2 + y^2 + z^2 = a";
    document.parameters["a"] = 0.5;
    document.time = 1.5;
    document.bounds = {scene::Bounds::Shape::box, {0, 0, 1}, {1, 2, 3}};
    document.camera = {{1, 2, 3}, {0, 0, 1}, {0, 1, 0}, 30};
    document.lights.push_back({{1, 0, 0}, {1, 0.5, 0.25}, 0.3});
    document.materials[0].colour = {0.1, 0.2, 0.3};
    document.environment.sky = {0, 0, 1};
    document.settings.steps = 100;
    document.settings.shadows = false;
    EXPECT_EQ(scene::write_preset(document),
              "{\n"
              "  \"zeroset\": 1,\n"
              "  \"title\": \"Ball\",\n"
              "  \"description\": \"A ball.\",\n"
              "  \"formula\": [\n"
              "    \"param a = 1 in [0, 2]\",\n"
              "    \"x^2 + y^2 + z^2 = a\"\n"
              "  ],\n"
              "  \"parameters\": {\"a\": 0.5},\n"
              "  \"time\": 1.5,\n"
              "  \"bounds\": {\"box\": [0, 0, 1, 1, 2, 3]},\n"
              "  \"camera\": {\n"
              "    \"eye\": [1, 2, 3],\n"
              "    \"target\": [0, 0, 1],\n"
              "    \"fov\": 30\n"
              "  },\n"
              "  \"lights\": [\n"
              "    {},\n"
              "    {\n"
              "      \"direction\": [1, 0, 0],\n"
              "      \"colour\": [1, 0.5, 0.25],\n"
              "      \"intensity\": 0.3\n"
              "    }\n"
              "  ],\n"
              "  \"materials\": [\n"
              "    {\"colour\": [0.1, 0.2, 0.3]}\n"
              "  ],\n"
              "  \"environment\": {\"sky\": [0, 0, 1]},\n"
              "  \"settings\": {\n"
              "    \"steps\": 100,\n"
              "    \"shadows\": false\n"
              "  }\n"
              "}\n");
}

TEST(Preset, is_the_same_text_in_every_locale) {
    Document document;
    document.formula = "x = 0";
    document.time = 1.5;
    const std::string text = scene::write_preset(document);
    const char* const before = setlocale(LC_ALL, nullptr);
    const std::string old = before ? before : "C";
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
        if (!setlocale(LC_ALL, name)) continue;
        EXPECT_EQ(scene::write_preset(document), text);
        const auto preset = scene::read_preset(text);
        EXPECT_TRUE(preset && preset->document == document);
    }
    setlocale(LC_ALL, old.c_str());
}

TEST(Preset, reads_whole_numbers_in_any_spelling) {
    const auto preset =
        scene::read_preset(R"({"zeroset": 1.0, "formula": "x", "settings": {"steps": 2e2}})");
    ASSERT_TRUE(preset);
    EXPECT_EQ(preset->document.settings.steps, 200);
}

TEST(Preset, reads_every_form_of_bounds) {
    using Shape = scene::Bounds::Shape;
    const auto bounds = [](const std::string& json) {
        const auto preset =
            scene::read_preset(R"({"zeroset": 1, "formula": "x", "bounds": )" + json + "}");
        EXPECT_TRUE(preset) << json;
        return preset ? preset->document.bounds : scene::Bounds{};
    };
    EXPECT_EQ(bounds(R"({"sphere": 3})"), (scene::Bounds{Shape::sphere, {0, 0, 0}, {3, 3, 3}}));
    EXPECT_EQ(bounds(R"({"sphere": [1, 2, 3, 4]})"),
              (scene::Bounds{Shape::sphere, {1, 2, 3}, {4, 4, 4}}));
    EXPECT_EQ(bounds(R"({"box": [1, 2, 3]})"), (scene::Bounds{Shape::box, {0, 0, 0}, {1, 2, 3}}));
    EXPECT_EQ(bounds(R"({"box": [1, 2, 3, 4, 5, 6]})"),
              (scene::Bounds{Shape::box, {1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(bounds(R"("none")").shape, Shape::none);
}

TEST(Preset, holds_parameters_as_people_write_them) {
    const std::string text = R"({
  "zeroset": 1,
  "formula": "x",
  "parameters": {
    "a": 0.5,
    "c": [-0.2, 0.6, 0.2, 0.2],
    "cut": true,
    "shape": "round"
  }
}
)";
    const auto preset = scene::read_preset(text);
    ASSERT_TRUE(preset);
    const scene::ParameterValues expected{
        {"a", 0.5}, {"c", std::vector{-0.2, 0.6, 0.2, 0.2}}, {"cut", true}, {"shape", "round"}};
    EXPECT_EQ(preset->document.parameters, expected);
    EXPECT_EQ(scene::write_preset(preset->document), text);
    const auto place = [&](const char* name, auto member) {
        const base::SourceSpan span = preset->parameter_places.at(name).*member;
        return text.substr(span.begin, span.end - span.begin);
    };
    EXPECT_EQ(place("c", &scene::ParameterPlace::name), "\"c\"");
    EXPECT_EQ(place("c", &scene::ParameterPlace::value), "[-0.2, 0.6, 0.2, 0.2]");
}

TEST(Preset, can_have_no_lights) {
    const auto preset = scene::read_preset(R"({"zeroset": 1, "formula": "x", "lights": []})");
    ASSERT_TRUE(preset);
    EXPECT_TRUE(preset->document.lights.empty());
    EXPECT_NE(scene::write_preset(preset->document).find("\"lights\": []"), std::string::npos);
}

TEST(Preset, never_holds_a_number_that_cannot_be_read_back) {
    Document document;
    document.formula = "x";
    document.time = std::numeric_limits<double>::quiet_NaN();
    document.parameters["a"] = std::numeric_limits<double>::infinity();
    document.parameters["b"] = std::vector{1, std::numeric_limits<double>::infinity()};
    document.settings.exposure = std::numeric_limits<double>::quiet_NaN();
    document.camera = {{std::numeric_limits<double>::infinity(), 0, 0}, {0, 0, 0}};
    const auto preset = scene::read_preset(scene::write_preset(document));
    ASSERT_TRUE(preset);
    Document plain;
    plain.formula = "x";
    EXPECT_EQ(preset->document, plain);
}

TEST(UnknownFields, survive_and_are_warned_about) {
    const std::string text = R"({
  "zeroset": 1,
  "formula": "x",
  "settings": {
    "sparkle": [1, {"deep": "x"}],
    "stepz": 5
  },
  "titel": "y"
}
)";
    const auto preset = scene::read_preset(text);
    ASSERT_TRUE(preset);
    ASSERT_EQ(preset->warnings.size(), 3u);
    EXPECT_EQ(base::format(preset->warnings[0], "a.json", text),
              "a.json:5:5: warning: unknown field 'settings.sparkle' is kept but ignored\n"
              "    \"sparkle\": [1, {\"deep\": \"x\"}],\n"
              "    ^~~~~~~~~\n");
    EXPECT_EQ(preset->warnings[1].message,
              "unknown field 'settings.stepz' is kept but ignored; did you mean 'steps'?");
    EXPECT_EQ(preset->warnings[2].message,
              "unknown field 'titel' is kept but ignored; did you mean 'title'?");
    EXPECT_EQ(scene::write_preset(preset->document), R"({
  "zeroset": 1,
  "formula": "x",
  "settings": {
    "sparkle": [
      1,
      {"deep": "x"}
    ],
    "stepz": 5
  },
  "titel": "y"
}
)");
}

TEST(UnknownFields, go_with_the_object_that_they_belong_to) {
    auto preset = scene::read_preset(R"({"zeroset": 1, "formula": "x",
        "camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "shutter": 5},
        "lights": [{}, {"name": "fill"}], "bounds": {"sphere": 1, "soft": true}})");
    ASSERT_TRUE(preset);
    Document& document = preset->document;
    EXPECT_EQ(document.unknown.size(), 3u);
    document.camera.reset();
    document.lights.pop_back();
    document.bounds.shape = scene::Bounds::Shape::none;
    const std::string text = scene::write_preset(document);
    EXPECT_TRUE(scene::read_preset(text));
    EXPECT_EQ(text.find("shutter"), std::string::npos);
    EXPECT_EQ(text.find("fill"), std::string::npos);
    EXPECT_EQ(text.find("soft"), std::string::npos);
}

TEST(UnknownFields, never_replace_known_ones) {
    Document document;
    document.formula = "x";
    document.unknown["/formula"] = "\"y\"";
    document.unknown["/broken"] = "{";
    document.unknown["no pointer"] = "1";
    document.unknown[""] = "1";
    const auto preset = scene::read_preset(scene::write_preset(document));
    ASSERT_TRUE(preset);
    EXPECT_EQ(preset->document.formula, "x");
    EXPECT_TRUE(preset->document.unknown.empty());
}

}  // namespace
