// How bright linear radiance of Rec. 709 primaries looks.
float luminance(vec3 radiance) {
  return dot(radiance, vec3(0.2126, 0.7152, 0.0722));
}
