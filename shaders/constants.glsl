// Numbers that several files share.
const float PI = 3.14159265358979;

// Further away than anything in a scene.
const float FAR_AWAY = 1.0e30;
