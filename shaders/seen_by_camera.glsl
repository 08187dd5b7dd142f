// Where what the camera sees differs from what other rays meet.
uniform float uFromCamera;  // 1 where the record is of the camera's ray, else 0

bool isSeen() {
  return uFromCamera > 0.5;
}
