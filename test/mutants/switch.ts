/** Setup file that activates the mutant `FURROW_MUTANT`, and records which mutants a test file reaches. */

import { writeFileSync } from 'node:fs'
import { afterAll, expect } from 'vitest'

const active = Number(process.env.FURROW_MUTANT)
const reached = new Set<number>()
const began = performance.now()

Object.assign(globalThis, {
  furrowMutant(id: number): boolean {
    reached.add(id)
    return id === active
  },
})

afterAll(() => {
  const folder = process.env.FURROW_REACHED
  if (folder === undefined) return
  const { testPath } = expect.getState()
  const file = testPath!.slice(process.cwd().length + 1)
  const seconds = (performance.now() - began) / 1000
  writeFileSync(
    `${folder}/${file.replaceAll('/', '+')}.json`,
    JSON.stringify({ file, seconds, reached: [...reached] }),
  )
})
