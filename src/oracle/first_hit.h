// SPDX-License-Identifier: MIT
// The first point of a shape along a ray, proven.
#pragma once

#include <optional>
#include <vector>

#include "oracle/along_ray.h"
#include "oracle/reference.h"

namespace oracle {

/// What was found of a shape: nothing before `near`.
struct Found {
    enum class Of { solid, sheet };
    Verdict verdict = Verdict::miss;
    double near = numeric::infinity;
    double far = numeric::infinity;
    Of of = Of::solid;
    std::size_t number = 0;  ///< of the part or of the sheet
    bool at_start = false;   ///< the stretch begins in a solid

    double middle() const { return near + 0.5 * (far - near); }
};

/// The nearer of two findings; where both may be the first, what encloses either.
Found nearer(const Found& a, const Found& b);

/// Finds first hits by bisection with interval arithmetic. Not for several threads.
class FirstHit {
public:
    explicit FirstHit(const Shape& shape) : shape_(shape), along_(shape) {}

    /// Of all parts without loops, within the stretch. A hit is enclosed to 1e-9 of its distance.
    /// Undecided is where f comes so close to 0 that its sign cannot be told, and where the effort
    /// is spent.
    Found operator()(const Ray& ray, const Stretch& stretch);

private:
    /// A part of the shape: the zeros of the function, or where it is not above 0.
    struct Target {
        Found::Of of = Found::Of::solid;
        std::size_t number = 0;
        Function function;
        const Sheet* sheet = nullptr;
    };
    /// What is known of a piece.
    enum class Fate { empty, hit, unknown };

    Found search(const Target& target, const Stretch& stretch);
    Fate judge(const Target& target, Piece& piece);
    Fate judge_solid(const Target& target, Piece& piece, const RayJet& jet);
    Fate judge_sheet(const Target& target, Piece& piece, const RayJet& jet);
    bool isolate_root(const Function& function, Piece& piece);
    void split(const Function& function, const Piece& piece);
    bool is_clipped_away(const Target& target, const Piece& piece);
    bool is_drawn_throughout(const Target& target, const Piece& piece);
    std::optional<Stretch> hit_around(const Target& target, const Piece& piece,
                                      const Stretch& stretch);
    double end_of_unsettled(const Function& function, const Piece& piece, double end);
    double coarse(double t) const;
    double fine(double t) const;

    const Shape& shape_;
    AlongRay along_;
    std::vector<Piece> open_;  ///< to be looked at, the nearest last
    double rounding_ = 0;      ///< of the coordinates of the ray's points
};

}  // namespace oracle
