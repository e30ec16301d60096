import type { TestProject } from 'vitest/node'
import { pack, remove, temporaryFolder } from './npm.ts'

declare module 'vitest' {
  export interface ProvidedContext {
    /** Paths of the packed packages, by name. */
    tarballs: Record<'furrow' | 'furrow-cli', string>
  }
}

/** Packs both packages once for all tests of the project, and removes the tarballs after the last test file. */
export default async function packAll(project: TestProject): Promise<() => Promise<void>> {
  const folder = await temporaryFolder()
  project.provide('tarballs', {
    furrow: await pack('furrow', folder),
    'furrow-cli': await pack('furrow-cli', folder),
  })
  return () => remove(folder)
}
