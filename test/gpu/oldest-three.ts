import type { TestProjectInlineConfiguration } from 'vitest/config'

declare module 'vitest' {
  export interface ProvidedContext {
    /** The release of three.js that a project runs on; the newest by default. */
    threeRelease?: 'oldest' | 'newest'
  }
}

/** Tests of what breaks first on an older three.js: array textures, blending, the paper's lighting, changed geometries, batches, KTX2Loader, ranges to draw, copies into textures, compiling ahead. */
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

/** Runs a project on `three-oldest`, the oldest three.js whose `WebGPURenderer` is supported; `WebGLRenderer` is supported from r160 on. */
export function onOldestThree(project: TestProjectInlineConfiguration): TestProjectInlineConfiguration {
  const oldest = (name: string) => name.replace(/^three(?=\/|$)/, 'three-oldest')
  return {
    ...project,
    resolve: { ...project.resolve, alias: { ...project.resolve?.alias, three: 'three-oldest' } },
    optimizeDeps: { ...project.optimizeDeps, include: project.optimizeDeps?.include?.map(oldest) },
    test: { ...project.test, provide: { ...project.test!.provide, threeRelease: 'oldest' } },
  }
}
