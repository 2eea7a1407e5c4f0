// SPDX-License-Identifier: MIT
#include "oracle/first_hit.h"

#include <algorithm>
#include <cmath>

#include "oracle/bracketed_root.h"

namespace oracle {
namespace {

using numeric::Interval;

/// A hit is enclosed by so much of its distance from the eye, and what is smaller than `finest` of
/// it is not cut any more.
constexpr double enclosure = 1e-9;
constexpr double finest = 1e-14;
/// After so many pieces a part of the shape counts as undecided.
constexpr int most_pieces = 20'000;
/// Likewise of one with iterations, where each takes many turns and an estimate stands by.
constexpr int most_pieces_of_loops = 4'000;
/// Steps are not shorter than this part of the distance, and of an estimate of it.
constexpr double close = 1e-6, least_part = 1.0 / 32;

bool is_positive(const Interval& a) { return a.lo > 0; }
bool is_negative(const Interval& a) { return a.hi < 0; }
bool has_sign(const Interval& a) { return is_positive(a) || is_negative(a); }
bool signs_differ(const Interval& a, const Interval& b) {
    return (is_positive(a) && is_negative(b)) || (is_negative(a) && is_positive(b));
}
bool is_defined(const Interval& a) { return !a.is_empty() && !a.partial; }

}  // namespace

Found nearer(const Found& a, const Found& b) {
    if (b.verdict == Verdict::miss) return a;
    if (a.verdict == Verdict::miss) return b;
    const Found& first = a.near <= b.near ? a : b;
    const Found& second = a.near <= b.near ? b : a;
    // Something is there at the second's far end at the latest.
    if (second.verdict != Verdict::hit || second.far >= first.far) return first;
    Found result = second;
    result.near = first.near;
    const bool narrow = result.far - result.near <= enclosure * result.far;
    if (first.verdict == Verdict::undecided && !narrow) result.verdict = Verdict::undecided;
    return result;
}

FirstHit::FirstHit(const Shape& shape) : shape_(shape), along_(shape), distance_(shape) {
    for (std::size_t i = 0; i < shape.parts.size(); ++i) {
        const std::size_t solid = shape.parts[i].solid;
        if (shape.solids[solid].estimated) continue;
        targets_.push_back({Found::Of::solid, i, {Function::What::solid, solid}});
    }
    for (std::size_t i = 0; i < shape.sheets.size(); ++i) {
        const Sheet& sheet = shape.sheets[i];
        targets_.push_back(
            {Found::Of::sheet, i, {Function::What::expression, sheet.source}, &sheet});
    }
}

double FirstHit::coarse(double t) const { return std::max(0.9 * enclosure * t, 8 * rounding_); }
double FirstHit::fine(double t) const { return std::max(finest * t, 2 * rounding_); }

void FirstHit::take_rounding(const glm::dvec3& o, double t) {
    rounding_ = 1e-16 * (std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) + t);
}

Piece FirstHit::piece_of(const Target& target, const Stretch& stretch) {
    return {stretch.begin, stretch.end, along_.over(target.function, stretch.begin),
            along_.over(target.function, stretch.end)};
}

bool FirstHit::is_clipped_away(const Target& target, const Piece& piece) {
    const std::optional<std::size_t> clip = target.sheet->clip;
    if (!clip) return false;
    if (shape_.solids[*clip].estimated) {
        const bool small = along_.is_ray() && piece.length() <= coarse(piece.end);
        return small && !is_guessed_inside(*clip, piece);
    }
    const Interval t{piece.begin, piece.end};
    return is_positive(along_.over({Function::What::solid, *clip}, t));
}

bool FirstHit::is_drawn_throughout(const Target& target, const Piece& piece) {
    const Interval t{piece.begin, piece.end};
    for (const std::size_t guard : target.sheet->guards) {
        const Interval value = along_.over({Function::What::expression, guard}, t);
        if (!has_sign(value) || !is_defined(value)) return false;
    }
    const std::optional<std::size_t> clip = target.sheet->clip;
    if (!clip) return true;
    if (shape_.solids[*clip].estimated) return along_.is_ray() && is_guessed_inside(*clip, piece);
    return along_.over({Function::What::solid, *clip}, t).hi <= 0;
}

