import { addMorphNormals, RecomputedNormals } from 'furrow/three'
import { Float32BufferAttribute, Mesh, PlaneGeometry, SphereGeometry } from 'three'
import { describe, expect, it } from 'vitest'
import { seeded } from '../../random.ts'

/** Creates a ball with two random blendshapes, which move vertices at the same position equally. */
function ball(relative = true) {
  const geometry = new SphereGeometry(1, 20, 14)
  const { position } = geometry.attributes
  const random = seeded(2)
  geometry.morphTargetsRelative = relative
  geometry.morphAttributes.position = [0, 1].map(() => {
    const offsets = new Map<string, number[]>()
    const values = Array.from({ length: position.count }, (_, i) => {
      const point = [position.getX(i), position.getY(i), position.getZ(i)]
      const key = point.map((value) => value.toFixed(5)).join()
      const offset = offsets.get(key) ?? point.map(() => 0.1 * (random() - 0.5))
      offsets.set(key, offset)
      return relative ? offset : offset.map((value, k) => value + point[k])
    })
    return new Float32BufferAttribute(values.flat(), 3)
  })
  geometry.setAttribute(
    'tangent',
    new Float32BufferAttribute(
      Array.from({ length: position.count }, (_, i) => [-position.getZ(i), 0, position.getX(i), 1]).flat(),
      4,
    ),
  )
  return new Mesh(geometry)
}

describe('RecomputedNormals', () => {
  it.each([true, false])(
    'gives the same normals as addMorphNormals for one blendshape, relative: %s',
    (relative) => {
      const mesh = ball(relative)
      const baked = mesh.geometry.clone()
      addMorphNormals(baked)
      const recomputed = new RecomputedNormals(mesh)
      mesh.morphTargetInfluences![1] = 1
      recomputed.update()
      const { normal } = mesh.geometry.attributes
      const [target, rest] = [baked.morphAttributes.normal![1], baked.attributes.normal]
      for (let i = 0; i < normal.count; i++) {
        const expected = target.getX(i) + (relative ? rest.getX(i) : 0)
        expect(normal.getX(i)).toBeCloseTo(expected, 5)
      }
      expect(mesh.geometry.morphAttributes.normal).toBeUndefined()
    },
  )

  it('turns tangents with the surface, keeps their signs, and returns to rest', () => {
    const mesh = ball()
    const before = mesh.geometry
    const recomputed = new RecomputedNormals(mesh)
    const { normal, tangent } = mesh.geometry.attributes
    const [restNormal, restTangent] = [normal, tangent].map(({ array }) => array.slice())
    mesh.morphTargetInfluences!.fill(0.7)
    recomputed.update()
    expect(normal.array).not.toEqual(restNormal)
    for (let i = 0; i < normal.count; i++) {
      const [n, t] = [normal, tangent].map((attribute) => [
        attribute.getX(i),
        attribute.getY(i),
        attribute.getZ(i),
      ])
      const dot = (a: ArrayLike<number>, b: ArrayLike<number>, at = 0) =>
        a[0] * b[at] + a[1] * b[at + 1] + a[2] * b[at + 2]
      const atRest = restNormal[3 * i] * restTangent[4 * i] + restNormal[3 * i + 2] * restTangent[4 * i + 2]
      expect(dot(n, t)).toBeCloseTo(atRest, 4)
      expect(tangent.getW(i)).toBe(1)
    }
    mesh.morphTargetInfluences!.fill(0)
    recomputed.update()
    for (let i = 0; i < normal.array.length; i++) expect(normal.array[i]).toBeCloseTo(restNormal[i], 5)
    recomputed.dispose()
    expect(mesh.geometry).toBe(before)
  })

  it('does nothing if no weight has changed, or without blendshapes', () => {
    const mesh = ball()
    const recomputed = new RecomputedNormals(mesh)
    const { version } = mesh.geometry.attributes.normal as Float32BufferAttribute
    recomputed.update()
    expect((mesh.geometry.attributes.normal as Float32BufferAttribute).version).toBe(version)
    const plain = new Mesh(new PlaneGeometry())
    expect(() => new RecomputedNormals(plain).update()).not.toThrow()
  })
})
