import { FaceTracker, type FrameScores } from 'furrow/three'
import { Group, type Mesh } from 'three'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { TakeMotion } from '../../../../studio/src/document/take.ts'
import { Live } from '../../../../studio/src/live/live.ts'
import type { SourceEvents } from '../../../../studio/src/live/source.ts'
import { targetDials } from '../../../../studio/src/viewer/pose/dials.ts'
import { LivePose } from '../../../../studio/src/viewer/pose/live-pose.ts'
import { SkeletonPose } from '../../../../studio/src/viewer/pose/skeleton-pose.ts'
import { blendMesh } from '../../../blend-mesh.ts'

let mesh: Mesh
let pose: LivePose
let live: Live
let source: SourceEvents
let takes: TakeMotion[]
let errors: string[]
let log: string[]
let isHeld: boolean
/** Time of the last frame, seconds. */
let time: number
/** Error that the next start of a source has. */
let failure: Error | null

beforeEach(async () => {
  const stored = new Map<string, string>()
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => stored.get(key) ?? null,
    setItem: (key: string, value: string) => stored.set(key, value),
    removeItem: (key: string) => stored.delete(key),
  })
  mesh = blendMesh('jawOpen', 'mouthSmileLeft', 'mouthSmileRight')
  const root = new Group().add(mesh)
  const viewer = {
    avatar: { root },
    targets: targetDials(root),
    areas: [],
    skeleton: new SkeletonPose(root, new Map()),
    move: (change: () => void) => change(),
  }
  ;[takes, errors, log, isHeld, time, failure] = [[], [], [], false, 0, null]
  pose = new LivePose({
    viewer: { peek: () => viewer } as never,
    begin: () => log.push('begin'),
    isHeld: () => isHeld,
    onPose: () => {},
  })
  live = newLive()
  live.change({ isSmooth: false, mirror: false })
})
afterEach(() => vi.unstubAllGlobals())

const newLive = () =>
  new Live({
    pose,
    load: async (name) => ({
      Tracker: FaceTracker,
      start: async (_, events) => {
        if (failure) throw failure
        source = events
        log.push(`start ${name}`)
        return { stop: () => log.push('stop') }
      },
    }),
    ready: async () => {
      if (failure) throw failure
    },
    onTake: (motion) => takes.push(motion),
    onFull: () => log.push('full'),
    onError: (error) => errors.push((error as Error).message),
  })

/** Sends frames for some seconds. @param scoresAt scores, which can depend on the time since the first of these frames. */
function send(seconds: number, scoresAt: (time: number) => FrameScores, sender = 'webcam', rate = 30): void {
  const start = time
  for (const end = time + seconds; time < end - 1e-9; ) {
    time += 1 / rate
    source.onScores(scoresAt(time - start), time, sender)
  }
}
const weights = () => mesh.morphTargetInfluences!.map((weight) => Number(weight.toFixed(3)))

it('scores move the face, and stopping restores the pose that it had before', async () => {
  mesh.morphTargetInfluences![1] = 0.7
  await live.start()
  expect({ log, weights: weights(), status: live.status.value }).toEqual({
    log: ['begin', 'start webcam'],
    weights: [0, 0, 0],
    status: 'starting',
  })
  send(0.1, () => ({ jawOpen: 0.5 }))
  expect({ weights: weights(), status: live.status.value, sender: live.sender.value }).toEqual({
    weights: [0.5, 0, 0],
    status: 'connected',
    sender: 'webcam',
  })
  live.stop()
  expect({ log: log.at(-1), weights: weights(), status: live.status.value }).toEqual({
    log: 'stop',
    weights: [0, 0.7, 0],
    status: null,
  })
  source.onScores({ jawOpen: 1 }, time + 1, 'webcam')
  source.onStatus('lost')
  expect({ weights: weights(), status: live.status.value }).toEqual({ weights: [0, 0.7, 0], status: null })
})

