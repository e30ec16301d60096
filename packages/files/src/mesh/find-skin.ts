import type { Document, Material, Mesh } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import type { ClothKind, Skin } from 'furrow/author'
import {
  chooseSkin,
  correctSkin,
  didYouMean,
  FACE_MOVERS,
  limbsOf,
  type SkinChoice,
  soleExpressions,
} from 'furrow/internal'
import { sourceOf } from '../gltf/document.ts'
import { correctionsIn } from '../json/corrections.ts'
import { namesOfMesh, type Target } from '../json/target-names.ts'
import { trianglesOf } from './mesh-nodes.ts'
import { type JointReader, jointReader } from './read-skeleton.ts'
import { readSkin } from './read-skin.ts'

/** The surface that gets wrinkles: the primitives of one mesh that share a material. */
export interface FoundSkin {
  skin: Skin
  /** Index of the mesh in the file. */
  mesh: number
  /** Index of the material in the file. */
  material: number
  /** Name of the mesh, or its index if it has none. */
  meshName: string
  /** Name of the material, or its index if it has none. */
  materialName: string
  /** Motion of this surface as a fraction of that of all surfaces (see `chooseSkin`), 0..1. NaN if nothing moves. */
  fraction: number
  /** Reason for the choice, in words for the user. */
  reason: string
  /** Whether blendshapes of brows, lids and mouth move the surface. */
  isFace?: boolean
  hasTangents: boolean
  /** Whether the joints of chains fold the surface, see `AutoOptions`. */
  tubes?: boolean
  /** Kind of cloth; undefined if the surface is skin. */
  cloth?: ClothKind
}

/** Surface that could get wrinkles. */
type Candidate = Omit<FoundSkin, 'fraction' | 'reason'>

/** Surface with the limbs that its joints move. */
export interface LimbSurface extends FoundSkin {
  /** Nouns for messages, see `LimbJoints`. */
  limbs: readonly string[]
  /** Names of the joints of each limb. */
  limbJoints: readonly (readonly string[])[]
}

/** Lists all surfaces that could get wrinkles. */
export function allSurfaces(document: Document, meshName?: string): LimbSurface[] {
  return candidatesIn(document, meshName).map((candidate) => {
    const found = limbsOf(candidate.skin)
    const [limbs, limbJoints] = [found.map(({ limb }) => limb), found.map(({ joints }) => joints)]
    const reason =
      limbs.length > 0 ? `joints move it: ${limbs.join(', ')}` : 'no joints of a humanoid move it'
    return { ...candidate, limbs, limbJoints, fraction: Number.NaN, reason }
  })
}

/**
 * Chooses the surface that gets wrinkles, among all meshes and materials of a file. See `chooseSkin`.
 *
 * @param meshName name of a mesh or its node. Only this mesh is considered. Default: all meshes.
 * @param isLit returns whether the given material can show wrinkles. In the choice, the motion of a
 *   surface with such a material counts twice.
 * @throws FurrowError if no mesh can have wrinkles.
 */
export function findSkin(
  document: Document,
  path: string,
  who: string,
  meshName?: string,
  isLit: (material: number) => boolean = () => true,
): FoundSkin {
  const found = bestSkin(candidatesIn(document, meshName), isLit)
  if (found) return found
  const names = document.getRoot().listMeshes().map(labelOf)
  throw new FurrowError({
    code: meshName === undefined ? 'invalid' : 'unknown-name',
    who,
    problem:
      meshName === undefined ? `no mesh in ${path} can wrinkle` : `no such mesh in ${path} that can wrinkle`,
    value: meshName,
    limit: 'triangles with texture coordinates and a material',
    remedy:
      meshName === undefined
        ? 'unwrap the face and give it a material'
        : didYouMean(meshName, names, `name one of ${names.join(', ')}`),
  })
}

