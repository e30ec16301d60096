import { readdirSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { createServer, type ViteDevServer } from 'vite'
import { afterAll, beforeAll, expect, it } from 'vitest'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const EXAMPLES = readdirSync(`${ROOT}examples`).filter((name) => name.endsWith('.html'))

let server: ViteDevServer
let origin: string

/** Serves the studio and examples like `npm start`. */
beforeAll(async () => {
  const configFile = `${ROOT}studio/vite.config.ts`
  server = await createServer({ configFile, logLevel: 'silent', server: { host: '127.0.0.1', port: 0 } })
  await server.listen()
  origin = server.resolvedUrls!.local[0]
})
afterAll(() => server.close())

it.each(EXAMPLES)('serves %s and everything it imports', async (name) => {
  const page = await (await fetch(new URL(`examples/${name}`, origin))).text()
  const [, script] = /src="([^"]*html-proxy[^"]*)"/.exec(page)!
  const response = await fetch(new URL(script.replaceAll('&amp;', '&'), origin))
  expect(response.status, await response.clone().text()).toBe(200)
  const imports = [...(await response.text()).matchAll(/from "(\/[^"]+)"/g)].map(([, path]) => path)
  expect(imports.length).toBeGreaterThan(1)
  for (const path of imports) expect((await fetch(new URL(path, origin))).status, path).toBe(200)
})
