// What a page downloads of the library: each renderer's entry with all that it exports, minified and gzipped; three.js and the
// user's own code apart.

import { fileURLToPath } from 'node:url'
import { gzipSync } from 'node:zlib'
import { build } from 'vite'
import { ROOT } from './serve.mjs'

/** Bytes by entry. */
export async function measureSizes() {
  const sizes = {}
  for (const entry of ['three', 'webgpu']) {
    const { output } = await build({
      root: ROOT,
      configFile: false,
      logLevel: 'silent',
      build: {
        write: false,
        minify: true,
        // Not as a library: of those Vite leaves the spaces.
        rolldownOptions: {
          input: fileURLToPath(import.meta.resolve(`furrow/${entry}`)),
          external: /^three(\/|$)/,
          preserveEntrySignatures: 'strict',
        },
      },
    })
    const code = output.map((chunk) => chunk.code ?? '').join('')
    sizes[`furrow/${entry}`] = {
      minified: Buffer.byteLength(code),
      gzipped: gzipSync(code, { level: 9 }).length,
    }
  }
  return sizes
}
