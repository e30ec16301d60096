import {
  AnimationClip,
  Group,
  InterpolateDiscrete,
  type Mesh,
  NumberKeyframeTrack,
  type Object3D,
  QuaternionKeyframeTrack,
} from 'three'
import { beforeEach, expect, it } from 'vitest'
import { ClipPlayer } from '../../../../studio/src/viewer/pose/clip-player.ts'
import { blendMesh } from '../../../blend-mesh.ts'

let face: Group
let mesh: Mesh
let joint: Object3D
let player: ClipPlayer
let begun: number

/** Clip as GLTFLoader reads it. It turns a joint by 180 degrees about x in two seconds, and moves two blendshapes. */
const nod = () =>
  new AnimationClip('nod', 2, [
    new QuaternionKeyframeTrack(`${joint.uuid}.quaternion`, [0, 2], [0, 0, 0, 1, 1, 0, 0, 0]),
    new NumberKeyframeTrack(`${mesh.uuid}.morphTargetInfluences`, [0, 2], [0, 1, 1, 0]),
  ])

beforeEach(() => {
  face = new Group()
  mesh = blendMesh('browInnerUp', 'jawOpen')
  joint = new Group()
  face.add(joint.add(mesh))
  begun = 0
  const viewer = { avatar: { root: face }, move: (change: () => void) => change() }
  player = new ClipPlayer({
    viewer: { peek: () => viewer } as never,
    begin: () => begun++,
    onPose: () => {},
  })
  player.open(face, [nod()])
})

const takeOf = (name: string, path: string, range: [number, number] = [0, 1]) => {
  return { name, animation: new AnimationClip('', 1, [new NumberKeyframeTrack(path, [0, 1], [0, 1])]), range }
}

const pose = () =>
  [...mesh.morphTargetInfluences!, joint.quaternion.x].map((value) => Number(value.toFixed(4)))
const REST = [0, 0, 0]
/** Pose in the middle of the clip, after a turn of 90 degrees. */
const HALFWAY = [0.5, 0.5, Number(Math.SQRT1_2.toFixed(4))]

it('a clip does not play until it is asked to', () => {
  player.advance(1)
  expect(pose()).toEqual(REST)
  expect(player.clip.value?.name).toBe('nod')
  expect({ begun, isPlaying: player.isPlaying.value }).toEqual({ begun: 0, isPlaying: false })
})

it('joints and blendshapes move together until the clip is paused', () => {
  player.play()
  player.advance(0.5)
  player.advance(0.5)
  expect(pose()).toEqual(HALFWAY)
  player.pause()
  player.advance(0.5)
  expect(pose()).toEqual(HALFWAY)
  expect(player.time.value).toBe(1)
  player.play()
  player.advance(0.5)
  expect(player.time.value).toBe(1.5)
  expect(begun).toBe(1)
})

it('dragging the time shows the pose at that time without playing, forwards and backwards', () => {
  player.scrub(2)
  expect(pose()).toEqual([1, 0, 1])
  player.scrub(1)
  expect(pose()).toEqual(HALFWAY)
  player.advance(0.5)
  expect(pose()).toEqual(HALFWAY)
  expect(player.isShown.value).toBe(true)
})

it('a looping clip starts again at its end, and another one stops there and plays again from its start', () => {
  player.play()
  player.advance(3)
  expect(pose()).toEqual(HALFWAY)
  player.isLooped.value = false
  player.advance(9)
  expect(pose()).toEqual([1, 0, 1])
  expect(player.isPlaying.value).toBe(false)
  player.play()
  expect(pose()).toEqual([0, 1, 0])
})

it('the speed of a clip can be set', () => {
  player.speed.value = 0.25
  player.play()
  player.advance(4)
  expect(pose()).toEqual(HALFWAY)
})

it('stopping a clip restores the pose before it', () => {
  mesh.morphTargetInfluences![0] = 0.25
  player.play()
  player.advance(1)
  player.stop()
  expect(pose()).toEqual([0.25, 0, 0])
  expect({ time: player.time.value, isShown: player.isShown.value }).toEqual({ time: 0, isShown: false })
})

it('another clip also starts from the pose before the first, and keeps playing', () => {
  player.play()
  player.advance(1)
  const path = `${mesh.uuid}.morphTargetInfluences[jawOpen]`
  player.setTakes([takeOf('talk', path)])
  player.choose(player.takes.value[0])
  expect(pose()).toEqual(REST)
  player.advance(0.5)
  expect(pose()).toEqual([0, 0.5, 0])
  expect(player.clip.value?.name).toBe('talk')
})

it("a blendshape that is added while a clip plays, such as a muscle's, is not moved", () => {
  mesh.morphTargetInfluences!.push(0.3)
  player.play()
  player.advance(1)
  expect(mesh.morphTargetInfluences).toEqual([0.5, 0.5, 0.3])
  player.stop()
  expect(mesh.morphTargetInfluences).toEqual([0, 0, 0.3])
})

it('key frames with stepped interpolation are not interpolated', () => {
  const track = new NumberKeyframeTrack(
    `${mesh.uuid}.morphTargetInfluences`,
    [0, 1],
    [0.1, 0.2, 1, 0.9],
    InterpolateDiscrete,
  )
  player.open(face, [new AnimationClip('steps', 1, [track])])
  player.scrub(0.99)
  expect(mesh.morphTargetInfluences).toEqual([0.1, 0.2].map(Math.fround))
})

it('a clip without duration shows its pose', () => {
  player.open(face, [
    new AnimationClip('pose', 0, [
      new NumberKeyframeTrack(`${mesh.uuid}.morphTargetInfluences`, [0], [0.5, 1]),
    ]),
  ])
  player.play()
  player.advance(1)
  expect(mesh.morphTargetInfluences).toEqual([0.5, 1])
})

it('a face without clips has nothing to play', () => {
  player.open(face, [])
  player.play()
  player.scrub(1)
  player.advance(1)
  player.stop()
  expect({ begun, isPlaying: player.isPlaying.value }).toEqual({ begun: 0, isPlaying: false })
})

it('a take plays between its in and out points, and its whole length can be looked at', () => {
  const path = `${mesh.uuid}.morphTargetInfluences[jawOpen]`
  player.setTakes([takeOf('talk', path, [0.25, 0.75])])
  player.choose(player.takes.value[0])
  expect(player.time.value).toBe(0.25)
  player.play()
  player.advance(0.625)
  expect(player.time.value).toBeCloseTo(0.375)
  player.isLooped.value = false
  player.advance(2)
  expect({ time: player.time.value, isPlaying: player.isPlaying.value }).toEqual({
    time: 0.75,
    isPlaying: false,
  })
  player.scrub(1)
  expect(pose()).toEqual([0, 1, 0])
  player.play()
  expect(player.time.value).toBe(0.25)
})

it('a take that is renamed or trimmed keeps playing, and one that is deleted stops', () => {
  const path = `${mesh.uuid}.morphTargetInfluences[jawOpen]`
  const take = takeOf('talk', path)
  player.setTakes([take])
  player.choose(take)
  player.play()
  player.advance(0.5)
  player.setTakes([{ ...take, name: 'speak', range: [0, 0.75] }])
  expect({ name: player.clip.value?.name, isPlaying: player.isPlaying.value }).toEqual({
    name: 'speak',
    isPlaying: true,
  })
  player.setTakes([])
  expect({ name: player.clip.value?.name, isShown: player.isShown.value }).toEqual({
    name: 'nod',
    isShown: false,
  })
  expect(pose()).toEqual(REST)
})
