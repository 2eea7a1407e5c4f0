// SPDX-License-Identifier: MIT
#include "bench/measure.h"

#include <algorithm>
#include <utility>

#include "bench/first_picture.h"
#include "bench/interleave.h"
#include "bench/judge.h"
#include "bench/kept_program.h"
#include "bench/plain.h"
#include "bench/plain_parts.h"
#include "bench/slider_move.h"
#include "bench/statistics.h"
#include "render/depth_texture.h"
#include "shader/assembly.h"

namespace bench {
namespace {

constexpr shader::Outputs picture_only{.picture = true};
constexpr shader::Outputs counted{
    .picture = false, .geometry = true, .normal = true, .count = true};

/// What the seconds of a program say.
enum class Part { yardstick, whole, geometry, normal, shading };

/// Something that is drawn once a round.
struct Timed {
    Part part = Part::whole;
    std::size_t entry = 0;  ///< of the report, unless it is the yardstick
    std::size_t program = 0;
    render::Frame frame;
    double typical_seconds = 0;  ///< of a frame before the rounds
};

/// What is slow is drawn in the first rounds only.
constexpr int slow_rounds = 3;

/// The work on one scene as it grows: what is to be drawn, and the report.
class Measurement {
public:
    static base::Result<Measurement> create(render::Context& context, const Subject& subject,
                                            const Options& options,
                                            const oracle::Reference* reference);

    void time_compiling();
    base::Status add_yardstick();
    base::Status add_tracer(const std::string& tracer);
    base::Status add_plain(const std::string& name);
    base::Status add_limit();
    base::Status add_passes(const std::string& tracer);
    base::Status add_slider();
    void draw_rounds();

    PresetReport report;
    std::vector<MarkedPicture> pictures;

private:
    Measurement(render::Context& context, const Subject& subject, const Options& options,
                const oracle::Reference* reference, render::Canvas picture, render::Canvas geometry,
                render::Canvas judged)
        : context_(context),
          subject_(subject),
          options_(options),
          reference_(reference),
          picture_(std::move(picture)),
          geometry_(std::move(geometry)),
          judged_(std::move(judged)) {}

    scene::Document document(const std::string& tracer, const Move& move) const;
    render::Frame frame(const scene::Document& document, const render::Canvas& canvas) const;
    base::Result<KeptProgram> keep_source(const shader::ProgramSource& source);
    base::Result<std::size_t> add_program(const shader::ProgramSource& source);
    base::Status add_entries(const std::string& tracer, const std::vector<Move>& moves,
                             const shader::ProgramSource& picture,
                             const shader::ProgramSource& counting);
    base::Status add_first_picture(const shader::ProgramSource& source, Entry& entry);
    base::Status count(const shader::ProgramSource& source, std::size_t first_entry);
    void count_pixels(Entry& entry);
    base::Status judge_entry(Entry& entry);
    base::Result<image::Grey> told_depth();
    double add_timed(Part part, std::size_t entry, std::size_t program,
                     const scene::Document& document);
    void tell(const Timed& timed, std::vector<double> seconds);

