import { chooseSkin, describeDriverFaults, type FileWrinkles, MOST_TRIANGLES, skinOf } from 'furrow/internal'
import {
  canCrease,
  chooseFaces,
  expressionsOfMesh,
  facesOf,
  materialReader,
  readMeshes,
  readQuantised,
  readsNormalMap,
  surfaceOf,
  wrinkledMaterials,
} from 'furrow/internal/three'
import { namesOfMesh, namesOfTarget, type TargetNames } from 'furrow-files'
import type { Mesh } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'

/** What may be the skin of an avatar: the primitives of one mesh that have one material. */
export interface SkinCandidate {
  /** Of the mesh in the file, with its material where the mesh has several. */
  name: string
  /** The first one drives. */
  meshes: [Mesh, ...Mesh[]]
  /** Names of its mesh and material, as in `wrinkles.json`. */
  target: TargetNames
  /** All names of its mesh; the first is unique in the file. */
  meshNames: [string, ...string[]]
  /** Names of a VRM's expressions that move one blendshape alone, by its index. */
  expressions: ReadonlyMap<number, string>
  triangles: number
  blendshapes: number
  /** Why it cannot wrinkle and what helps; null if it can. */
  fault: string | null
  wrinkles: FileWrinkles | null
}

/**
 * Lists what may be the skin of a file, with the wrinkles that it has.
 *
 * @param onFault is told why wrinkles are left out, a sentence each.
 */
export async function findSkins(gltf: GLTF, onFault: (fault: string) => void): Promise<SkinCandidate[]> {
  const { parser } = gltf
  const read = materialReader(parser, (faults) => onFault(describeDriverFaults(faults)))
  const wrinkled = new Map<Mesh, FileWrinkles>()
  for (const { material, faces } of wrinkledMaterials(gltf, parser)) {
    try {
      const wrinkles = await read(material)
      for (const [mesh] of chooseFaces(faces, wrinkles)) wrinkled.set(mesh, wrinkles)
    } catch (error) {
      onFault(`${(error as Error).message}; the face stays plain`)
    }
  }
  return facesOf(gltf, parser).map((meshes) => {
    const wrinkles = wrinkled.get(meshes[0]) ?? null
    if (!wrinkles) readQuantised(meshes)
    return { ...describe(meshes, gltf), wrinkles }
  })
}

/**
 * Chooses the skin as automatic wrinkles do: of the meshes with blendshapes and texture coordinates, the one on which brows, lids and mouth
 * move the most surface. One with wrinkles comes first; without any blendshape it is the largest.
 *
 * @param skins at least one.
 * @returns its index.
 */
export function indexOfSkin(skins: readonly SkinCandidate[]): number {
  const wrinkled = skins.findIndex(({ wrinkles }) => wrinkles)
  if (wrinkled >= 0) return wrinkled
  const movable = skins.filter(
    ({ meshes, triangles }) => meshes.every(canCrease) && triangles <= MOST_TRIANGLES,
  )
  if (movable.length > 1) {
    const candidates = movable.map(({ meshes, expressions }) => {
      const data = readMeshes(meshes, expressions)
      return { skin: skinOf(data), isLit: data.isLit, label: data.label }
    })
    return skins.indexOf(movable[chooseSkin(candidates)!.index])
  }
  const possible = skins.filter(({ fault }) => fault === null)
  const [largest] = [movable, possible, skins]
    .find((some) => some.length > 0)!
    .toSorted((a, b) => b.triangles - a.triangles)
  return skins.indexOf(largest)
}

/** The skin that a document is of, or else the one that was chosen. */
export function skinOfDocument(
  { skins, skin }: { skins: readonly SkinCandidate[]; skin: number },
  { mesh, material }: TargetNames,
): number {
  if (mesh === undefined && material === undefined) return skin
  const index = skins.findIndex(({ target }) => target.mesh === mesh && target.material === material)
  return index < 0 ? skin : index
}

function describe(meshes: [Mesh, ...Mesh[]], { parser }: GLTF): Omit<SkinCandidate, 'wrinkles'> {
  const [{ name, geometry }] = meshes
  const surface = surfaceOf(meshes[0])
  const index = parser.associations.get(meshes[0])?.meshes
  const mesh = index === undefined ? undefined : parser.json.meshes[index]
  const hasOthers = mesh?.primitives.length > meshes.length
  const triangles = meshes.reduce((sum, { geometry }) => sum + trianglesOf(geometry), 0)
  const material = parser.associations.get(surface)?.materials
  const isFound = material !== undefined && index !== undefined
  const target = isFound ? namesOfTarget(parser.json, { mesh: index, material }) : {}
  const meshNames = index === undefined ? [] : namesOfMesh(parser.json, index)
  return {
    target,
    meshNames: [target.mesh ?? String(index), ...meshNames],
    name: (mesh?.name || name || `mesh ${index}`) + (hasOthers && surface.name ? ` (${surface.name})` : ''),
    meshes,
    expressions: expressionsOfMesh(parser, meshes[0]),
    triangles,
    blendshapes: geometry.morphAttributes.position?.length ?? 0,
    fault: faultOf(meshes, triangles),
  }
}

function trianglesOf({ index, attributes: { position } }: Mesh['geometry']): number {
  return position ? Math.floor((index ?? position).count / 3) : 0
}

function faultOf(meshes: readonly Mesh[], triangles: number): string | null {
  const surface = surfaceOf(meshes[0])
  if (!meshes.every(({ geometry }) => geometry.attributes.uv)) {
    return 'it has no texture coordinates: unwrap it, and export it again'
  }
  if (!meshes.every(({ geometry }) => geometry.attributes.normal)) {
    return 'it has no normals: export it again with normals'
  }
  if (!readsNormalMap(surface)) return `its material is unlit: give it a lit one, and export it again`
  if (triangles > MOST_TRIANGLES) {
    return `it has ${triangles.toLocaleString('en')} triangles, more than ${MOST_TRIANGLES.toLocaleString('en')}: decimate it`
  }
  return null
}