bool FirstHit::is_guessed_inside(std::size_t solid, const Piece& piece) {
    return distance_(solid, along_.ray().at(piece.begin + 0.5 * piece.length())) <= 0;
}

/// By what is cheap: without derivatives.
bool FirstHit::is_empty(const Target& target, const Piece& piece, const Interval& values) {
    const auto excludes = [&](const Interval& each) {
        return is_positive(each) || each.is_empty() || (target.is_sheet() && is_negative(each));
    };
    return excludes(values) || (target.is_sheet() && is_clipped_away(target, piece)) ||
           along_.on_each_side(target.function, {piece.begin, piece.end}, excludes);
}

/// Shrinks a piece on which the function is monotone and changes its sign to one around the root
/// that is small enough for a hit; false if rounding hides the signs beside it.
bool FirstHit::isolate_root(const Function& function, Piece& piece) {
    const double root =
        bracketed_root([&](double t) { return along_.near(function, t); }, piece.begin,
                       piece.at_begin.lo, piece.end, piece.at_end.lo, fine(piece.end));
    for (const double reach : {2 * fine(piece.end), 0.02 * coarse(root), 0.45 * coarse(root)}) {
        Piece part = piece;
        if (root - reach > piece.begin) {
            part.begin = root - reach;
            part.at_begin = along_.over(function, part.begin);
        }
        if (root + reach < piece.end) {
            part.end = root + reach;
            part.at_end = along_.over(function, part.end);
        }
        if (!signs_differ(part.at_begin, part.at_end)) continue;
        if (is_positive(part.at_begin) != is_positive(piece.at_begin)) continue;
        if (part.length() > coarse(part.end)) continue;
        piece = part;
        return true;
    }
    return false;
}

FirstHit::Fate FirstHit::judge_solid(const Target& target, Piece& piece, const RayJet& jet) {
    if (is_positive(values_on(piece, jet))) return Fate::empty;
    if (piece.at_end.hi > 0) return Fate::unknown;
    if (piece.length() <= coarse(piece.end)) return Fate::hit;
    const bool enters = is_positive(piece.at_begin) && is_negative(piece.at_end);
    if (!enters || !is_monotone(jet)) return Fate::unknown;
    return isolate_root(target.function, piece) ? Fate::hit : Fate::unknown;
}

FirstHit::Fate FirstHit::judge_sheet(const Target& target, Piece& piece, const RayJet& jet) {
    if (has_sign(values_on(piece, jet))) return Fate::empty;
    const bool continuous = is_defined(jet.value) && !jet.value.jumps;
    if (!continuous || !signs_differ(piece.at_begin, piece.at_end)) return Fate::unknown;
    const bool small = piece.length() <= coarse(piece.end);
    if (small && is_drawn_throughout(target, piece)) return Fate::hit;
    if (small || !is_monotone(jet)) return Fate::unknown;
    // The only zero of the piece: what is beside it is empty.
    if (!isolate_root(target.function, piece)) return Fate::unknown;
    if (is_clipped_away(target, piece)) return Fate::empty;
    return is_drawn_throughout(target, piece) ? Fate::hit : Fate::unknown;
}

/// May shrink the piece to the part that is not empty.
FirstHit::Fate FirstHit::judge(const Target& target, Piece& piece) {
    if (!target.is_sheet() && piece.at_begin.hi <= 0) {
        piece.end = piece.begin;
        return Fate::hit;
    }
    const Interval t{piece.begin, piece.end}, values = along_.over(target.function, t);
    if (is_empty(target, piece, values)) return Fate::empty;
    // Where the function may jump its derivatives tell nothing.
    const RayJet jet =
        values.partial || values.jumps ? RayJet(values) : along_.jet_over(target.function, t);
    return target.is_sheet() ? judge_sheet(target, piece, jet) : judge_solid(target, piece, jet);
}

