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
    'is activated by the curves of its drivers when the middle joints of its fingers bend by %d',
    (angle) => {
      const { pose, activations, drivers } = jointsOf(documents.hand)
      for (const finger of [2, 3, 4, 5]) pose(`finger${finger}-2.L`, [1, 0, 0], angle)
      const found = activations()
      for (const { area, curve, joints } of drivers) {
        if (!/^finger[2-5]-2/.test(joints[1])) continue
        expect(found[area], area).toBeCloseTo(interpolate(curve, angle), 2)
      }
    },
  )

  it('has all creases and smooth knuckles when it makes a fist', () => {
    const { play, activations } = jointsOf(documents.hand)
    play('fist', 1.5)
    for (const [area, activation] of Object.entries(activations())) {
      if (/^finger[2-5].* back$/.test(area)) expect(activation, area).toBeLessThan(0.3)
      if (/^finger[2-5].* flexion$|(distal|proximal) crease$/.test(area))
        expect(activation, area).toBeGreaterThan(0.8)
    }
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
    expect(blue.min).toBeLessThan(40)
    const { play, activations } = jointsOf(documents.hand)
    expect(wrinkles.getDrivers()).toContainEqual({
      type: 'time',
      area: 'wrist.L knuckles',
      attack: 0.08,
      release: 0.9,
    })
    expect(activations()['wrist.L knuckles']).toBe(0)
    play('fist', 1.5)
    expect(activations()['wrist.L knuckles']).toBeGreaterThan(0.9)
  })
})

describe('the neck', () => {
  it.each([
    ['turn', 1.4, 'head turn to the left'],
    ['turn', 4.2, 'head turn to the right'],
    ['nod', 1.2, 'head forward'],
  ])('shows most of all the creases of %s at %d s', (clip, seconds, area) => {
    const { play, activations } = jointsOf(documents.neck)
    play(clip, seconds)
    const { [area]: activation, ...others } = activations()
    expect(activation).toBeGreaterThan(0.7)
    expect(Math.max(...Object.values(others))).toBeLessThan(0.4)
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
