// Texture coordinates and colours of vertices, laid out as layout.h says. Dispatches on the scene's
// effects.
uniform sampler2D uAttributes;
uniform vec2 uAttributesStep;

#if VERTEX_COLORS
#define ATTRIBUTE_TEXELS (TEXCOORD_TEXELS + COLOR_TEXELS)
#else
#define ATTRIBUTE_TEXELS TEXCOORD_TEXELS
#endif

vec4 fetchAttribute(float triangle, float texel) {
  return texture2D(uAttributes, texelAddress(triangle * ATTRIBUTE_TEXELS + texel, uAttributesStep));
}

// Texture coordinates of both sets, one in xy, the other in zw.
struct VertexTexcoords {
  vec4 t0;
  vec4 t1;
  vec4 t2;
};

VertexTexcoords fetchTexcoords(float triangle) {
  vec4 first = fetchAttribute(triangle, 0.0);
  vec4 last = fetchAttribute(triangle, 1.0);
  vec4 second = fetchAttribute(triangle, 2.0);
  return VertexTexcoords(vec4(first.xy, second.xy), vec4(first.zw, second.zw), last);
}

vec4 interpolateAttribute(vec4 at0, vec4 at1, vec4 at2, vec2 uv) {
  return (1.0 - uv.x - uv.y) * at0 + uv.x * at1 + uv.y * at2;
}

vec4 interpolatedTexcoords(VertexTexcoords texcoords, vec2 uv) {
  return interpolateAttribute(texcoords.t0, texcoords.t1, texcoords.t2, uv);
}

#if VERTEX_COLORS
vec4 interpolatedColor(float triangle, vec2 uv) {
  return interpolateAttribute(fetchAttribute(triangle, TEXCOORD_TEXELS),
                              fetchAttribute(triangle, TEXCOORD_TEXELS + 1.0),
                              fetchAttribute(triangle, TEXCOORD_TEXELS + 2.0), uv);
}
#endif
