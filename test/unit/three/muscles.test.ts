import type { MuscleDriver } from 'furrow'
import { addMorphNormals, addMuscles, setDrivers } from 'furrow/three'
import { Float32BufferAttribute, Mesh, PlaneGeometry } from 'three'
import { describe, expect, it } from 'vitest'
import { face } from './refused.ts'

const muscle = (name: string): MuscleDriver => ({
  type: 'muscle',
  name,
  kind: 'sheet',
  origin: [0, 0, -1],
  insertion: [0, 0, 0],
  angle: 0.5,
  width: 0.7,
  inner: 1,
  outer: 2,
  strength: 0.25,
})

describe('addMuscles', () => {
  it('adds a morph target with normals for each muscle, whose weight is its contraction', () => {
    const mesh = new Mesh(new PlaneGeometry(2, 2, 8, 8))
    addMuscles(mesh, [muscle('a'), muscle('b')])
    expect(mesh.morphTargetDictionary).toEqual({ a: 0, b: 1 })
    expect(mesh.morphTargetInfluences).toEqual([0, 0])
    const { position, normal } = mesh.geometry.morphAttributes as Required<
      typeof mesh.geometry.morphAttributes
    >
    expect(position.map(({ name }) => name)).toEqual(['a', 'b'])
    // The middle of the sheet moves by a quarter of the length of the muscle. The edge does not move.
    const middle = 40
    expect(position[0].getZ(middle)).toBeCloseTo(-0.25, 6)
    expect(position[0].getZ(0)).toBe(0)
    // Right of the middle the surface now faces left.
    const { normal: rest } = mesh.geometry.attributes
    const right = middle + 2
    expect(rest.getX(right) + normal[0].getX(right)).toBeLessThan(-0.2)
    expect(normal[0].getX(middle)).toBeCloseTo(0, 6)
    // A second call changes nothing.
    addMuscles(mesh, [muscle('a')])
    expect(position).toHaveLength(2)
  })

  it.each([true, false])('keeps existing blendshapes, relative: %s', (relative) => {
    const geometry = new PlaneGeometry(2, 2, 4, 4)
    const rest = geometry.attributes.position
    const raised = new Float32BufferAttribute(new Float32Array(3 * rest.count), 3)
    for (let i = 0; i < rest.count; i++) {
      const base = relative ? [0, 0, 0] : [rest.getX(i), rest.getY(i), rest.getZ(i)]
      raised.setXYZ(i, base[0], base[1], base[2] + (i === 12 ? 0.5 : 0))
    }
    geometry.morphAttributes.position = [raised]
    geometry.morphTargetsRelative = relative
    const mesh = new Mesh(geometry)
    mesh.morphTargetDictionary = { raised: 0 }
    mesh.morphTargetInfluences = [0.3]
    addMuscles(mesh, [muscle('a')])
    expect(mesh.morphTargetDictionary).toEqual({ raised: 0, a: 1 })
    expect(mesh.morphTargetInfluences).toEqual([0.3, 0])
    expect(geometry.morphAttributes.position[1].getZ(12)).toBeCloseTo(-0.25, 6)
    const [first] = geometry.morphAttributes.normal!
    expect(first.getX(13)).toBeGreaterThan(0.1)
    expect(first.getZ(13)).toBeLessThan(relative ? 0 : 1)
  })
})

it('the drivers of a face add its muscles to all its meshes, and to a shared geometry only once', () => {
  const { mesh, wrinkles } = face()
  const [other, twin, late] = [new PlaneGeometry(), mesh.geometry, new PlaneGeometry()].map(
    (geometry) => new Mesh(geometry, mesh.material),
  )
  mesh.geometry.morphAttributes.position = [mesh.geometry.attributes.position.clone()]
  for (const each of [other, twin]) wrinkles.addMesh(each)
  setDrivers(wrinkles, [muscle('a'), muscle('b')])
  wrinkles.addMesh(late)
  expect(mesh.morphTargetDictionary).toEqual({ jawOpen: 0, a: 1, b: 2 })
  expect(other.morphTargetDictionary).toEqual({ a: 0, b: 1 })
  expect(other.morphTargetInfluences).toEqual([0, 0])
  expect(late.morphTargetDictionary).toEqual({ a: 0, b: 1 })
  expect(twin.morphTargetDictionary).toMatchObject({ a: 1, b: 2 })
  expect(twin.morphTargetInfluences).toEqual([0, 0, 0])
  expect(mesh.geometry.morphAttributes.position).toHaveLength(3)
})

describe('addMorphNormals', () => {
  it('does not change a geometry without targets or with normals', () => {
    const geometry = new PlaneGeometry()
    addMorphNormals(geometry)
    expect(geometry.morphAttributes).toEqual({})
    geometry.morphAttributes.position = [geometry.attributes.position as Float32BufferAttribute]
    const normals = [geometry.attributes.normal as Float32BufferAttribute]
    geometry.morphAttributes.normal = normals
    addMorphNormals(geometry)
    expect(geometry.morphAttributes.normal).toBe(normals)
  })
})
