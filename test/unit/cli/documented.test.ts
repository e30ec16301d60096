// What `--help` offers stands in the documents too.

import { readFileSync } from 'node:fs'
import type { Command } from 'commander'
import { expect, it } from 'vitest'

/** Where the options of a command are explained. */
const PAGES: Readonly<Record<string, string>> = {
  activations: 'docs/drivers.md',
  array: 'docs/array.md',
  auto: 'docs/auto.md',
  bake: 'docs/bake.md',
  batch: 'docs/batch.md',
  inspect: 'docs/pack.md',
  normals: 'docs/normals.md',
  pack: 'docs/pack.md',
  strokes: 'docs/strokes.md',
  unpack: 'docs/pack.md',
  uv: 'docs/pack.md',
  validate: 'docs/pack.md',
  worker: 'docs/batch.md',
}

const modules = import.meta.glob<Record<string, Command>>('../../../packages/cli/src/**/commands/*.ts', {
  eager: true,
})
const commands = Object.values(modules).flatMap((module) => Object.values(module))

it.each(commands.filter((command) => command.name() !== 'render'))(
  'every option of $_name is explained',
  (command) => {
    const page = readFileSync(PAGES[command.name()], 'utf8')
    const missing = command.options.filter(
      ({ short, long }) => ![short, long].some((flag) => flag && page.includes(flag)),
    )
    expect(missing.map(({ flags }) => flags)).toEqual([])
  },
)

it('render is explained by its help alone, which the README names', () => {
  expect(commands).toHaveLength(Object.keys(PAGES).length + 1)
  expect(readFileSync('README.md', 'utf8')).toContain('`npx furrow render --help` lists all options')
})
