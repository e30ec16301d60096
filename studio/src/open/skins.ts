import type { SkinJoint } from 'furrow/author'
import {
  chooseSkin,
  describeDriverErrors,
  type FileWrinkles,
  MAX_SKIN_TRIANGLES,
  skinOf,
} from 'furrow/internal'
import {
  addFlatNormalMap,
  animatedRotations,
  chooseFaces,
  expressionsOfMesh,
  facesOf,
  materialReader,
  placementOf,
  readMeshes,
  readsNormalMap,
  supportsAutoWrinkles,
  surfaceInFile,
  surfaceOf,
  wrinkledMaterials,
} from 'furrow/internal/three'
import { namesOfMesh, namesOfTarget, type TargetNames } from 'furrow-files'
import type { Mesh } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import { type JointReader, jointReader } from './rest-skeleton.ts'
import { type JudgedSurface, judgeSurface } from './surface.ts'

/** Candidate for the skin of an avatar: the primitives of one mesh with one material. */
export interface SkinCandidate {
  /** Mesh name in the file, followed by the material's name if the mesh has several materials. */
  name: string
  /** One three.js mesh for each primitive. Drivers read the blendshapes of the first one. */
  meshes: [Mesh, ...Mesh[]]
  /** Names of the skin's mesh and material, as in `wrinkles.json`. */
  target: TargetNames
  /** All names of the skin's mesh. The first one is unique in the file. */
  meshNames: [string, ...string[]]
  /** Names of the VRM expressions that consist of a single blendshape. The keys are indices of blendshapes. */
  expressions: ReadonlyMap<number, string>
  triangles: number
  blendshapes: number
  /** Reason why the skin cannot wrinkle, with a remedy, or null. */
  problem: string | null
  surface: JudgedSurface
  rest: RestPose
  wrinkles: FileWrinkles | null
}

/** Rest pose of a skin. */
export interface RestPose {
  /** Column-major 4 x 4 matrix from the mesh to world space. */
  placement: readonly number[]
  /** Joints that move the skin, in world space. */
  joints: readonly SkinJoint[] | undefined
}

/**
 * Lists skin candidates of a file with their wrinkles.
 *
 * @param onProblem receives a sentence for each part of the wrinkles that is skipped as invalid.
 */
export async function findSkins(gltf: GLTF, onProblem: (problem: string) => void): Promise<SkinCandidate[]> {
  const { parser } = gltf
  const read = materialReader(parser, (faults) => onProblem(describeDriverErrors(faults)))
  const wrinkled = new Map<Mesh, FileWrinkles>()
  for (const { material, faces } of wrinkledMaterials(gltf, parser)) {
    try {
      const wrinkles = await read(material)
      for (const [mesh] of chooseFaces(faces, wrinkles)) wrinkled.set(mesh, wrinkles)
    } catch (error) {
      onProblem(`${(error as Error).message}; the face is shown without wrinkles`)
    }
  }
  const joints = jointReader(parser, await animatedRotations(parser))
  return facesOf(gltf, parser).map((meshes) => {
    const wrinkles = wrinkled.get(meshes[0]) ?? null
    if (!wrinkles) addFlatNormalMap(meshes)
    return { ...describe(meshes, gltf, joints), wrinkles }
  })
}

/**
 * Chooses the skin of an avatar: the first candidate that has wrinkles. Otherwise, of those with blendshapes and not too many triangles, the one
 * that blendshapes move most, as `furrow auto` does. If there is none, chooses the candidate with the most triangles: if possible skin or
 * cloth that joints move, and one without a `problem`.
 *
 * @param skins at least one.
 * @returns index of the skin.
 */
export function indexOfSkin(skins: readonly SkinCandidate[]): number {
  const wrinkled = skins.findIndex(({ wrinkles }) => wrinkles)
  if (wrinkled >= 0) return wrinkled
  const movable = skins.filter(
    ({ meshes, triangles }) => meshes.every(supportsAutoWrinkles) && triangles <= MAX_SKIN_TRIANGLES,
  )
  if (movable.length > 1) {
    const candidates = movable.map(({ meshes, expressions }) => {
      const data = readMeshes(meshes, expressions)
      return { skin: skinOf(data), isLit: data.isLit, label: data.label }
    })
    return skins.indexOf(movable[chooseSkin(candidates)!.index])
  }
  const possible = skins.filter(({ problem }) => problem === null)
  const folded = possible.filter(({ rest }) => rest.joints)
  const ofKind = (kind: JudgedSurface['kind']) => folded.filter(({ surface }) => surface.kind === kind)
  const [largest] = [movable, ofKind('skin'), ofKind('cloth'), ofKind(undefined), possible, skins]
    .find((some) => some.length > 0)!
    .toSorted((a, b) => b.triangles - a.triangles)
  return skins.indexOf(largest)
}

/** Returns the index of the skin that a document names, or `skin` if the avatar has no such skin. */
export function skinOfDocument(
  { skins, skin }: { skins: readonly SkinCandidate[]; skin: number },
  { mesh, material }: TargetNames,
): number {
  if (mesh === undefined && material === undefined) return skin
  const index = skins.findIndex(({ target }) => target.mesh === mesh && target.material === material)
  return index < 0 ? skin : index
}

function describe(
  meshes: [Mesh, ...Mesh[]],
  { parser }: GLTF,
  joints: JointReader,
): Omit<SkinCandidate, 'wrinkles'> {
  const [{ name, geometry }] = meshes
  const shown = surfaceOf(meshes[0])
  const index = parser.associations.get(meshes[0])?.meshes
  const mesh = index === undefined ? undefined : parser.json.meshes[index]
  const hasOthers = mesh?.primitives.length > meshes.length
  const triangles = meshes.reduce((sum, { geometry }) => sum + trianglesOf(geometry), 0)
  const material = parser.associations.get(shown)?.materials
  const isFound = material !== undefined && index !== undefined
  const target = isFound ? namesOfTarget(parser.json, { mesh: index, material }) : {}
  const meshNames = index === undefined ? [] : namesOfMesh(parser.json, index)
  return {
    target,
    meshNames: [target.mesh ?? String(index), ...meshNames],
    name: (mesh?.name || name || `mesh ${index}`) + (hasOthers && shown.name ? ` (${shown.name})` : ''),
    meshes,
    expressions: expressionsOfMesh(parser, meshes[0]),
    triangles,
    blendshapes: geometry.morphAttributes.position?.length ?? 0,
    problem: problemOf(meshes, triangles),
    surface: judgeSurface(surfaceInFile(parser, meshes[0])),
    rest: { placement: placementOf(meshes[0]).toArray(), joints: joints(meshes[0]) },
  }
}

function trianglesOf({ index, attributes: { position } }: Mesh['geometry']): number {
  return position ? Math.floor((index ?? position).count / 3) : 0
}

function problemOf(meshes: readonly Mesh[], triangles: number): string | null {
  if (!meshes.every(({ geometry }) => geometry.attributes.uv)) {
    return 'it has no texture coordinates: unwrap it, and export it again'
  }
  if (!meshes.every(({ geometry }) => geometry.attributes.normal)) {
    return 'it has no normals: export it again with normals'
  }
  if (!readsNormalMap(surfaceOf(meshes[0])))
    return `its material is unlit: give it a lit one, and export it again`
  if (triangles > MAX_SKIN_TRIANGLES) {
    return `it has ${triangles.toLocaleString('en')} triangles, more than ${MAX_SKIN_TRIANGLES.toLocaleString('en')}: decimate it`
  }
  return null
}
