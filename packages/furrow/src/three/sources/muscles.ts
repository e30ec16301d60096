import { BufferAttribute, type BufferGeometry, type Mesh } from 'three'
import { wrongArgument } from '../../core/argument.ts'
import type { MuscleDriver } from '../../drivers/muscle/definition.ts'
import { muscleOffsets } from '../../drivers/muscle/offsets.ts'
import { morphNormalDeltas } from '../../math/deformed-normals.ts'
import { checkIsMesh } from '../mesh/check-mesh.ts'
import { coordinates, targetOffsets, trianglesOf } from './geometry-arrays.ts'

/**
 * Adds virtual muscles to a mesh. Each muscle becomes a morph target with normals. The target has the name of the muscle, and its weight is
 * the contraction of the muscle (1 = full). If the mesh already has a target with this name, the muscle is skipped. Call the
 * function for every mesh of a face, including brows and lashes.
 *
 * @param mesh mesh whose local space is the coordinate system of the muscles. The function changes the geometry of this mesh, so other meshes
 *   with the same geometry change too.
 * @param muscles drivers of type `muscle`, see `driversOf`.
 * @throws FurrowError if `mesh` is not a mesh, or `muscles` is not an array.
 */
export function addMuscles(mesh: Mesh, muscles: readonly MuscleDriver[]): void {
  checkIsMesh(mesh, 'addMuscles')
  if (!Array.isArray(muscles)) throw wrongArgument('addMuscles', 'muscles', muscles, 'a list of drivers')
  if (muscles.length === 0) return
  const { geometry } = mesh
  mesh.morphTargetDictionary ??= {}
  mesh.morphTargetInfluences ??= []
  const { morphTargetDictionary: targets, morphTargetInfluences: influences } = mesh
  const missing = muscles.filter(({ name }) => targets[name] === undefined)
  if (missing.length === 0) return
  const position = coordinates(geometry.getAttribute('position'))
  const { morphAttributes } = geometry
  morphAttributes.position ??= []
  if (morphAttributes.position.length === 0) geometry.morphTargetsRelative = true
  for (const muscle of missing) {
    const known = morphAttributes.position.findIndex(({ name }) => name === muscle.name)
    const index = known < 0 ? morphAttributes.position.length : known
    targets[muscle.name] = index
    while (influences.length <= index) influences.push(0)
    // The muscle was already added to the geometry, through another mesh.
    if (known >= 0) continue
    const offsets = muscleOffsets(muscle, position)
    const stored = geometry.morphTargetsRelative ? offsets : offsets.map((offset, i) => offset + position[i])
    morphAttributes.position.push(named(new BufferAttribute(stored, 3), muscle.name))
  }
  addMorphNormals(geometry)
}

/**
 * Adds missing normals to the morph targets of a geometry. Without these normals, three.js shades a moved face with the normals of the face at
 * rest. Does nothing if the geometry itself has no normals.
 */
export function addMorphNormals(geometry: BufferGeometry): void {
  const { morphAttributes, morphTargetsRelative } = geometry
  const targets = morphAttributes.position ?? []
  const normal = geometry.getAttribute('normal')
  const known = morphAttributes.normal ?? []
  if (!normal || known.length >= targets.length) return
  const normals = coordinates(normal)
  const changes = morphNormalDeltas({
    positions: coordinates(geometry.getAttribute('position')),
    normals,
    triangles: trianglesOf(geometry),
  })
  for (const [i, offsets] of targetOffsets(geometry).entries()) {
    if (i < known.length) continue
    const deltas = changes(offsets)
    const stored = morphTargetsRelative ? deltas : deltas.map((change, k) => normals[k] + change)
    known.push(named(new BufferAttribute(stored, 3), targets[i].name))
  }
  morphAttributes.normal = known
}

function named(attribute: BufferAttribute, name: string): BufferAttribute {
  attribute.name = name
  return attribute
}
