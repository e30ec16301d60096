import type { Mesh } from 'three'
import { PoseWatch } from '../viewer/pose/pose-watch.ts'
import { PaintSkin } from './paint-skin.ts'
import { SkinPicker } from './picker.ts'
import { readSkin } from './read-skin.ts'

/** The skin of a face as all tools use it. */
export class PosedSkin {
  /** At rest. */
  readonly skin: PaintSkin
  /** Has the pose of the last `follow`. */
  readonly picker: SkinPicker
  readonly scale: number
  readonly #watch: PoseWatch

  constructor(meshes: readonly [Mesh, ...Mesh[]], scale: number) {
    const read = readSkin(meshes)
    this.skin = new PaintSkin(read.skin, scale)
    this.picker = new SkinPicker(read, this.skin)
    this.scale = scale
    this.#watch = new PoseWatch(meshes)
    this.#watch.isNew()
  }

  /** Takes the present pose; nothing is done while the face rests. */
  follow(): void {
    if (this.#watch.isNew()) this.picker.refit()
  }
}

/** By the meshes, which are one array for as long as the avatar is open. */
const lastMade = new WeakMap<readonly Mesh[], PosedSkin>()

/**
 * The skin of a face in its present pose. It is read once, which takes 0.1 to 0.3 s for a scan: later calls give the same one.
 *
 * @param scale millimetres per unit of its positions.
 * @throws FurrowError when it cannot be painted.
 */
export function posedSkinOf(meshes: readonly [Mesh, ...Mesh[]], scale: number): PosedSkin {
  const last = lastMade.get(meshes)
  if (last?.scale === scale) {
    last.follow()
    return last
  }
  const made = new PosedSkin(meshes, scale)
  lastMade.set(meshes, made)
  return made
}
