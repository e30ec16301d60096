import { findForks } from 'furrow/internal'
import { beforeEach, describe, expect, test } from 'vitest'
import { remake, withoutAutomatic } from '../../../studio/src/document/automatic.ts'
import type { LayerStroke, StudioArea, StudioDocument } from '../../../studio/src/document/document.ts'
import { setMap } from '../../../studio/src/document/layers.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { editorOn, lines } from './lines/sheet.ts'
import { areaOf, sampleDocument, strokeOf } from './sample-document.ts'

/** Returns an automatic line from one point to another. */
function line(group: string, ...points: [number, number][]): LayerStroke {
  return { ...strokeOf('up', group), curve: 'spline', points, taper: [0.3, 0], isAutomatic: true }
}

/** Makes automatic wrinkles with a fork in the group `forehead`. `shift` moves all lines. */
function automatic(shift: number): StudioDocument {
  const { layers } = sampleDocument()
  const at = (u: number, v: number): [number, number] => [u, v + shift]
  const automaticArea = (name: string): StudioArea => ({
    ...areaOf(name, 'up', 200 + 100 * shift),
    isAutomatic: true,
  })
  return {
    scale: 1000,
    mapSize: 64,
    areaSize: 4,
    layers,
    areas: ['forehead', 'frown'].map(automaticArea),
    strokes: [
      line('forehead', at(0.1, 0.4), at(0.9, 0.4)),
      line('forehead', at(0.4, 0.1), at(0.5, 0.4)),
      line('frown', at(0.2, 0.6), at(0.4, 0.6)),
    ],
    drivers: ['forehead', 'frown'].map(
      (area) => ({ type: 'age', area, ages: [20, 60 + 100 * shift] }) as never,
    ),
    auto: { strength: 1, size: 64, seed: 1 + 10 * shift },
  }
}

let session: Session
let editor: ReturnType<typeof editorOn>['editor']

beforeEach(() => {
  session = new Session()
  session.open(automatic(0))
  ;({ editor } = editorOn(session))
})

const document = () => session.document.value!
const made = automatic(0.1)
const remade = () => remake(document(), made)
const forksOf = ({ strokes }: StudioDocument) => findForks(strokes, lines).length

function bend(index: number): void {
  editor.choose(document().strokes[index])
  editor.point.value = 0
  editor.points.move([0.35, 0.15])
  editor.settle()
}

describe('making automatic wrinkles again', () => {
  test('replaces all lines, areas and drivers of an unchanged document', () => {
    const after = remade()
    expect(after.strokes).toEqual(made.strokes)
    expect(after.areas).toEqual(made.areas)
    expect(after.drivers).toEqual(made.drivers)
  })

  test('keeps a fork of which one branch was bent, and replaces other groups', () => {
    bend(1)
    const before = document()
    const after = remade()
    expect(after.strokes).toEqual([...before.strokes.slice(0, 2), made.strokes[2]])
    expect(after.strokes.map(({ isAutomatic }) => isAutomatic)).toEqual([true, undefined, true])
    expect([forksOf(before), forksOf(after)]).toEqual([1, 1])
    expect(remake(after, automatic(0.2)).strokes.slice(0, 2)).toEqual(before.strokes.slice(0, 2))
  })

  test('keeps the area around kept lines, because the new area surrounds other lines, with new drivers', () => {
    bend(1)
    const after = remade()
    expect(after.areas).toEqual([document().areas[0], made.areas[1]])
    expect(after.drivers).toEqual(made.drivers)
  })

  test('keeps lines, area and drivers of a region that gets no new lines', () => {
    bend(1)
    const without = {
      ...made,
      areas: made.areas.slice(1),
      strokes: made.strokes.slice(2),
      drivers: made.drivers.slice(1),
    }
    const after = remake(document(), without)
    expect(after.areas.map(({ name }) => name)).toEqual(['forehead', 'frown'])
    expect(after.drivers).toEqual([document().drivers[0], made.drivers[1]])
  })

  test('keeps a line that was only made deeper, or drawn, or detached from its fork', () => {
    editor.choose(document().strokes[1])
    editor.detach()
    const [, detached] = document().strokes
    expect(remade().strokes).toContain(detached)
    session.undo()
    editor.choose(document().strokes[2])
    editor.fields.setShape({ depth: 1 })
    expect(remade().strokes.map(({ depth }) => depth)).toContain(1)
    expect(remade().strokes.slice(1)).toEqual(made.strokes.slice(0, 2))
    session.undo()
    expect(remade().strokes).toEqual(made.strokes)
  })

  test('removes all automatic wrinkles of a surface that nothing wrinkles, and takes any size of regions afterwards', () => {
    const settings = { strength: 1, size: 64, kind: 'hard' } as const
    const bare = remake(document(), withoutAutomatic(document(), settings))
    expect([bare.areas, bare.strokes, bare.drivers, bare.auto]).toEqual([[], [], [], settings])
    const larger = { ...automatic(0.1), areaSize: 8 }
    expect(remake(bare, larger).areaSize).toBe(8)
    expect(remake(document(), larger).areaSize).toBe(4)
  })

  test('does not bring deleted lines back', () => {
    editor.choose(document().strokes[1])
    editor.removeLine()
    const [trunk] = document().strokes
    expect(remade().strokes).toEqual([trunk, made.strokes[2]])
    session.undo()
    editor.choose(document().strokes[2])
    editor.removeLine()
    expect(remade().strokes).toEqual(made.strokes.slice(0, 2))
    expect(
      remade()
        .areas.map(({ name }) => name)
        .sort(),
    ).toEqual(['forehead', 'frown'])
  })

  test('keeps the layer of kept lines and its imported maps', () => {
    const image = { mimeType: 'image/png', bytes: Uint8Array.of(1) }
    session.edit('', (old) => setMap(old, 'up', 'roughness', image))
    bend(1)
    expect(remade().layers[0].maps.roughness).toBe(image)
  })
})

test('drivers that stay get the new age, because only the age of the first driver counts', () => {
  const age = (area: string, initial: number) => ({ type: 'age', area, curve: [[20, 0]], initial }) as never
  session.open({ ...automatic(0), drivers: [age('forehead', 45), age('frown', 45)] })
  session.edit('paint', (old) => ({
    ...old,
    areas: old.areas.map(({ isAutomatic: _, ...area }, i) =>
      i === 0 ? area : { ...area, isAutomatic: true },
    ),
  }))
  const older = {
    ...made,
    drivers: [age('forehead', 73), age('frown', 73)],
    auto: { ...made.auto!, age: 73 },
  }
  const ages = remake(document(), older).drivers.map((driver) => 'initial' in driver && driver.initial)
  expect(ages).toEqual([73, 73])
})
