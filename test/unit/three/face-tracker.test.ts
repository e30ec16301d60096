import { FACE_TRACKER_DEFAULTS, FaceTracker, type FaceTrackerOptions } from 'furrow/three'
import { Group } from 'three'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { blendMesh } from '../../blend-mesh.ts'
import { seeded } from '../../random.ts'

const scoreList = (scores: Record<string, number>) =>
  Object.entries(scores).map(([categoryName, score]) => ({ categoryName, score }))

/** A face with the given blendshapes, its tracker, and a function that returns the weights. */
function tracked(names: readonly string[], options: FaceTrackerOptions = {}) {
  const face = blendMesh(...names)
  const tracker = new FaceTracker(face, options)
  let time = 0
  return {
    face,
    tracker,
    /** Sets constant scores for some seconds at 30 frames per second, and returns the weights. */
    hold(scores: Record<string, number>, seconds = 1) {
      for (const end = time + seconds; time < end; time += 1 / 30) tracker.set(scores, time)
      return [...face.morphTargetInfluences!]
    },
  }
}

afterEach(() => vi.restoreAllMocks())

describe('without a filter', () => {
  it('moves each mesh of the face, with its names in any spelling, and keeps other blendshapes', () => {
    const warn = vi.spyOn(console, 'warn')
    const skin = blendMesh('browDown_L', 'browInnerUp_L', 'browInnerUp_R', 'tongueOut')
    const lashes = blendMesh('Fcl.browDownLeft')
    skin.morphTargetInfluences![3] = 0.3
    const tracker = new FaceTracker(new Group().add(skin, lashes), { filter: null })
    tracker.set(scoreList({ _neutral: 0.9, browDownLeft: 0.7, browInnerUp: 0.4 }))
    expect(skin.morphTargetInfluences).toEqual([0.7, 0.4, 0.4, 0.3])
    expect(lashes.morphTargetInfluences).toEqual([0.7])
    // The next scores have another order and fewer names, and one score is invalid.
    tracker.set({ browInnerUp: Number.NaN, browDownLeft: 0.1 })
    expect(skin.morphTargetInfluences).toEqual([0.1, 0, 0, 0.3])
    expect(warn).not.toHaveBeenCalled()
  })

  it('logs one warning for names that the face lacks', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { face, tracker } = tracked(['jawOpen'], { filter: null })
    for (let i = 0; i < 3; i++) {
      tracker.set(scoreList({ _neutral: 1, trunkUp: 1, jawOpen: 0.5 }))
      tracker.set({ jawOpen: 0.5, trunkUp: 1, HeadYaw: 0.2 })
    }
    expect(face.morphTargetInfluences).toEqual([0.5])
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toContain('got "trunkUp"')
  })

  it('keeps weights in 0..1 for any score', () => {
    const { face, tracker } = tracked(['jawOpen'], { filter: null, gains: { jaw_open: 3 } })
    for (const [score, weight] of [
      [0.1, 0.3],
      [0.9, 1],
      [Number.POSITIVE_INFINITY, 1],
      [-5, 0],
      ['x' as never, 0],
    ]) {
      tracker.set({ jawOpen: score })
      expect(face.morphTargetInfluences![0]).toBeCloseTo(weight)
    }
  })
})

it('refuses a face without blendshapes', () => {
  expect(() => new FaceTracker(new Group()).set({ jawOpen: 1 })).toThrow(/FaceTracker: no morph targets/)
})

