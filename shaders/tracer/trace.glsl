// What a ray has come to.
const int zs_miss = 0, zs_hit = 1, zs_unresolved = 2;

struct Trace {
    int status;
    real t;       // where: the depth of a hit, the end of a miss, the best guess otherwise
    int object;   // of a hit
    bool turned;  // whether the object's f grows towards the inside there
    bool cap;     // the hit is where a solid is cut by the bounds, or the eye is inside
    bool exact;   // f was followed to the root itself, not only to where |f| is least
    int steps;
};
