import type { Mesh } from 'three'
import { nextTask } from '../later.ts'
import { PoseWatch } from '../viewer/pose/pose-watch.ts'
import { makeSkinInWorker } from './in-worker.ts'
import { type MadeSkin, makeSkin } from './make-skin.ts'
import { PaintSkin } from './paint-skin.ts'
import { SkinPicker } from './picker.ts'
import { type MeshSkin, readSkin } from './read-skin.ts'

/** The skin of a face as all tools use it. */
export class PosedSkin {
  /** At rest. */
  readonly skin: PaintSkin
  /** Has the pose of the last `follow`. */
  readonly picker: SkinPicker
  readonly scale: number
  readonly #watch: PoseWatch

  /** @param made of what was read. */
  constructor(meshes: readonly Mesh[], scale: number, read: MeshSkin, made: MadeSkin) {
    this.skin = new PaintSkin(read.skin, made.surface, made.map)
    this.picker = new SkinPicker(read, this.skin, made)
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
 * The skin of a face in its present pose. It is made once: later calls give the same one. Where `prepareSkin` has not made it, the page waits for
 * it: 0.1 to 0.3 s for a scan.
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
  const read = readSkin(meshes)
  const made = new PosedSkin(meshes, scale, read, makeSkin(read.skin, scale))
  lastMade.set(meshes, made)
  return made
}

/** Vertices of the largest skin that is made before it is needed: a larger one takes hundreds of megabytes, perhaps for nothing. */
const MOST_PREPARED = 500_000

/**
 * Makes the skin of a face in a worker, so that `posedSkinOf` has it at once. It rejects with a FurrowError where that fails.
 *
 * @param size side of the face's areas in texels.
 */
export async function prepareSkin(
  meshes: readonly [Mesh, ...Mesh[]],
  scale: number,
  size: number,
): Promise<void> {
  const isMade = () => lastMade.get(meshes)?.scale === scale
  const vertices = meshes.reduce((sum, { geometry }) => sum + geometry.attributes.position.count, 0)
  if (isMade() || vertices > MOST_PREPARED) return
  const read = readSkin(meshes)
  // Each a task of its own: copying the skin for the worker takes as long as reading it.
  await nextTask()
  const made = await makeSkinInWorker(read.skin, scale, size)
  // It was needed meanwhile.
  if (!isMade()) lastMade.set(meshes, new PosedSkin(meshes, scale, read, made))
}
