import { DeformedNormals } from 'furrow/internal'
import {
  IcosahedronGeometry,
  Matrix3,
  Matrix4,
  PlaneGeometry,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three'
import { describe, expect, it } from 'vitest'

/** Returns the arrays of a geometry as a mesh for `DeformedNormals`. */
function meshOf({ attributes, index }: PlaneGeometry | SphereGeometry | IcosahedronGeometry) {
  const positions = attributes.position.array as Float32Array
  return {
    positions,
    normals: attributes.normal.array as Float32Array,
    triangles: index ? index.array : positions.map((_, i) => i).subarray(0, positions.length / 3),
  }
}

const moved = (positions: Float32Array, move: (point: Vector3) => Vector3) => {
  const out = positions.slice()
  for (let i = 0; i < out.length; i += 3) move(new Vector3().fromArray(positions, i)).toArray(out, i)
  return out
}

const vectorsOf = (list: ArrayLike<number>) =>
  Array.from(
    { length: list.length / 3 },
    (_, i) => new Vector3(list[3 * i], list[3 * i + 1], list[3 * i + 2]),
  )

/** Returns the largest angle between the vectors of two lists, radians. */
function largestAngle(a: ArrayLike<number>, b: ArrayLike<number>): number {
  const others = vectorsOf(b)
  return vectorsOf(a).reduce((most, vector, i) => Math.max(most, vector.angleTo(others[i])), 0)
}

/** Moves the points of a mesh, and returns its deformed normals. */
function deform(mesh: ReturnType<typeof meshOf>, move: (point: Vector3) => Vector3) {
  const deformed = new DeformedNormals(mesh)
  const out = new Float32Array(mesh.normals.length)
  deformed.update(moved(mesh.positions, move), out)
  return { deformed, out }
}

describe('DeformedNormals', () => {
  it('equal the authored normals at rest and after scaling and translation', () => {
    const mesh = meshOf(new SphereGeometry(1, 24, 16))
    // Uses authored normals that differ from those of the triangles.
    const authored = moved(mesh.normals, (n) => n.add(new Vector3(0.2, 0.1, 0)).normalize())
    const deformed = new DeformedNormals({ ...mesh, normals: authored })
    const out = new Float32Array(authored.length)
    deformed.update(mesh.positions, out)
    expect(largestAngle(out, authored)).toBeLessThan(1e-3)
    deformed.update(
      moved(mesh.positions, (p) => p.multiplyScalar(3).add(new Vector3(1, 2, 3))),
      out,
    )
    expect(largestAngle(out, authored)).toBeLessThan(1e-3)
  })

  it('rotate the authored normals and tangents', () => {
    const mesh = meshOf(new IcosahedronGeometry(1, 16))
    const rotation = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.5)
    const { deformed, out } = deform(mesh, (p) => p.applyQuaternion(rotation))
    const expected = moved(mesh.normals, (n) => n.applyQuaternion(rotation))
    expect(largestAngle(out, expected)).toBeLessThan(0.02)
    // Tangents must stay perpendicular to the normals.
    const normals = vectorsOf(out)
    const tangents = moved(mesh.normals, (n) => new Vector3(0, 1, 0).cross(n))
    deformed.rotate(tangents, 3)
    expect(Math.max(...vectorsOf(tangents).map((t, i) => Math.abs(t.dot(normals[i]))))).toBeLessThan(0.02)
  })

  it('follow the bending of a plane, within the accuracy of its triangles', () => {
    const mesh = meshOf(new PlaneGeometry(2, 2, 80, 4))
    const wave = (x: number) => 0.3 * Math.sin(2 * x)
    const { out } = deform(mesh, (p) => p.setZ(wave(p.x)))
    const expected = moved(mesh.positions, ({ x }) => new Vector3(-0.6 * Math.cos(2 * x), 0, 1).normalize())
    expect(largestAngle(out, expected)).toBeLessThan(0.02)
  })

  it('agree with the inverse transpose of a scaling, on a sphere without an index', () => {
    const mesh = meshOf(new IcosahedronGeometry(1, 24))
    const scaling = new Matrix4().makeScale(1.3, 0.8, 1)
    const { out } = deform(mesh, (p) => p.applyMatrix4(scaling))
    const normal = new Matrix3().getNormalMatrix(scaling)
    const expected = moved(mesh.normals, (n) => n.applyMatrix3(normal).normalize())
    expect(largestAngle(out, expected)).toBeLessThan(0.02)
    expect(Math.max(...vectorsOf(out).map((n) => Math.abs(n.length() - 1)))).toBeLessThan(1e-5)
  })

  it('keep the normals of vertices whose triangles have no area', () => {
    const deformed = new DeformedNormals({
      positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5],
      normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0],
      triangles: [0, 1, 2],
    })
    const out = new Float32Array(12)
    deformed.update([0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5], out)
    expect([...out]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0])
    deformed.update([0, 0, Number.NaN, 1, 0, 0, 0, 1, 0, 5, 5, 5], out)
    expect([...out]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0])
  })
})
