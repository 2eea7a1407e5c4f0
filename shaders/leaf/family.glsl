// The members of families: rows of numbers, heads of lists, and lists of rows (shader/family.h).
layout(binding = 6) uniform samplerBuffer family_numbers;

// Where the rows of those members begin and end that can matter in the cell of a grid that p is in;
// outside of the grid all of them.
ivec2 family_list(real3 p, real3 origin, real inverse, real3 count, real heads) {
    real3 cell = floor((p - origin) * inverse);
    bool inside = cell == clamp(cell, real3(0.0), count - 1.0);
    real at = inside ? 1.0 + cell.x + count.x * (cell.y + count.y * cell.z) : 0.0;
    return ivec2(texelFetch(family_numbers, int(heads + at)).xy);
}
