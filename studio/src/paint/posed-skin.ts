import { PoseWatch } from 'furrow/internal/three'
import type { Mesh } from 'three'
import { makeSkinInWorker } from './in-worker.ts'
import { makeSkin, type SkinData } from './make-skin.ts'
import { PaintSkin } from './paint-skin.ts'
import { SkinPicker } from './picker.ts'
import { type MeshSkin, readSkin } from './read-skin.ts'

/** Skin of a face at rest and in its current pose. All tools share it. */
export class PosedSkin {
  /** Skin at rest. */
  readonly skin: PaintSkin
  /** Finds the skin under the pointer, in the pose at the last call of `follow`. */
  readonly picker: SkinPicker
  readonly scale: number
  readonly #watch: PoseWatch

  /** @param made result of `makeSkin` for `read.skin`. */
  constructor(meshes: readonly Mesh[], scale: number, read: MeshSkin, made: SkinData) {
    this.skin = new PaintSkin(read.skin, made.surface, made.map)
    this.picker = new SkinPicker(read, this.skin, made)
    this.scale = scale
    this.#watch = new PoseWatch(meshes)
    this.#watch.hasChanged()
  }

  /** Updates `picker` to the current pose. Does nothing if the face has not moved. */
  follow(): void {
    if (this.#watch.hasChanged()) this.picker.refit()
  }
}

/** Cached skins. The key is the array of meshes of an open avatar. */
const cachedSkins = new WeakMap<readonly Mesh[], PosedSkin>()

const preparations = new WeakMap<readonly Mesh[], { scale: number; size: number; skin: Promise<PosedSkin> }>()

/**
 * Returns the skin of a face in its current pose, and caches it. If `prepareSkin` has not run before, computes the skin on the main thread, which
 * takes 0.1 to 0.3 s for a scanned face.
 *
 * @param scale millimetres per unit of the face's positions.
 * @throws FurrowError if the skin cannot be painted.
 */
export function posedSkinOf(meshes: readonly [Mesh, ...Mesh[]], scale: number): PosedSkin {
  const last = cachedSkin(meshes, scale)
  if (last) {
    last.follow()
    return last
  }
  const read = readSkin(meshes)
  const made = new PosedSkin(meshes, scale, read, makeSkin(read.skin, scale))
  cachedSkins.set(meshes, made)
  return made
}

/** Returns the cached skin in its current pose. Returns null if no skin with a map of this size is cached. */
export function preparedSkin(
  meshes: readonly [Mesh, ...Mesh[]],
  scale: number,
  size: number,
): PosedSkin | null {
  const known = cachedSkin(meshes, scale)
  if (!known?.skin.hasMap(size)) return null
  known.follow()
  return known
}

/**
 * Prepares the skin of a face and its paint map in a worker, or on the main thread if the worker dies. Rejects with a
 * FurrowError if the skin cannot be painted.
 *
 * @param size width and height of the face's areas, texels.
 */
export function prepareSkin(
  meshes: readonly [Mesh, ...Mesh[]],
  scale: number,
  size: number,
): Promise<PosedSkin> {
  const last = preparations.get(meshes)
  if (last?.scale === scale && last.size === size) return last.skin
  const own = { scale, size, skin: prepareUncached(meshes, scale, size) }
  const forget = () => {
    if (preparations.get(meshes) === own) preparations.delete(meshes)
  }
  preparations.set(meshes, own)
  own.skin.then(forget, forget)
  return own.skin
}

async function prepareUncached(
  meshes: readonly [Mesh, ...Mesh[]],
  scale: number,
  size: number,
): Promise<PosedSkin> {
  const known = preparedSkin(meshes, scale, size)
  if (known) return known
  const { skin: own, parts } = readSkin(meshes)
  const answer = await makeSkinInWorker(own, scale, size).catch(() => null)
  if (answer) {
    const { skin, made } = answer
    // While the worker ran, `posedSkinOf` may have cached the skin.
    const early = cachedSkin(meshes, scale)
    if (!early) cachedSkins.set(meshes, new PosedSkin(meshes, scale, { skin, parts }, made))
    else if (!early.skin.hasMap(size)) early.skin.addMap(made.map!)
  }
  const posed = posedSkinOf(meshes, scale)
  posed.skin.mapOf(size)
  return posed
}

function cachedSkin(meshes: readonly Mesh[], scale: number): PosedSkin | null {
  const last = cachedSkins.get(meshes)
  return last?.scale === scale ? last : null
}
