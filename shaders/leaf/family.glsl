// The members of families: rows of numbers, trees of cells, and lists of rows (shader/family_table.h).
layout(binding = 6) uniform samplerBuffer family_numbers;

// The cell of a tree that a point is in (analysis/active_cells.h).
struct FamilyCell {
    int head;      // its first texel
    real4 first;   // that texel: where lists begin and end, or of a far cell its slope and its value
    real3 offset;  // from its middle
};

// In the node whose cells' heads begin there and which is as large as `size`; `local` are parts of it.
FamilyCell family_cell_of(int node, real3 local, real size, int texels) {
    local *= 4.0;
    real3 cell = min(floor(local), 3.0);
    int head = node + texels * int(cell.x + 4.0 * (cell.y + 4.0 * cell.z));
    return FamilyCell(head, real4(texelFetch(family_numbers, head)), 0.25 * size * (local - cell - 0.5));
}

// Outside of the tree all members. Nodes are at most three deep.
FamilyCell family_cell(real3 p, real3 origin, real inverse, real3 count, real heads, int texels) {
    real3 local = (p - origin) * inverse;
    real3 cube = floor(local);
    if (cube != clamp(cube, real3(0.0), count - 1.0)) {
        return FamilyCell(int(heads), real4(texelFetch(family_numbers, int(heads))), real3(0.0));
    }
    int node = int(heads) + texels * (1 + 64 * int(cube.x + count.x * (cube.y + count.y * cube.z)));
    real size = 1.0 / inverse;
    FamilyCell cell = family_cell_of(node, local - cube, size, texels);
    for (int level = 1; level < 3; ++level) {
        if (cell.first.w != 0.0 || cell.first.x >= 0.0) break;
        size *= 0.25;
        cell = family_cell_of(int(-cell.first.x), cell.offset / size + 0.5, size, texels);
    }
    return cell;
}

// The answer of a far cell, by its value and slope: free of surfaces is the ball around its middle.
Answer family_far(FamilyCell cell, int object) {
    real value = cell.first.w, side = sign(value);
    real free = abs(value) - length(cell.offset);
    real distance = max(side * (value + dot(cell.first.xyz, cell.offset)), free);
    return Answer(side * free * frame.up.w, side * distance, side * distance, 0.0, false, false, object);
}
