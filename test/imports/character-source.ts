import type { Pose } from './evaluate.ts'
import { toLinear } from './evaluate.ts'
import { normalised } from './expression-source.ts'
import { type Bump, centreOf, creased, type Field, normalPng, rgbPng, stored } from './paint.ts'

/**
 * Export in the layout of Character Creator, and the formula with which the add-ons for Blender and Unity shade it. The formula is written
 * here a second time, with the names of the rules instead of the packed vectors of the shader.
 */

/** Centre of the skin that a mask covers on the right half of the texture, which is the left side of the face. */
const SPOTS: Readonly<Record<string, [u: number, v: number, radius: number]>> = {
  'Set1A 0': [0.7, 0.37, 0.08],
  'Set1A 1': [0.6, 0.16, 0.12],
  'Set1A 2': [0.56, 0.83, 0.06],
  'Set1A 3': [0.56, 0.65, 0.06],
  'Set1B 0': [0.78, 0.16, 0.12],
  'Set1B 1': [0.58, 0.93, 0.08],
  'Set1B 2': [0.66, 0.9, 0.07],
  'Set1B 3': [0.64, 0.44, 0.06],
  'Set2 0': [0.64, 0.28, 0.07],
  'Set2 1': [0.56, 0.22, 0.09],
  'Set2 2': [0.7, 0.75, 0.08],
  'Set2 3': [0.9, 0.92, 0.1],
  'Set3 0': [0.68, 0.55, 0.055],
  'Set3 1': [0.86, 0.5, 0.09],
  'Set3 2': [0.8, 0.42, 0.07],
  'Set3 3': [0.75, 0.66, 0.07],
  'Set123 0': [0.55, 0.77, 0.05],
  'Set123 1': [0.55, 0.71, 0.05],
  'Set123 2': [0.55, 0.42, 0.06],
  'Set123 3': [0.61, 0.62, 0.04],
}

/** Sets, with the masks of their rules: rule, mask file, channel. Names as in the JSON file, without side. */
const RULES: readonly (readonly [set: number, rule: string, mask: string])[] = [
  [1, 'blink', 'Set1A 0'],
  [1, 'browRaiseInner', 'Set1A 1'],
  [1, 'purse_D', 'Set1A 2'],
  [1, 'purse_U', 'Set1A 3'],
  [1, 'browRaiseOuter', 'Set1B 0'],
  [1, 'chinRaise', 'Set1B 1'],
  [1, 'jawOpen', 'Set1B 2'],
  [1, 'squintInner', 'Set1B 3'],
  [1, 'lips_D', 'Set123 0'],
  [1, 'lips_U', 'Set123 1'],
  [2, 'browsDown', 'Set2 0'],
  [2, 'browsLateral', 'Set2 1'],
  [2, 'mouthStretch', 'Set2 2'],
  [2, 'neckStretch', 'Set2 3'],
  [2, 'noseWrinkler', 'Set123 2'],
  [2, 'noseCrease', 'Set123 3'],
  [3, 'cheekRaiseInner', 'Set3 0'],
  [3, 'cheekRaiseOuter', 'Set3 1'],
  [3, 'cheekRaiseUpper', 'Set3 2'],
  [3, 'smile', 'Set3 3'],
  [3, 'lips_D', 'Set123 0'],
  [3, 'lips_U', 'Set123 1'],
  [3, 'browRaiseCorrection', 'Set1A 1'],
]

/** Blendshapes of the test, with the rules of the same side that they activate. */
const SHAPES: Readonly<Record<string, readonly (readonly [set: number, rule: string, factor: number])[]>> = {
  'Brow_Raise_Inner_*': [
    [1, 'browRaiseInner', 1],
    [2, 'browsLateral', 0.03],
  ],
  'Brow_Raise_Outer_*': [[1, 'browRaiseOuter', 1]],
  'Brow_Drop_*': [
    [2, 'browsDown', 0.1],
    [2, 'browsLateral', 1],
  ],
  'Eye_Blink_*': [
    [1, 'blink', 1],
    [1, 'squintInner', 0.3],
  ],
  'Nose_Sneer_*': [
    [2, 'browsDown', 0.7],
    [2, 'browsLateral', 0.6],
    [2, 'noseWrinkler', 1],
  ],
  'Cheek_Raise_*': [
    [3, 'cheekRaiseInner', 0.3],
    [3, 'cheekRaiseOuter', 0.7],
    [3, 'cheekRaiseUpper', 1],
  ],
  'Mouth_Smile_*': [
    [3, 'cheekRaiseInner', 0.6],
    [3, 'cheekRaiseOuter', 0.6],
    [3, 'smile', 1],
    [3, 'lips_D', 1],
    [3, 'lips_U', 1],
    [2, 'noseCrease', 0.7],
  ],
  'Mouth_Stretch_*': [[2, 'mouthStretch', 1]],
  'Mouth_Pucker_Up_*': [
    [1, 'purse_U', 1],
    [1, 'lips_U', 1],
  ],
  Jaw_Open: [[1, 'jawOpen', 1]],
  Mouth_Chin_Up: [[1, 'chinRaise', 1]],
}

