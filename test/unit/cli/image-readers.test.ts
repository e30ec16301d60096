import { once } from 'node:events'
import { Worker } from 'node:worker_threads'
import sharp from 'sharp'
import { describe, expect, it, vi } from 'vitest'
import { noise } from '../../noise.ts'

const load = () => import('../../../packages/files/src/images/open-image.ts')

await load()

/** Script of a thread that reads an image in a loop. `counts` holds the numbers of successful and of failed reads. */
const READER = `
  const { workerData: { counts, png } } = require('node:worker_threads')
  const sharp = require('sharp')
  const read = async () => {
    const failed = await sharp(png).metadata().then(() => 0, () => 1)
    Atomics.add(counts, failed, 1)
    Atomics.notify(counts, failed)
    read()
  }
  read()`

describe("libvips' readers", () => {
  it('are limited to the allowed formats', async () => {
    const png = await noise(1)
    const readable = async (bytes: Uint8Array) =>
      sharp(bytes)
        .metadata()
        .then(Boolean, () => false)
    const results: Record<string, boolean> = {}
    for (const format of ['png', 'jpeg', 'webp', 'avif', 'tiff', 'gif'] as const) {
      results[format] = await readable(await sharp(png).toFormat(format).toBuffer())
    }
    results.svg = await readable(
      Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="4" height="4"/>'),
    )
    const allowed = { png: true, jpeg: true, webp: true, avif: true, tiff: true }
    expect(results).toEqual({ ...allowed, gif: false, svg: false })
  })

  it('stay allowed while another thread loads the module', async () => {
    const counts = new Int32Array(new SharedArrayBuffer(8))
    const reader = new Worker(READER, { eval: true, workerData: { counts, png: await noise(1) } })
    await once(reader, 'online')
    const { block } = sharp
    const blocking = vi.spyOn(sharp, 'block').mockImplementation((options) => {
      block(options)
      for (let reads = 0; reads < 5; reads++) Atomics.wait(counts, 0, Atomics.load(counts, 0), 1000)
    })
    vi.resetModules()
    await load()
    await reader.terminate()
    expect(blocking).toHaveBeenCalled()
    expect(counts[0]).toBeGreaterThan(0)
    expect(counts[1]).toBe(0)
  })
})
