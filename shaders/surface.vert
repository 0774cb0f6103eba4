layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

out vec3 world_position;
out vec3 world_normal;
out vec2 surface_uv;

// Equal to the bit in depth.vert: surfaces are drawn over their own depth.
invariant gl_Position;

void main() {
  world_position = position;
  world_normal = normal;
  surface_uv = uv;
  gl_Position = clip_from_world * vec4(position, 1.0);
}
