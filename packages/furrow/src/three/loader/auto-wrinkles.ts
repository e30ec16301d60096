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

export type AddFace = (meshes: Meshes, made: FileWrinkles) => Promise<WrinklesBase>

/** Duration of the fade-in, milliseconds. */
const FADE_IN = 300

interface GeneratedWrinkles extends FileWrinkles {
  /** Faces that get the wrinkles. They have the same geometry and material. */
  faces: Meshes[]
}

/** Result of the generation for the previous file. Files are processed one at a time, because each occupies a CPU core and hundreds of megabytes. */
let previous: Promise<unknown> = Promise.resolve()

/**
 * Starts generating wrinkles in a worker from the blendshapes of a file. Reads the current pose before it returns.
 *
 * @param file loaded file. The wrinkles are added to `userData.wrinkles`. `userData.wrinklesReady` is set to a promise that resolves
 *   afterwards.
 * @param faces meshes of each face.
 */
export function beginAuto(
  file: GLTF,
  faces: readonly Meshes[],
  options: AutoRunOptions,
  addFace: AddFace,
  warnings: Warnings,
): void {
  file.userData.wrinklesReady = addAutoWrinkles(file, faces, options, addFace).catch((error) =>
    warnings.add(error, 'the file is shown without wrinkles'),
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
 * Generates wrinkles in a worker for the most suitable skin of a file. A skin is a geometry and a material, which several faces may use.
 *
 * @param faces meshes of each face.
 * @returns undefined if generation was aborted, or if the geometry or material of the skin was disposed of.
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
  // The pose is read before the first `await`, because during an `await` the page may move the scene and its bones.
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

/** Creates textures from the maps that the worker has packed. */
function setOf(made: CharacterWrinkles): FileWrinkles {
  const { layers, normals, values, hasOnset, bloodAmplitude, heights, areas, drivers } = made
  const normalArray = mapTexture(normals, 1)
  const valueArray = mapTexture(values, 1)
  const set: WrinkleSet<ArraySlice> = {
    layers: layers.map((name, slice) => ({
      name,
      kind: 'detail',
      normal: { array: normalArray, slice, channel: 0 },
      occlusion: { array: valueArray, slice, channel: 0 },
      blood: { array: valueArray, slice, channel: 1 },
      ...(hasOnset[slice] && { onset: { array: valueArray, slice, channel: 2 } }),
      bloodAmplitude,
      ...heights[slice],
    })),
    areas,
  }
  return { set, drivers }
}

const WHO = 'WrinkleLoaderPlugin'

/** Groups faces with the same geometry and material, because several nodes of a file may use one mesh. */
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

/** Tracks which skins still have their geometry and material. When all skins are disposed of, `signal` aborts. */
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
