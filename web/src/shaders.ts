// SPDX-License-Identifier: Apache-2.0
// Surfaces are drawn without indices, so that gl_VertexID names the triangle and its corner; what differs per face lies
// in textures. Normals come from screen-space derivatives. Memory per triangle on the GPU: 36 bytes and its face number.

/** Width in texels of the textures that hold one entry per triangle, face or piece. */
export const tableWidth = 4096;

const tables = /* glsl */ `
ivec2 entry(int index) { return ivec2(index & ${tableWidth - 1}, index >> ${Math.log2(tableWidth)}); }
`;

export const surfaceVertex = /* glsl */ `
precision highp usampler2D;
uniform usampler2D triangleFaces;
uniform usampler2D faceTable;      // packed colour, origin, piece
uniform sampler2D pieceOffsets;
uniform float explode;
uniform int highlightFace;
uniform int hoverFace;
uniform int highlightOrigin;
uniform int firstTriangle;
out vec4 vColor;
out vec3 vMark;                    // picked, hovered, dimmed
out vec3 vCorner;
out vec3 vView;
out vec3 vPlace;
out vec4 vId;
${tables}
void main() {
  int triangle = gl_VertexID / 3;
  int corner = gl_VertexID - 3 * triangle;
  int face = int(texelFetch(triangleFaces, entry(triangle), 0).r);
  uvec4 info = texelFetch(faceTable, entry(face), 0);
  vec3 place = position + explode * texelFetch(pieceOffsets, entry(int(info.b)), 0).xyz;
  vColor = vec4(info.r & 255u, info.r >> 8 & 255u, info.r >> 16 & 255u, info.r >> 24) / 255.0;
  vMark = vec3(face == highlightFace, face == hoverFace, highlightOrigin >= 0 && int(info.g) != highlightOrigin);
  vCorner = vec3(corner == 0, corner == 1, corner == 2);
  uint id = uint(firstTriangle) + uint(triangle) + 1u;
  vId = vec4(id & 255u, id >> 8 & 255u, id >> 16 & 255u, id >> 24) / 255.0;
  vec4 view = viewMatrix * vec4(place, 1.0);
  vPlace = place;
  vView = view.xyz;
  gl_Position = projectionMatrix * view;
}
`;

export const clipping = /* glsl */ `
uniform vec4 cut;                  // keeps n . p <= d; n is zero when there is no cut
bool isCutAway(vec3 place) { return dot(cut.xyz, place) > cut.w; }
/** By a pixel more for what is seen from behind: no inside shines through along the rim of the cut. */
bool isCutAway(vec3 place, bool isFront) {
  float beyond = dot(cut.xyz, place) - cut.w;
  return beyond > (isFront ? 0.0 : -fwidth(beyond));
}
`;

const color = /* glsl */ `
vec3 toLinear(vec3 c) { return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, vec3(lessThanEqual(c, vec3(0.04045)))); }
/** Half a step of the screen's colours up or down, so that slow gradients show no bands. */
float dither(vec2 p) { return (fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }
vec3 toScreen(vec3 c) { return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, c * 12.92, vec3(lessThanEqual(c, vec3(0.0031308)))); }
`;

export const surfaceFragment = /* glsl */ `
in vec4 vColor;
in vec3 vMark;
in vec3 vCorner;
in vec3 vView;
in vec3 vPlace;
uniform float showTriangles;
uniform vec3 accent;
uniform float isPerspective;
uniform float pass;                // 0: opaque faces, 1: the others
out vec4 outColor;
${clipping}
${color}
const vec3 key = vec3(-0.473, 0.520, 0.710);
float light(vec3 n, vec3 toEye) {
  vec3 fill = normalize(vec3(0.85, 0.1, 0.45));
  vec3 up = normalize((viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz);
  return 0.34 + 0.1 * dot(n, up) + 0.62 * max(dot(n, key), 0.0) + 0.16 * max(dot(n, fill), 0.0) + 0.12 * max(dot(n, toEye), 0.0);
}
void main() {
  if (isCutAway(vPlace, gl_FrontFacing)) discard;
  if ((vColor.a > 0.998) == (pass > 0.5)) discard;
  vec3 n = normalize(cross(dFdx(vView), dFdy(vView)));
  vec3 toEye = isPerspective > 0.5 ? normalize(-vView) : vec3(0.0, 0.0, 1.0);
  vec3 base = toLinear(vColor.rgb);
  base = mix(base, vec3(dot(base, vec3(0.3, 0.5, 0.2))) * 0.6 + 0.12, 0.82 * vMark.z);
  if (!gl_FrontFacing && pass < 0.5) base = mix(base, vec3(0.36, 0.12, 0.1), 0.7);
  float brightness = light(n, toEye);
  vec3 shaded = base * brightness + 0.05 * pow(max(dot(n, normalize(key + toEye)), 0.0), 24.0);
  shaded = mix(shaded, accent * (0.6 + 0.4 * brightness), max(0.85 * vMark.x, 0.3 * vMark.y));
  if (showTriangles > 0.5) {
    vec3 width = fwidth(vCorner);
    vec3 inside = smoothstep(width * 0.4, width * 1.3, vCorner);
    shaded = mix(shaded * 0.42, shaded, min(inside.x, min(inside.y, inside.z)));
  }
  float alpha = pass > 0.5 ? max(vColor.a, 0.8 * vMark.x) : 1.0;
  outColor = vec4((toScreen(shaded) + dither(gl_FragCoord.xy)) * alpha, alpha);
}
`;

