// SPDX-License-Identifier: MIT
// Operations that make one solid of the values of solids. Where all operands are formulas they are
// composed into one formula, which stays a distance where that is still 1-Lipschitz; otherwise the
// result is a Blend. Numbers are expressions that do not depend on the point. All of them work on
// values: exact as far as these are exact distances near the surface.
#pragma once

#include "field/field.h"

namespace field {

/// The polynomial smooth minimum over a width k: min(a, b) - h^2 k / 4, h = max(1 - |a - b| / k,
/// 0). A slider may bring the width down to 0, which gives the plain union, here and below.
FieldId smooth_union(Field& field, FieldId a, FieldId b, graph::NodeId k);

/// The same of many: of the first two, of that and the third, and so on.
FieldId smooth_union(Field& field, const std::vector<FieldId>& operands, graph::NodeId k);

/// -log(exp(-a / w) + exp(-b / w)) w, with the sharpness k = 1 / w (K 23).
FieldId smooth_union_exp(Field& field, FieldId a, FieldId b, graph::NodeId k);

/// (a^-p + b^-p)^(-1/p) where both are positive, else the minimum (K 22): it keeps the surface of
/// the plain union and rounds the surfaces at a distance around it. p > 0.
FieldId smooth_union_power(Field& field, FieldId a, FieldId b, graph::NodeId p);

/// The polynomial smooth maximum of a and b, and of a and -b.
FieldId smooth_intersection(Field& field, FieldId a, FieldId b, graph::NodeId k);
FieldId smooth_difference(Field& field, FieldId a, FieldId b, graph::NodeId k);

/// All within the distance d of the solid; smaller for d < 0.
FieldId offset(Field& field, FieldId a, graph::NodeId d);

/// All within half of the thickness of the surface.
FieldId shell(Field& field, FieldId a, graph::NodeId thickness);

/// The value plus an expression in the point.
FieldId displace(Field& field, FieldId a, graph::NodeId by);

/// (1 - t) a + t b, with t kept in [0, 1].
FieldId morph(Field& field, FieldId a, FieldId b, graph::NodeId t);

/// a where less < than, else b: solids or sheets.
FieldId choose(Field& field, graph::NodeId less, graph::NodeId than, FieldId a, FieldId b);

}  // namespace field
