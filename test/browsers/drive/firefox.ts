import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { WebSocket } from 'ws'
import { type BrowserKind, outputOf } from './driven-browser.ts'

const PREFERENCES = {
  // Firefox blocks software rasterisers by default.
  'webgl.force-enabled': true,
  'browser.shell.checkDefaultBrowser': false,
  'browser.startup.page': 0,
  'browser.aboutwelcome.enabled': false,
  'datareporting.policy.dataSubmissionEnabled': false,
  'app.update.enabled': false,
  'network.captive-portal-service.enabled': false,
  'network.connectivity-service.enabled': false,
  // Firefox must not interrupt long scripts.
  'dom.max_script_run_time': 0,
  'dom.ipc.reportProcessHangs': false,
}

/** Firefox through WebDriver BiDi, which it supports natively. */
export const firefox: BrowserKind = {
  name: 'firefox',
  async launch({ folder, run }) {
    const lines = Object.entries(PREFERENCES).map(([name, value]) => `user_pref("${name}", ${value});`)
    writeFileSync(join(folder, 'user.js'), lines.join('\n'))
    const words = ['--no-remote', '--profile', folder, '--remote-debugging-port', '0', 'about:blank']
    const child = run('firefox-esr', words, { MOZ_DISABLE_CONTENT_SANDBOX: '1' })
    const address = await outputOf(child, 'stderr', /WebDriver BiDi listening on (ws:\S+)/)
    const send = await connect(`${address}/session`)
    const { capabilities } = await send('session.new', { capabilities: {} })
    const { contexts } = await send('browsingContext.getTree', {})
    const { context } = contexts[0]
    return {
      version: capabilities.browserVersion,
      async open(url) {
        await send('browsingContext.navigate', { context, url, wait: 'complete' })
      },
      async evaluate(body) {
        const { result, exceptionDetails } = await send('script.evaluate', {
          expression: `(async () => JSON.stringify(await (async () => { ${body} })()) ?? 'null')()`,
          target: { context },
          awaitPromise: true,
        })
        if (exceptionDetails) throw new Error(exceptionDetails.text)
        return JSON.parse(result.value)
      },
      async act(actions) {
        await send('input.performActions', { context, actions })
      },
      async screenshot() {
        const { data } = await send('browsingContext.captureScreenshot', { context })
        return Buffer.from(data, 'base64')
      },
      async resize(width, height) {
        await send('browsingContext.setViewport', { context, viewport: { width, height } })
      },
      async close() {
        await send('session.end', {})
      },
    }
  },
}

// biome-ignore lint/suspicious/noExplicitAny: protocol responses.
type Send = (method: string, params: object) => Promise<any>

async function connect(address: string): Promise<Send> {
  const socket = new WebSocket(address, { maxPayload: 0 })
  const waiting = new Map<number, { resolve(result: unknown): void; reject(error: Error): void }>()
  await new Promise((resolve, reject) => {
    socket.once('open', resolve)
    socket.once('error', reject)
  })
  socket.on('message', (data) => {
    const { id, result, error, message } = JSON.parse(String(data))
    if (error) waiting.get(id)?.reject(new Error(`Firefox: ${error}: ${message}`))
    else waiting.get(id)?.resolve(result)
    waiting.delete(id)
  })
  socket.on('close', () => {
    for (const { reject } of waiting.values()) reject(new Error('Firefox: the connection was closed'))
  })
  let last = 0
  return (method, params) =>
    new Promise((resolve, reject) => {
      const id = ++last
      waiting.set(id, { resolve, reject })
      socket.send(JSON.stringify({ id, method, params }))
    })
}