/** Which triangle is seen, plus one; the highest bit is set where it is seen from behind. */
export const pickFragment = /* glsl */ `
in vec3 vPlace;
in vec4 vId;
out vec4 outColor;
${clipping}
void main() {
  if (isCutAway(vPlace)) discard;
  outColor = vId;
  if (!gl_FrontFacing) outColor.a += 128.0 / 255.0;
}
`;

/** Writes nothing but the stencil: what is left of the solid where the cut hides its boundary. */
export const stencilFragment = /* glsl */ `
in vec3 vPlace;
out vec4 outColor;
${clipping}
void main() {
  if (isCutAway(vPlace)) discard;
  outColor = vec4(0.0);
}
`;

export const capVertex = /* glsl */ `
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }
`;

export const capFragment = /* glsl */ `
uniform vec3 capColor;
uniform float hatch;               // distance of the hatching lines in pixels
uniform float slant;
out vec4 outColor;
void main() {
  float along = (gl_FragCoord.x * slant + gl_FragCoord.y) / hatch;
  float line = abs(fract(along) - 0.5) * hatch;
  float ink = 1.0 - smoothstep(0.35, 1.15, line * 0.7071);
  outColor = vec4(mix(capColor, capColor * 0.62, ink), 1.0);
}
`;

/** Segments as screen-aligned quads of constant width; cut at the near plane first, so that none turns inside out. */
export const lineVertex = /* glsl */ `
in vec3 start;
in vec3 end;
in float piece;
in float opacity;
uniform sampler2D pieceOffsets;
uniform float explode;
uniform vec2 viewport;
uniform float width;
uniform float near;
uniform float isPerspective;
uniform float fade;
uniform float fadeStart;
out vec3 vPlace;
out float vOpacity;
${tables}
void main() {
  vec3 offset = explode * texelFetch(pieceOffsets, entry(int(piece)), 0).xyz;
  vec4 a = viewMatrix * vec4(start + offset, 1.0);
  vec4 b = viewMatrix * vec4(end + offset, 1.0);
  float tA = 0.0, tB = 1.0;
  if (isPerspective > 0.5) {
    if (a.z > -near && b.z < -near) tA = (-near - a.z) / (b.z - a.z);
    if (b.z > -near && a.z < -near) tB = (-near - a.z) / (b.z - a.z);
  }
  vec4 clipA = projectionMatrix * mix(a, b, tA);
  vec4 clipB = projectionMatrix * mix(a, b, tB);
  vec2 along = (clipB.xy / clipB.w - clipA.xy / clipA.w) * viewport * 0.5;
  float pixels = length(along);
  vec2 across = pixels > 0.0 ? vec2(-along.y, along.x) / pixels : vec2(0.0, 1.0);
  vec4 clip = position.x < 0.5 ? clipA : clipB;
  clip.xy += across * position.y * width / viewport * clip.w;
  clip.z -= 4e-5 * clip.w;
  vPlace = mix(start, end, mix(tA, tB, position.x)) + offset;
  vOpacity = opacity * mix(1.0, smoothstep(-2.0, 14.0, pixels), fade);
  if (position.x < 0.5) vOpacity *= 1.0 - fadeStart;
  gl_Position = clip;
}
`;

export const lineFragment = /* glsl */ `
in vec3 vPlace;
in float vOpacity;
uniform vec4 lineColor;
uniform float isCut;
out vec4 outColor;
${clipping}
void main() {
  if (isCut > 0.5 && isCutAway(vPlace)) discard;
  float opacity = lineColor.a * vOpacity;
  outColor = vec4(lineColor.rgb * opacity, opacity);
}
`;
