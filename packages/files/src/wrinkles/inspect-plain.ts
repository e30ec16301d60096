import type { Document } from '@gltf-transform/core'
import type { Glb } from '../gltf/glb.ts'
import { targetNamesOf } from '../json/gltf-json.ts'
import { bestSkin, type FoundSkin } from '../mesh/find-skin.ts'
import { inspectShapes, type ShapeReport } from './inspect-shapes.ts'

export interface MeshReport {
  mesh: string
  materials: string[]
  vertices: number
  triangles: number
  blendshapes: string[]
}

export interface PlainInspection {
  fileBytes: number
  meshes: MeshReport[]
  /** Mesh and material that `furrow auto` chooses. Absent if no mesh is suitable. */
  skin?: { mesh: string; material: string; reason: string }
  /** Recognised blendshapes of `skin`. Empty without `skin`. */
  shapes: ShapeReport[]
  /** Whether `furrow auto` can generate wrinkles. True if blendshapes move `skin`. */
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
  const skin = bestSkin(document)
  const auto = skin !== undefined && skin.fraction > 0
  const report = {
    fileBytes: glb.fileBytes,
    meshes: meshesOf(glb, document),
    ...(skin && {
      skin: { mesh: skin.meshName, material: skin.materialName, reason: skin.reason },
    }),
    shapes: skin ? inspectShapes(skin.skin) : [],
    auto,
    next: nextStep(path, skin, auto),
  }
  return { report, ...(skin && { skin }) }
}

function nextStep(path: string, skin: FoundSkin | undefined, auto: boolean): string {
  if (auto) return `generate wrinkles from its blendshapes: furrow auto ${quoted(path)} -o wrinkled.glb`
  if (!skin) return 'no mesh has triangles with texture coordinates and a material: unwrap the face first'
  return 'no blendshape moves the skin: draw wrinkles (furrow strokes) or paint them over its UV layout (furrow uv)'
}

/** Quotes a path for a shell if it has special characters. */
function quoted(path: string): string {
  return /^[\p{L}\p{N}_./\\:-]+$/u.test(path) ? path : `"${path}"`
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
