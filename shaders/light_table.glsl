// Triangles that emit, chosen in proportion to their power: an alias table (Vose 1991), so that a
// choice costs the same among two lights and ten thousand. Laid out as layout.h says.
uniform sampler2D uLights;
uniform vec2 uLightsStep;
uniform float uLightCount;

// The index of a triangle.
float chooseLight(float random) {
  float place = random * uLightCount;
  float entry = min(floor(place), uLightCount - 1.0);
  vec4 light = texture2D(uLights, texelAddress(entry, uLightsStep));
  return place - entry < light.x ? light.y : light.z;
}
