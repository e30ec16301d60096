import { keyRotations, rotationChannels, skinJoints } from 'furrow/internal'
import { Euler, Matrix4, Quaternion, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'

const turn = (x: number, y: number, z: number) => new Quaternion().setFromEuler(new Euler(x, y, z))
const matrix = (rotation: Quaternion, scale = 1) =>
  new Matrix4().compose(new Vector3(1, 2, 3), rotation, new Vector3(scale, scale, scale)).toArray()

describe('the joints of a skin', () => {
  it('have rotations from their rest pose in the bind matrices', () => {
    const [upper, lower, bend] = [turn(0.4, 1, -2), turn(-3, 0.2, 0.9), turn(0, 0, 1.2)]
    const json = {
      nodes: [{ name: 'elbow' }, { name: 'shoulder', children: [0] }],
      skins: [{ joints: [1, 0] }],
    }
    const world = upper.clone().multiply(lower)
    const rotations = new Map([[0, [lower.clone().multiply(bend).toArray()]]])
    const [shoulder, elbow] = skinJoints(json, 0, [matrix(upper), matrix(world, 100)], rotations)
    expect([shoulder!.name, shoulder!.parent, elbow!.name, elbow!.parent]).toEqual([
      'shoulder',
      -1,
      'elbow',
      0,
    ])
    expect(shoulder!.rotations).toHaveLength(0)
    const found = new Quaternion().fromArray(Array.from(elbow!.rotations!))
    expect(found.angleTo(bend)).toBeLessThan(1e-6)
  })

  it('skip nodes between them, which hide the rest pose in the bind matrices', () => {
    const rest = turn(0.3, 0, 0)
    const json = {
      nodes: [{ children: [1] }, { children: [2] }, { name: 'tip', rotation: rest.toArray() }],
      skins: [{ joints: [0, 2] }],
    }
    const binds = [matrix(new Quaternion()), matrix(turn(1, 1, 1))]
    const [root, tip] = skinJoints(json, 0, binds, new Map([[2, [rest.toArray()]]]))
    expect([root!.name, tip!.parent]).toEqual(['0', 0])
    expect(Array.from(tip!.rotations!)).toEqual([0, 0, 0, 1].map((value) => expect.closeTo(value, 6)))
  })

  it.each([
    ['VRM 1', { VRMC_vrm: { humanoid: { humanBones: { leftThumbMetacarpal: { node: 0 } } } } }],
    ['VRM 0', { VRM: { humanoid: { humanBones: [{ bone: 'leftThumbProximal', node: 0 }] } } }],
  ])('have the names of humanoid bones of %s', (_, extensions) => {
    const json = { nodes: [{}], skins: [{ joints: [0] }], extensions }
    const [joint] = skinJoints(json, 0, [matrix(new Quaternion())], new Map())
    expect(joint!.humanBone).toBe('leftThumbMetacarpal')
  })

  it('are none if the file has no such skin', () => {
    expect(skinJoints({}, 0, [], new Map())).toEqual([])
  })
})

describe('the rotations of animations', () => {
  it('are named by nodes and by pointers', () => {
    const pointer = (text: unknown) => ({
      path: 'pointer',
      extensions: { KHR_animation_pointer: { pointer: text } },
    })
    const animation = {
      samplers: [{ output: 7, interpolation: 'STEP' }, { output: 8 }],
      channels: [
        { sampler: 0, target: { node: 3, path: 'rotation' } },
        { sampler: 1, target: pointer('/nodes/12/rotation') },
        { sampler: 1, target: pointer('/nodes/12/scale') },
        { sampler: 1, target: pointer(undefined) },
        { sampler: 0, target: { node: 3, path: 'translation' } },
        { sampler: 9, target: { node: 3, path: 'rotation' } },
        {},
      ],
    }
    expect(rotationChannels({ animations: [animation, {}] })).toEqual([
      { node: 3, output: 7, interpolation: 'STEP' },
      { node: 12, output: 8, interpolation: 'LINEAR' },
    ])
  })

  it('are read without the tangents of cubic splines, and at most 256 per channel', () => {
    const read = (i: number) => [i]
    expect(keyRotations('LINEAR', 3, read)).toEqual([[0], [1], [2]])
    expect(keyRotations('CUBICSPLINE', 6, read)).toEqual([[1], [4]])
    const many = keyRotations('LINEAR', 1000, read)
    expect(many.length).toBeLessThanOrEqual(256)
    expect(many.slice(0, 2)).toEqual([[0], [4]])
  })
})
