import type { WrinkleDriver } from 'furrow'
import { addDrivers, Wrinkles } from 'furrow/three'
import { InstancedMesh, type Mesh } from 'three'
import { describe, expect, it } from 'vitest'
import { Frame, type FrameMember } from '../../../packages/furrow/src/runtime/frame.ts'
import { meshOf } from '../../../packages/furrow/src/three/wrinkles-base.ts'
import { blendMesh } from '../../blend-mesh.ts'
import { layer, randomNormals } from '../../cases.ts'
import { morph, ramp, STRAIGHT } from '../../drivers.ts'
import { seeded } from '../../random.ts'
import { frameOf } from '../three/stub-renderer.ts'

/** Fake renderer, which counts its pictures. */
interface Engine {
  pictures: number
}

/** Returns a frame and its members (faces), whose calls are recorded in `log`. */
function recorded(names: string[]) {
  const log: string[] = []
  const frame = new Frame<Engine>((engine) => engine.pictures)
  const hidden = new Set<string>()
  const entries = Object.fromEntries(
    names.map((name) => {
      const member: FrameMember<Engine> = {
        readInputs: () => log.push(`inputs ${name}`),
        evaluateDrivers: () => log.push(`drivers ${name}`),
        applyActivations: () => log.push(`activations ${name}`),
        collectInfluence() {
          if (hidden.has(name)) return false
          log.push(`influence ${name}`)
          return true
        },
        composeNormals: () => log.push(`compose ${name}`),
      }
      return [name, frame.add(member)]
    }),
  )
  frame.targets.push({ draw: () => log.push('atlas') })
  const engine = { pictures: 0 }
  const drawOn = (by: Engine, ...seen: string[]): string[] => {
    log.length = 0
    by.pictures++
    for (const name of seen) {
      frame.begin(entries[name], by)
      log.push(`draw ${name}`)
    }
    return [...log]
  }
  return {
    frame,
    entries,
    hidden,
    engine,
    /** Draws one picture of some members, and returns the recorded calls. */
    draw: (...seen: string[]) => drawOn(engine, ...seen),
    drawOn,
    log,
  }
}

/** Imitates an engine that announces each picture of a scene before drawing. Returns its draw function. */
function early({ frame, entries, engine, log }: ReturnType<typeof recorded>, isCounted = false) {
  /** Name of the last member drawn in the scene. */
  let known: string | undefined
  return (...seen: string[]): string[] => {
    log.length = 0
    if (isCounted) engine.pictures++
    frame.beginImage(engine, known === undefined ? -1 : entries[known].seen, isCounted)
    log.push('picture')
    if (!isCounted) engine.pictures++
    for (const name of seen) {
      frame.begin(entries[name], engine)
      known = name
      log.push(`draw ${name}`)
    }
    return [...log]
  }
}

/** Returns the calls of all phases of some members. */
const phases = (...names: string[]) => [
  ...['inputs', 'drivers', 'activations', 'influence'].flatMap((phase) =>
    names.map((name) => `${phase} ${name}`),
  ),
  'atlas',
  ...names.map((name) => `compose ${name}`),
]

describe('a frame', () => {
  it('runs each phase for all faces before the next, when the first face is drawn', () => {
    const { draw } = recorded(['a', 'b', 'c'])
    expect(draw('a', 'b', 'c')).toEqual([...phases('a', 'b', 'c'), 'draw a', 'draw b', 'draw c'])
    expect(draw('b', 'a')).toEqual([...phases('a', 'b', 'c'), 'draw b', 'draw a'])
    // `c` was not drawn in the last frame, so its phases do not run.
    expect(draw('a', 'b')).toEqual([...phases('a', 'b'), 'draw a', 'draw b'])
  })

  it('runs the phases of newly visible faces separately, once per frame', () => {
    const { draw } = recorded(['a', 'b'])
    draw('a', 'b')
    draw('a')
    expect(draw('a', 'a', 'b', 'b')).toEqual([
      ...phases('a'),
      'draw a',
      'draw a',
      ...phases('b'),
      'draw b',
      'draw b',
    ])
  })

  it('evaluates the drivers of a face without influence, and draws its influence once there is some', () => {
    const { draw, hidden } = recorded(['a', 'b'])
    draw('a', 'b')
    hidden.add('a')
    const without = phases('a', 'b').filter((call) => call !== 'influence a')
    expect(draw('a', 'b')).toEqual([...without, 'draw a', 'draw b'])
    const { frame, entries, engine, log } = recorded(['c'])
    engine.pictures++
    frame.begin(entries.c, engine)
    expect(log).toEqual(phases('c'))
  })

  it('is separate for each engine, whatever numbers of pictures the engines have drawn', () => {
    for (const lead of [0, 1, 2]) {
      const { draw, drawOn } = recorded(['a', 'b'])
      const other = { pictures: lead }
      draw('a')
      for (let i = 0; i < 3; i++) {
        expect(drawOn(other, 'b', 'b')).toEqual([...phases('b'), 'draw b', 'draw b'])
        expect(draw('a')).toEqual([...phases('a'), 'draw a'])
      }
      // Both engines draw this face.
      expect(drawOn(other, 'b', 'a')).toEqual([...phases('b'), 'draw b', ...phases('a'), 'draw a'])
      expect(draw('a')).toEqual([...phases('a'), 'draw a'])
    }
  })

  it.each([false, true])(
    'begins before the first draw call of a picture (picture already counted: %s)',
    (isCounted) => {
      const all = recorded(['a', 'b'])
      const draw = early(all, isCounted)
      // The phases of `b` run although `b` has never been drawn.
      expect(draw('a')).toEqual([...phases('a', 'b'), 'picture', 'draw a'])
      expect(draw('a')).toEqual([...phases('a'), 'picture', 'draw a'])
      expect(draw('a', 'b')).toEqual([...phases('a'), 'picture', 'draw a', ...phases('b'), 'draw b'])
      // The members' phases run even for pictures in which no member is drawn.
      for (let i = 0; i < 2; i++) expect(draw()).toEqual([...phases('a', 'b'), 'picture'])
      expect(draw('b', 'a')).toEqual([...phases('a', 'b'), 'picture', 'draw b', 'draw a'])
    },
  )

  it('runs together all members whose inputs may still change, when the first of them is drawn', () => {
    const all = recorded(['a', 'late', 'later'])
    for (const name of ['late', 'later']) all.entries[name].isLate = true
    const draw = early(all)
    draw('a', 'late', 'later')
    const lateOnes = phases('late', 'later')
    expect(draw('late', 'later', 'a')).toEqual([
      ...phases('a'),
      'picture',
      ...lateOnes,
      ...['late', 'later', 'a'].map((name) => `draw ${name}`),
    ])
  })

  it('runs members together in unannounced pictures between announced ones', () => {
    const all = recorded(['a', 'b'])
    const draw = early(all)
    draw('a', 'b')
    for (let i = 0; i < 3; i++) {
      expect(all.draw('b', 'a')).toEqual([...phases('a', 'b'), 'draw b', 'draw a'])
      expect(draw('a', 'b').filter((call) => call === 'atlas')).toHaveLength(1)
    }
  })

  it('is separate for each scene if an engine draws several in turn', () => {
    const all = recorded(['a', 'b'])
    const [first, second] = [early(all), early(all)]
    first('a')
    second('b')
    for (let i = 0; i < 3; i++) {
      expect(first('a')).toEqual([...phases('a'), 'picture', 'draw a'])
      expect(second('b')).toEqual([...phases('b'), 'picture', 'draw b'])
    }
  })

  it('can be updated manually; without an engine, the update ends after the activations', () => {
    const { frame, entries, engine, log } = recorded(['a', 'b'])
    frame.update(entries.b, null)
    expect(log).toEqual(['inputs b', 'drivers b', 'activations b'])
    log.length = 0
    frame.update(entries.b, engine)
    expect(log).toEqual(phases('b'))
  })
})

