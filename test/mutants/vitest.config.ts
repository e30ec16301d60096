import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { defineConfig, type TestProjectInlineConfiguration } from 'vitest/config'
import root from '../../vitest.config.ts'
import { findMutants, type Mutant, mutate } from './instrument.ts'

// Project to run. `unit` contains all mutants, and a switch selects one. Other projects contain one changed shader.
const name = process.env.FURROW_PROJECT ?? 'unit'
const only = process.env.FURROW_ONLY === undefined ? undefined : Number(process.env.FURROW_ONLY)
const list = process.env.FURROW_MUTANTS ?? 'mutants.json'

const folder = fileURLToPath(new URL('../../', import.meta.url))
const { mutants }: { mutants: Mutant[] } = JSON.parse(readFileSync(new URL(list, import.meta.url), 'utf8'))
const { found } = findMutants(mutants, folder)
const projects = root.test!.projects as TestProjectInlineConfiguration[]
const project = projects.find(({ test }) => test?.name === name)!
const setup = fileURLToPath(new URL('switch.ts', import.meta.url))

export default defineConfig({
  root: folder,
  test: {
    experimental: { fsModuleCache: true },
    projects: [
      {
        ...project,
        plugins: [...(project.plugins ?? []), mutate(found, folder, only)],
        test: { ...project.test, ...(only === undefined && { setupFiles: [setup] }) },
      },
    ],
  },
})
