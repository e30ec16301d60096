/**
 * Elementary functions that return exactly the same numbers in every JavaScript engine, so that automatic wrinkles are reproducible. The
 * ECMAScript standard specifies the rounding only of `+ - * /` and `Math.sqrt`. Functions such as `Math.sin` return different numbers in
 * different engines. The polynomials are from fdlibm (Sun Microsystems, 1993). Errors are below one unit in the last place,
 * except for `power`.
 */

const PI_LOW = 1.2246467991473532e-16

const LN2_HIGH = 0.6931471803691238
const LN2_LOW = 1.9082149292705877e-10

const double = new Float64Array(1)
const words = new Int32Array(double.buffer)
/** Index of the 32-bit word that contains the exponent of a float64. It is 1 on little-endian machines. */
const HIGH = new Int32Array(new Float64Array([1]).buffer)[1] === 0 ? 0 : 1

export function exp(x: number): number {
  if (!(x > -745.2)) return Number.isNaN(x) ? x : 0
  if (x > 709.8) return Number.POSITIVE_INFINITY
  const k = Math.round(x / Math.LN2)
  const high = x - k * LN2_HIGH
  const low = k * LN2_LOW
  const r = high - low
  const t = r * r
  // No loop over the coefficients, for speed: every texel of a bake calls this function.
  const c =
    r -
    t *
      (0.16666666666666602 +
        t *
          (-0.0027777777777015593 +
            t * (0.00006613756321437934 + t * (-0.0000016533902205465252 + t * 4.1381367970572385e-8))))
  const y = 1 - (low - (r * c) / (2 - c) - high)
  // The result is scaled by 2^k in two steps, because 2^k alone may overflow or be subnormal.
  const half = k >> 1
  return y * powerOfTwo(half) * powerOfTwo(k - half)
}

function powerOfTwo(k: number): number {
  words[1 - HIGH] = 0
  words[HIGH] = (k + 1023) << 20
  return double[0]
}

const LOG = [
  0.6666666666666735, 0.3999999999940942, 0.2857142874366239, 0.22222198432149784, 0.1818357216161805,
  0.15313837699209373, 0.14798198605116586,
]

/** Computes the natural logarithm. */
export function log(x: number): number {
  if (!(x > 0 && x < Number.POSITIVE_INFINITY))
    return x === 0 ? Number.NEGATIVE_INFINITY : x > 0 ? x : Number.NaN
  if (x < 2.3e-308) return log(x * 2 ** 54) - 54 * Math.LN2
  double[0] = x
  const mantissa = words[HIGH] & 0xfffff
  // Scale the mantissa to a number between `sqrt(1 / 2)` and `sqrt(2)`.
  const above = (mantissa + 0x95f64) & 0x100000
  const k = (words[HIGH] >> 20) - 1023 + (above >> 20)
  words[HIGH] = mantissa | (above ^ 0x3ff00000)
  const f = double[0] - 1
  const s = f / (2 + f)
  const z = s * s
  const half = 0.5 * f * f
  return s * (half + z * polynomial(z, LOG)) + k * LN2_LOW - half + f + k * LN2_HIGH
}

/** Computes `base ** exponent` for a base of at least 0 and an exponent above 0. */
export function power(base: number, exponent: number): number {
  return base === 0 ? 0 : exp(exponent * log(base))
}

const SIN = [
  -0.16666666666666632, 0.00833333333332249, -0.0001984126982985795, 0.0000027557313707070068,
  -2.5050760253406863e-8, 1.58969099521155e-10,
]
const COS = [
  0.0416666666666666, -0.001388888888887411, 0.00002480158728947673, -2.7557314351390663e-7,
  2.087572321298175e-9, -1.1359647557788195e-11,
]
/** `PI / 2` as a sum of three numbers. The first two have few significant bits, so that their products with small integers are exact. */
const HALF_PI = [1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21]

/** Computes the sine of `x` radians. The absolute value of `x` must be at most 100,000. */
export function sin(x: number): number {
  return sinOfQuarter(x, 0)
}

/** Computes the cosine of `x` radians. The absolute value of `x` must be at most 100,000. */
export function cos(x: number): number {
  return sinOfQuarter(x, 1)
}

/** Computes the sine of `x + turns * PI / 2`. */
function sinOfQuarter(x: number, turns: number): number {
  const n = Math.round(x / (Math.PI / 2))
  const first = x - n * HALF_PI[0]
  const rest = first - n * HALF_PI[1]
  const low = n * HALF_PI[2] - (first - rest - n * HALF_PI[1])
  const r = rest - low
  const tail = rest - r - low
  const z = r * r
  const quarter = (n + turns) & 3
  let y: number
  if (quarter & 1) {
    const half = 0.5 * z
    const w = 1 - half
    y = w + (1 - w - half + (z * z * polynomial(z, COS) - r * tail))
  } else {
    y = r + (z * r * polynomial(z, SIN) + tail * (1 - 0.5 * z))
  }
  return quarter & 2 ? -y : y
}

const ATAN = [
  0.3333333333333293, -0.19999999999876483, 0.14285714272503466, -0.11111110405462356, 0.09090887133436507,
  -0.0769187620504483, 0.06661073137387531, -0.058335701337905735, 0.049768779946159324,
  -0.036531572744216916, 0.016285820115365782,
]
/** Arc tangents of 0.5, 1, 1.5 and infinity. `ATAN_REST` contains their rounding errors. */
const ATAN_AT = [0.4636476090008061, Math.PI / 4, 0.982793723247329, Math.PI / 2]
const ATAN_REST = [2.2698777452961687e-17, PI_LOW / 4, 1.3903311031230998e-17, PI_LOW / 2]

/** Computes the arc tangent of a nonnegative number. */
function atan(x: number): number {
  if (x < 0.4375) return x - x * (x * x * polynomial(x * x, ATAN))
  const i = x < 0.6875 ? 0 : x < 1.1875 ? 1 : x < 2.4375 ? 2 : 3
  const t =
    i === 0
      ? (2 * x - 1) / (2 + x)
      : i === 1
        ? (x - 1) / (x + 1)
        : i === 2
          ? (x - 1.5) / (1 + 1.5 * x)
          : -1 / x
  return ATAN_AT[i] - (t * (t * t * polynomial(t * t, ATAN)) - ATAN_REST[i] - t)
}

/** Computes the angle between the x axis and the vector (x, y), in radians. Returns 0 for the zero vector. */
export function atan2(y: number, x: number): number {
  if (y === 0) return x < 0 ? Math.PI : 0
  const angle = x === 0 ? Math.PI / 2 : atan(Math.abs(y / x))
  const upper = x < 0 ? Math.PI - (angle - PI_LOW) : angle
  return y < 0 ? -upper : upper
}

function polynomial(x: number, coefficients: readonly number[]): number {
  let sum = 0
  for (let i = coefficients.length - 1; i >= 0; i--) sum = sum * x + coefficients[i]
  return sum
}
