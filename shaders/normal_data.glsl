// Shading normals, laid out as layout.h says. Depends on octahedral.glsl.
uniform sampler2D uNormals;
uniform vec2 uNormalsStep;

// The interpolated normal, or the geometric one where the triangle is flat.
vec3 fetchNormal(float triangle, vec2 uv, vec3 geometric) {
  float texel = triangle * NORMAL_TEXELS;
  vec4 t0 = texture2D(uNormals, texelAddress(texel, uNormalsStep));
  vec4 t1 = texture2D(uNormals, texelAddress(texel + 1.0, uNormalsStep));
  if (t1.z < 0.5) return geometric;
  vec3 normal = interpolate(decodeOctahedral(t0.xy), decodeOctahedral(t0.zw),
                            decodeOctahedral(t1.xy), uv);
  float size = length(normal);
  return size > 1.0e-6 ? normal / size : geometric;
}
