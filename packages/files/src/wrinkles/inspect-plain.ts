import type { Document } from '@gltf-transform/core'
import { foldsLimb, isFoldedAs, judgeKind, type SurfaceKind } from 'furrow/internal'
import type { Glb } from '../gltf/glb.ts'
import { targetNamesOf } from '../json/gltf-json.ts'
import { allSurfaces, bestSkin, type FoundSkin } from '../mesh/find-skin.ts'
import { inspectShapes, type ShapeReport } from './inspect-shapes.ts'

export interface MeshReport {
  mesh: string
  materials: string[]
  vertices: number
  triangles: number
  blendshapes: string[]
}

/** Surface of a mesh with one material, which `furrow auto` judges to be skin, cloth or hard. */
export interface SurfaceReport {
  mesh: string
  material: string
  kind: SurfaceKind | 'unknown'
  /** Why the surface is of this kind: a clause. */
  why: string
  /** Limbs that joints of the surface move, such as `left hand` and `left elbow`. */
  limbs: readonly string[]
  /** Limbs at which `furrow auto` would draw creases or folds, with the names of their joints. */
  creased: { limb: string; joints: readonly string[] }[]
}

export interface PlainInspection {
  fileBytes: number
  meshes: MeshReport[]
  surfaces: SurfaceReport[]
  /** Mesh and material that `furrow auto` chooses. Absent if no mesh is suitable. */
  skin?: { mesh: string; material: string; reason: string }
  /** Recognised blendshapes of `skin`. Empty without `skin`. */
  shapes: ShapeReport[]
  /** Whether `furrow auto` can generate wrinkles: whether blendshapes move `skin`, or joints of a humanoid fold skin or cloth. */
  auto: boolean
  /** Suggestion for the user: the next command or step. */
  next: string
}

/**
 * Inspects a file without wrinkles.
 *
 * @param document `glb`, decoded.
 * @returns the report, and the surface that `furrow auto` would choose if there is one.
 */
export function inspectPlain(
  glb: Glb,
  document: Document,
  path: string,
): { report: PlainInspection; skin?: FoundSkin } {
  const all = allSurfaces(document)
  const skin = bestSkin(all)
  const surfaces = all.map((surface): SurfaceReport => {
    const { kind = 'unknown', reason } = judgeKind(glb.json.materials?.[surface.material], surface)
    const { meshName, materialName, limbs, limbJoints } = surface
    const creased = limbs.flatMap((limb, i) =>
      foldsLimb(kind, limb) ? [{ limb, joints: limbJoints[i] }] : [],
    )
    return { mesh: meshName, material: materialName, kind, why: reason, limbs, creased }
  })
  const isMoved = skin !== undefined && skin.fraction > 0
  const report = {
    fileBytes: glb.fileBytes,
    meshes: meshesOf(glb, document),
    surfaces,
    ...(skin && {
      skin: { mesh: skin.meshName, material: skin.materialName, reason: skin.reason },
    }),
    shapes: skin ? inspectShapes(skin.skin) : [],
    auto: isMoved || surfaces.some(isFolded),
    next: nextStep(path, skin, isMoved, surfaces),
  }
  return { report, ...(skin && { skin }) }
}

function isFolded({ kind, limbs }: SurfaceReport): boolean {
  return isFoldedAs(kind, limbs)
}

function nextStep(
  path: string,
  skin: FoundSkin | undefined,
  isMoved: boolean,
  surfaces: readonly SurfaceReport[],
): string {
  const command = `furrow auto ${quoted(path)} -o wrinkled.glb`
  if (isMoved) return `generate wrinkles from its blendshapes: ${command}`
  if (surfaces.some(isFolded)) return `generate wrinkles from its joints: ${command}`
  const unknown = surfaces.find(({ kind, limbs }) => kind === 'unknown' && limbs.length > 0)
  if (unknown)
    return `if mesh "${unknown.mesh}" is skin, generate wrinkles from its joints: ${command} --kind ${quoted(`${unknown.mesh}=skin`)} (or cloth)`
  if (!skin) return 'no mesh has triangles with texture coordinates and a material: unwrap the face first'
  return 'no blendshape moves the skin: draw wrinkles (furrow strokes) or paint them over its UV layout (furrow uv)'
}

/** Quotes a text for a shell if it has special characters. */
function quoted(path: string): string {
  return /^[\p{L}\p{N}_./\\:=-]+$/u.test(path) ? path : `"${path}"`
}

function meshesOf({ json }: Glb, document: Document): MeshReport[] {
  return document
    .getRoot()
    .listMeshes()
    .map((mesh, index) => {
      const primitives = mesh.listPrimitives()
      const materials = primitives.map((primitive) => primitive.getMaterial()?.getName() ?? '')
      const counts = primitives.map((primitive) => primitive.getAttribute('POSITION')?.getCount() ?? 0)
      const corners = primitives.map((primitive, i) => primitive.getIndices()?.getCount() ?? counts[i])
      return {
        mesh: mesh.getName() || String(index),
        materials: [...new Set(materials)].filter(Boolean),
        vertices: counts.reduce((sum, count) => sum + count, 0),
        triangles: corners.reduce((sum, count) => sum + Math.floor(count / 3), 0),
        blendshapes: json.meshes?.[index] ? targetNamesOf(json.meshes[index]) : [],
      }
    })
}