/// In two, where the function's sign can be told if that is possible.
void FirstHit::split(const Function& function, const Piece& piece) {
    Piece first = piece, second = piece;
    for (const double part : {0.5, 0.43, 0.59}) {
        first.end = piece.begin + part * piece.length();
        first.at_end = along_.over(function, first.end);
        if (has_sign(first.at_end)) break;
    }
    second.begin = first.end;
    second.at_begin = first.at_end;
    open_.push_back(second);
    open_.push_back(first);
}

/// A hit on a piece around one that could not be settled, still small enough: beside a jump or a
/// root the sign may be known again.
std::optional<Piece> FirstHit::hit_around(const Target& target, const Piece& piece,
                                          const Stretch& stretch) {
    for (const double part : {0.01, 0.45}) {
        const double reach = part * coarse(piece.end);
        Piece wide = piece_of(target, {std::max(piece.begin - reach, stretch.begin),
                                       std::min(piece.end + reach, stretch.end)});
        if (wide.length() > coarse(wide.end)) continue;
        const RayJet jet = along_.jet_over(target.function, {wide.begin, wide.end});
        const Fate fate =
            target.is_sheet() ? judge_sheet(target, wide, jet) : judge_solid(target, wide, jet);
        if (fate == Fate::hit) return wide;
    }
    return std::nullopt;
}

/// How far on from the piece the sign of the function cannot be told.
double FirstHit::end_of_unsettled(const Function& function, const Piece& piece, double end) {
    double step = piece.length(), at = piece.end;
    while (at < end && !has_sign(along_.over(function, at))) {
        at = std::min(at + step, end);
        step *= 2;
    }
    return at;
}

Found FirstHit::found_on(const Target& target, const Piece& piece, const Stretch& stretch) {
    Found found{.of = target.of, .number = target.number};
    found.verdict = Verdict::hit;
    found.near = piece.begin;
    found.far = piece.end;
    found.at_start = !target.is_sheet() && piece.begin == stretch.begin;
    return found;
}

bool FirstHit::has_loops(const Target& target) const {
    return !target.is_sheet() && shape_.solids[target.function.number].has_loops;
}

/// Of the open pieces; takes what it needs of the effort.
Found FirstHit::bisect(const Target& target, const Stretch& stretch, int& effort) {
    std::size_t fresh = open_.size();  // so many, the first ones, have no values at their ends yet
    for (; !open_.empty(); --effort) {
        Piece piece = open_.back();
        open_.pop_back();
        if (open_.size() < fresh) {
            fresh = open_.size();
            piece = piece_of(target, {piece.begin, piece.end});
        }
        const Fate fate = judge(target, piece);
        if (fate == Fate::hit) return found_on(target, piece, stretch);
        if (fate == Fate::empty) continue;
        if (piece.length() > fine(piece.end) && effort > 0) {
            split(target.function, piece);
            continue;
        }
        if (const auto around = hit_around(target, piece, stretch)) {
            return found_on(target, *around, stretch);
        }
        Found found = found_on(target, piece, stretch);
        found.verdict = Verdict::undecided;
        found.far = end_of_unsettled(target.function, piece, stretch.end);
        return found;
    }
    return {};
}

/// Moves t on over what is empty, by steps as long as the estimate says, each of them proven. Stops
/// at the end, and where the estimate is short or more than can be proven; returns it, or what is
/// left.
double FirstHit::march(const Target& target, double& t, double end, int& effort) {
    for (double part = 0.5;; --effort) {
        const double distance = distance_(target.function.number, along_.ray().at(t));
        const double way = std::min(end - t, distance);
        if (!(distance > close * t) || part < least_part || effort <= 0) return way;
        const double next = std::min(t + part * way, end);
        if (is_positive(along_.over(target.function, {t, next}))) {
            t = next;
            if (t >= end) return 0;
            part = std::min(1.25 * part, 1.0);
        } else {
            part *= 0.5;
        }
    }
}

