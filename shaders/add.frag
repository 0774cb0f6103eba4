uniform sampler2D picture;

layout(location = 0) out vec4 sum;

void main() { sum = texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }
