import { type ImageArray, parseWrinkleSetDocument } from 'furrow'
import { BLOOD_ABSORPTION, packAreas, reference } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { packChannels } from '../../../packages/furrow/src/core/maps/pack-channels.ts'

/**
 * Spectra, one row per wavelength. Columns: wavelength in nm; molar extinction of oxygenated and of deoxygenated haemoglobin in 1/cm/M
 * (Prahl 1998); power of the illuminant D65; x, y and z of the CIE 1931 observer.
 */
const SPECTRA = [
  [400, 266232, 223296, 82.7549, 0.01431, 0.000396, 0.06785],
  [410, 466840, 303956, 91.486, 0.04351, 0.00121, 0.2074],
  [420, 480360, 407560, 93.4318, 0.13438, 0.004, 0.6456],
  [430, 246072, 528600, 86.6823, 0.2839, 0.0116, 1.3856],
  [440, 102580, 413280, 104.865, 0.34828, 0.023, 1.74706],
  [450, 62816, 103292, 117.008, 0.3362, 0.038, 1.77211],
  [460, 44480, 23388.8, 117.812, 0.2908, 0.06, 1.6692],
  [470, 33209.2, 16156.4, 114.861, 0.19536, 0.09098, 1.28764],
  [480, 26629.2, 14550, 115.923, 0.09564, 0.13902, 0.81295],
  [490, 23684.4, 16684, 108.811, 0.03201, 0.20802, 0.46518],
  [500, 20932.8, 20862, 109.354, 0.0049, 0.323, 0.272],
  [510, 20035.2, 25773.6, 107.802, 0.0093, 0.503, 0.1582],
  [520, 24202.4, 31589.6, 104.79, 0.06327, 0.71, 0.07825],
  [530, 39956.8, 39036.4, 107.689, 0.1655, 0.862, 0.04216],
  [540, 53236, 46592, 104.405, 0.2904, 0.954, 0.0203],
  [550, 43016, 53412, 104.046, 0.43345, 0.99495, 0.00875],
  [560, 32613.2, 53788, 100, 0.5945, 0.995, 0.0039],
  [570, 44496, 45072, 96.3342, 0.7621, 0.952, 0.0021],
  [580, 50104, 37020, 95.788, 0.9163, 0.87, 0.00165],
  [590, 14400.8, 28324.4, 88.6856, 1.0263, 0.757, 0.0011],
  [600, 3200, 14677.2, 90.0062, 1.0622, 0.631, 0.0008],
  [610, 1506, 9443.6, 89.5991, 1.0026, 0.503, 0.00034],
  [620, 942, 6509.6, 87.6987, 0.85445, 0.381, 0.00019],
  [630, 610, 5148.8, 83.2886, 0.6424, 0.265, 0.00005],
  [640, 442, 4345.2, 83.6992, 0.4479, 0.175, 0.00002],
  [650, 368, 3750.12, 80.0268, 0.2835, 0.107, 0],
  [660, 319.6, 3226.56, 80.2146, 0.1649, 0.061, 0],
  [670, 294, 2795.12, 82.2778, 0.0874, 0.032, 0],
  [680, 277.6, 2407.92, 78.2842, 0.04677, 0.017, 0],
  [690, 276, 2051.96, 69.7213, 0.0227, 0.00821, 0],
  [700, 290, 1794.28, 71.6091, 0.01136, 0.0041, 0],
]

/** Matrix from CIE XYZ to linear sRGB (IEC 61966-2-1). */
const XYZ_TO_SRGB = [
  [3.2404542, -1.5371385, -0.4985314],
  [-0.969266, 1.8760108, 0.041556],
  [0.0556434, -0.2040259, 1.0572252],
]

const OXYGENATED = 0.75

/** Concentration of haemoglobin in blood, mol/l: 150 g/l divided by 64500 g/mol. */
const MOLAR = 150 / 64500

/** Returns the diffuse reflectance of a dermis by the dipole model (Jensen et al. 2001). `blood` is the fraction of blood in the dermis. */
function reflectance(nm: number, extinction: number, blood: number): number {
  const scattering = 2e5 * nm ** -1.5 + 2e12 * nm ** -4
  const bloodless = 0.244 + 85.3 * Math.exp(-(nm - 154) / 66.2)
  const absorption = bloodless + blood * Math.LN10 * extinction * MOLAR
  const index = 1.4
  const inner = -1.44 / index ** 2 + 0.71 / index + 0.668 + 0.0636 * index
  const boundary = (1 + inner) / (1 - inner)
  const albedo = scattering / (scattering + absorption)
  const root = Math.sqrt(3 * (1 - albedo))
  return (albedo / 2) * (1 + Math.exp((-4 / 3) * boundary * root)) * Math.exp(-root)
}