/// Where bisection would take many pieces, each with many turns.
Found FirstHit::search_loops(const Target& target, const Stretch& stretch,
                             const std::vector<Stretch>& stretches) {
    int effort = most_pieces_of_loops;
    for (const Stretch& each : stretches) {
        double t = std::max(each.begin, stretch.begin);
        const double end = std::min(each.end, stretch.end);
        while (t < end) {
            const double way = march(target, t, end, effort);
            double next = std::min(end, t + std::max(4 * coarse(t), 8 * way));
            if (effort <= 0 || !(t < next)) next = end;
            open_.assign(1, {t, next, {}, {}});
            const Found found = bisect(target, stretch, effort);
            if (found.verdict != Verdict::miss) return found;
            t = next;
        }
    }
    return {};
}

Found FirstHit::search(const Target& target, const Stretch& stretch,
                       const std::vector<Stretch>& stretches) {
    if (has_loops(target)) return search_loops(target, stretch, stretches);
    open_.clear();
    for (auto it = stretches.rbegin(); it != stretches.rend(); ++it) {
        const Stretch part{std::max(it->begin, stretch.begin), std::min(it->end, stretch.end)};
        if (part.begin < part.end) open_.push_back({part.begin, part.end, {}, {}});
    }
    int effort = most_pieces;
    return bisect(target, stretch, effort);
}

bool FirstHit::proves_loops() const {
    return std::ranges::any_of(targets_, [&](const Target& target) { return has_loops(target); });
}

Found FirstHit::operator()(const Ray& ray, const Stretch& stretch, const Places& places, Of of) {
    along_.take(ray);
    take_rounding(ray.origin, stretch.begin);
    Found found;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const Stretch rest{stretch.begin, std::min(stretch.end, found.far)};
        if (!(rest.begin < rest.end)) break;
        if (of == Of::formulas && has_loops(targets_[i])) continue;
        found = nearer(found, search(targets_[i], rest, places[i]));
    }
    return found;
}

Places FirstHit::anywhere(const Stretch& stretch) const {
    return Places(targets_.size(), std::vector<Stretch>{stretch});
}

/// True if all rays of the beam meet the target on the piece.
bool FirstHit::all_meet(const Target& target, const Piece& piece) {
    if (!target.is_sheet()) return piece.at_end.hi <= 0;
    if (!signs_differ(piece.at_begin, piece.at_end)) return false;
    const Interval values = along_.over(target.function, {piece.begin, piece.end});
    return is_defined(values) && !values.jumps && is_drawn_throughout(target, piece);
}

/// Of one target, up to `end`, which becomes less where all rays meet the target before.
std::vector<Stretch> FirstHit::narrowed(const Target& target, const std::vector<Stretch>& stretches,
                                        double within, double& end) {
    std::vector<Stretch> left;
    const auto keep = [&](const Piece& piece) {
        if (!left.empty() && left.back().end == piece.begin) {
            left.back().end = piece.end;
        } else {
            left.push_back({piece.begin, piece.end});
        }
    };
    const double spread = along_.spread();
    for (const Stretch& stretch : stretches) {
        if (stretch.begin >= end) return left;
        open_.assign(1, piece_of(target, {stretch.begin, std::min(stretch.end, end)}));
        const double shortest = 1e-3 * (stretch.end - stretch.begin);
        while (!open_.empty()) {
            const Piece piece = open_.back();
            open_.pop_back();
            const Interval t{piece.begin, piece.end};
            if (is_empty(target, piece, along_.over(target.function, t))) continue;
            if (piece.length() > std::max(2 * spread * piece.end, shortest)) {
                const RayJet jet = along_.jet_over(target.function, t);
                const Interval values = values_on(piece, jet);
                if (is_positive(values) || (target.is_sheet() && is_negative(values))) continue;
                split(target.function, piece);
                continue;
            }
            keep(piece);
            if (piece.begin < within || !all_meet(target, piece)) continue;
            end = piece.end;
            return left;
        }
    }
    return left;
}

Places FirstHit::narrowed(const Beam& beam, const Places& places, double within) {
    along_.take(beam);
    Places left;
    double end = numeric::infinity;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        left.push_back(narrowed(targets_[i], places[i], within, end));
    }
    return left;
}

}  // namespace oracle
