import { BufferAttribute, type BufferGeometry, type Mesh } from 'three'
import { DeformedNormals } from '../core/deformed-normals.ts'
import type { MuscleDriver } from '../core/driver-types.ts'
import { muscleOffsets } from '../drivers/muscles.ts'
import { coordinates } from './coordinates.ts'

/**
 * Gives a mesh virtual muscles: each becomes a morph target of its name, with normals, whose weight is the contraction. Muscles
 * that the mesh has a target for already are passed over. Call it for every mesh of a face (brows and lashes too), all in the
 * space of the muscles; the geometry is changed, for all meshes that share it.
 */
export function addMuscles(mesh: Mesh, muscles: readonly MuscleDriver[]): void {
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
    const offsets = muscleOffsets(muscle, position)
    targets[muscle.name] = influences.length
    influences.push(0)
    const own = geometry.morphTargetsRelative ? offsets : offsets.map((offset, i) => offset + position[i])
    morphAttributes.position.push(named(new BufferAttribute(own, 3), muscle.name))
  }
  addMorphNormals(geometry)
}

/**
 * Gives the morph targets of a geometry normals where they have none, so that light follows what they do: three.js otherwise shades
 * the face at rest. Does nothing where the geometry has no normals, or all its targets have some.
 */
export function addMorphNormals(geometry: BufferGeometry): void {
  const { morphAttributes, morphTargetsRelative } = geometry
  const targets = morphAttributes.position ?? []
  const normal = geometry.getAttribute('normal')
  const known = morphAttributes.normal ?? []
  if (!normal || known.length >= targets.length) return
  const rest = coordinates(geometry.getAttribute('position'))
  const normals = coordinates(normal)
  const triangles = geometry.index?.array ?? Uint32Array.from({ length: rest.length / 3 }, (_, i) => i)
  const deformed = new DeformedNormals({ positions: rest, normals, triangles })
  const turned = new Float32Array(normals.length)
  for (let i = known.length; i < targets.length; i++) {
    const target = coordinates(targets[i])
    const moved = morphTargetsRelative ? target.map((offset, k) => rest[k] + offset) : target
    deformed.update(moved, turned)
    const own = morphTargetsRelative ? turned.map((value, k) => value - normals[k]) : turned.slice()
    known.push(named(new BufferAttribute(own, 3), targets[i].name))
  }
  morphAttributes.normal = known
}

function named(attribute: BufferAttribute, name: string): BufferAttribute {
  attribute.name = name
  return attribute
}
