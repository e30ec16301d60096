import { createHash } from 'node:crypto'
import { readFile } from 'node:fs/promises'
import { fileURLToPath } from 'node:url'
import { type Plugin, transformWithOxc } from 'vite'

const WORKER = fileURLToPath(new URL('./src/offline/service-worker.ts', import.meta.url))

/**
 * Adds `service-worker.js`, which lets the page work offline, to a build. In its source, replaces `FILES` by the list of files to cache, and
 * `VERSION` by the hash of all files. Workbox could do this, but depends on 250 packages.
 *
 * @param isKept whether a file is cached in advance. Other files are cached at their first request.
 */
export function offline(isKept: (path: string) => boolean): Plugin {
  return {
    name: 'furrow-offline',
    apply: 'build',
    // Run after all other plugins, to see the files that they add.
    enforce: 'post',
    async generateBundle(_, bundle) {
      const files = Object.keys(bundle).filter(isKept).sort()
      const hash = createHash('sha256')
      for (const path of Object.keys(bundle).sort()) {
        const file = bundle[path]
        hash.update(path).update(file.type === 'chunk' ? file.code : file.source)
      }
      const listed = fill(await readFile(WORKER, 'utf8'), "'FILES'", ['./', ...files])
      const source = fill(listed, "'VERSION'", hash.digest('hex').slice(0, 16))
      const { code } = await transformWithOxc(source, WORKER)
      this.emitFile({ type: 'asset', fileName: 'service-worker.js', source: code })
    },
  }
}

/** Replaces a placeholder by a value. Throws an Error if the text does not have the placeholder exactly once. */
function fill(text: string, placeholder: string, value: unknown): string {
  const parts = text.split(placeholder)
  if (parts.length === 2) return parts.join(JSON.stringify(value))
  throw new Error(
    `offline: ${placeholder} in ${WORKER}, got ${parts.length - 1} times, allowed: once; rename others`,
  )
}