describe('names of sources', () => {
  const arkit = ['eyeBlink', 'mouthSmile', 'browDown', 'browOuterUp', 'eyeWide', 'mouthFrown', 'mouthStretch']
  const face = [...arkit.flatMap((name) => [`${name}Left`, `${name}Right`]), 'jawOpen', 'mouthPucker']
  it.each<[source: string, score: Record<string, number>, shape: string, weight: number]>([
    ['MediaPipe', { mouthSmileLeft: 0.5 }, 'mouthSmileLeft', 0.5],
    ['Live Link Face', { MouthSmileLeft: 0.5 }, 'mouthSmileLeft', 0.5],
    ['iFacialMocap', { mouthSmile_L: 0.5 }, 'mouthSmileLeft', 0.5],
    ['VMC', { Blink_L: 0.5 }, 'eyeBlinkLeft', 0.5],
    ['VMC', { Blink: 0.5 }, 'eyeBlinkRight', 0.5],
    ['VMC', { A: 0.5 }, 'jawOpen', 0.3],
    ['VRM 1.0', { aa: 0.5 }, 'jawOpen', 0.3],
    ['VRM', { Joy: 0.5 }, 'mouthSmileRight', 0.4],
    ['Oculus', { viseme_U: 1 }, 'mouthPucker', 0.7],
    ['Oculus, short', { U: 1 }, 'mouthPucker', 0.7],
    ['Oculus, short', { nn: 1 }, 'jawOpen', 0.12],
    ['VRChat', { 'vrc.v_ou': 1 }, 'mouthPucker', 0.7],
    ['OpenSeeFace', { EyeLeft: -0.5 }, 'eyeBlinkLeft', 0.5],
    ['OpenSeeFace', { EyeLeft: 0.5 }, 'eyeWideLeft', 0.5],
    ['OpenSeeFace', { EyebrowUpDownRight: -0.5 }, 'browDownRight', 0.5],
    ['OpenSeeFace', { MouthCornerUpDownLeft: -0.5 }, 'mouthFrownLeft', 0.5],
    ['OpenSeeFace', { MouthOpen: 0.5 }, 'jawOpen', 0.5],
  ])('%s: %o', (_, scores, shape, weight) => {
    const warn = vi.spyOn(console, 'warn')
    expect(tracked(face, { filter: null }).hold(scores)[face.indexOf(shape)]).toBeCloseTo(weight, 6)
    expect(warn).not.toHaveBeenCalled()
  })

  it('prefers a blendshape of the face to a mix of others', () => {
    const hold = (name: string) => tracked([name, 'jawOpen'], { filter: null }).hold({ [name]: 0.5 })
    expect(hold('viseme_aa')).toEqual([0.5, 0])
    expect(hold('A')).toEqual([0.5, 0])
  })

  it('moves presets of VRM by scores of ARKit', () => {
    const { hold } = tracked(['Fcl_EYE_Close_L', 'Fcl_MTH_A'], { filter: null })
    expect(hold({ eyeBlinkLeft: 0.5, jawOpen: 0.25 })).toEqual([0.5, 0.25])
  })
})

it('swaps left and right, also while it runs', () => {
  const names = ['mouthSmileLeft', 'mouthSmileRight', 'jawLeft', 'jawRight']
  const { tracker, hold } = tracked(names, { filter: null, mirror: true })
  expect(hold({ mouthSmileLeft: 0.5, jawRight: 0.25 })).toEqual([0, 0.5, 0.25, 0])
  tracker.mirror = false
  expect(hold({ mouthSmileLeft: 0.5, jawRight: 0.25 })).toEqual([0.5, 0, 0, 0.25])
})

describe('calibration', () => {
  it('makes a biased neutral face neutral, and reaches 1 at the highest score', () => {
    const { tracker, hold } = tracked(['browDownLeft'])
    expect(hold({ browDownLeft: 0.3 })[0]).toBeCloseTo(0.3)
    tracker.record('neutral')
    expect(tracker.recording).toBe('neutral')
    hold({ browDownLeft: 0.3 }, 2.1)
    expect(tracker.recording).toBeNull()
    expect(hold({ browDownLeft: 0.3 })).toEqual([0])
    tracker.record('range', 1)
    hold({ browDownLeft: 0.6 }, 1.1)
    expect(hold({ browDownLeft: 0.6 })[0]).toBeCloseTo(1, 2)
    expect(hold({ browDownLeft: 0.45 })[0]).toBeCloseTo(0.5, 2)
  })

  it('keeps the range of shapes that the person did not move', () => {
    const { tracker, hold } = tracked(['browDownLeft'])
    tracker.record('range', 1)
    hold({ browDownLeft: 0.01 }, 1.1)
    expect(hold({ browDownLeft: 0.5 })[0]).toBeCloseTo(0.5, 2)
  })

  it('can be saved and loaded, also for names in another spelling', () => {
    const first = tracked(['browDownLeft'])
    first.tracker.record('neutral')
    first.hold({ browDownLeft: 0.3 }, 2.1)
    const saved = JSON.parse(JSON.stringify(first.tracker.calibration))
    const { tracker, hold } = tracked(['browDown_L'])
    tracker.calibration = saved
    expect(hold({ browDown_L: 0.3 })).toEqual([0])
    expect(tracker.calibration).toEqual(saved)
    expect(tracker.calibration).toMatchObject({ version: 1, shapes: { browDownLeft: { extreme: 1 } } })
  })

  const shape = { neutral: 0, noise: 0, extreme: 1 }
  it.each<[name: string, value: unknown]>([
    ['null', null],
    ['text', '{}'],
    ['another version', { version: 2, shapes: {} }],
    ['no shapes', { version: 1 }],
    ['an unknown field', { version: 1, shapes: {}, face: 1 }],
    ['a shape without numbers', { version: 1, shapes: { jawOpen: {} } }],
    ['NaN', { version: 1, shapes: { jawOpen: { ...shape, neutral: Number.NaN } } }],
    ['negative noise', { version: 1, shapes: { jawOpen: { ...shape, noise: -1 } } }],
    ['an empty range', { version: 1, shapes: { jawOpen: { ...shape, neutral: 1 } } }],
    ['a control character in a name', { version: 1, shapes: { 'jaw\n': shape } }],
    [
      'too many shapes',
      { version: 1, shapes: Object.fromEntries(Array.from({ length: 513 }, (_, i) => [`s${i}`, shape])) },
    ],
  ])('refuses %s, and keeps the previous calibration', (_, value) => {
    const { tracker, hold } = tracked(['jawOpen'])
    hold({ jawOpen: 0.5 })
    const before = tracker.calibration
    expect(() => {
      tracker.calibration = value as never
    }).toThrow(/^FaceTracker: calibration/)
    expect(tracker.calibration).toEqual(before)
  })
})

