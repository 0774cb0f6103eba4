#pragma once

#include "mesh/triangle_mesh.h"
#include "render/view.h"
#include "scene/description.h"

namespace drape::app {

// The surface of a collider in its own frame, fine enough to be drawn; a plane becomes a square.
TriangleMesh collider_mesh(const ColliderShape& shape);

// What is drawn of a collider, in its own frame.
render::Surface collider_surface(const ColliderDescription& collider);

render::Surface posed(const render::Surface& surface, const RigidPose& pose);

}  // namespace drape::app
