// How much of what a page downloads is executed until the first frame of the shipped face: what would be left of the loader if all else were
// fetched later, however it were cut. The code is that which `size.mjs` weighs. The browser tells which blocks of it were executed; the others are
// cut out, and the rest is compressed.

import { join } from 'node:path'
import { ROOT, serve } from '../serve.mjs'
import { bundle, closure, compressed, ELSEWHERE } from '../size.mjs'

/** By the entry that pages have the loader of. */
const RENDERERS = { 'furrow/three': 'webgl', 'furrow/webgpu': 'webgpu' }

/** WebGPU asks for a secure context. Nothing listens there: requests are answered here. */
const ORIGIN = 'http://localhost/'

/**
 * Bytes by gzip and Brotli, by what was executed.
 *
 * @returns {Promise<Record<string, { gzip: number, brotli: number }>>}
 */
export async function measureExecuted() {
  const server = await serve()
  const { launchBrowser, newPage } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  const browser = await launchBrowser()
  try {
    const sizes = {}
    for (const [entry, renderer] of Object.entries(RENDERERS)) {
      const code = `import { WrinkleLoaderPlugin as used } from '${entry}'; globalThis.used = used`
      const chunks = await bundle(code, ELSEWHERE)
      const page = await newPage(browser)
      const executed = await executedChunks(page, chunks, renderer)
      await page.close()
      const own = closure([chunks[0]], chunks).map(({ fileName }) => fileName)
      const isOwn = ({ fileName }) => own.includes(fileName)
      sizes[`executed of the loader, ${entry}`] = compressed(executed.filter(isOwn))
      sizes[`executed of what it fetches, ${entry}`] = compressed(executed.filter((chunk) => !isOwn(chunk)))
    }
    return sizes
  } finally {
    await browser.close()
    await server.close()
  }
}

/** What of each chunk that was loaded was executed when the first frame has been drawn. */
async function executedChunks(page, chunks, renderer) {
  const problems = []
  page.on('pageerror', ({ message }) => problems.push(message))
  await page.route('**', (route) => {
    const path = new URL(route.request().url()).pathname.slice(1)
    const chunk = chunks.find(({ fileName }) => path === `page/${fileName}`)
    if (chunk) return route.fulfill({ contentType: 'text/javascript', body: chunk.code })
    return route.fulfill({ path: join(ROOT, path) })
  })
  await page.coverage.startJSCoverage()
  await page.goto(`${ORIGIN}bench/download/executed.html`)
  const isFrowning = await page.evaluate((kind) => globalThis.firstFrame(kind), renderer)
  if (!isFrowning || problems.length > 0) throw new Error(`The face does not frown. ${problems.join(' ')}`)
  const scripts = await page.coverage.stopJSCoverage()
  return chunks.flatMap((chunk) => {
    const script = scripts.find(({ url }) => url === `${ORIGIN}page/${chunk.fileName}`)
    return script ? [{ ...chunk, code: executedCode(script) }] : []
  })
}

/** The blocks that were executed. Those of a function come outermost first. */
function executedCode({ source, functions }) {
  const isExecuted = new Uint8Array(source.length)
  for (const { ranges } of functions) {
    for (const { startOffset, endOffset, count } of ranges)
      isExecuted.fill(Number(count > 0), startOffset, endOffset)
  }
  return Array.from(source, (character, i) => (isExecuted[i] ? character : '')).join('')
}
