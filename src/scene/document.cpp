// SPDX-License-Identifier: MIT
// The document's camera.
#include "scene/document.h"

namespace scene {

Camera camera_of(const Document& document, double aspect) {
    return document.camera ? *document.camera : frame_all(document.bounds, aspect);
}

}  // namespace scene
