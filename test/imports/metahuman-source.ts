import { type Pose, toLinear } from './evaluate.ts'
import { normalised } from './expression-source.ts'
import { type Bump, centreOf, creased, type Field, rgbPng, stored } from './paint.ts'
import { tga } from './tga.ts'

/**
 * Synthetic files in the layout of MetaHuman's DCC export: maps in `Maps`, masks in `Masks`. `shade` uses the formula of the head shader in
 * MetaHuman DNA Calibration. For each set of maps, the shader multiplies the difference from the resting maps by a mask and by a rig curve. It
 * does so for the x and y of normals, and for colours.
 */

/** Masks in the order of the channels, with the centre and radius of the skin that they cover. */
const MASKS: Readonly<
  Record<string, readonly (readonly [mask: string, u: number, v: number, radius: number])[]>
> = {
  head_wm1_msk_01: [
    ['blink_L', 0.7, 0.37, 0.07],
    ['blink_R', 0.3, 0.37, 0.07],
    ['browsRaiseInner_L', 0.6, 0.14, 0.1],
    ['browsRaiseInner_R', 0.4, 0.14, 0.1],
  ],
  head_wm1_msk_02: [
    ['browsRaiseOuter_L', 0.79, 0.16, 0.1],
    ['browsRaiseOuter_R', 0.21, 0.16, 0.1],
    ['chinRaise_L', 0.58, 0.94, 0.06],
    ['chinRaise_R', 0.42, 0.94, 0.06],
  ],
  head_wm1_msk_03: [
    ['jawOpen', 0.5, 0.86, 0.05],
    ['purse_DL', 0.6, 0.84, 0.04],
    ['purse_DR', 0.4, 0.84, 0.04],
    ['purse_UL', 0.58, 0.64, 0.04],
  ],
  head_wm1_msk_04: [
    ['purse_UR', 0.42, 0.64, 0.04],
    ['squintInner_L', 0.63, 0.46, 0.05],
    ['squintInner_R', 0.37, 0.46, 0.05],
  ],
  head_wm2_msk_01: [
    ['browsDown_L', 0.66, 0.28, 0.06],
    ['browsDown_R', 0.34, 0.28, 0.06],
    ['browsLateral_L', 0.55, 0.26, 0.05],
    ['browsLateral_R', 0.45, 0.26, 0.05],
  ],
  head_wm2_msk_02: [
    ['mouthStretch_L', 0.7, 0.78, 0.07],
    ['mouthStretch_R', 0.3, 0.78, 0.07],
    ['neckStretch_L', 0.9, 0.92, 0.08],
    ['neckStretch_R', 0.1, 0.92, 0.08],
  ],
  head_wm2_msk_03: [
    ['noseWrinkler_L', 0.55, 0.4, 0.05],
    ['noseWrinkler_R', 0.45, 0.4, 0.05],
  ],
  head_wm3_msk_01: [
    ['cheekRaiseInner_L', 0.69, 0.54, 0.05],
    ['cheekRaiseInner_R', 0.31, 0.54, 0.05],
    ['cheekRaiseOuter_L', 0.86, 0.5, 0.07],
    ['cheekRaiseOuter_R', 0.14, 0.5, 0.07],
  ],
  head_wm3_msk_02: [
    ['cheekRaiseUpper_L', 0.85, 0.38, 0.05],
    ['cheekRaiseUpper_R', 0.15, 0.38, 0.05],
    ['smile_L', 0.76, 0.66, 0.06],
    ['smile_R', 0.24, 0.66, 0.06],
  ],
  head_wm13_msk_01: [
    ['lips_DL', 0.53, 0.76, 0.03],
    ['lips_DR', 0.47, 0.76, 0.03],
    ['lips_UL', 0.53, 0.71, 0.03],
    ['lips_UR', 0.47, 0.71, 0.03],
  ],
}

/** For each rig curve, named by set and mask: the factors of the controls that raise it. A control acts on masks of its own side. */
const CURVES: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  '1 browsRaiseInner': { browRaiseIn: 1 },
  '1 browsRaiseOuter': { browRaiseOuter: 1 },
  '1 blink': { eyeBlink: 1 },
  '1 squintInner': { eyeBlink: 0.3 },
  '2 browsDown': { browDown: 1, noseWrinkle: 0.2 },
  '2 browsLateral': { browLateral: 1, noseWrinkle: 0.3 },
  '2 noseWrinkler': { noseWrinkle: 1 },
  '2 mouthStretch': { mouthStretch: 1 },
  '3 cheekRaiseInner': { mouthCornerPull: 0.8 },
  '3 cheekRaiseOuter': { mouthCornerPull: 0.8 },
  '3 smile': { mouthCornerPull: 1 },
  '3 lips_D': { mouthCornerPull: 1, mouthStretch: 1 },
  '3 lips_U': { mouthCornerPull: 1, mouthStretch: 1 },
}