const aging: WrinkleDriver = { type: 'age', area: 'brow', curve: ramp(20, 70, 0.5) }

function wrinklesOn<M extends Mesh>(mesh: M) {
  const weights = { width: 2, height: 2, data: new Uint8Array(4).fill(255) }
  const layers = [layer('skin', 'detail', randomNormals(seeded(1), 2))]
  const wrinkles = new Wrinkles(mesh, { layers, areas: ['brow', 'nose'].map((name) => ({ name, weights })) })
  return { mesh, wrinkles, draw: frameOf(mesh) }
}

/** Creates two instances of a mesh, with the blendshape at 0.25 and 0.75. */
function instances() {
  const pose = blendMesh('jawOpen')
  const mesh = new InstancedMesh(pose.geometry, pose.material, 2)
  for (const [i, weight] of [0.25, 0.75].entries()) {
    pose.morphTargetInfluences![0] = weight
    mesh.setMorphAt(i, pose)
  }
  const face = wrinklesOn(mesh)
  addDrivers(face.wrinkles, [morph('brow', 'jawOpen'), { ...aging, area: 'nose' }])
  const activations = (area: string) => [0, 1].map((i) => face.wrinkles.getActivation(area, i))
  return { ...face, activations }
}

describe('instances', () => {
  it.each(['default', 'off'] as const)('are all driven in mode %s', (mode) => {
    const { wrinkles, draw, activations } = instances()
    wrinkles.mode = mode
    draw()
    expect(activations('brow')).toEqual([0.25, 0.75])
  })

  it.each(['paper', 'composed'] as const)('are refused by mode %s, which does not support them', (mode) => {
    const { wrinkles, draw, activations } = instances()
    expect(() => {
      wrinkles.mode = mode
    }).toThrow(new RegExp(`Wrinkles.mode: mode unsupported for instances, got "${mode}"`))
    expect(wrinkles.mode).toBe('default')
    draw()
    expect(activations('brow')).toEqual([0.25, 0.75])
  })

  it('have their own inputs', () => {
    const { wrinkles, draw, activations } = instances()
    wrinkles.inputs.set('age', 70)
    wrinkles.inputs.set('age', 45, 1)
    draw()
    expect(activations('nose')).toEqual([0.5, 0.25])
  })
})

it('age adds to the value of setActivation in an area without other drivers, also before a VRM has expressions', () => {
  const { wrinkles, draw } = wrinklesOn(blendMesh())
  let found = 0
  const expressions = () => {
    found++
    return undefined
  }
  meshOf(wrinkles).drive([aging], { expressions }, true)
  wrinkles.setActivation('brow', 0.3)
  wrinkles.inputs.set('age', 70)
  expect([found, wrinkles.isDriven('brow')]).toEqual([0, false])
  for (let i = 0; i < 3; i++) {
    draw()
    expect(wrinkles.getActivation('brow')).toBeCloseTo(0.8, 6)
  }
  expect(found).toBe(1)
})

it('before the first frame, isDriven is true for an area that another area drives, and false for age alone', () => {
  const { wrinkles } = wrinklesOn(blendMesh())
  const between: WrinkleDriver = {
    type: 'area',
    area: 'nose',
    areas: [{ name: 'brow', weight: 1 }],
    rule: 'sum',
    curve: STRAIGHT,
  }
  addDrivers(wrinkles, [aging, between])
  expect([wrinkles.isDriven('brow'), wrinkles.isDriven('nose')]).toEqual([false, true])
})
