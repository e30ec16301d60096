import { fileURLToPath } from 'node:url'
import { MorphActivation } from 'furrow'
import { type AutoWrinkles, autoWrinkles, type Skin } from 'furrow/author'
import { findSkin } from '../../../../packages/cli/src/auto/read-skin.ts'
import { readDocument } from '../../../../packages/cli/src/face.ts'
import { type Face, findFace, poseOf } from '../../../../packages/furrow/src/author/auto/face.ts'
import { SCANS } from '../../../bare-faces/bare-faces.ts'

/** The face that ships, and the scan where it is at hand. */
export const FACES = [
  ['human', fileURLToPath(new URL('../../../../faces/human.glb', import.meta.url))],
  ...SCANS.map(({ name, path }) => [name, path] as const),
] as readonly (readonly [string, string])[]

/** A face with its automatic wrinkles, and what is measured of them. */
export class Measured {
  readonly skin: Skin
  readonly face: Face
  readonly wrinkles: AutoWrinkles
  readonly #morph: MorphActivation

  constructor(skin: Skin, face: Face, wrinkles: AutoWrinkles) {
    this.skin = skin
    this.face = face
    this.wrinkles = wrinkles
    this.#morph = new MorphActivation(
      wrinkles.areas.map(({ driver }) => driver),
      skin.targets.map(({ name }) => name),
    )
  }

  static async read(path: string): Promise<Measured> {
    const { skin } = findSkin(await readDocument(path, 'test'), path, 'test')
    return new Measured(skin, findFace(skin)!, autoWrinkles(skin, { age: 70, size: 512 }))
  }

  /** Activations of a pose, by area. */
  activations(pose: Readonly<Record<string, number>>): Map<string, number> {
    const weights = new Float32Array(this.skin.targets.length)
    for (const [target, weight] of poseOf(this.face.find, pose)) weights[target] = weight
    this.#morph.update(weights)
    return new Map(this.#morph.areaNames.map((name, i) => [name, this.#morph.activations[i]!]))
  }

  /**
   * Activated weight of a pose over the skin: weights times activations times surface.
   *
   * @param where of all of it, the part to be counted, by millimetres in the frame of the face.
   */
  activated(
    pose: Readonly<Record<string, number>>,
    where: (x: number, y: number, z: number) => boolean,
  ): number {
    const activations = this.activations(pose)
    const { surface } = this.face
    const seen = new Set<number>()
    let sum = 0
    for (const [vertex, point] of surface.pointOf.entries()) {
      if (seen.has(point)) continue
      seen.add(point)
      const [x, y, z] = [0, 1, 2].map((k) => surface.points[3 * point + k]!) as [number, number, number]
      if (!where(x, y, z)) continue
      for (const { name, weights } of this.wrinkles.areas) {
        const texel = (k: number) =>
          Math.min(weights.width - 1, Math.floor(this.skin.uvs[2 * vertex + k]! * weights.width))
        const weight = weights.data[texel(1) * weights.width + texel(0)]! / 255
        sum += weight * activations.get(name)! * surface.areas[point]!
      }
    }
    return sum
  }

  /** The part of a pose's activated weight that lies there. */
  share(pose: Readonly<Record<string, number>>, where: (x: number, y: number, z: number) => boolean): number {
    return this.activated(pose, where) / this.activated(pose, () => true)
  }
}
