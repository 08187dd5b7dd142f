// Lights without triangles: points, spots and directions, as glTF's KHR_lights_punctual defines them,
// chosen by an alias table (Vose 1991). Laid out as layout.h says.
uniform sampler2D uPunctualLights;
uniform vec2 uPunctualLightsStep;
uniform float uPunctualLightCount;

struct PunctualSample {
  vec3 to;          // from the surface to the light, or the unit direction there where that is far away
  float far;        // so many times `to` is what a shadow ray has to pass
  vec3 direction;   // unit
  vec3 irradiance;  // of a surface that faces it
  float probability;
};

vec4 punctualTexel(float light, float part) {
  return texture2D(uPunctualLights,
                   texelAddress(light * PUNCTUAL_LIGHT_TEXELS + part, uPunctualLightsStep));
}

float choosePunctualLight(float random) {
  float place = random * uPunctualLightCount;
  float entry = min(floor(place), uPunctualLightCount - 1.0);
  vec4 alias = punctualTexel(entry, 3.0);
  return place - entry < alias.z ? entry : alias.w;
}

PunctualSample samplePunctualLight(vec3 position, float random) {
  float light = choosePunctualLight(random);
  vec4 place = punctualTexel(light, 0.0);
  vec4 intensity = punctualTexel(light, 1.0);
  vec4 aim = punctualTexel(light, 2.0);
  vec2 cone = punctualTexel(light, 3.0).xy;
  vec3 to = place.xyz - place.w * position;
  float distance2 = max(dot(to, to), 1.0e-30);
  vec3 direction = to * inversesqrt(distance2);
  float reach = distance2 * aim.w;
  float windowed = clamp(1.0 - reach * reach, 0.0, 1.0);
  float spot = clamp(cone.y - cone.x * dot(aim.xyz, direction), 0.0, 1.0);
  float falloff = place.w > 0.5 ? windowed * spot * spot / distance2 : 1.0;
  return PunctualSample(to, place.w > 0.5 ? 1.0 : FAR_AWAY, direction, falloff * intensity.rgb,
                        intensity.w);
}