it('other motion of the face ends the source, and a shown clip only holds it', async () => {
  await live.start()
  isHeld = true
  send(0.1, () => ({ jawOpen: 0.5 }))
  expect(weights()).toEqual([0, 0, 0])
  isHeld = false
  send(0.1, () => ({ jawOpen: 0.5 }))
  expect(weights()).toEqual([0.5, 0, 0])
  pose.stop()
  expect({ log: log.at(-1), status: live.status.value }).toEqual({ log: 'stop', status: null })
})

it('a source that cannot start leaves the pose, and tells why', async () => {
  mesh.morphTargetInfluences![0] = 0.3
  failure = new Error('no camera was found')
  await expect(live.start()).rejects.toThrow('no camera was found')
  expect({ weights: weights(), status: live.status.value }).toEqual({ weights: [0.3, 0, 0], status: null })
})

it('a source that is stopped while it starts is released, or does not start', async () => {
  const loading = live.start()
  live.stop()
  await loading
  expect(log).toEqual([])
  const starting = live.start()
  while (!log.includes('start webcam')) await Promise.resolve()
  live.stop()
  await starting
  expect({ log, status: live.status.value }).toEqual({ log: ['begin', 'start webcam', 'stop'], status: null })
})

it('a source that ends by itself stops with its error', async () => {
  await live.start()
  send(0.1, () => ({ jawOpen: 0.5 }))
  source.onError(new Error('the camera was disconnected'))
  expect({ errors, status: live.status.value, weights: weights() }).toEqual({
    errors: ['the camera was disconnected'],
    status: null,
    weights: [0, 0, 0],
  })
})

it('mirroring swaps the sides at once', async () => {
  await live.start()
  send(0.1, () => ({ mouthSmileLeft: 0.5, mouthSmileRight: 0 }))
  expect(weights()).toEqual([0, 0.5, 0])
  live.change({ mirror: true })
  send(0.1, () => ({ mouthSmileLeft: 0.5, mouthSmileRight: 0 }))
  expect(weights()).toEqual([0, 0, 0.5])
})

it('calibrates with a countdown, and uses the calibration at the next start, for each sender', async () => {
  await live.start()
  send(0.1, () => ({ jawOpen: 0.2 }))
  live.calibrate('neutral')
  const counted: (number | null)[] = []
  send(2.2, () => {
    const left = live.calibrating.value?.left ?? null
    if (left !== counted.at(-1)) counted.push(left)
    return { jawOpen: 0.2 }
  })
  expect({ counted, isCalibrated: live.isCalibrated.value }).toEqual({
    counted: [2, 1, null],
    isCalibrated: true,
  })
  expect(weights()[0]).toBe(0)
  live.calibrate('range')
  send(10.2, (seconds) => ({ jawOpen: seconds > 2 && seconds < 5 ? 0.6 : 0.2 }))
  send(0.1, () => ({ jawOpen: 0.6 }))
  expect(weights()[0]).toBeCloseTo(1, 2)
  live.stop()

  live = newLive()
  await live.start()
  send(0.1, () => ({ jawOpen: 0.4 }))
  expect(weights()[0]).toBeCloseTo(0.5, 1)
  send(0.1, () => ({ jawOpen: 0.4 }), 'vmc')
  expect({ weights: weights()[0], isCalibrated: live.isCalibrated.value }).toEqual({
    weights: 0.4,
    isCalibrated: false,
  })
})

