import { AnimationMixer, Group, type Mesh } from 'three'
import { expect, it } from 'vitest'
import type { Capture } from '../../../../studio/src/capture/live-link-face.ts'
import { takeClip } from '../../../../studio/src/capture/take-clip.ts'
import { takeOfCapture } from '../../../../studio/src/capture/take-of-capture.ts'
import { blendMesh } from '../../../blend-mesh.ts'

const CAPTURE: Capture = {
  name: 'take',
  times: Float32Array.of(0, 2),
  weights: new Map([
    ['BrowInnerUp', Float32Array.of(0, 1)],
    ['JawOpen', Float32Array.of(0, 0.5)],
    ['TongueOut', Float32Array.of(1, 1)],
  ]),
}

/** Returns a face with one mesh for each list of blendshapes. */
const faceOf = (...meshes: string[][]) => new Group().add(...meshes.map((names) => blendMesh(...names)))

/** Plays the take up to a time, and returns the weights of each mesh. */
function weightsAt(face: Group, time: number): number[][] {
  const mixer = new AnimationMixer(face)
  const targets = face.children.flatMap((mesh) => Object.keys((mesh as Mesh).morphTargetDictionary!))
  mixer.clipAction(takeClip(takeOfCapture(CAPTURE, targets).motion, face)).play()
  mixer.setTime(time)
  return face.children.map((mesh) => (mesh as Mesh).morphTargetInfluences!)
}

it.each([
  ['of ARKit', ['browInnerUp', 'jawOpen']],
  ['of the app', ['BrowInnerUp', 'JawOpen']],
  ['with prefixes', ['blendShape1.browInnerUp', 'BS_jawOpen']],
])('a take moves blendshapes with names %s', (_, names) => {
  expect(weightsAt(faceOf(names), 1)).toEqual([[0.5, 0.25]])
})

it('a take moves each mesh, and both halves of a blendshape that the face splits into left and right', () => {
  const face = faceOf(['jawOpen', 'smile'], ['browInnerUp_L', 'browInnerUp_R', 'jawOpen'])
  expect(weightsAt(face, 1)).toEqual([
    [0.25, 0],
    [0.5, 0.5, 0.25],
  ])
})

it('blendshapes that a take lacks are 0 while it plays', () => {
  const face = faceOf(['jawOpen', 'mouthPucker'])
  ;(face.children[0] as Mesh).morphTargetInfluences![1] = 0.8
  expect(weightsAt(face, 1)).toEqual([[0.25, 0]])
})

it('a capture is refused if the face has none of its blendshapes', () => {
  expect(() => takeOfCapture(CAPTURE, ['Fcl_ALL_Joy'])).toThrow(
    'Studio: the face has none of the blendshapes in take, allowed: names of ARKit, such as browInnerUp; name its',
  )
})
