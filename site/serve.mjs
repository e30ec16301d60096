import { join } from 'node:path'
import { preview } from 'vite'
import { ROOT } from '../scripts/lib/run.mjs'

/** Arbitrary path: the site must work under any. */
const PATH = '/somewhere/else/'

/** Serves the built site like a static file server, under an arbitrary path. */
export async function serveSite() {
  const server = await preview({
    configFile: false,
    logLevel: 'silent',
    root: join(ROOT, 'site'),
    base: PATH,
    appType: 'mpa',
    build: { outDir: 'dist' },
    preview: { host: '127.0.0.1', port: 0 },
  })
  return { address: server.resolvedUrls.local[0], close: () => server.close() }
}
