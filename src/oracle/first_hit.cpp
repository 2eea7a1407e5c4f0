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
    Found result = first;
    // Something is there at the second's far end at the latest.
    if (second.verdict == Verdict::hit && second.far < first.far) {
        result = second;
        result.near = first.near;
        if (first.verdict == Verdict::hit) result.verdict = Verdict::hit;
        if (result.far - result.near > enclosure * result.far) result.verdict = first.verdict;
    }
    return result;
}

double FirstHit::coarse(double t) const { return std::max(0.9 * enclosure * t, 8 * rounding_); }
double FirstHit::fine(double t) const { return std::max(finest * t, 2 * rounding_); }

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

bool FirstHit::is_clipped_away(const Target& target, const Piece& piece) {
    const std::optional<std::size_t> clip = target.sheet->clip;
    if (!clip) return false;
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
    return !clip || along_.over({Function::What::solid, *clip}, t).hi <= 0;
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
    const bool sheet = target.of == Found::Of::sheet;
    if (!sheet && piece.at_begin.hi <= 0) {
        piece.end = piece.begin;
        return Fate::hit;
    }
    const Interval t{piece.begin, piece.end};
    const Interval values = along_.over(target.function, t);
    if (is_positive(values) || (sheet && is_negative(values))) return Fate::empty;
    if (values.is_empty() || (sheet && is_clipped_away(target, piece))) return Fate::empty;
    const bool apart = along_.on_each_side(target.function, t, [&](const Interval& side) {
        return is_positive(side) || (sheet && is_negative(side));
    });
    if (apart) return Fate::empty;
    const RayJet jet = along_.jet_over(target.function, t);
    return sheet ? judge_sheet(target, piece, jet) : judge_solid(target, piece, jet);
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
std::optional<Stretch> FirstHit::hit_around(const Target& target, const Piece& piece,
                                            const Stretch& stretch) {
    for (const double part : {0.01, 0.45}) {
        const double reach = part * coarse(piece.end);
        Piece wide{std::max(piece.begin - reach, stretch.begin),
                   std::min(piece.end + reach, stretch.end),
                   {},
                   {}};
        wide.at_begin = along_.over(target.function, wide.begin);
        wide.at_end = along_.over(target.function, wide.end);
        if (wide.length() > coarse(wide.end)) continue;
        const RayJet jet = along_.jet_over(target.function, {wide.begin, wide.end});
        const bool sheet = target.of == Found::Of::sheet;
        const Fate fate = sheet ? judge_sheet(target, wide, jet) : judge_solid(target, wide, jet);
        if (fate == Fate::hit) return Stretch{wide.begin, wide.end};
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

Found FirstHit::search(const Target& target, const Stretch& stretch) {
    const auto value = [&](double t) { return along_.over(target.function, t); };
    open_.assign(1, {stretch.begin, stretch.end, value(stretch.begin), value(stretch.end)});
    for (int effort = 0; !open_.empty(); ++effort) {
        Piece piece = open_.back();
        open_.pop_back();
        const Fate fate = judge(target, piece);
        if (fate == Fate::empty) continue;
        Found found{.of = target.of, .number = target.number};
        found.near = piece.begin;
        found.far = piece.end;
        if (fate == Fate::hit) {
            found.verdict = Verdict::hit;
            found.at_start = target.of == Found::Of::solid && piece.begin == stretch.begin;
            return found;
        }
        if (piece.length() <= fine(piece.end) || effort > most_pieces) {
            if (const auto around = hit_around(target, piece, stretch)) {
                found.verdict = Verdict::hit;
                found.near = around->begin;
                found.far = around->end;
                return found;
            }
            found.verdict = Verdict::undecided;
            found.far = end_of_unsettled(target.function, piece, stretch.end);
            return found;
        }
        split(target.function, piece);
    }
    return {};
}

Found FirstHit::operator()(const Ray& ray, const Stretch& stretch) {
    along_.take(ray);
    const glm::dvec3& o = ray.origin;
    rounding_ = 1e-16 * (std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) + stretch.begin);
    Found found;
    const auto look = [&](const Target& target) {
        const Stretch rest{stretch.begin, std::min(stretch.end, found.far)};
        if (rest.begin < rest.end) found = nearer(found, search(target, rest));
    };
    for (std::size_t i = 0; i < shape_.parts.size(); ++i) {
        const std::size_t solid = shape_.parts[i].solid;
        if (shape_.solids[solid].has_loops) continue;
        look({Found::Of::solid, i, {Function::What::solid, solid}});
    }
    for (std::size_t i = 0; i < shape_.sheets.size(); ++i) {
        const Sheet& sheet = shape_.sheets[i];
        look({Found::Of::sheet, i, {Function::What::expression, sheet.source}, &sheet});
    }
    return found;
}

}  // namespace oracle
