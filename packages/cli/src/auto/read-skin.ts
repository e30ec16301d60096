import type { Document, Mesh, Primitive } from '@gltf-transform/core'
import { FurrowError, findTargets } from 'furrow'
import type { Skin } from 'furrow/author'
import { trianglesOf } from '../face.ts'

/** The skin that was chosen: the primitives of one mesh that wear one material. */
export interface FoundSkin {
  skin: Skin
  /** Indices of the mesh and of its material in the file. */
  mesh: number
  material: number
  meshName: string
  materialName: string
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
 * Chooses what wrinkles: of all meshes and materials the one of whose surface brows, lids and mouth move most.
 *
 * @param meshName only this mesh, or that of a node of this name.
 * @throws FurrowError when there is none.
 */
export function findSkin(document: Document, path: string, who: string, meshName?: string): FoundSkin {
  const root = document.getRoot()
  const meshes = root.listMeshes()
  const wanted = meshes.flatMap((mesh, index) => (isNamed(mesh, meshName) ? [{ mesh, index }] : []))
  const candidates = wanted.flatMap(({ mesh, index }) => {
    const materials = new Set(trianglesOf(mesh).map((primitive) => primitive.getMaterial()))
    return [...materials].flatMap((material) => {
      if (!material) return []
      const primitives = trianglesOf(mesh).filter((primitive) => primitive.getMaterial() === material)
      const skin = readSkin(mesh, primitives)
      const hasTangents = primitives.every((primitive) => primitive.getAttribute('TANGENT') !== null)
      const names = { meshName: nameOf(mesh, index), materialName: material.getName() }
      return [{ skin, mesh: index, material: root.listMaterials().indexOf(material), hasTangents, ...names }]
    })
  })
  const scored = candidates.map((candidate) => ({ candidate, moved: movedSurface(candidate.skin) }))
  const best = scored.reduce((a, b) => (b.moved > a.moved ? b : a), { candidate: candidates[0], moved: -1 })
  if (best.candidate) return best.candidate
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

function isNamed(mesh: Mesh, name: string | undefined): boolean {
  if (name === undefined || mesh.getName() === name) return true
  return mesh.listParents().some((parent) => parent.propertyType === 'Node' && parent.getName() === name)
}

function nameOf(mesh: Mesh, index: number): string {
  return mesh.getName() || String(index)
}

function readSkin(mesh: Mesh, primitives: readonly Primitive[]): Skin {
  const names = targetNames(mesh, primitives)
  const counts = primitives.map((primitive) => primitive.getAttribute('POSITION')!.getCount())
  const total = counts.reduce((a, b) => a + b, 0)
  const positions = new Float32Array(3 * total)
  const uvs = new Float32Array(2 * total)
  const offsets = names.map(() => new Float32Array(3 * total))
  const indices: number[] = []
  let first = 0
  for (const [i, primitive] of primitives.entries()) {
    copyInto(positions, primitive.getAttribute('POSITION')!, 3, first)
    copyInto(uvs, primitive.getAttribute('TEXCOORD_0')!, 2, first)
    for (const [k, target] of primitive.listTargets().entries()) {
      const moved = target.getAttribute('POSITION')
      if (moved && offsets[k]) copyInto(offsets[k], moved, 3, first)
    }
    const index = primitive.getIndices()
    for (let k = 0; k < (index?.getCount() ?? counts[i]!); k++)
      indices.push(first + (index?.getScalar(k) ?? k))
    first += counts[i]!
  }
  return {
    positions,
    uvs,
    indices: Uint32Array.from(indices),
    targets: names.map((name, k) => ({ name, offsets: offsets[k]! })),
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
function copyInto(
  out: Float32Array,
  accessor: NonNullable<ReturnType<Primitive['getAttribute']>>,
  size: number,
  first: number,
): void {
  const element: number[] = []
  for (let i = 0; i < accessor.getCount(); i++) {
    accessor.getElement(i, element)
    for (let k = 0; k < size; k++) out[size * (first + i) + k] = element[k]!
  }
}

/** How many vertices brows, lids and mouth move. */
function movedSurface({ targets }: Skin): number {
  const names = targets.map(({ name }) => name)
  let sum = 0
  for (const index of TELLING.flatMap((name) => findTargets(name, names))) {
    const { offsets } = targets[index]!
    for (let i = 0; i < offsets.length; i += 3) if (offsets[i] || offsets[i + 1] || offsets[i + 2]) sum++
  }
  return sum
}
