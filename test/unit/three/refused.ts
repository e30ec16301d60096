import { FurrowError } from 'furrow'
import { Wrinkles } from 'furrow/three'
import { expect } from 'vitest'
import { blendMesh } from '../../blend-mesh.ts'
import { randomSet } from '../../cases.ts'
import { seeded } from '../../random.ts'

/** Returns the same random wrinkles on each call. */
export const set = () => randomSet(seeded(1), 2, 8)

/** Creates a face with one blendshape, and wrinkles. */
export function face() {
  const mesh = blendMesh('jawOpen')
  mesh.name = 'head'
  return { mesh, wrinkles: new Wrinkles(mesh, set()) }
}

/** Expects an error of the library whose message matches, not another JavaScript error. */
export function expectRefused(run: () => unknown, start: RegExp) {
  let error: unknown
  try {
    run()
  } catch (caught) {
    error = caught
  }
  expect(error).toBeInstanceOf(FurrowError)
  expect((error as Error).message).toMatch(start)
  expect((error as Error).message).not.toMatch(/undefined is not|Cannot read|reading '/)
}

/** Creates a mesh without blendshapes and wrinkles. */
export const plain = () => blendMesh()
