// SPDX-License-Identifier: Apache-2.0

export const globeVertex = /* glsl */ `
out vec3 direction;
out vec3 toCamera;
void main() {
  direction = position;
  vec4 world = modelMatrix * vec4(position, 1.0);
  toCamera = cameraPosition - world.xyz;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

// Colours of the four nearest pixels of the map are blended: what looks smooth is the outline, the faces are flat.
export const globeFragment = /* glsl */ `
precision highp float;
precision highp int;
precision highp usampler2D;
in vec3 direction;
in vec3 toCamera;
out vec4 color;
uniform usampler2D ids;
uniform sampler2D colors;
uniform int faceCount;
uniform int hovered;
uniform int picked;
uniform vec3 accent;
uniform vec3 rim;
uniform float opacity;
uniform float areFacesShown;

vec3 shade(ivec2 at) {
  ivec2 size = textureSize(ids, 0);
  uint id = texelFetch(ids, ivec2((at.x + size.x) % size.x, clamp(at.y, 0, size.y - 1)), 0).r;
  int face = int(min(id, uint(faceCount)));
  int entry = areFacesShown > 0.5 ? face : faceCount;
  vec3 own = texelFetch(colors, ivec2(entry % ${1024}, entry / ${1024}), 0).rgb;
  return face == faceCount ? own : mix(own, accent, face == picked ? 0.62 : face == hovered ? 0.34 : 0.0);
}

void main() {
  vec3 d = normalize(direction);
  vec2 at = vec2((atan(d.y, d.x) / 3.14159265358979 + 1.0) / 2.0, 0.5 - asin(clamp(d.z, -1.0, 1.0)) / 3.14159265358979);
  vec2 pixel = at * vec2(textureSize(ids, 0)) - 0.5;
  ivec2 corner = ivec2(floor(pixel));
  vec2 part = smoothstep(0.2, 0.8, pixel - floor(pixel));
  vec3 flat_ = mix(mix(shade(corner), shade(corner + ivec2(1, 0)), part.x),
                   mix(shade(corner + ivec2(0, 1)), shade(corner + ivec2(1, 1)), part.x), part.y);
  float facing = abs(dot(d, normalize(toCamera)));
  color = vec4(mix(rim, flat_, 0.62 + 0.38 * smoothstep(0.0, 0.75, facing)), opacity);
}`;
