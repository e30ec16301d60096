import type { TestProjectInlineConfiguration } from 'vitest/config'

declare module 'vitest' {
  export interface ProvidedContext {
    /** Release of three.js that a Vitest project uses; default `newest`. */
    threeRelease?: 'oldest' | 'newest'
  }
}

/**
 * Tests of features that depend most on the release of three.js: array textures, blending, the paper's lighting, changed
 * geometries, batches, KTX2Loader, draw ranges, texture copies, and compileAsync.
 */
export const FILES_FOR_OLDEST = [
  'three-version',
  'layers',
  'maps',
  'paper',
  'crowd',
  'normals',
  'loader/loader',
  'mtoon',
  'update',
  'compile',
  'relief/relief',
].map((name) => `test/gpu/${name}.test.ts`)

/** Returns a Vitest project that uses `three-oldest`, the oldest supported release for `WebGPURenderer`. `WebGLRenderer` needs only r160. */
export function onOldestThree(project: TestProjectInlineConfiguration): TestProjectInlineConfiguration {
  const oldest = (name: string) => name.replace(/^three(?=\/|$)/, 'three-oldest')
  return {
    ...project,
    resolve: { ...project.resolve, alias: { ...project.resolve?.alias, three: 'three-oldest' } },
    optimizeDeps: { ...project.optimizeDeps, include: project.optimizeDeps?.include?.map(oldest) },
    test: { ...project.test, provide: { ...project.test!.provide, threeRelease: 'oldest' } },
  }
}
