layout(location = 0) in vec3 position;

uniform mat4 clip_from_position;

invariant gl_Position;

void main() { gl_Position = clip_from_position * vec4(position, 1.0); }
