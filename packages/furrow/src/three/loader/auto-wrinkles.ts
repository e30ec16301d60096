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
import { addFlatNormalMap, readMeshes, supportsAutoWrinkles } from './read-character.ts'

type Meshes = [Mesh, ...Mesh[]]

/** Adds wrinkles to a face of a file. */
export type AddFace = (meshes: Meshes, made: FileWrinkles) => Promise<WrinklesBase>

/** Duration of the fade-in, milliseconds. */
const FADE_IN = 300

/** Wrinkles generated for a file. */
interface GeneratedWrinkles extends FileWrinkles {
  /** Faces with the skin that the wrinkles belong to. */
  faces: Meshes[]
}

/** Files are processed one at a time: each occupies a core and hundreds of megabytes. */
let previous: Promise<unknown> = Promise.resolve()

/**
 * Starts generating wrinkles from the blendshapes of a file, in its current pose.
 *
 * @param file receives the wrinkles in `userData.wrinkles`, and a promise in `userData.wrinklesReady`.
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

/** @throws FurrowError if no mesh has blendshapes and UVs, or the worker fails. */
async function addAutoWrinkles(
  file: GLTF,
  faces: readonly Meshes[],
  options: AutoRunOptions,
  addFace: AddFace,
): Promise<void> {
  const made = await makeAutoWrinkles(file.parser, faces, options)
  for (const meshes of made?.faces ?? []) {
    const wrinkles = await addFace(meshes, made!)
    meshOf(wrinkles).appear(new Appearance(FADE_IN, wrinkles.clock))
    file.userData.wrinkles.push(wrinkles)
  }
}

/**
 * Generates wrinkles from the blendshapes of a file, in a worker.
 *
 * @param faces meshes of each face.
 * @returns undefined if aborted, or if all skins were disposed of.
 * @throws FurrowError if no mesh has blendshapes and UVs, or the worker fails.
 */
async function makeAutoWrinkles(
  parser: GLTFParser,
  faces: readonly Meshes[],
  options: AutoRunOptions,
): Promise<GeneratedWrinkles | undefined> {
  const skins = groupBySkin(faces.filter((meshes) => meshes.every(supportsAutoWrinkles)))
  if (skins.length === 0) throw missingBlendshapes()
  nameTargets(parser, faces.flat())
  // Reads the pose before the first await: the page may move the scene and its bones afterwards.
  for (const [first] of skins) addFlatNormalMap(first!)
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

/** Wraps the maps, which the worker has packed, in textures. */
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

/** Groups faces by geometry and material: several nodes may share a mesh. */
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

/** Tracks skins until their geometry or material is disposed of. Aborts its signal when none is left. */
class SkinsInUse {
  readonly #left: Set<Meshes[]>
  readonly #unused = new AbortController()
  readonly #unwatch: (() => void)[] = []
  readonly signal: AbortSignal

  constructor(skins: readonly Meshes[][], signal: AbortSignal | undefined) {
    this.#left = new Set(skins)
    this.signal = signal ? AbortSignal.any([signal, this.#unused.signal]) : this.#unused.signal
    for (const skin of skins) {
      const remove = () => {
        this.#left.delete(skin)
        if (this.#left.size === 0) this.#unused.abort()
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

function missingBlendshapes(): FurrowError {
  return new FurrowError({
    who: WHO,
    problem: 'no wrinkles can be made: no mesh has blendshapes and texture coordinates',
    remedy: 'export the face with its blendshapes, or load the file without the option auto',
  })
}
