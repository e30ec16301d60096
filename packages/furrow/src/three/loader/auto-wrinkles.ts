import type { Mesh } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { CharacterWrinkles } from '../../auto/make-wrinkles.ts'
import type { AutoRunOptions } from '../../auto/run-options.ts'
import { runWorker } from '../../auto/run-worker.ts'
import { FurrowError } from '../../core/error.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { FileWrinkles } from '../../runtime/file/read-wrinkles.ts'
import type { Warnings } from '../../runtime/file/warnings.ts'
import { Appearance } from '../appearance.ts'
import { surfaceOf } from '../material/surface.ts'
import { mapTexture } from '../material/textures.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'
import { expressionsOfMesh, nameTargets } from './file-targets.ts'
import { canCrease, readMeshes, readQuantised } from './read-character.ts'

type Meshes = [Mesh, ...Mesh[]]

/** Adds wrinkles to a face of a file. */
export type AddFace = (meshes: Meshes, made: FileWrinkles) => Promise<WrinklesBase>

/** Milliseconds over which wrinkles appear that come after loading. */
const FADE_IN = 300

/** Wrinkles that were made for a file. */
interface MadeWrinkles extends FileWrinkles {
  /** The faces that show the skin. */
  faces: Meshes[]
}

/** Files are worked on one after the other: each takes a core and some hundred megabytes. */
let previous: Promise<unknown> = Promise.resolve()

/**
 * Begins to make wrinkles from the blendshapes of a file, while it is at rest. They are added when they are done.
 *
 * @param file its `userData.wrinkles` takes them, and `userData.wrinklesReady` says when.
 */
export function beginAuto(
  file: GLTF,
  faces: readonly Meshes[],
  options: AutoRunOptions,
  addFace: AddFace,
  warnings: Warnings,
): void {
  file.userData.wrinklesReady = addAutoWrinkles(file, faces, options, addFace).catch((error) =>
    warnings.add(error, 'the file stays plain'),
  )
}

/** @throws FurrowError as `makeAutoWrinkles` does. */
async function addAutoWrinkles(
  file: GLTF,
  faces: readonly Meshes[],
  options: AutoRunOptions,
  addFace: AddFace,
): Promise<void> {
  const made = await makeAutoWrinkles(file.parser, faces, options)
  for (const meshes of made?.faces ?? []) {
    const own = await addFace(meshes, made!)
    meshOf(own).appear(new Appearance(FADE_IN, own.clock))
    file.userData.wrinkles.push(own)
  }
}

/**
 * Makes wrinkles for the skin of a file from its blendshapes, in a worker.
 *
 * @param faces the meshes of each face.
 * @returns undefined when that was cancelled, or everything was disposed of.
 * @throws FurrowError when none of them can wrinkle, or the worker fails.
 */
async function makeAutoWrinkles(
  parser: GLTFParser,
  faces: readonly Meshes[],
  options: AutoRunOptions,
): Promise<MadeWrinkles | undefined> {
  const skins = groupBySkin(faces.filter((meshes) => meshes.every(canCrease)))
  if (skins.length === 0) throw withoutBlendshapes()
  nameTargets(parser, faces.flat())
  // Now, since a page may move the scene and its bones at once.
  for (const [first] of skins) readQuantised(first!)
  const character = skins.map(([first]) => readMeshes(first!, expressionsOfMesh(parser, first![0])))
  const inUse = new SkinsInUse(skins, options.signal)
  const run = async () => {
    const { signal } = inUse
    return signal.aborted
      ? undefined
      : runWorker({ type: 'character', character }, { ...options, signal }, [], WHO)
  }
  try {
    const made = previous.then(run, run)
    previous = made
    const result = await made
    if (!result || !inUse.has(skins[result.mesh]!)) return undefined
    const { set, drivers } = setOf(result)
    return { set, drivers, faces: skins[result.mesh]! }
  } catch (error) {
    if (inUse.signal.aborted) return undefined
    throw error
  } finally {
    inUse.end()
  }
}

/** The worker has packed the maps, so that this takes no time. */
function setOf(made: CharacterWrinkles): FileWrinkles {
  const { layers, normals, occlusionAndBlood, bloodAmplitude, heights, areas, drivers } = made
  const normalArray = mapTexture(normals, 1)
  const pairArray = mapTexture(occlusionAndBlood, 1)
  const set: WrinkleSet<ArraySlice> = {
    layers: layers.map((name, slice) => ({
      name,
      kind: 'detail',
      normal: { array: normalArray, slice, channel: 0 },
      occlusion: { array: pairArray, slice, channel: 0 },
      blood: { array: pairArray, slice, channel: 1 },
      bloodAmplitude,
      ...heights[slice],
    })),
    areas,
  }
  return { set, drivers }
}

const WHO = 'WrinkleLoaderPlugin'

/** Several nodes may have the same mesh. */
function groupBySkin(faces: readonly Meshes[]): Meshes[][] {
  const groups: Meshes[][] = []
  for (const face of faces) {
    const isSame = ([[mesh]]: Meshes[]) =>
      mesh.geometry === face[0].geometry && surfaceOf(mesh) === surfaceOf(face[0])
    const group = groups.find(isSame)
    if (group) group.push(face)
    else groups.push([face])
  }
  return groups
}

/** Skins of which neither geometry nor material was disposed of. The signal is aborted when there is none left. */
class SkinsInUse {
  readonly #left: Set<Meshes[]>
  readonly #gone = new AbortController()
  readonly #unwatch: (() => void)[] = []
  readonly signal: AbortSignal

  constructor(skins: readonly Meshes[][], signal: AbortSignal | undefined) {
    this.#left = new Set(skins)
    this.signal = signal ? AbortSignal.any([signal, this.#gone.signal]) : this.#gone.signal
    for (const skin of skins) {
      const remove = () => {
        this.#left.delete(skin)
        if (this.#left.size === 0) this.#gone.abort()
      }
      const [[mesh]] = skin
      for (const part of [mesh.geometry, surfaceOf(mesh)]) {
        part.addEventListener('dispose', remove)
        this.#unwatch.push(() => part.removeEventListener('dispose', remove))
      }
    }
  }

  has(skin: Meshes[]): boolean {
    return this.#left.has(skin)
  }

  end(): void {
    for (const unwatch of this.#unwatch) unwatch()
  }
}

function withoutBlendshapes(): FurrowError {
  return new FurrowError({
    who: WHO,
    problem: 'no wrinkles can be made: no mesh has blendshapes and texture coordinates',
    remedy: 'export the face with its blendshapes, or load the file without the option auto',
  })
}
