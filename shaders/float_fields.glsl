// A float as three integers, without bit operations.
//
// A channel of an RGBA32F target carries a sign, an exponent and a mantissa; all of them survive
// writing and reading as long as the float is a normal one. Here a channel is
//
//   (2^23 + mantissa) * 2^exponent,  mantissa in [0, 2^23),  exponent in [-64, 64)
//
// with a sign in front: 23 + 7 + 1 bits. log2 and exp2 are not exact on every device (floor(log2(x))
// is wrong just below powers of two), so exponents are built and found by multiplying with constant
// powers of two, which is exact.

const float MANTISSA_RANGE = 8388608.0;

// `power` where the bit is 1, and 1 where it is 0. Chosen, not calculated: of mix(), and of a sum of
// products too, a driver may make 1 + bit * (power - 1), in which small powers are lost.
float powerIf(float bit, float power) {
  return bit > 0.5 ? power : 1.0;
}

vec4 powerWhere(vec4 bit, float power) {
  return vec4(powerIf(bit.x, power), powerIf(bit.y, power), powerIf(bit.z, power),
              powerIf(bit.w, power));
}

// 2^exponent for whole exponents in [-64, 64).
vec4 powerOfTwo(vec4 exponent) {
  vec4 rest = exponent + 64.0;
  vec4 power = vec4(5.421010862427522e-20);
  vec4 bit = step(64.0, rest);
  rest -= 64.0 * bit;
  power *= powerWhere(bit, 18446744073709551616.0);
  bit = step(32.0, rest);
  rest -= 32.0 * bit;
  power *= powerWhere(bit, 4294967296.0);
  bit = step(16.0, rest);
  rest -= 16.0 * bit;
  power *= powerWhere(bit, 65536.0);
  bit = step(8.0, rest);
  rest -= 8.0 * bit;
  power *= powerWhere(bit, 256.0);
  bit = step(4.0, rest);
  rest -= 4.0 * bit;
  power *= powerWhere(bit, 16.0);
  bit = step(2.0, rest);
  rest -= 2.0 * bit;
  power *= powerWhere(bit, 4.0);
  bit = step(1.0, rest);
  return power * powerWhere(bit, 2.0);
}

struct FloatFields {
  vec4 mantissa;  // whole, in [0, 2^23)
  vec4 exponent;  // whole, in [-64, 64)
};

vec4 joinFields(FloatFields fields) {
  return (MANTISSA_RANGE + fields.mantissa) * powerOfTwo(fields.exponent);
}

// The inverse of joinFields, for values in [2^-41, 2^87).
FloatFields splitFields(vec4 value) {
  vec4 exponent = vec4(-64.0);
  vec4 rest = value;
  vec4 bit = step(8388608.0, rest);
  exponent += 64.0 * bit;
  rest *= powerWhere(bit, 5.421010862427522e-20);
  bit = step(0.001953125, rest);
  exponent += 32.0 * bit;
  rest *= powerWhere(bit, 2.3283064365386963e-10);
  bit = step(2.9802322387695312e-8, rest);
  exponent += 16.0 * bit;
  rest *= powerWhere(bit, 1.52587890625e-5);
  bit = step(1.1641532182693481e-10, rest);
  exponent += 8.0 * bit;
  rest *= powerWhere(bit, 0.00390625);
  bit = step(7.275957614183426e-12, rest);
  exponent += 4.0 * bit;
  rest *= powerWhere(bit, 0.0625);
  bit = step(1.8189894035458565e-12, rest);
  exponent += 2.0 * bit;
  rest *= powerWhere(bit, 0.25);
  bit = step(9.094947017729282e-13, rest);
  exponent += bit;
  rest *= powerWhere(bit, 0.5);
  return FloatFields(rest * 18446744073709551616.0 - MANTISSA_RANGE, exponent);
}
