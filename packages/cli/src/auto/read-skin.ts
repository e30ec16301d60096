import type { Accessor, Document, Material, Mesh, mat4, Node, Primitive } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import { crossOf, faceShapeFinder, type Skin } from 'furrow/author'
import { placementOf, trianglesOf } from '../face.ts'
import { readCoordinates } from './coordinates.ts'

/** The skin that was chosen: the primitives of one mesh that wear one material. */
export interface FoundSkin {
  skin: Skin
  /** Indices of the mesh and of its material in the file. */
  mesh: number
  material: number
  meshName: string
  materialName: string
  /** Why it was chosen, in a few words. */
  reason: string
  /** Whether all primitives bring tangents of their own. */
  hasTangents: boolean
}

/** Shapes that move skin, and neither eyes nor teeth alone. */
const TELLING = [
  'browInnerUp',
  'browDownLeft',
  'browDownRight',
  'eyeBlinkLeft',
  'eyeBlinkRight',
  'mouthSmileLeft',
  'mouthSmileRight',
]

/**
 * Chooses what wrinkles: of all meshes and materials the one of whose surface brows, lids and mouth move most; where no shape has
 * such a name, the one that all shapes together move most.
 *
 * @param meshName only this mesh, or that of a node of this name.
 * @throws FurrowError when there is none.
 */
export function findSkin(document: Document, path: string, who: string, meshName?: string): FoundSkin {
  const meshes = document.getRoot().listMeshes()
  const wanted = meshes.flatMap((mesh, index) => (isNamed(mesh, meshName) ? [{ mesh, index }] : []))
  const candidates = wanted.flatMap(({ mesh, index }) => candidatesOf(document, mesh, index))
  const byFace = candidates.map(({ skin }) => movedSurface(skin, tellingTargets(skin)))
  const isFace = byFace.some((moved) => moved > 0)
  const moved = isFace ? byFace : candidates.map(({ skin }) => movedSurface(skin, [...skin.targets.keys()]))
  const best = candidates[moved.indexOf(Math.max(...moved))]
  if (best) {
    const share = Math.max(...moved) / moved.reduce((a, b) => a + b, 0)
    return { ...best, reason: reasonOf(isFace, share, candidates.length) }
  }
  throw new FurrowError({
    who,
    what:
      meshName === undefined ? `no mesh in ${path} can wrinkle` : `no such mesh in ${path} that can wrinkle`,
    value: meshName,
    limit: 'triangles with texture coordinates and a material',
    remedy:
      meshName === undefined
        ? 'unwrap the face and give it a material'
        : `name one of ${meshes.map(nameOf).join(', ')}`,
  })
}

function reasonOf(isFace: boolean, share: number, count: number): string {
  if (count === 1) return 'no other has triangles with texture coordinates and a material'
  if (!(share > 0)) return 'the first one: no blendshape moves any'
  const movers = isFace ? 'brows, lids and mouth' : 'the blendshapes'
  return `${Math.round(100 * share)}% of what ${movers} move`
}

/** The skins of a mesh: the primitives of each of its materials. */
function candidatesOf(document: Document, mesh: Mesh, index: number): Omit<FoundSkin, 'reason'>[] {
  const triangles = trianglesOf(mesh)
  const materials = [...new Set(triangles.map((primitive) => primitive.getMaterial()))]
  return materials.flatMap((material) => {
    if (!material) return []
    const primitives = triangles.filter((primitive) => primitive.getMaterial() === material)
    return [
      {
        skin: readSkin(mesh, primitives, material),
        mesh: index,
        material: document.getRoot().listMaterials().indexOf(material),
        meshName: nameOf(mesh, index),
        materialName: material.getName(),
        hasTangents: primitives.every((primitive) => primitive.getAttribute('TANGENT') !== null),
      },
    ]
  })
}

function isNamed(mesh: Mesh, name: string | undefined): boolean {
  if (name === undefined || mesh.getName() === name) return true
  return mesh.listParents().some((parent) => parent.propertyType === 'Node' && parent.getName() === name)
}

function nameOf(mesh: Mesh, index: number): string {
  return mesh.getName() || String(index)
}

