import type { Document, Mesh } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import { crossOf, faceShapeFinder, type Skin } from 'furrow/author'
import { trianglesOf } from '../gltf/mesh-nodes.ts'
import { didYouMean } from '../nearest.ts'
import { readSkin } from './read-skin.ts'

/** The skin that was chosen: the primitives of one mesh with one material. */
export interface FoundSkin {
  skin: Skin
  /** Indices of the mesh and its material in the file. */
  mesh: number
  material: number
  meshName: string
  materialName: string
  /** Of what the blendshapes move, 0..1; NaN where they move nothing. */
  fraction: number
  /** Why it was chosen, for the user. */
  reason: string
  /** Whether all primitives have tangents. */
  hasTangents: boolean
}

/** Blendshapes of a face that move its skin, not only eyes or teeth. */
const SKIN_SHAPES = [
  'browInnerUp',
  'browDownLeft',
  'browDownRight',
  'eyeBlinkLeft',
  'eyeBlinkRight',
  'mouthSmileLeft',
  'mouthSmileRight',
]

/**
 * Chooses the skin of a file: of all meshes and materials the one whose surface brows, lids and mouth move most. Where
 * no blendshape has such a name, the one that all blendshapes together move most.
 *
 * @param meshName only this mesh, or the mesh of a node of this name; all by default.
 * @param isLit tells whether a material, by its index, can show wrinkles: such a one is preferred where it moves at least half as much.
 * @throws FurrowError when no mesh can wrinkle.
 */
export function findSkin(
  document: Document,
  path: string,
  who: string,
  meshName?: string,
  isLit: (material: number) => boolean = () => true,
): FoundSkin {
  const found = bestSkin(document, meshName, isLit)
  if (found) return found
  const names = document.getRoot().listMeshes().map(labelOf)
  throw new FurrowError({
    code: meshName === undefined ? 'invalid' : 'unknown-name',
    who,
    what:
      meshName === undefined ? `no mesh in ${path} can wrinkle` : `no such mesh in ${path} that can wrinkle`,
    value: meshName,
    limit: 'triangles with texture coordinates and a material',
    remedy:
      meshName === undefined
        ? 'unwrap the face and give it a material'
        : didYouMean(meshName, names, `name one of ${names.join(', ')}`),
  })
}

/** The skin that the blendshapes move more than all others together; undefined where there is none. */
export function mostMovedSkin(document: Document, meshName?: string): FoundSkin | undefined {
  const skin = bestSkin(document, meshName)
  return skin && skin.fraction > 0.5 ? skin : undefined
}

/** As `findSkin`, but undefined where no mesh can wrinkle. */
export function bestSkin(
  document: Document,
  meshName?: string,
  isLit: (material: number) => boolean = () => true,
): FoundSkin | undefined {
  const meshes = document.getRoot().listMeshes()
  const wanted = meshes.flatMap((mesh, index) => (isNamed(mesh, meshName) ? [{ mesh, index }] : []))
  const candidates = wanted.flatMap(({ mesh, index }) => candidatesOf(document, mesh, index))
  const byFace = candidates.map(({ skin }) => movedSurface(skin, faceTargets(skin)))
  const isFace = byFace.some((moved) => moved > 0)
  const moved = isFace ? byFace : candidates.map(({ skin }) => movedSurface(skin, [...skin.targets.keys()]))
  const preferred = moved.map((value, i) => (isLit(candidates[i].material) ? 2 * value : value))
  const index = preferred.indexOf(Math.max(...preferred))
  const best = candidates[index]
  if (!best) return undefined
  const fraction = moved[index] / moved.reduce((a, b) => a + b, 0)
  return { ...best, fraction, reason: reasonOf(isFace, fraction, candidates.length) }
}

function reasonOf(isFace: boolean, fraction: number, count: number): string {
  if (count === 1) return 'the only one with texture coordinates and a material'
  if (!(fraction > 0)) return 'the first one: no blendshape moves any'
  const movers = isFace ? 'brows, lids and mouth' : 'the blendshapes'
  return `${Math.round(100 * fraction)}% of what ${movers} move`
}

/** The possible skins of a mesh: the primitives of each of its materials. */
function candidatesOf(
  document: Document,
  mesh: Mesh,
  index: number,
): Omit<FoundSkin, 'fraction' | 'reason'>[] {
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
        meshName: labelOf(mesh, index),
        materialName: material.getName(),
        hasTangents: primitives.every((primitive) => primitive.getAttribute('TANGENT') !== null),
      },
    ]
  })
}

/** Whether the mesh, or a node of it, has that name; true for no name. */
function isNamed(mesh: Mesh, name: string | undefined): boolean {
  if (name === undefined || mesh.getName() === name) return true
  return mesh.listParents().some((parent) => parent.propertyType === 'Node' && parent.getName() === name)
}

/** Its name, or its index where it has none. */
function labelOf(mesh: Mesh, index: number): string {
  return mesh.getName() || String(index)
}

/** Indices of the targets that move brows, lids and mouth. */
function faceTargets({ targets }: Skin): number[] {
  const find = faceShapeFinder(targets.map(({ name }) => name))
  return [...new Set(SKIN_SHAPES.flatMap(find))]
}

/** The area of each triangle times how far the chosen targets move it, summed. */
function movedSurface({ positions, indices, targets }: Skin, chosen: readonly number[]): number {
  const distances = new Float64Array(positions.length / 3)
  for (const { offsets } of chosen.map((index) => targets[index])) {
    for (let i = 0; i < distances.length; i++) {
      distances[i] += Math.hypot(offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2])
    }
  }
  const normal = new Float64Array(3)
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const distance = distances[indices[t]] + distances[indices[t + 1]] + distances[indices[t + 2]]
    const area = crossOf(positions, indices[t], indices[t + 1], indices[t + 2], normal) / 2
    if (distance > 0 && area > 0) sum += distance * area
  }
  return sum
}
