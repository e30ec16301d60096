import type { Mesh } from 'three'
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

/** Those that are being made. */
const preparations = new WeakMap<readonly Mesh[], { scale: number; size: number; skin: Promise<PosedSkin> }>()

/**
 * The skin of a face in its present pose. It is made once: later calls give the same one. Where `prepareSkin` has not made it, the page waits for
 * it: 0.1 to 0.3 s for a scan.
 *
 * @param scale millimetres per unit of its positions.
 * @throws FurrowError when it cannot be painted.
 */
export function posedSkinOf(meshes: readonly [Mesh, ...Mesh[]], scale: number): PosedSkin {
  const last = knownSkin(meshes, scale)
  if (last) {
    last.follow()
    return last
  }
  const read = readSkin(meshes)
  const made = new PosedSkin(meshes, scale, read, makeSkin(read.skin, scale))
  lastMade.set(meshes, made)
  return made
}

/** The skin of a face in its present pose, with the map of areas of a size; null before `prepareSkin` has made both. */
export function preparedSkin(
  meshes: readonly [Mesh, ...Mesh[]],
  scale: number,
  size: number,
): PosedSkin | null {
  const known = knownSkin(meshes, scale)
  if (!known?.skin.hasMap(size)) return null
  known.follow()
  return known
}

/**
 * Makes the skin of a face and the map of its areas in a worker; on the page where the worker ends. It rejects with a FurrowError where the skin
 * cannot be painted.
 *
 * @param size side of the face's areas in texels.
 */
export function prepareSkin(
  meshes: readonly [Mesh, ...Mesh[]],
  scale: number,
  size: number,
): Promise<PosedSkin> {
  const last = preparations.get(meshes)
  if (last?.scale === scale && last.size === size) return last.skin
  const own = { scale, size, skin: makePrepared(meshes, scale, size) }
  const forget = () => {
    if (preparations.get(meshes) === own) preparations.delete(meshes)
  }
  preparations.set(meshes, own)
  own.skin.then(forget, forget)
  return own.skin
}

async function makePrepared(
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
    // An area may have needed the skin meanwhile.
    const early = knownSkin(meshes, scale)
    if (!early) lastMade.set(meshes, new PosedSkin(meshes, scale, { skin, parts }, made))
    else if (!early.skin.hasMap(size)) early.skin.addMap(made.map!)
  }
  const posed = posedSkinOf(meshes, scale)
  posed.skin.mapOf(size)
  return posed
}

function knownSkin(meshes: readonly Mesh[], scale: number): PosedSkin | null {
  const last = lastMade.get(meshes)
  return last?.scale === scale ? last : null
}
