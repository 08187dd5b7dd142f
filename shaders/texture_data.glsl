// Looking up pictures. All of them are in one texture, the atlas, where each has a rectangle; what is
// beyond a rectangle's edges is found by counting texels, so that they may lie side by side. Rows
// are from the top. Depends on texture_wrap.glsl, srgb_decoding.glsl and material_data.glsl.
uniform sampler2D uAtlas;
uniform vec2 uAtlasStep;  // one over its size

struct TextureUse {
  vec4 rectangle;  // see layout.h; width 0: there is no picture
  vec4 matrix;
  vec4 offset;
};

TextureUse fetchTextureUse(float material, float use) {
  float texel = TEXTURE_USES + TEXTURE_USE_TEXELS * use;
  return TextureUse(fetchMaterial(material, texel), fetchMaterial(material, texel + 1.0),
                    fetchMaterial(material, texel + 2.0));
}

// The picture's coordinates, (0, 0) its upper left corner, (1, 1) the lower right one.
vec2 texturePoint(TextureUse use, vec4 texcoords) {
  vec2 at = use.offset.w < 0.5 ? texcoords.xy : texcoords.zw;
  return vec2(dot(use.matrix.xy, at), dot(use.matrix.zw, at)) + use.offset.xy;
}

vec4 fetchAtlas(vec2 corner, float x, float y) {
  return texture2D(uAtlas, (corner + vec2(x, y) + 0.5) * uAtlasStep);
}

// Colours are encoded as sRGB, and mixed only when they are linear.
vec4 decoded(vec4 texel, bool is_color) {
  if (!is_color) return texel;
  return vec4(decodeSrgb(texel.r), decodeSrgb(texel.g), decodeSrgb(texel.b), texel.a);
}

vec4 filteredTexel(TextureUse use, vec2 point, bool is_color) {
  float nearest = floor(use.offset.z / 16.0);
  float wraps = use.offset.z - 16.0 * nearest;
  float wrap_v = floor(wraps / 4.0);
  float wrap_u = wraps - 4.0 * wrap_v;
  vec2 size = use.rectangle.zw;
  vec2 place = point * size - (0.5 - 0.5 * nearest);
  vec2 first = floor(place);
  vec2 share = (place - first) * (1.0 - nearest);
  float left = wrapTexel(first.x, size.x, wrap_u);
  float right = wrapTexel(first.x + 1.0, size.x, wrap_u);
  float upper = wrapTexel(first.y, size.y, wrap_v);
  float lower = wrapTexel(first.y + 1.0, size.y, wrap_v);
  vec2 corner = use.rectangle.xy;
  vec4 above = mix(decoded(fetchAtlas(corner, left, upper), is_color),
                   decoded(fetchAtlas(corner, right, upper), is_color), share.x);
  vec4 below = mix(decoded(fetchAtlas(corner, left, lower), is_color),
                   decoded(fetchAtlas(corner, right, lower), is_color), share.x);
  return mix(above, below, share.y);
}

// White where the material has no picture there. A loop is the only branch that skips work where
// pixels run in lockstep.
vec4 lookUp(float material, float use, vec4 texcoords, bool is_color) {
  vec4 value = vec4(1.0);
  bool wanted = fetchMaterial(material, TEXTURE_USES + TEXTURE_USE_TEXELS * use).z > 0.0;
  for (int i = 0; i < MAX_STEPS; i++) {
    if (!wanted) break;
    TextureUse texture_use = fetchTextureUse(material, use);
    value = filteredTexel(texture_use, texturePoint(texture_use, texcoords), is_color);
    wanted = false;
  }
  return value;
}

// Linear; alpha is not encoded.
vec4 lookUpColor(float material, float use, vec4 texcoords) {
  return lookUp(material, use, texcoords, true);
}

vec4 lookUpNumbers(float material, float use, vec4 texcoords) {
  return lookUp(material, use, texcoords, false);
}