describe('substitutes', () => {
  const names = [
    'mouthUpperUpLeft',
    'browDownLeft',
    'noseSneerLeft',
    'mouthSmileLeft',
    'eyeSquintLeft',
    'cheekSquintLeft',
  ]
  const face = { mouthUpperUpLeft: 0, browDownLeft: 0, noseSneerLeft: 0, mouthSmileLeft: 0, eyeSquintLeft: 0 }

  it('sneers when the upper lip rises and the brow falls, and not by one of them', () => {
    const sneer = (scores: object) => tracked(names).hold({ ...face, ...scores })[2]
    expect(sneer({ mouthUpperUpLeft: 0.5, browDownLeft: 0.5, noseSneerLeft: 0.02 })).toBeGreaterThan(0.6)
    expect(sneer({ mouthUpperUpLeft: 1 })).toBe(0)
    expect(sneer({ browDownLeft: 1 })).toBe(0)
  })

  it('raises the cheeks in a smile and a squint, also if the source does not name them', () => {
    expect(tracked(names).hold({ ...face, mouthSmileLeft: 0.8, eyeSquintLeft: 0.5 })[5]).toBeCloseTo(0.62, 2)
  })

  it('do not act on a shape that the source delivers', () => {
    const { hold } = tracked(names)
    hold({ ...face, noseSneerLeft: 0.8 })
    expect(hold({ ...face, mouthUpperUpLeft: 0.5, browDownLeft: 0.5 })[2]).toBe(0)
  })
})

describe('filter', () => {
  it('starts at once, continues after a repeated time, and starts again after a pause', () => {
    const { face, tracker } = tracked(['jawOpen'])
    const weightAt = (jawOpen: number, time: number) => {
      tracker.set({ jawOpen }, time)
      return face.morphTargetInfluences![0]
    }
    expect(weightAt(0.5, 0)).toBe(0.5)
    expect(weightAt(0.6, 0)).toBe(0.5)
    const later = weightAt(0.6, 0.01)
    expect(later).toBeGreaterThan(0.5)
    expect(later).toBeLessThan(0.6)
    expect(weightAt(0.9, 10)).toBe(0.9)
  })

  it('reduces noise by the default dead zone and filter', () => {
    const random = seeded(3)
    const { face, tracker } = tracked(['mouthSmileLeft'])
    const weights = Array.from({ length: 90 }, (_, i) => {
      tracker.set({ mouthSmileLeft: 0.05 + 0.1 * (random() - 0.5) }, i / 30)
      return face.morphTargetInfluences![0]
    })
    expect(Math.max(...weights.slice(30))).toBeLessThan(0.06)
  })
})

it.each<[start: RegExp, options: unknown]>([
  [/^FaceTracker: unknown option, got "smooth"/, { smooth: 1 }],
  [/^FaceTracker: unknown option, got "cutoff"/, { filter: { cutoff: 1 } }],
  [/^FaceTracker: invalid option filter, got 1/, { filter: 1 }],
  [/^FaceTracker: invalid option filter.minCutoff, got 0/, { filter: { minCutoff: 0 } }],
  [/^FaceTracker: invalid option filter.beta, got NaN/, { filter: { beta: Number.NaN } }],
  [/^FaceTracker: invalid option deadZone, got 1/, { deadZone: 1 }],
  [/^FaceTracker: invalid gain of jawOpen, got -1/, { gains: { jawOpen: -1 } }],
  [/^FaceTracker: invalid options, got "null"/, null],
])('refuses options: %s', (start, options) => {
  expect(() => new FaceTracker(blendMesh('jawOpen'), options as never)).toThrow(start)
  expect(FACE_TRACKER_DEFAULTS.deadZone).toBe(0.04)
})
