import { fileURLToPath } from 'node:url'
import { AUTO_DEFAULTS, type AutoWrinkles, autoWrinkles, type Skin } from 'furrow/author'
import type { CreasedRegion } from '../../../../packages/furrow/src/author/auto/lines/crease.ts'
import { layLines } from '../../../../packages/furrow/src/author/auto/lines/lay-lines.ts'
import { measureStrain } from '../../../../packages/furrow/src/author/auto/strain/measure-strain.ts'
import type { DetectedFace } from '../../../../packages/furrow/src/author/auto/surface/detect-face.ts'
import { poseOf } from '../../../../packages/furrow/src/author/auto/surface/pose.ts'
import {
  type PreparedSkin,
  prepareSkin,
} from '../../../../packages/furrow/src/author/auto/surface/prepare-skin.ts'
import { SCANS } from '../../../bare-faces/bare-faces.ts'
import { driven } from '../../../driven.ts'
import { skinAt } from '../../../skin-at.ts'

/** Names and paths of the shipped face, and of the scanned face if available. */
export const FACES = [
  ['human', fileURLToPath(new URL('../../../../faces/human.glb', import.meta.url))],
  ...SCANS.map(({ name, path }) => [name, path] as const),
] as readonly (readonly [string, string])[]

/** Skin on which a face was detected. */
export type PreparedFace = PreparedSkin & { face: DetectedFace }

export function prepareFace(skin: Skin): PreparedFace {
  const prepared = prepareSkin(skin)
  const { face } = prepared
  if (!face) throw new Error('no face was detected')
  return { ...prepared, face }
}

/** Returns the wrinkle lines of all regions of a face, with default strength and seed. */
export function facialCreases(prepared: PreparedFace, ageFraction: number): CreasedRegion[] {
  const settings = { ...AUTO_DEFAULTS, seed: 1, ageFraction, maxAreas: AUTO_DEFAULTS.areas }
  return layLines(prepared, measureStrain(prepared, settings), settings)
}

/** Face with automatic wrinkles, and functions that measure them. */
export class MeasuredFace {
  readonly skin: Skin
  readonly prepared: PreparedFace
  readonly wrinkles: AutoWrinkles
  readonly #driven: ReturnType<typeof driven>

  constructor(skin: Skin, wrinkles: AutoWrinkles) {
    this.skin = skin
    this.prepared = prepareFace(skin)
    this.wrinkles = wrinkles
    this.#driven = driven(
      wrinkles.areas.map(({ driver }) => driver),
      skin.targets.map(({ name }) => name),
    )
  }

  static async read(path: string): Promise<MeasuredFace> {
    const skin = await skinAt(path)
    return new MeasuredFace(skin, autoWrinkles(skin, { age: 70, size: 512 }))
  }

  get face(): DetectedFace {
    return this.prepared.face
  }

  activations(pose: Readonly<Record<string, number>>): Map<string, number> {
    const weights = new Float32Array(this.skin.targets.length)
    for (const [target, weight] of poseOf(this.face.find, pose)) weights[target] = weight
    return new Map(Object.entries(this.#driven.activations({ weights })))
  }

  /**
   * Integrates weight times activation of all areas over the skin, in a pose.
   *
   * @param isCounted tells whether to include a point, given its position in the frame of the face, millimetres.
   */
  activated(
    pose: Readonly<Record<string, number>>,
    isCounted: (x: number, y: number, z: number) => boolean,
  ): number {
    const activations = this.activations(pose)
    const { surface } = this.face
    const seen = new Set<number>()
    let sum = 0
    for (const [vertex, point] of surface.pointOf.entries()) {
      if (seen.has(point)) continue
      seen.add(point)
      const [x, y, z] = [0, 1, 2].map((k) => surface.points[3 * point + k])
      if (!isCounted(x, y, z)) continue
      for (const { name, weights } of this.wrinkles.areas) {
        const texel = (k: number) =>
          Math.min(weights.width - 1, Math.floor(this.skin.uvs[2 * vertex + k] * weights.width))
        const weight = weights.data[texel(1) * weights.width + texel(0)] / 255
        sum += weight * (activations.get(name) ?? Number.NaN) * surface.areas[point]
      }
    }
    return sum
  }

  /** Returns the fraction of `activated` that comes from the points that `isCounted` accepts. */
  activatedFraction(
    pose: Readonly<Record<string, number>>,
    isCounted: (x: number, y: number, z: number) => boolean,
  ): number {
    return this.activated(pose, isCounted) / this.activated(pose, () => true)
  }
}
