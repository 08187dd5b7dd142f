// sRGB-encoded values to linear ones: IEC 61966-2-1.
float decodeSrgb(float value) {
  return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}
