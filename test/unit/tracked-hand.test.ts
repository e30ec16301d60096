import { readFileSync } from 'node:fs'
import { addDrivers, readWrinkleMaps, Wrinkles } from 'furrow/three'
import { type Mesh, type Object3D, Quaternion, Vector3 } from 'three'
import { afterAll, beforeAll, expect, it, vi } from 'vitest'
import { handPoser, simulatedJoints } from '../../examples/tracked-hand.js'
import { loadInNode } from './three/node-loader.ts'
import { frameOf } from './three/stub-renderer.ts'

let hand: Object3D
let wrinkles: Wrinkles
let draw: () => void
let pose: ReturnType<typeof handPoser>

beforeAll(async () => {
  const gltf = await loadInNode(readFileSync('faces/hand.glb'))
  const [{ meshes, set, drivers }] = await readWrinkleMaps(gltf)
  wrinkles = new Wrinkles(meshes[0] as Mesh, set)
  addDrivers(wrinkles, drivers)
  hand = gltf.scene
  pose = handPoser(hand)
  draw = frameOf(meshes[0] as Mesh)
})
afterAll(() => vi.unstubAllGlobals())

function activations(joints: ReturnType<typeof simulatedJoints>) {
  pose(joints)
  hand.updateMatrixWorld(true)
  draw()
  return Object.fromEntries(wrinkles.areaNames.map((area) => [area, wrinkles.getActivation(area)]))
}

const PLACE = new Vector3(0.1, 1.2, -0.3)
const FINGERS = [2, 3, 4, 5].map((finger) => `finger${finger}-2.L flexion`)
const KNUCKLES = [2, 3, 4, 5].map((finger) => `finger${finger}-2.L back`)

it('creases the fingers of a fist, and the knuckles of an open hand', () => {
  const open = activations(simulatedJoints(0, PLACE))
  const fist = activations(simulatedJoints(1, PLACE))
  for (const finger of FINGERS) {
    expect(open[finger]).toBeLessThan(0.55)
    expect(fist[finger]).toBeGreaterThan(0.7)
  }
  for (const knuckle of KNUCKLES) expect(fist[knuckle]).toBeLessThan(open[knuckle] - 0.4)
})

it('creases do not depend on where the hand is and how it is turned', () => {
  const still = activations(simulatedJoints(0.6, PLACE))
  const turn = new Quaternion().setFromAxisAngle(new Vector3(1, 2, 3).normalize(), 2)
  const joints = simulatedJoints(0.6, new Vector3(-1, 0.5, 2))
  for (const { quaternion } of Object.values(joints)) quaternion.premultiply(turn)
  const turned = activations(joints)
  for (const finger of [...FINGERS, ...KNUCKLES]) expect(turned[finger]).toBeCloseTo(still[finger], 5)
})

it('puts the wrist at the joint, and points each finger along its joint', () => {
  const joints = simulatedJoints(0.3, PLACE)
  activations(joints)
  const wrist = hand.getObjectByName('wristL')!
  expect(wrist.getWorldPosition(new Vector3()).distanceTo(PLACE)).toBeLessThan(1e-6)
  const tip = hand.getObjectByName('finger2-3L')!
  const along = new Vector3(0, 1, 0).applyQuaternion(tip.getWorldQuaternion(new Quaternion()))
  const wanted = new Vector3(0, 0, -1).applyQuaternion(joints['index-finger-phalanx-distal'].quaternion)
  expect(along.distanceTo(wanted)).toBeLessThan(1e-6)
})

it('keeps the pose while the hand is not tracked', () => {
  const fist = activations(simulatedJoints(1, PLACE))
  const hidden = simulatedJoints(0, PLACE)
  for (const joint of Object.values(hidden)) joint.visible = false
  const [finger] = FINGERS
  expect(activations(hidden)[finger]).toBe(fist[finger])
  expect(activations({})[finger]).toBe(fist[finger])
})
