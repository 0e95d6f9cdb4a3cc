// SPDX-License-Identifier: Apache-2.0

export const layerVertex = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform sampler2D places;
uniform usampler2D vertices;
uniform vec2 viewport;
uniform float ratio;
uniform float size;
uniform vec4 color;
#ifdef HAS_COLORS
uniform sampler2D colors;
#endif
flat out vec4 tint;
out vec3 seen;

ivec2 cell(int i) { return ivec2(i & 4095, i >> 12); }
vec4 place(int corner) {
  int vertex = int(texelFetch(vertices, cell(corner), 0).r);
  return modelViewMatrix * vec4(texelFetch(places, cell(vertex), 0).xyz, 1.0);
}

void main() {
#if defined(IS_POINTS)
  int element = gl_VertexID;
#elif defined(IS_SEGMENTS)
  int element = gl_VertexID / 6;
#else
  int element = gl_VertexID / 3;
#endif
  tint = color;
#ifdef HAS_COLORS
  tint = texelFetch(colors, cell(element), 0);
#endif
#if defined(IS_SEGMENTS)
  // Two triangles as wide as the line, on the screen.
  int corner = gl_VertexID - 6 * element;
  bool isEnd = corner == 2 || corner == 4 || corner == 5;
  float side = corner == 1 || corner == 2 || corner == 4 ? 1.0 : -1.0;
  if (corner == 3) side = 1.0;
  if (corner == 5) side = -1.0;
  vec4 a = projectionMatrix * place(2 * element);
  vec4 b = projectionMatrix * place(2 * element + 1);
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  vec2 across = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(0.0, 1.0);
  gl_Position = isEnd ? b : a;
  gl_Position.xy += side * across * size * ratio / viewport * gl_Position.w;
  gl_Position.z -= 3e-4 * gl_Position.w; // above the triangles that it bounds
#else
  vec4 at = place(gl_VertexID);
  seen = at.xyz;
  gl_Position = projectionMatrix * at;
#endif
#ifdef IS_POINTS
  gl_PointSize = size * ratio;
  gl_Position.z -= 6e-4 * gl_Position.w;
#endif
}`;

export const layerFragment = /* glsl */ `
precision highp float;
flat in vec4 tint;
in vec3 seen;
out vec4 pixel;
#ifdef IS_POINTS
uniform float size;
uniform float ratio;
#endif
void main() {
  vec3 shade = tint.rgb;
#if defined(IS_POINTS)
  if (size * ratio > 3.0) {
    float r = length(gl_PointCoord - 0.5) * 2.0;
    if (r > 1.0) discard;
    shade *= 1.0 - 0.3 * smoothstep(0.55, 1.0, r);
  }
#elif defined(IS_TRIANGLES)
  vec3 n = cross(dFdx(seen), dFdy(seen));
  float size2 = dot(n, n);
  n = size2 > 0.0 ? n * inversesqrt(size2) : vec3(0.0, 0.0, 1.0);
  float light = abs(dot(n, normalize(vec3(0.25, 0.45, 0.86))));
  shade *= 0.52 + 0.56 * light;
#endif
  pixel = vec4(shade, tint.a);
}`;