/** As its first node or skeleton places it, in metres. Vertices that no triangle uses are left out: primitives often share all of them. */
function readSkin(mesh: Mesh, primitives: readonly Primitive[], material: Material): Skin {
  const names = targetNames(mesh, primitives)
  const parts = primitives.map((primitive) => ({ primitive, ...usedVertices(primitive) }))
  const total = parts.reduce((sum, { used }) => sum + used.length, 0)
  const positions = new Float32Array(3 * total)
  const uvs = new Float32Array(2 * total)
  const offsets = names.map(() => new Float32Array(3 * total))
  const indices = new Uint32Array(parts.reduce((sum, { corners }) => sum + corners.length, 0))
  let [first, corner] = [0, 0]
  for (const { primitive, used, corners } of parts) {
    copyInto(positions, primitive.getAttribute('POSITION')!, used, first)
    readCoordinates(primitive, material, used, uvs.subarray(2 * first))
    for (const [k, target] of primitive.listTargets().entries()) {
      const moved = target.getAttribute('POSITION')
      if (moved && offsets[k]) copyInto(offsets[k], moved, used, first)
    }
    for (const vertex of corners) indices[corner++] = first + vertex
    first += used.length
  }
  const placement = placementOfMesh(mesh)
  if (placement) {
    place(positions, placement, 1)
    for (const offset of offsets) place(offset, placement, 0)
  }
  return { positions, uvs, indices, targets: names.map((name, k) => ({ name, offsets: offsets[k] })) }
}

/** Stands for a corner that is no vertex: the skin is refused for it later. */
const NOWHERE = 2 ** 31

/** Vertices that triangles use, in their order, and each triangle's corners as indices into them. */
function usedVertices(primitive: Primitive): { used: Uint32Array; corners: Uint32Array } {
  const index = primitive.getIndices()
  const count = primitive.getAttribute('POSITION')!.getCount()
  const corners = Uint32Array.from({ length: index?.getCount() ?? count }, (_, k) => index?.getScalar(k) ?? k)
  const isUsed = new Uint8Array(count)
  for (const vertex of corners) isUsed[vertex] = 1
  const used = Uint32Array.from({ length: count }, (_, i) => i).filter((i) => isUsed[i] === 1)
  const placeOf = new Uint32Array(count)
  for (const [place, vertex] of used.entries()) placeOf[vertex] = place
  return { used, corners: corners.map((vertex) => placeOf[vertex] ?? NOWHERE) }
}

/** undefined where it is where its numbers say. */
function placementOfMesh(mesh: Mesh): mat4 | undefined {
  const node = mesh.listParents().find((parent) => parent.propertyType === 'Node') as Node | undefined
  const placement = node && placementOf(node)
  return placement?.every((value, i) => value === (i % 5 === 0 ? 1 : 0)) ? undefined : placement
}

/** @param isPlace 0 for ways, which are turned and scaled but not moved. */
function place(values: Float32Array, placement: mat4, isPlace: 0 | 1): void {
  for (let i = 0; i < values.length; i += 3) {
    const [x, y, z] = [values[i], values[i + 1], values[i + 2]]
    for (let k = 0; k < 3; k++) {
      const moved = placement[k] * x + placement[4 + k] * y + placement[8 + k] * z
      values[i + k] = moved + isPlace * placement[12 + k]
    }
  }
}

/** As `mesh.extras.targetNames` says; their numbers where it does not. */
function targetNames(mesh: Mesh, primitives: readonly Primitive[]): string[] {
  const count = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length))
  const { targetNames: names } = mesh.getExtras()
  return Array.from({ length: count }, (_, i) =>
    String(Array.isArray(names) && names.length === count ? names[i] : i),
  )
}

/** Quantised or not. */
function copyInto(out: Float32Array, accessor: Accessor, used: Uint32Array, first: number): void {
  const element: number[] = []
  for (const [i, vertex] of used.entries()) {
    accessor.getElement(vertex, element)
    for (let k = 0; k < 3; k++) out[3 * (first + i) + k] = element[k]
  }
}

/** Targets of brows, lids and mouth. */
function tellingTargets({ targets }: Skin): number[] {
  const find = faceShapeFinder(targets.map(({ name }) => name))
  return [...new Set(TELLING.flatMap(find))]
}

/** How much surface some targets move, times how far. */
function movedSurface({ positions, indices, targets }: Skin, chosen: readonly number[]): number {
  const ways = new Float64Array(positions.length / 3)
  for (const { offsets } of chosen.map((index) => targets[index])) {
    for (let i = 0; i < ways.length; i++)
      ways[i] += Math.hypot(offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2])
  }
  const normal = new Float64Array(3)
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const way = ways[indices[t]] + ways[indices[t + 1]] + ways[indices[t + 2]]
    const area = crossOf(positions, indices[t], indices[t + 1], indices[t + 2], normal) / 2
    if (way > 0 && area > 0) sum += way * area
  }
  return sum
}
