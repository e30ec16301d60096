import { type Document, NodeIO } from '@gltf-transform/core'
import { autoWrinkles } from 'furrow/author'
import { decodeGlb, documentOf, findSurfaces } from 'furrow-files'
import { describe, expect, it } from 'vitest'
import { dressFile, robotFile } from '../../../../bodies.ts'
import { dress } from './dress.ts'

/** Finds the surfaces of a file, as `furrow auto` does. */
async function surfacesOf(file: Document, name: string) {
  const bytes = await new NodeIO().writeBinary(file)
  return findSurfaces(await documentOf(decodeGlb(bytes, name, 'test'), name, 'test'), name, 'test', {})
}

describe('a robot of hard parts', () => {
  it('gets no wrinkles', async () => {
    await expect(surfacesOf(robotFile(), 'robot.glb')).rejects.toThrow(/no skin or cloth/)
  })
})

describe('a dress', () => {
  const { jointAreas } = autoWrinkles(dress(), { size: 256, areaSize: 64, cloth: 'shirt' })
  const areaOf = (name: string) => jointAreas.find((area) => area.name === name)!.weights

  it('is the only surface of its file that folds, because the stand is hard', async () => {
    const { surfaces, notes } = await surfacesOf(dressFile(), 'dress.glb')
    expect(surfaces.map(({ meshName, cloth }) => [meshName, cloth])).toEqual([['dress', 'shirt']])
    expect(notes).toEqual([])
  })

  it('folds at the elbows and the waist, and not where the skirt hangs around both knees', () => {
    expect(jointAreas.map(({ name }) => name)).toEqual([
      'LeftForeArm flexion',
      'RightForeArm flexion',
      'Spine2 forward',
      'Spine2 tilt to the left',
      'Spine2 tilt to the right',
      'Spine2 turn to the left',
      'Spine2 turn to the right',
    ])
    for (const { lines, name } of jointAreas) expect(lines, name).toBeGreaterThan(3)
  })

  it('has the folds of a sleeve on the sleeve, and those of the waist on the waist', () => {
    const sleeve = boundsOf(areaOf('LeftForeArm flexion'))
    expect(sleeve.low).toBeGreaterThan(0.62)
    expect(sleeve.right).toBeLessThan(0.5)
    const waist = boundsOf(areaOf('Spine2 forward'))
    expect(waist.low).toBeGreaterThan(0.3)
    expect(waist.high).toBeLessThan(0.6)
  })
})

/** Returns the range of texture coordinates at which an area is visible. */
function boundsOf({ width, height, data }: { width: number; height: number; data: ArrayLike<number> }) {
  const visible = Array.from(data, (weight, i) => [i % width, Math.floor(i / width), weight] as const).filter(
    ([, , weight]) => weight > 0.1,
  )
  const [xs, ys] = [0, 1].map((k) => visible.map((texel) => texel[k]!)) as [number[], number[]]
  return {
    left: Math.min(...xs) / width,
    right: Math.max(...xs) / width,
    low: Math.min(...ys) / height,
    high: Math.max(...ys) / height,
  }
}