    render::Context& context_;
    const Subject& subject_;
    const Options& options_;
    const oracle::Reference* reference_;
    std::optional<render::DepthTexture> told_;
    render::Canvas picture_, geometry_, judged_;
    std::vector<KeptProgram> programs_;
    std::vector<Timed> timed_;
};

base::Result<Measurement> Measurement::create(render::Context& context, const Subject& subject,
                                              const Options& options,
                                              const oracle::Reference* reference) {
    const auto canvas = [&](int width, int height, const shader::Outputs& outputs) {
        return render::Canvas::create(context.gl(), width, height, outputs);
    };
    auto picture = canvas(options.width, options.height, picture_only);
    if (!picture) return picture.problems();
    auto geometry = canvas(options.width, options.height, counted);
    if (!geometry) return geometry.problems();
    auto judged = canvas(options.reference_width, options.reference_height, counted);
    if (!judged) return judged.problems();
    Measurement made(context, subject, options, reference, std::move(*picture),
                     std::move(*geometry), std::move(*judged));
    made.report.preset = subject.name;
    made.report.smooth = subject.smooth;
    made.report.settings = own_values(subject.document.settings);
    if (reference) made.report.proven = !reference->heuristic;
    return made;
}

scene::Document Measurement::document(const std::string& tracer, const Move& move) const {
    scene::Document document = subject_.document;
    document.settings = moved(document.settings, move);
    document.settings.tracer = tracer;
    return document;
}

render::Frame Measurement::frame(const scene::Document& document,
                                 const render::Canvas& canvas) const {
    return render::frame(document, *document.camera,
                         render::whole(canvas.width(), canvas.height()));
}

base::Result<KeptProgram> Measurement::keep_source(const shader::ProgramSource& source) {
    return keep(context_, source,
                compile::field_numbers(subject_.formula, source, subject_.document));
}

base::Result<std::size_t> Measurement::add_program(const shader::ProgramSource& source) {
    auto kept = keep_source(source);
    if (!kept) return kept.problems();
    programs_.push_back(std::move(*kept));
    return programs_.size() - 1;
}

void Measurement::time_compiling() {
    const BeforeLinking before = before_linking(subject_, picture_only);
    report.parse_seconds = before.parse_seconds;
    report.analyse_seconds = before.analyse_seconds;
}

base::Status Measurement::add_yardstick() {
    shader::Assembly vertex;
    vertex.add_part("output/vertex.glsl");
    const std::string& text = plain_parts().at("yardstick.glsl");
    const std::string fragment = text.substr(text.find("#version"));
    const auto program = add_program({vertex.text(), fragment, {}, {}});
    if (!program) return program.problems();
    add_timed(Part::yardstick, 0, *program, subject_.document);
    return base::Done{};
}

/// Draws it a first time; the seconds of that.
double Measurement::add_timed(Part part, std::size_t entry, std::size_t program,
                              const scene::Document& document) {
    Timed& timed = timed_.emplace_back(Timed{part, entry, program, frame(document, picture_)});
    const double first = timed_draw(picture_, programs_[program], timed.frame);
    timed.typical_seconds = first;
    // The first draw of a program may be long because the driver compiles it.
    if (first > slow_seconds) {
        timed.typical_seconds = timed_draw(picture_, programs_[program], timed.frame);
    }
    return first;
}

base::Status Measurement::add_entries(const std::string& tracer, const std::vector<Move>& moves,
                                      const shader::ProgramSource& picture,
                                      const shader::ProgramSource& counting) {
    const auto program = add_program(picture);
    if (!program) return program.problems();
    const std::size_t first = report.entries.size();
    for (const Move& move : moves) {
        Entry entry;
        entry.tracer = tracer;
        entry.move = move;
        entry.link_seconds = programs_[*program].link_seconds;
        report.entries.push_back(std::move(entry));
        const scene::Document moved = document(tracer, move);
        const std::size_t number = report.entries.size() - 1;
        if (number == first) {
            report.entries.back().first_frame_seconds =
                add_timed(Part::whole, number, *program, moved);
            continue;
        }
        // About as slow as without the move: not worth a draw before the rounds.
        const double typical_seconds = timed_.back().typical_seconds;
        timed_.push_back({Part::whole, number, *program, frame(moved, picture_), typical_seconds});
    }
    return count(counting, first);
}

/// What is asked of single seconds is measured more than once.
base::Status Measurement::add_first_picture(const shader::ProgramSource& source, Entry& entry) {
    const auto picture = first_picture(
        context_, picture_, source,
        compile::field_numbers(subject_.formula, source, subject_.document),
        frame(subject_.document, picture_), entry.first_frame_seconds < slow_seconds ? 5 : 1);
    if (!picture) return picture.problems();
    entry.link_seconds = picture->link_seconds;
    entry.first_frame_seconds = picture->first_frame_seconds;
    return base::Done{};
}

base::Status Measurement::add_tracer(const std::string& tracer) {
    const scene::Document own = document(tracer, {});
    const auto source = compile::program_source(subject_.formula, own, picture_only);
    const std::size_t first = report.entries.size();
    auto added = add_entries(tracer, moves(options_.sweeps, subject_.document.settings), source,
                             compile::program_source(subject_.formula, own, counted));
    if (!added || tracer != "auto") return added;
    return add_first_picture(source, report.entries[first]);
}

base::Status Measurement::add_plain(const std::string& name) {
    return add_entries(name, {Move{}}, plain_source(subject_, name, picture_only),
                       plain_source(subject_, name, counted));
}

/// Depths of the reference, if it has this size and is sure of them, else those of `auto`.
base::Result<image::Grey> Measurement::told_depth() {
    const scene::Document own = document("auto", {});
    const auto kept = keep_source(compile::program_source(subject_.formula, own, counted));
    if (!kept) return kept.problems();
    timed_draw(geometry_, *kept, frame(own, geometry_));
    const auto geometry = geometry_.read_geometry();
    image::Grey depth(options_.width, options_.height);
    const bool fits =
        reference_ && reference_->width == depth.width && reference_->height == depth.height;
    for (std::size_t i = 0; i < depth.values.size(); ++i) {
        const bool sure = fits && reference_->pixels[i].verdict != oracle::Verdict::undecided;
        depth.values[i] =
            sure ? static_cast<float>(reference_->pixels[i].depth()) : geometry.values[4 * i];
    }
    return depth;
}

base::Status Measurement::add_limit() {
    const auto depth = told_depth();
    if (!depth) return depth.problems();
    auto texture = render::DepthTexture::create(context_.gl(), *depth);
    if (!texture) return texture.problems();
    told_ = std::move(*texture);
    told_->bind();
    const scene::Document own = document("auto", {});
    shader::Features picture = compile::features(subject_.formula, own, picture_only);
    picture.told_depth = true;
    picture.shadows = false;
    shader::Features counting = picture;
    counting.outputs = counted;
    const field::Field& field = subject_.formula.field;
    return add_entries(std::string(limit_name), {Move{}}, shader::program_source(field, picture),
                       shader::program_source(field, counting));
}

/// Draws all settings of one tracer with a program that counts and tells depths.
base::Status Measurement::count(const shader::ProgramSource& source, std::size_t first_entry) {
    const auto kept = keep_source(source);
    if (!kept) return kept.problems();
    for (std::size_t i = first_entry; i < report.entries.size(); ++i) {
        Entry& entry = report.entries[i];
        const scene::Document moved = document(entry.tracer, entry.move);
        timed_draw(geometry_, *kept, frame(moved, geometry_));
        count_pixels(entry);
        if (!reference_ || entry.tracer == limit_name) continue;
        timed_draw(judged_, *kept, frame(moved, judged_));
        if (auto judged = judge_entry(entry); !judged) return judged;
    }
    return base::Done{};
}

void Measurement::count_pixels(Entry& entry) {
    const auto geometry = geometry_.read_geometry();
    const auto normal = geometry_.read_normal();
    double evaluations = 0;
    for (std::size_t i = 0; i < geometry.values.size(); i += 4) {
        const auto status = static_cast<shader::Status>(geometry.values[i + 2]);
        entry.hit += status == shader::Status::hit;
        entry.miss += status == shader::Status::miss;
        entry.unresolved += status == shader::Status::unresolved;
        evaluations += normal.values[i + 3];
    }
    entry.evaluations = evaluations / (static_cast<double>(geometry.values.size()) / 4);
}

/// Holds what the canvas shows against the reference.
base::Status Measurement::judge_entry(Entry& entry) {
    auto judged = judge(*reference_, judged_.read_geometry(), judged_.read_normal());
    if (!judged) return judged.problems();
    entry.errors = judged->errors;
    if (entry.move.name.empty()) {
        pictures.push_back({entry.tracer, std::move(judged->picture)});
    }
    return base::Done{};
}

base::Status Measurement::add_passes(const std::string& tracer) {
    const Entry* found = find(report, tracer);
    if (!found) return base::Done{};
    const auto entry = static_cast<std::size_t>(found - report.entries.data());
    report.entries[entry].passes = Passes{};
    const scene::Document own = document(tracer, {});
    const shader::Features whole = compile::features(subject_.formula, own, picture_only);
    shader::Features geometry = whole, normal = whole, shading = whole;
    geometry.show_steps = true;
    normal.show_normals = true;
    shading.shadows = false;
    for (const auto& [part, features] :
         {std::pair{Part::geometry, geometry}, {Part::normal, normal}, {Part::shading, shading}}) {
        const auto program = add_program(shader::program_source(subject_.formula.field, features));
        if (!program) return program.problems();
        add_timed(part, entry, *program, own);
    }
    return base::Done{};
}

/// Also a first draw, in which the driver may compile.
base::Status Measurement::add_slider() {
    const scene::Document own = document("auto", {});
    const auto source = compile::program_source(subject_.formula, own, picture_only);
    auto kept = keep_source(source);
    if (!kept) return kept.problems();
    const render::Frame shown = frame(own, picture_);
    timed_draw(picture_, *kept, shown);
    report.slider = move_slider(subject_.formula, source, own, [&](shader::FieldNumbers numbers) {
        kept->numbers = std::move(numbers);
        timed_draw(picture_, *kept, shown);
    });
    return base::Done{};
}

void Measurement::tell(const Timed& timed, std::vector<double> seconds) {
    const double median = quantile(seconds, 0.5);
    if (timed.part == Part::yardstick) {
        report.yardstick_seconds = std::move(seconds);
        return;
    }
    Entry& entry = report.entries[timed.entry];
    switch (timed.part) {
        case Part::yardstick:
            break;
        case Part::whole:
            if (entry.passes) entry.passes->shadows = median;
            entry.seconds = std::move(seconds);
            break;
        case Part::geometry:
            entry.passes->geometry = median;
            break;
        case Part::normal:
            entry.passes->normal = median;
            break;
        case Part::shading:
            entry.passes->shading = median;
            break;
    }
}

void Measurement::draw_rounds() {
    std::vector<int> rounds;
    for (const Timed& timed : timed_) {
        const bool is_slow = timed.typical_seconds > slow_seconds;
        rounds.push_back(is_slow ? std::min(slow_rounds, options_.rounds) : options_.rounds);
    }
    auto seconds = interleave(rounds, options_.seed, [&](std::size_t i) {
        return timed_draw(picture_, programs_[timed_[i].program], timed_[i].frame);
    });
    for (std::size_t i = 0; i < timed_.size(); ++i) tell(timed_[i], std::move(seconds[i]));
}

}  // namespace

base::Result<Measured> measure(render::Context& context, const Subject& subject,
                               const Options& options, const oracle::Reference* reference) {
    auto work = Measurement::create(context, subject, options, reference);
    if (!work) return work.problems();
    work->time_compiling();
    if (auto added = work->add_yardstick(); !added) return added.problems();
    for (const std::string& tracer : options.tracers) {
        if (auto added = work->add_tracer(tracer); !added) return added.problems();
    }
    for (const std::string& name : plain_names(subject)) {
        if (auto added = work->add_plain(name); !added) return added.problems();
    }
    if (auto added = work->add_limit(); !added) return added.problems();
    for (const std::string& tracer : options.passes) {
        if (auto added = work->add_passes(tracer); !added) return added.problems();
    }
    if (auto added = work->add_slider(); !added) return added.problems();
    work->draw_rounds();
    return Measured{std::move(work->report), std::move(work->pictures)};
}

}  // namespace bench