/** Returns the colour of skin in linear sRGB. `melanin` is the optical depth of the epidermis at 550 nm. */
function skin(blood: number, melanin: number): number[] {
  return XYZ_TO_SRGB.map((row) =>
    SPECTRA.reduce((sum, [nm, oxygenated, deoxygenated, light, ...xyz]) => {
      const extinction = OXYGENATED * oxygenated + (1 - OXYGENATED) * deoxygenated
      const epidermis = Math.exp(-melanin * (nm / 550) ** -3.33)
      const seen = row.reduce((total, factor, i) => total + factor * xyz[i], 0)
      return sum + seen * light * epidermis * reflectance(nm, extinction, blood)
    }, 0),
  )
}

/** Returns the rate at which the logarithm of each channel decreases with more blood, relative to green. */
function absorption(melanin: number): number[] {
  const [less, more] = [0.009, 0.011].map((blood) => skin(blood, melanin))
  const rates = less.map((value, i) => Math.log(value / more[i]))
  return rates.map((rate) => rate / rates[1])
}

describe('the absorption of blood', () => {
  it('follows from the extinction of haemoglobin, for skin of a medium tone', () => {
    for (const [i, value] of absorption(0.6).entries()) expect(value).toBeCloseTo(BLOOD_ABSORPTION[i], 2)
  })

  it.each([
    ['without melanin', 0],
    ['light', 0.2],
    ['dark', 1.5],
  ])('is nearly the same for skin that is %s', (_, melanin) => {
    for (const [i, value] of absorption(melanin).entries()) {
      expect(Math.abs(value - BLOOD_ABSORPTION[i])).toBeLessThan(0.14)
    }
  })

  it('makes skin of any tone redder with more blood, and paler with less, like the model', () => {
    for (const melanin of [0, 0.6, 1.5]) {
      const rest = skin(0.01, melanin)
      const flushed = skin(0.02, melanin)
      const amount = Math.log(rest[1] / flushed[1])
      for (const [i, value] of reference.bloodColour(rest, amount).entries()) {
        expect(Math.abs(value / flushed[i] - 1)).toBeLessThan(0.05)
      }
      const [r, g] = reference.bloodColour(rest, -0.2)
      expect(g).toBeGreaterThan(rest[1])
      expect(r / g).toBeLessThan(rest[0] / rest[1])
    }
  })
})

describe('a blood map', () => {
  it('is exactly neutral at 128, and within a hundredth of a step around 128', () => {
    const colour = [0.1234567, 0.3, 0.9]
    for (const byte of [128, 127.991, 128.009]) {
      expect(reference.bloodOf(byte / 255)).toBe(0)
      expect(reference.bloodColour(colour, reference.bloodOf(byte / 255))).toEqual(colour)
    }
    expect(reference.bloodOf(129 / 255)).toBeCloseTo(1 / 127, 10)
  })

  it('reaches from -1 to 1', () => {
    expect([0, 1, 255].map((byte) => reference.bloodOf(byte / 255))).toEqual([-1, -1, 1])
  })

  it('is packed next to the occlusion, with neutral values for a map that a layer lacks', () => {
    const flat = (value: number) => ({ width: 1, height: 2, data: new Uint8Array(2).fill(value) })
    const packed = packChannels(
      [
        [flat(10), flat(20)],
        [undefined, flat(30)],
        [flat(40), undefined],
      ],
      [255, 128],
    )
    expect(packed).toEqual({
      width: 1,
      height: 2,
      depth: 3,
      channels: 2,
      data: Uint8Array.of(10, 20, 10, 20, 255, 30, 255, 30, 40, 128, 40, 128),
    } satisfies ImageArray)
    expect(reference.sampleArray(packed, 0.5, 0.5, 1, 1)).toBeCloseTo(30 / 255, 12)
    expect(packAreas([flat(40)], 2).channels).toBe(1)
  })
})

describe('wrinkles.json', () => {
  const document = (layer: object) => ({
    layers: [{ name: 'skin', ...layer }],
    areas: [{ name: 'nose' }],
  })

  it.each([
    [{ blood: 'b.png' }, 'layers[0].bloodAmplitude must be a number'],
    [{ blood: 'b.png', bloodAmplitude: -0.1 }, 'layers[0].bloodAmplitude is out of range'],
    [{ blood: 'b.png', bloodAmplitude: 2.1 }, 'layers[0].bloodAmplitude is out of range'],
    [{ blood: 7, bloodAmplitude: 1 }, 'layers[0].blood must be text'],
  ])('refuses %j', (layer, message) => {
    expect(() => parseWrinkleSetDocument(document(layer))).toThrow(message)
  })
})
