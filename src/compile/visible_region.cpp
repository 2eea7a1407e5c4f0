// SPDX-License-Identifier: MIT
#include "compile/visible_region.h"

namespace compile {

analysis::Region visible_region(const scene::Bounds& bounds) {
    const scene::Bounds framed = scene::framed_region(bounds);
    return {framed.centre, framed.half, framed.shape == scene::Bounds::Shape::sphere};
}

}  // namespace compile