export const SIDES = ['L', 'R'] as const
export const CHARACTER_SHAPES = Object.keys(SHAPES).flatMap((name) =>
  name.includes('*') ? SIDES.map((side) => name.replace('*', side)) : name,
)

const MASK_SIZE = 256
const SLOPE = 0.35

export interface CharacterOptions {
  size: number
  /** Flow at the top and at the bottom of the texture, 0..1. Without it, there are no flow maps. */
  flow?: readonly [number, number]
  weights?: Readonly<Record<string, number>>
  overall?: number
}

export class CharacterSource {
  readonly base: Field
  readonly sets: readonly Field[]
  readonly #options: CharacterOptions
  readonly #colours = new Map<number, Float64Array>()

  constructor(options: CharacterOptions) {
    this.#options = options
    const bumpsOf = (set: number): Bump[] =>
      RULES.filter(([own]) => own === set).flatMap(([, , mask]) => {
        const [u, v, radius] = SPOTS[mask]!
        const bump = { v, radius, slope: SLOPE / 2, turn: set }
        return [
          { ...bump, u },
          { ...bump, u: 1 - u },
        ]
      })
    this.base = creased(options.size, 3, [])
    this.sets = [1, 2, 3].map((set) => creased(options.size, 3, bumpsOf(set)))
  }

  get size(): number {
    return this.#options.size
  }

