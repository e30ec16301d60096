import type { TestProjectInlineConfiguration } from 'vitest/config'

declare module 'vitest' {
  export interface ProvidedContext {
    /** Whether a project runs tests in full, which takes several times as long: before a release. */
    inDepth?: boolean
  }
}

/** Tests that leave something out on every change: renderers (`LONG_TEST_RENDERERS`) or random cases (`casesOn`). */
export const FILES_IN_DEPTH = [
  'arrays',
  'babylon/influence',
  'blood',
  'conformance/three',
  'features',
  'figures',
  'influence',
  'layers',
  'paper',
  'relief/relief',
  'several-renderers',
].map((name) => `test/gpu/${name}.test.ts`)

/** Runs a project's tests in full. */
export function inDepth(project: TestProjectInlineConfiguration): TestProjectInlineConfiguration {
  return { ...project, test: { ...project.test, provide: { ...project.test?.provide, inDepth: true } } }
}
