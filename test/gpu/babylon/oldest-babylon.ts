import type { TestProjectInlineConfiguration } from 'vitest/config'

/** Test files that draw with Babylon.js. */
export const FILES_FOR_OLDEST_BABYLON = ['test/gpu/babylon/*.test.ts', 'test/gpu/conformance/babylon.test.ts']

/** Aliases that replace Babylon.js by the oldest supported version. */
const OLDEST = [
  { find: /^@babylonjs\/core(?=\/|$)/, replacement: 'babylon-oldest' },
  { find: /^@babylonjs\/loaders(?=\/|$)/, replacement: 'babylon-loaders-oldest' },
]

/** Returns a Vitest project that uses the oldest supported Babylon.js. */
export function onOldestBabylon(project: TestProjectInlineConfiguration): TestProjectInlineConfiguration {
  const oldest = (name: string) =>
    OLDEST.reduce((text, { find, replacement }) => text.replace(find, replacement), name)
  const own = Object.entries(project.resolve?.alias ?? {}).map(([find, replacement]) => ({
    find,
    replacement,
  }))
  return {
    ...project,
    resolve: { ...project.resolve, alias: [...OLDEST, ...own] },
    optimizeDeps: { ...project.optimizeDeps, include: project.optimizeDeps?.include?.map(oldest) },
  }
}
