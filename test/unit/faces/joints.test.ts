import { fileURLToPath } from 'node:url'
import { type Document, NodeIO, type vec4 } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { cloneDocument } from '@gltf-transform/functions'
import type { BoneDriver, Curve } from 'furrow'
import { FurrowWrinkleMaps, type MaterialWrinkles } from 'furrow/gltf'
import { DriverProgram, JointMeasurement, measuredSource, planDrivers } from 'furrow/internal'
import sharp from 'sharp'
import { Matrix4, Quaternion, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'

const io = new NodeIO().registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
const read = (name: string) => io.read(fileURLToPath(new URL(`../../../faces/${name}.glb`, import.meta.url)))
const documents = { hand: await read('hand'), neck: await read('neck') }

/** The weight 1 as a normalised 16-bit integer. */
const UNIT_WEIGHT = 65535

describe.each(Object.entries(documents))('the shipped %s', (_, document) => {
  it('has skin weights that add up to exactly 1', () => {
    const skinned = document
      .getRoot()
      .listNodes()
      .filter((node) => node.getSkin())
    expect(skinned.map((node) => node.getName())).toContain('skin')
    for (const node of skinned) {
      const [primitive] = node.getMesh()!.listPrimitives()
      const weights = primitive.getAttribute('WEIGHTS_0')!.getArray()
      const joints = primitive.getAttribute('JOINTS_0')!.getArray()
      expect(Math.max(...joints)).toBeLessThan(node.getSkin()!.listJoints().length)
      for (let i = 0; i < weights.length; i += 4) {
        if (weights[i] + weights[i + 1] + weights[i + 2] + weights[i + 3] !== UNIT_WEIGHT)
          expect.fail(`vertex ${i / 4} of ${node.getName()}`)
      }
    }
  })

  it('rests in its bind pose', () => {
    const { rest, now } = jointsOf(document)
    for (const [i, value] of now().entries()) expect(value).toBeCloseTo(rest[i], 5)
  })
})

describe('the hand', () => {
  it.each([0, 0.2, 0.7, 1.1, 1.6])(
    'is activated by the curves of its drivers when its joints bend by %d',
    (angle) => {
      const { pose, activations, drivers, positionOf } = jointsOf(documents.hand)
      const bent = ['finger1-3', 'finger2-2', 'finger3-2', 'finger4-2', 'finger5-2', 'finger1-1']
      for (const name of bent) pose(`${name}.L`, [1, 0, 0], angle)
      const distance = positionOf('wrist.L').distanceTo(positionOf('finger3-3.L'))
      const found = activations()
      for (const { area, curve, measure } of drivers)
        expect(found[area]).toBeCloseTo(interpolate(curve, measure === 'angle' ? angle : distance), 5)
      expect(Object.keys(found)).toEqual([
        'thumb',
        'index',
        'middle',
        'ring',
        'little',
        'knuckles',
        'palm',
        'thenar',
        'pressed',
      ])
    },
  )

  it('has all creases and smooth knuckles when it makes a fist', () => {
    const { play, activations } = jointsOf(documents.hand)
    play('fist', 1.5)
    const { knuckles, ...others } = activations()
    expect(knuckles).toBe(0)
    for (const activation of Object.values(others)) expect(activation).toBe(1)
  })

  it('has pale knuckles when it makes a fist, and the blood returns in about a second', async () => {
    const material = documents.hand
      .getRoot()
      .listMaterials()
      .find((one) => one.getName() === 'skin')!
    const wrinkles = material.getExtension<MaterialWrinkles>('FURROW_wrinkle_maps')!
    const [layer] = wrinkles.listLayers()
    expect(layer.getBloodAmplitude()).toBeGreaterThan(0.2)
    const image = sharp(layer.getTexture('bloodTexture')!.getImage()!)
    const [, , blue] = (await image.stats()).channels
    expect(blue.max).toBe(128)
    expect(blue.min).toBeLessThan(40)
    expect(wrinkles.getDrivers()).toContainEqual({ type: 'time', area: 'pressed', attack: 0.15, release: 1 })
    expect(jointsOf(documents.hand).activations().pressed).toBe(0)
  })
})

describe('the neck', () => {
  it.each([-0.25, -0.1, 0, 0.08, 0.2])(
    'is activated by the total rotation of its joints, %d each',
    (angle) => {
      const { pose, activations, drivers, rotationFromRest } = jointsOf(documents.neck)
      for (const name of ['neck01', 'neck02', 'neck03', 'head']) {
        pose(name, [0.3, 1, 0], angle)
      }
      const { x, y, w } = rotationFromRest('spine01', 'head')
      const found = activations()
      for (const { area, curve, axis } of drivers) {
        const angle = 2 * Math.atan2(axis![0] === 1 ? x : y, w)
        expect(found[area]).toBeCloseTo(interpolate(curve, angle), 5)
      }
    },
  )

  it.each([
    ['turn', 1.4, 'neckLeft'],
    ['turn', 4.2, 'neckRight'],
    ['nod', 1.2, 'neckFront'],
  ])('shows only the creases of %s at %d s', (clip, seconds, area) => {
    const { play, activations } = jointsOf(documents.neck)
    play(clip, seconds)
    const { [area]: activation, ...others } = activations()
    expect(activation).toBeGreaterThan(0.9)
    expect(Math.max(...Object.values(others))).toBeLessThan(0.1)
  })
})

/** Returns functions that pose the joints of a model and evaluate its drivers. */
function jointsOf(original: Document) {
  const document = cloneDocument(original)
  const [skin] = document.getRoot().listSkins()
  const joints = skin.listJoints()
  const rests = joints.map((joint) => joint.getRotation())
  const names = joints.map((joint) => joint.getName())
  const inverse = skin.getInverseBindMatrices()!
  const rest = joints.flatMap((_, i) => {
    const elements = inverse.getElement(i, [])
    return new Matrix4().fromArray(elements).invert().elements
  })
  const material = document
    .getRoot()
    .listMaterials()
    .find((one) => one.getName() === 'skin')!
  const wrinkles = material.getExtension<MaterialWrinkles>('FURROW_wrinkle_maps')!
  const drivers = wrinkles.getDrivers()
  const now = () => joints.flatMap((joint) => joint.getWorldMatrix() as number[])
  const joint = (name: string) => joints[names.indexOf(name)]
  const quaternionOf = (matrix: Matrix4) => new Quaternion().setFromRotationMatrix(matrix)
  return {
    drivers: drivers.filter(({ type }) => type === 'bone') as BoneDriver[],
    rest,
    now,
    /** Rotates a joint from its rest pose about a local axis. The angle is in radians. */
    pose(name: string, axis: [number, number, number], angle: number) {
      const bend = new Quaternion().setFromAxisAngle(new Vector3(...axis).normalize(), angle)
      const rotation = new Quaternion().fromArray(rests[names.indexOf(name)]).multiply(bend)
      joint(name).setRotation(rotation.toArray() as vec4)
    },
    /** Sets all joints to an animation's last key frame at or before `seconds`. */
    play(clip: string, seconds: number) {
      const animation = document
        .getRoot()
        .listAnimations()
        .find((one) => one.getName() === clip)!
      for (const channel of animation.listChannels()) {
        const sampler = channel.getSampler()!
        const times = [...sampler.getInput()!.getArray()]
        const key = times.findLastIndex((time) => time <= seconds + 1e-4)
        const rotation = sampler.getOutput()!.getElement<vec4>(key, [0, 0, 0, 1])
        channel.getTargetNode()!.setRotation(rotation)
      }
    },
    positionOf: (name: string) => new Vector3(...joint(name).getWorldTranslation()),
    /** Returns the rotation of the joint `name` from its rest pose, relative to the joint `from`. */
    rotationFromRest(from: string, name: string) {
      const relative = (matrices: readonly number[]) => {
        const [a, b] = [from, name].map((one) =>
          quaternionOf(new Matrix4().fromArray(matrices, 16 * names.indexOf(one))),
        )
        return a.invert().multiply(b)
      }
      return relative(rest).invert().multiply(relative(now()))
    },
    activations(): Record<string, number> {
      const plan = planDrivers(drivers)
      const joints = new JointMeasurement(plan.inputs.joint, names, () => rest)
      const program = new DriverProgram(plan, { joint: measuredSource(joints.missing) })
      expect(program.missing).toEqual([])
      const state = program.createState()
      // After a minute all delays have ended.
      state.seconds[0] = 60
      joints.measure(now(), state.inputs.joint)
      program.evaluate(state)
      return Object.fromEntries(plan.areaNames.map((name, i) => [name, state.activations[i]]))
    },
  }
}

/** Evaluates a curve: linear between its points, constant beyond its ends. */
function interpolate(curve: Curve, input: number): number {
  const [[firstInput, first]] = curve
  if (input <= firstInput) return first
  for (let i = 1; i < curve.length; i++) {
    const [[a, from], [b, to]] = [curve[i - 1], curve[i]]
    if (input <= b) return from + ((to - from) * (input - a)) / (b - a)
  }
  return curve[curve.length - 1][1]
}