/** Chooses like `bestSkin`, but returns undefined if the surface has at most half of the motion of all surfaces. */
export function mostMovedSkin(document: Document, meshName?: string): FoundSkin | undefined {
  const skin = bestSkin(candidatesIn(document, meshName))
  return skin && skin.fraction > 0.5 ? skin : undefined
}

/** Chooses like `findSkin` among surfaces that were read. Returns undefined if there are none. */
export function bestSkin<T extends Candidate>(
  candidates: readonly T[],
  isLit: (material: number) => boolean = () => true,
): (T & FoundSkin) | undefined {
  const choice = chooseSkin(
    candidates.map(({ skin, material, meshName, materialName }) => ({
      skin,
      isLit: isLit(material),
      label: `${meshName} ${materialName}`,
    })),
  )
  return choice && chosenSkin(candidates, choice)
}

/** Describes the skin that `chooseSkin` chose among surfaces. */
export function chosenSkin<T extends Candidate>(candidates: readonly T[], choice: SkinChoice): T & FoundSkin {
  const { index, fraction, movers } = choice
  const isFace = fraction > 0 && movers === FACE_MOVERS
  return { ...candidates[index], fraction, isFace, reason: reasonOf(choice, candidates.length) }
}

/** Returns the surface of a mesh and material, or undefined if it has no triangles with texture coordinates. */
export function skinOfTarget(document: Document, { mesh: index, material }: Target): Skin | undefined {
  const mesh = document.getRoot().listMeshes()[index]
  const candidates = candidatesOf(document, mesh, index, jointReader(document))
  return candidates.find((candidate) => candidate.material === material)?.skin
}

function reasonOf({ fraction, movers }: SkinChoice, count: number): string {
  if (count === 1) return 'the only surface with texture coordinates and a material'
  if (!(fraction > 0)) return 'the first surface, because blendshapes move none of them'
  return `${Math.round(100 * fraction)}% of the motion of ${movers}`
}

/** Lists the surfaces of a file that could get wrinkles. If `meshName` is given, only those of this mesh. */
function candidatesIn(document: Document, meshName: string | undefined): Candidate[] {
  const joints = jointReader(document)
  const meshes = document.getRoot().listMeshes()
  return meshes.flatMap((mesh, index) =>
    isNamed(mesh, meshName) ? candidatesOf(document, mesh, index, joints) : [],
  )
}

/** Lists the surfaces of a mesh that could get wrinkles, one per material. */
function candidatesOf(document: Document, mesh: Mesh, index: number, joints: JointReader): Candidate[] {
  const triangles = trianglesOf(mesh)
  const materials = [...new Set(triangles.map((primitive) => primitive.getMaterial()))]
  const json = sourceOf(document)
  const expressions = soleExpressions(json, index)
  return materials.flatMap((material) => {
    if (!material) return []
    const primitives = triangles.filter((primitive) => primitive.getMaterial() === material)
    const materialIndex = document.getRoot().listMaterials().indexOf(material)
    const { corrections } = correctionsIn(json, materialIndex, 'furrow')
    const skin = readSkin(mesh, primitives, material, expressions, joints)
    return [
      {
        skin: correctSkin(skin, corrections, namesOfMesh(json, index)),
        mesh: index,
        material: materialIndex,
        meshName: labelOf(mesh, index),
        materialName: labelOf(material, materialIndex),
        hasTangents: primitives.every((primitive) => primitive.getAttribute('TANGENT') !== null),
      },
    ]
  })
}

/** Returns whether the mesh or one of its nodes has this name. Returns true if `name` is undefined. */
function isNamed(mesh: Mesh, name: string | undefined): boolean {
  if (name === undefined || mesh.getName() === name) return true
  return mesh.listParents().some((parent) => parent.propertyType === 'Node' && parent.getName() === name)
}

/** Returns the name of a mesh or material, or its index if it has no name. */
function labelOf(named: Mesh | Material, index: number): string {
  return named.getName() || String(index)
}