it('a calibration is saved, reset and loaded, and an invalid one is refused', async () => {
  await live.start()
  send(0.1, () => ({ jawOpen: 0.3 }))
  live.calibrate('neutral')
  send(2.2, () => ({ jawOpen: 0.3 }))
  const saved = structuredClone(live.calibration!)
  expect(saved.shapes.jawOpen.neutral).toBeCloseTo(0.3)
  live.setCalibration(null)
  send(0.1, () => ({ jawOpen: 0.3 }))
  expect({ weights: weights()[0], isCalibrated: live.isCalibrated.value }).toEqual({
    weights: 0.3,
    isCalibrated: false,
  })
  live.setCalibration(saved)
  send(0.1, () => ({ jawOpen: 0.3 }))
  expect({ weights: weights()[0], isCalibrated: live.isCalibrated.value }).toEqual({
    weights: 0,
    isCalibrated: true,
  })
  expect(() => live.setCalibration({ version: 1, shapes: { jawOpen: {} } } as never)).toThrow('FaceTracker')
  expect(live.isCalibrated.value).toBe(true)
})

it('damaged data in the browser counts as not calibrated', async () => {
  localStorage.setItem('furrow-calibration-webcam', '{"version":1,"shapes":7}')
  localStorage.setItem('furrow-live', '{"source":"telepathy"}')
  live = newLive()
  expect(live.settings.value.source).toBe('webcam')
  await live.start()
  send(0.1, () => ({ jawOpen: 0.3 }))
  expect(live.isCalibrated.value).toBe(false)
})

it('settings are kept in the browser, except the address with its secret', () => {
  live.change({ source: 'phone', address: 'ws://127.0.0.1:8765/?token=secret' })
  expect(newLive().settings.value).toEqual({ ...live.settings.value, address: '' })
  expect(localStorage.getItem('furrow-live')).not.toContain('secret')
})

it('records the weights of the face, and nothing else', async () => {
  await live.start()
  await live.toggleRecording()
  expect(live.recorded.value).toBe(null)
  send(0.1, () => ({ jawOpen: 0 }))
  await live.toggleRecording()
  send(2, (seconds) => ({ jawOpen: seconds / 4 }), 'webcam', 60)
  expect(live.recorded.value).toBe(1)
  await live.toggleRecording()
  expect(live.recorded.value).toBe(null)
  const [{ names, weights: recorded }] = takes
  expect(names).toEqual(['jawOpen'])
  expect(recorded).toHaveLength(120)
  expect(recorded[0]).toBeCloseTo(1 / 240, 4)
  expect(recorded[119]).toBeCloseTo(0.5, 4)
})

it('a recording ends with the source, and after ten minutes', async () => {
  await live.start()
  send(0.1, () => ({ jawOpen: 0 }))
  await live.toggleRecording()
  send(1, () => ({ jawOpen: 0.5 }))
  live.stop()
  expect(takes).toHaveLength(1)
  await live.start()
  send(0.1, () => ({ jawOpen: 0 }))
  await live.toggleRecording()
  send(601, () => ({ jawOpen: 0.5 }), 'webcam', 10)
  expect({ full: log.includes('full'), recorded: live.recorded.value }).toEqual({
    full: true,
    recorded: null,
  })
  expect(takes[1].weights).toHaveLength(600 * 60 + 1)
})

it('a recording without scores is refused', async () => {
  await live.start()
  send(0.1, () => ({ jawOpen: 0 }))
  await live.toggleRecording()
  await live.toggleRecording()
  expect(errors).toEqual([
    'Studio: nothing was recorded, because no scores arrived; wait until the source shows a face, then record again',
  ])
})

it('a recording does not start if takes cannot be kept', async () => {
  await live.start()
  send(0.1, () => ({ jawOpen: 0 }))
  failure = new Error('no project')
  await expect(live.toggleRecording()).rejects.toThrow('no project')
  expect({ recorded: live.recorded.value, isPreparing: live.isPreparing.value }).toEqual({
    recorded: null,
    isPreparing: false,
  })
})

it('a face without blendshapes cannot follow', async () => {
  const empty = { avatar: { root: new Group() }, targets: [], areas: [], move: () => {} }
  pose = new LivePose({
    viewer: { peek: () => empty } as never,
    begin: () => {},
    isHeld: () => false,
    onPose: () => {},
  })
  await expect(newLive().start()).rejects.toThrow('open an avatar with blendshapes')
})