  async files(): Promise<Record<string, Uint8Array>> {
    const { size, flow } = this.#options
    const files: Record<string, Uint8Array> = {
      'Kevin.json': new TextEncoder().encode(JSON.stringify(this.json())),
    }
    for (const [i, field] of this.sets.entries()) {
      files[`textures/Kevin/Head_Wrinkle_Normal${i + 1}.png`] = await normalPng(field)
      files[`textures/Kevin/Head_Wrinkle_Diffuse${i + 1}.png`] = await rgbPng(size, this.#diffuse(i + 1))
      if (flow) files[`textures/Kevin/Head_Wrinkle_Flow${i + 1}.png`] = await rgbPng(size, this.#flow())
    }
    for (const [mask, png] of await masks()) files[`RL_WrinkleMask_${mask}.png`] = png
    return files
  }

  /** Colours of the resting face, three bytes per texel. */
  diffuse(): Uint8Array {
    return this.#diffuse(0)
  }

  json(): object {
    const { weights, overall = 1, flow } = this.#options
    const textures = Object.fromEntries(
      [1, 2, 3].flatMap((set) =>
        ['Normal', 'Diffuse', ...(flow ? ['Flow'] : [])].map((kind) => [
          `${kind}_${set}`,
          { 'Texture Path': `./textures/Kevin/Head_Wrinkle_${kind}${set}.png` },
        ]),
      ),
    )
    const rules = RULES.flatMap(([set, rule]) => namesOf(set, rule))
    const Wrinkle = {
      Textures: textures,
      WrinkleRules: rules,
      WrinkleEaseStrength: rules.map(() => 1),
      WrinkleRuleWeights: rules.map((name) => weights?.[name] ?? 1),
      WrinkleOverallWeight: overall,
    }
    const head = { 'Material Type': 'Pbr', Wrinkle }
    const Meshes = { CC_Base_Body: { Materials: { Std_Skin_Head: head, Std_Skin_Body: {} } } }
    return { Kevin: { Version: '1.10.1822.1', Object: { Kevin: { Generation: 'G3Plus', Meshes } } } }
  }

  /** Returns the values of the rules: set, rule and side, 0..1. */
  values(pose: Pose, power = 1): Map<string, number> {
    const { weights, overall = 1 } = this.#options
    const sums = new Map<string, number>()
    for (const [pattern, links] of Object.entries(SHAPES)) {
      for (const [i, side] of SIDES.entries()) {
        const weight = pose[pattern.replace('*', side)] ?? 0
        for (const [set, rule, factor] of links) {
          const key = `${set} ${rule} ${side}`
          sums.set(
            key,
            (sums.get(key) ?? 0) + weight * factor * (weights?.[namesOf(set, rule)[i] ?? ''] ?? 1),
          )
        }
      }
    }
    const values = new Map([...sums].map(([key, sum]) => [key, Math.min(1, overall * sum ** power)]))
    for (const side of SIDES) {
      const [raise, lateral] = [`1 browRaiseInner ${side}`, `2 browsLateral ${side}`]
      const overlap = Math.min(values.get(raise) ?? 0, values.get(lateral) ?? 0)
      values.set(raise, (values.get(raise) ?? 0) - overlap)
      values.set(lateral, (values.get(lateral) ?? 0) - overlap)
      values.set(`3 browRaiseCorrection ${side}`, overlap)
    }
    return values
  }

  /** Returns the normals and the linear base colours of a pose, three numbers per texel. Shades only some texels if they are given. */
  shade(pose: Pose, power = 1, texels?: readonly number[]): { normals: Float64Array; colours: Float64Array } {
    const { size } = this.#options
    const values = this.values(pose, power)
    const normals = stored(this.base).data
    const colours = this.#linear(0).slice()
    const sets = this.sets.map((field) => stored(field).data)
    const diffuses = [1, 2, 3].map((set) => this.#linear(set))
    for (const i of texels ?? Array(size * size).keys()) {
      const [u, v] = centreOf(i, size)
      const amounts = [1, 2, 3].map((set) => this.#amount(set, values, u, v))
      for (let k = 3 * i; k < 3 * i + 3; k++) {
        normals[k] = blend(
          normals[k]!,
          sets.map((data) => data[k]!),
          amounts,
        )
        colours[k] = blend(
          colours[k]!,
          diffuses.map((data) => data[k]!),
          amounts,
        )
      }
    }
    return { normals: normalised(normals), colours }
  }

  #amount(set: number, values: ReadonlyMap<string, number>, u: number, v: number): number {
    let sum = 0
    for (const [own, rule, mask] of RULES) {
      if (own !== set) continue
      const weight = maskAt(mask, u, v)
      if (weight === 0) continue
      for (const side of SIDES) sum += weight * sideAt(u, side) * (values.get(`${set} ${rule} ${side}`) ?? 0)
    }
    return Math.min(1, this.#flowAt(v) + sum) * sum
  }

  #flowAt(v: number): number {
    const [top, bottom] = this.#options.flow ?? [1, 1]
    return Math.round(255 * (top + (bottom - top) * v)) / 255
  }

  #flow(): Uint8Array {
    const { size } = this.#options
    return Uint8Array.from({ length: 3 * size * size }, (_, i) => {
      return Math.round(255 * this.#flowAt(centreOf(Math.floor(i / 3), size)[1]))
    })
  }

  #linear(set: number): Float64Array {
    const known =
      this.#colours.get(set) ?? Float64Array.from(this.#diffuse(set), (byte) => toLinear(byte / 255))
    this.#colours.set(set, known)
    return known
  }

  /** Skin, with redder wrinkles. */
  #diffuse(set: number): Uint8Array {
    const { size } = this.#options
    const colour = [200 - 6 * set, 150 - 9 * set, 130 - 8 * set]
    return Uint8Array.from({ length: 3 * size * size }, (_, i) => colour[i % 3]!)
  }
}

let known: Promise<[string, Uint8Array][]> | undefined

/** Returns the masks as PNG. They are the same for all characters. */
function masks(): Promise<[string, Uint8Array][]> {
  known ??= Promise.all(
    ['Set1A', 'Set1B', 'Set2', 'Set3', 'Set123'].map(async (mask): Promise<[string, Uint8Array]> => {
      const data = Uint8Array.from({ length: 4 * MASK_SIZE ** 2 }, (_, i) => {
        return Math.round(255 * maskAt(`${mask} ${i % 4}`, ...centreOf(Math.floor(i / 4), MASK_SIZE)))
      })
      return [mask, await rgbPng(MASK_SIZE, data)]
    }),
  )
  return known
}

/** Adds the largest and the smallest of the changes of the three sets. */
function blend(base: number, wrinkled: readonly number[], amounts: readonly number[]): number {
  const changes = wrinkled.map((value, i) => (value - base) * amounts[i]!)
  return base + Math.max(...changes) + Math.min(...changes)
}

/** Masks of the sets that use a mask, per set. */
const SHARERS = new Map(
  Object.keys(SPOTS).map((mask) => {
    const sets = RULES.filter(([, , own]) => own === mask).map(([set]) => set)
    return [
      mask,
      sets.map((set) => [...new Set(RULES.filter(([own]) => own === set).map(([, , own]) => own))]),
    ]
  }),
)

/** Returns the weight of a mask. The masks of one set sum to at most 1. */
function maskAt(mask: string, u: number, v: number): number {
  const weight = spotAt(mask, u, v)
  if (weight === 0) return 0
  const sums = SHARERS.get(mask)!.map((masks) => masks.reduce((sum, own) => sum + spotAt(own, u, v), 0))
  return weight / Math.max(1, ...sums)
}

function spotAt(mask: string, u: number, v: number): number {
  const [cu, cv, radius] = SPOTS[mask]!
  const distance = Math.min(Math.hypot(u - cu, v - cv), Math.hypot(1 - u - cu, v - cv)) / radius
  const t = Math.min(1, Math.max(0, 1.6 - 1.6 * distance))
  return t * t * (3 - 2 * t)
}

function sideAt(u: number, side: 'L' | 'R'): number {
  const left = Math.min(1, Math.max(0, (u - 0.49) / 0.02))
  return side === 'L' ? left : 1 - left
}

/** Names of a rule in the JSON file, left and right. */
function namesOf(set: number, rule: string): string[] {
  if (rule === 'jawOpen') return ['head_wm1_normal_head_wm1_jawOpen']
  const family = rule.startsWith('lips') ? 'wm13' : `wm${set}`
  const prefix = `head_wm${set}_normal_head_${family}_${rule}`
  return SIDES.map((side) => (/_[DU]$/.test(rule) ? `${prefix}${side}` : `${prefix}_${side}`))
}
