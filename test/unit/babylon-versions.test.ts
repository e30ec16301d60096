import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'

const read = (path: string) => JSON.parse(readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8'))

it.each([
  ['@babylonjs/core', 'babylon-oldest'],
  ['@babylonjs/loaders', 'babylon-loaders-oldest'],
])('the oldest %s that users may install is the one under test', (name, alias) => {
  const [, oldest] = /^>=(\S+)$/.exec(read('packages/furrow/package.json').peerDependencies[name])!
  expect(read('package.json').devDependencies[alias]).toBe(`npm:${name}@${oldest}`)
})
