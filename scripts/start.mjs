// `npm start`: serves the studio and the faces of the repository.

import { join } from 'node:path'
import { main, ROOT, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

const PORT = 5173

await main(async () => {
  await setUp()
  const { createServer } = await import('vite')
  const server = await createServer({
    configFile: join(ROOT, 'studio/vite.config.ts'),
    logLevel: 'warn',
    clearScreen: false,
    server: { port: PORT, strictPort: false },
  })
  await server.listen()
  const address = server.resolvedUrls.local[0]
  say(`studio   ${address}`)
  say(`example  ${new URL('/examples/minimal.html', address)}`)
  say('Ctrl-C stops it')
  let stopping = false
  const stop = async () => {
    // Ctrl-C sends the signal twice: from the terminal and from npm.
    if (stopping) return
    stopping = true
    await server.close()
    process.exit(0)
  }
  for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, stop)
  if (process.env.npm_lifecycle_event) stopWithParent(stop)
})

/**
 * Stops this script when npm has ended. npm forwards a signal only to a shell, which ends without stopping this script.
 */
function stopWithParent(stop) {
  const parent = process.ppid
  setInterval(() => process.ppid !== parent && stop(), 500).unref()
}
