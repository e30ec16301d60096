import type { Mesh } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { CharacterMesh } from '../../auto/character.ts'
import type { MeshWrinkles } from '../../auto/make-wrinkles.ts'
import { LOADER, nothingToWrinkle } from '../../auto/no-wrinkles.ts'
import type { AutoCharacterOptions } from '../../auto/run-options.ts'
import { runWorker } from '../../auto/run-worker.ts'
import { skinJoints } from '../../auto/skeleton-json.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { FileWrinkles } from '../../runtime/file/read-wrinkles.ts'
import type { Warnings } from '../../runtime/file/warnings.ts'
import { Appearance } from '../appearance.ts'
import { surfaceOf } from '../material/surface.ts'
import { mapTexture } from '../material/textures.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'
import { animatedRotations, type BoundSkin, readBoundSkin, surfaceInFile } from './file-surface.ts'
import { expressionsOfMesh, nameTargets } from './file-targets.ts'
import {
  addFlatNormalMap,
  readMeshes,
  supportsAutoWrinkles,
  supportsJointWrinkles,
} from './read-character.ts'
import { separateOthers } from './read-wrinkle-maps.ts'

type Meshes = [Mesh, ...Mesh[]]

export type AddFace = (meshes: Meshes, made: FileWrinkles) => Promise<WrinklesBase>

/** Duration of the fade-in, milliseconds. */
const FADE_IN = 300

/** Result of the generation for the previous file. Files are processed one at a time, because each occupies a CPU core and hundreds of megabytes. */
let previous: Promise<unknown> = Promise.resolve()

/**
 * Starts generating wrinkles in a worker from the blendshapes and joints of a file. Reads the current pose before it returns.
 *
 * @param file loaded file. The wrinkles of each mesh are added to `userData.wrinkles` when they are ready. `userData.wrinklesReady` is set to a
 *   promise that resolves after the last mesh.
 * @param faces meshes of each face, see `facesOf`.
 */
export function beginAuto(
  file: GLTF,
  faces: readonly Meshes[],
  options: AutoCharacterOptions,
  addFace: AddFace,
  warnings: Warnings,
): void {
  file.userData.wrinklesReady = addAutoWrinkles(file, faces, options, addFace, warnings).catch((error) =>
    warnings.add(error, consequenceFor(file)),
  )
}

function consequenceFor({ userData }: GLTF, what = 'some meshes are'): string {
  return `${userData.wrinkles.length > 0 ? what : 'the file is'} shown without wrinkles`
}

/**
 * Generates wrinkles in a worker for the surfaces of a file. A surface is a geometry and a material, which several faces may use. Adds the
 * wrinkles of each surface when they are ready, unless generation was aborted, or the geometry or material of the surface was disposed of.
 *
 * @throws FurrowError if no mesh has UVs and blendshapes or joints, or the worker fails.
 */
async function addAutoWrinkles(
  file: GLTF,
  faces: readonly Meshes[],
  { kinds = {}, ...options }: AutoCharacterOptions,
  addFace: AddFace,
  warnings: Warnings,
): Promise<void> {
  const { parser } = file
  const isUsable = (meshes: Meshes) =>
    meshes.every(supportsAutoWrinkles) || meshes.every(supportsJointWrinkles)
  const skins = groupBySkin(faces.filter(isUsable))
  if (skins.length === 0) throw nothingToWrinkle()
  nameTargets(parser, faces.flat())
  // The pose is read before the first `await`, because during an `await` the page may move the scene and its bones.
  for (const [first] of skins) addFlatNormalMap(first!)
  const read = skins.map(([first]) => readSurface(parser, first!))
  const inUse = new SkinsInUse(skins, options.signal)
  const { signal } = inUse
  const failures: { error: unknown; name: string }[] = []
  const add = async (part: MeshWrinkles) => {
    const skin = skins[part.mesh]!
    if (!inUse.has(skin)) return
    try {
      separateMeshes(skin, faces)
      await addToFaces(file, skin, setOf(part), addFace)
    } catch (error) {
      failures.push({ error, name: read[part.mesh].mesh.meshName })
    }
  }
  let adding: Promise<void> = Promise.resolve()
  const received = (part: MeshWrinkles) => {
    adding = adding.then(() => add(part))
  }
  const run = async () => {
    if (signal.aborted) return []
    const meshes = await withJoints(parser, read)
    const character = { meshes, kinds }
    return runWorker({ type: 'character', character }, { ...options, signal }, [], LOADER, received)
  }
  try {
    const made = previous.then(run, run)
    previous = made
    const notes = await made
    for (const note of notes) warnings.addText(`${LOADER}: ${note}`)
  } catch (error) {
    if (!signal.aborted) throw error
  } finally {
    await adding
    inUse.end()
    for (const { error, name } of failures)
      warnings.add(error, consequenceFor(file, `mesh ${JSON.stringify(name)} is`))
  }
}

/** Replaces the material of a skin on other meshes, which may use it with other texture coordinates. */
function separateMeshes(skin: readonly Meshes[], faces: readonly Meshes[]): void {
  const surface = surfaceOf(skin[0][0])
  const others = faces.filter((face) => !skin.includes(face)).flat()
  separateOthers(
    others.filter((mesh) => surfaceOf(mesh) === surface),
    surface,
  )
}

async function addToFaces(
  file: GLTF,
  faces: readonly Meshes[],
  made: FileWrinkles,
  addFace: AddFace,
): Promise<void> {
  for (const meshes of faces) {
    const wrinkles = await addFace(meshes, made)
    meshOf(wrinkles).appear(new Appearance(FADE_IN, wrinkles.clock))
    file.userData.wrinkles.push(wrinkles)
  }
}

interface ReadSurface {
  mesh: CharacterMesh
  bound: BoundSkin | undefined
}

function readSurface(parser: GLTFParser, meshes: Meshes): ReadSurface {
  const [first] = meshes
  const data = readMeshes(meshes, expressionsOfMesh(parser, first))
  return {
    mesh: { ...data, ...surfaceInFile(parser, first) },
    bound: meshes.every(supportsJointWrinkles) ? readBoundSkin(parser, first) : undefined,
  }
}

/** Adds joints, with the rotations that animations of the file give them. */
async function withJoints(parser: GLTFParser, read: readonly ReadSurface[]): Promise<CharacterMesh[]> {
  const hasJoints = read.some(({ bound }) => bound)
  const rotations = hasJoints ? await animatedRotations(parser) : new Map<number, number[][]>()
  return read.map(({ mesh, bound }) => ({
    ...mesh,
    joints: bound && skinJoints(parser.json, bound.skin, bound.binds, rotations),
  }))
}

/** Creates textures from the maps that the worker has packed. */
function setOf(made: MeshWrinkles): FileWrinkles {
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