const CONTROLS = [...new Set(Object.values(CURVES).flatMap((factors) => Object.keys(factors)))]
export const METAHUMAN_SHAPES = ['L', 'R'].flatMap((side) => CONTROLS.map((control) => `${control}${side}`))
const MASK_SIZE = 256

export class MetahumanSource {
  readonly base: Field
  readonly sets: readonly Field[]
  readonly size: number

  constructor(size: number) {
    this.size = size
    this.base = creased(size, 5, [])
    this.sets = [1, 2, 3].map((set) => {
      const bumps = spotsOf(set).map(([, u, v, radius]): Bump => ({ u, v, radius, slope: 0.35, turn: set }))
      return creased(size, 5, bumps)
    })
  }

  async files(): Promise<Record<string, Uint8Array>> {
    const files: Record<string, Uint8Array> = {
      'ExportManifest.json': new TextEncoder().encode('{ "metaHumanName": "Ada" }'),
      'head.dna': new Uint8Array(16),
    }
    for (const [i, field] of this.sets.entries()) {
      files[`Maps/Head_Normal_Animated_WM${i + 1}.png`] = await rgbPng(this.size, directX(field))
      files[`Maps/Head_Basecolor_Animated_CM${i + 1}.png`] = await rgbPng(this.size, this.colours(i + 1))
    }
    for (const [file, masks] of Object.entries(MASKS)) {
      const data = Uint8Array.from({ length: 4 * MASK_SIZE ** 2 }, (_, i) => {
        const mask = masks[i % 4]
        return mask ? Math.round(255 * spotAt(mask, ...centreOf(Math.floor(i / 4), MASK_SIZE))) : 255
      })
      files[`Masks/${file}.tga`] = tga(MASK_SIZE, data)
    }
    return files
  }

  /** Colours of the resting skin (0) or of a set, three bytes per texel. */
  colours(set: number): Uint8Array {
    const colour = [210 - 6 * set, 160 - 12 * set, 140 - 10 * set]
    return Uint8Array.from({ length: 3 * this.size ** 2 }, (_, i) => colour[i % 3]!)
  }

  /** Returns the normals and the linear base colours of a pose, three numbers per texel. Shades only some texels. */
  shade(pose: Pose, texels: readonly number[]): { normals: Float64Array; colours: Float64Array } {
    const linear = (set: number) => Float64Array.from(this.colours(set), (byte) => toLinear(byte / 255))
    const base = stored(this.base).data
    const [normals, colours] = [base.slice(), linear(0)]
    const [skin, sets, tints] = [
      linear(0),
      this.sets.map((field) => stored(field).data),
      [1, 2, 3].map(linear),
    ]
    for (const i of texels) {
      const [u, v] = centreOf(i, this.size)
      for (const set of [1, 2, 3]) {
        let amount = 0
        for (const spot of spotsOf(set)) {
          const weight = spotAt(spot, u, v)
          if (weight > 0) amount += weight * curveOf(set, spot[0], pose)
        }
        for (let k = 3 * i; k < 3 * i + 3; k++) {
          if (k % 3 < 2) normals[k]! += amount * (sets[set - 1]![k]! - base[k]!)
          colours[k]! += amount * (tints[set - 1]![k]! - skin[k]!)
        }
      }
    }
    return { normals: normalised(normals), colours }
  }
}

type Spot = readonly [mask: string, u: number, v: number, radius: number]

const SPOTS = new Map([1, 2, 3].map((set) => [set, listSpots(set)]))

function spotsOf(set: number): readonly Spot[] {
  return SPOTS.get(set)!
}

function listSpots(set: number): Spot[] {
  return Object.entries(MASKS).flatMap(([file, masks]) => {
    const family = /wm(\d+)/.exec(file)![1]!
    return family === String(set) || (family === '13' && set !== 2) ? [...masks] : []
  })
}

/** Value of a rig curve, 0..1. */
function curveOf(set: number, mask: string, pose: Pose): number {
  const [, name, side] = /^(.*?)_?([LR])$/.exec(mask) ?? [undefined, mask, '']
  const factors = CURVES[`${set} ${name}`] ?? {}
  const sum = Object.entries(factors).reduce(
    (total, [control, factor]) => total + factor * (pose[`${control}${side}`] ?? 0),
    0,
  )
  return Math.min(1, sum)
}

function spotAt([, cu, cv, radius]: Spot, u: number, v: number): number {
  const t = Math.min(1, Math.max(0, 1.6 - (1.6 * Math.hypot(u - cu, v - cv)) / radius))
  return t * t * (3 - 2 * t)
}

/** Bytes of a normal map with green down. */
function directX({ data }: Field): Uint8Array {
  return Uint8Array.from(data, (value, i) => Math.round(((i % 3 === 1 ? -value : value) + 1) * 127.5))
}
