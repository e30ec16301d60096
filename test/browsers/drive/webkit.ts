import { createServer } from 'node:net'
import { MINI_BROWSER } from '../../../scripts/lib/other-browsers.mjs'
import type { BrowserKind } from './driven-browser.ts'

/** Interval between attempts to reach WebKit's driver, and time limit for the first success, milliseconds. */
const STEP = 100
const STARTING = 60_000

/** Time limit for scripts, milliseconds. */
const SCRIPT = 900_000

/** WebKitGTK through WebDriver. */
export const webkit: BrowserKind = {
  name: 'webkit',
  async launch({ run }) {
    const port = await freePort()
    run('WebKitWebDriver', [`--port=${port}`], { WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' })
    const options = { binary: MINI_BROWSER, args: ['--automation'] }
    const session = await whenReady(() =>
      send(port, 'POST', '/session', {
        capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': options } },
      }),
    )
    const { sessionId, capabilities } = session
    const call = (method: string, path: string, body?: object) =>
      send(port, method, `/session/${sessionId}${path}`, body)
    await call('POST', '/timeouts', { script: SCRIPT, pageLoad: SCRIPT })
    return {
      version: capabilities.browserVersion,
      async open(url) {
        await call('POST', '/url', { url })
      },
      async evaluate(body) {
        const script = `const done = arguments[0];
          (async () => { ${body} })().then(
            (value) => done(JSON.stringify({ value })),
            (error) => done(JSON.stringify({ error: String(error?.stack ?? error) })))`
        const { value = null, error } = JSON.parse(await call('POST', '/execute/async', { script, args: [] }))
        if (error) throw new Error(error)
        return value
      },
      async act(actions) {
        await call('POST', '/actions', { actions })
      },
      async screenshot() {
        return Buffer.from(await call('GET', '/screenshot'), 'base64')
      },
      async resize(width, height) {
        await call('POST', '/window/rect', { x: 0, y: 0, width, height })
      },
      async close() {
        await call('DELETE', '')
      },
    }
  },
}

// biome-ignore lint/suspicious/noExplicitAny: protocol responses.
async function send(port: number, method: string, path: string, body?: object): Promise<any> {
  const headers = { 'content-type': 'application/json' }
  const request = { method, headers, body: body && JSON.stringify(body) }
  const response = await fetch(`http://127.0.0.1:${port}${path}`, request)
  const { value } = (await response.json()) as { value: { error?: string; message?: string } }
  if (value?.error) throw new Error(`WebKit: ${value.error}: ${value.message}`)
  return value
}

/** Repeats a request until WebKit's driver answers. */
async function whenReady<T>(ask: () => Promise<T>): Promise<T> {
  const until = Date.now() + STARTING
  for (;;) {
    try {
      return await ask()
    } catch (error) {
      const isRefused = error instanceof TypeError
      if (!isRefused || Date.now() > until) throw error
      await new Promise((resolve) => setTimeout(resolve, STEP))
    }
  }
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address() as { port: number }
      server.close(() => resolve(port))
    })
  })
}
