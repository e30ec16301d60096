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

/** Arrays of a geometry. */
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

/** Largest angle between the vectors of two lists, in radians. */
function largestAngle(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let largest = 0
  for (let i = 0; i < a.length; i += 3) {
    const [p, q] = [a, b].map((list) => new Vector3(list[i], list[i + 1], list[i + 2]))
    largest = Math.max(largest, p.angleTo(q))
  }
  return largest
}

describe('DeformedNormals', () => {
  it('returns the authored normals at rest and after scaling and translation', () => {
    const mesh = meshOf(new SphereGeometry(1, 24, 16))
    // Unlike the geometric normals.
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

  it('rotates the authored normals and tangents', () => {
    const mesh = meshOf(new IcosahedronGeometry(1, 16))
    const rotation = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.5)
    const deformed = new DeformedNormals(mesh)
    const out = new Float32Array(mesh.normals.length)
    deformed.update(
      moved(mesh.positions, (p) => p.applyQuaternion(rotation)),
      out,
    )
    expect(
      largestAngle(
        out,
        moved(mesh.normals, (n) => n.applyQuaternion(rotation)),
      ),
    ).toBeLessThan(0.02)
    // Tangents stay in the surface.
    const tangents = moved(mesh.normals, (n) => new Vector3(0, 1, 0).cross(n))
    deformed.rotate(tangents, 3)
    for (let i = 0; i < out.length; i += 3) {
      expect(
        Math.abs(new Vector3().fromArray(tangents, i).dot(new Vector3().fromArray(out, i))),
      ).toBeLessThan(0.02)
    }
  })

  it('follows the bending of a plane, within the resolution of its triangles', () => {
    const mesh = meshOf(new PlaneGeometry(2, 2, 80, 4))
    const wave = (x: number) => 0.3 * Math.sin(2 * x)
    const deformed = new DeformedNormals(mesh)
    const out = new Float32Array(mesh.normals.length)
    deformed.update(
      moved(mesh.positions, (p) => p.setZ(wave(p.x))),
      out,
    )
    const expected = moved(mesh.positions, ({ x }) => new Vector3(-0.6 * Math.cos(2 * x), 0, 1).normalize())
    expect(largestAngle(out, expected)).toBeLessThan(0.02)
  })

  it('agrees with the inverse transpose of a scaling, on a sphere without an index', () => {
    const mesh = meshOf(new IcosahedronGeometry(1, 24))
    const scaling = new Matrix4().makeScale(1.3, 0.8, 1)
    const deformed = new DeformedNormals(mesh)
    const out = new Float32Array(mesh.normals.length)
    deformed.update(
      moved(mesh.positions, (p) => p.applyMatrix4(scaling)),
      out,
    )
    const normal = new Matrix3().getNormalMatrix(scaling)
    expect(
      largestAngle(
        out,
        moved(mesh.normals, (n) => n.applyMatrix3(normal).normalize()),
      ),
    ).toBeLessThan(0.02)
    for (let i = 0; i < out.length; i += 3)
      expect(Math.hypot(out[i], out[i + 1], out[i + 2])).toBeCloseTo(1, 5)
  })

  it('keeps the normals of vertices without adjacent area', () => {
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
