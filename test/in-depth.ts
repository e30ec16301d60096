import type { TestProjectInlineConfiguration } from 'vitest/config'

declare module 'vitest' {
  export interface ProvidedContext {
    /** Whether a project runs tests in full, which takes several times as long: before a release. */
    inDepth?: boolean
  }
}

/** Tests that leave something out on every change: renderers (`LONG_TEST_RENDERERS`) or random cases (`casesOn`). */
export const GPU_FILES_IN_DEPTH = [
  'arrays',
  'babylon/influence',
  'blood',
  'conformance/babylon',
  'conformance/three',
  'features',
  'figures',
  'influence',
  'layers',
  'maps',
  'paper',
  'relief/relief',
  'several-renderers',
  'update',
].map((name) => `test/gpu/${name}.test.ts`)

/** The same in Node: random cases (`MUTATED` of gltf/mutations.ts, and `COUNT` of cli/fuzz). */
export const UNIT_FILES_IN_DEPTH = ['cli/fuzz', 'drivers/usual-maps', 'gltf/bad-input'].map(
  (name) => `test/unit/${name}.test.ts`,
)

/** Runs a project's tests in full. */
export function inDepth(project: TestProjectInlineConfiguration): TestProjectInlineConfiguration {
  return { ...project, test: { ...project.test, provide: { ...project.test?.provide, inDepth: true } } }
}
