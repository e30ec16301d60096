import type { TestProjectInlineConfiguration } from 'vitest/config'

declare module 'vitest' {
  export interface ProvidedContext {
    /** The release of three.js that a project runs on; the newest by default. */
    threeRelease?: 'oldest' | 'newest'
  }
}

/** What breaks first on an older three.js: array textures, blending, the paper's lighting, changed geometries, batches, KTX2Loader. */
const FILES = ['three-version', 'layers', 'paper', 'crowd', 'normals', 'loader'].map(
  (name) => `test/gpu/${name}.test.ts`,
)

/** Adds the project `gpu-oldest`: some of the project `gpu`'s files on the oldest three.js that is allowed, `three-oldest`. */
export function withOldestThree(
  projects: TestProjectInlineConfiguration[],
): TestProjectInlineConfiguration[] {
  const gpu = projects.find(({ test }) => test?.name === 'gpu')
  if (!gpu) return projects
  const oldest = (name: string) => name.replace(/^three(?=\/|$)/, 'three-oldest')
  return [
    ...projects,
    {
      ...gpu,
      resolve: { ...gpu.resolve, alias: [{ find: /^three(?=\/|$)/, replacement: 'three-oldest' }] },
      optimizeDeps: { include: gpu.optimizeDeps?.include?.map(oldest) },
      test: { ...gpu.test, name: 'gpu-oldest', include: FILES, provide: { threeRelease: 'oldest' } },
    },
  ]
}
