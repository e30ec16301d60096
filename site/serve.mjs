import { join } from 'node:path'
import { preview } from 'vite'
import { ROOT } from '../scripts/lib/run.mjs'

/** An arbitrary path, because the site must work under any path. */
const PATH = '/somewhere/else/'

/** Serves the built site as a static file server does, under an arbitrary path. */
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
