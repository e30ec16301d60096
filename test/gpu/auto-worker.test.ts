// Runs in a browser, without drawing, because web workers of browsers differ from those of Node.

import { FurrowError } from 'furrow'
import { autoWrinkles, type Skin } from 'furrow/author'
import { autoWrinklesInWorker } from 'furrow/auto'
import { AUTO_STEPS } from 'furrow/internal'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { sheet } from '../unit/author/auto/sheet.ts'

const OPTIONS = { size: 256, areaSize: 32 }

function makeSkin(): Skin {
  const { positions, uvs, indices, offsets } = sheet(24, 30)
  return {
    positions: Float32Array.from(positions, (millimetres) => millimetres / 1000),
    uvs: Float32Array.from(uvs),
    indices: Uint32Array.from(indices),
    targets: [{ name: 'squash', offsets: Float32Array.from(offsets, (millimetres) => millimetres / 1000) }],
  }
}

/** Workers that were created and not terminated. */
const running = new Set<Worker>()
const RealWorker = globalThis.Worker

/** Records all workers from now on. With `script`, each worker runs this script instead of its own. */
function watchWorkers(script?: string): void {
  vi.stubGlobal(
    'Worker',
    class extends RealWorker {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(script === undefined ? address : URL.createObjectURL(new Blob([script])), script ? {} : options)
        running.add(this)
      }
      override terminate(): void {
        running.delete(this)
        super.terminate()
      }
    },
  )
}

afterEach(() => {
  vi.unstubAllGlobals()
  running.clear()
})

describe('autoWrinklesInWorker', () => {
  it('returns the same bytes as autoWrinkles, and ends its worker', async () => {
    watchWorkers()
    const made = await autoWrinklesInWorker(makeSkin(), OPTIONS)
    expect(made).toEqual(autoWrinkles(makeSkin(), OPTIONS))
    expect(made.areas.length).toBeGreaterThan(0)
    await vi.waitFor(() => expect(running.size).toBe(0))
  })

  it('reports progress', async () => {
    const [told, expected]: unknown[][] = [[], []]
    await autoWrinklesInWorker(makeSkin(), { ...OPTIONS, progress: (...at) => told.push(at) })
    autoWrinkles(makeSkin(), OPTIONS, (...at) => expected.push(at))
    expect(told).toEqual(expected)
    expect(told.length).toBeGreaterThan(AUTO_STEPS.length)
  })

  it('copies the skin by default, or transfers it', async () => {
    const skin = makeSkin()
    const copied = await autoWrinklesInWorker(skin, OPTIONS)
    expect(skin).toEqual(makeSkin())
    expect(await autoWrinklesInWorker(skin, { ...OPTIONS, transfer: true })).toEqual(copied)
    expect([skin.positions, skin.uvs, skin.indices, skin.targets[0]!.offsets].map((a) => a.length)).toEqual([
      0, 0, 0, 0,
    ])
  })

  it('accepts a skin whose arrays are views of one buffer', async () => {
    const { positions, uvs, indices, targets } = makeSkin()
    const arrays = [positions, uvs, targets[0]!.offsets]
    const file = new Float32Array(arrays.reduce((sum, { length }) => sum + length, 0))
    let start = 0
    const views = arrays.map((values) => {
      file.set(values as Float32Array, start)
      start += values.length
      return file.subarray(start - values.length, start)
    })
    const skin = {
      positions: views[0]!,
      uvs: views[1]!,
      indices,
      targets: [{ name: 'squash', offsets: views[2]! }],
    }
    const made = await autoWrinklesInWorker(skin, { ...OPTIONS, transfer: true })
    expect(made).toEqual(autoWrinkles(makeSkin(), OPTIONS))
    expect(file.length).toBe(0)
  })

  it('stops immediately when aborted', async () => {
    watchWorkers()
    const controller = new AbortController()
    const reason = new Error('closed')
    const settle = vi.fn()
    const begun = new Promise((resolve) => {
      const options = { ...OPTIONS, size: 2048, signal: controller.signal, progress: resolve }
      autoWrinklesInWorker(makeSkin(), options).catch(settle)
    })
    await begun
    expect(running.size).toBe(1)
    controller.abort(reason)
    await nextTask()
    expect(settle).toHaveBeenCalledExactlyOnceWith(reason)
    expect(running.size).toBe(0)
  })

  it('does not start if the signal is already aborted', async () => {
    watchWorkers()
    const signal = AbortSignal.abort()
    await expect(autoWrinklesInWorker(makeSkin(), { signal })).rejects.toBe(signal.reason)
    const controller = new AbortController()
    const made = autoWrinklesInWorker(makeSkin(), { signal: controller.signal })
    controller.abort()
    await expect(made).rejects.toBe(controller.signal.reason)
    expect(running.size).toBe(0)
  })

  it('throws the same errors as autoWrinkles', async () => {
    watchWorkers()
    const skin = { ...makeSkin(), targets: [] }
    const thrown = await errorOf(autoWrinklesInWorker(skin, OPTIONS))
    const expected = await errorOf((async () => autoWrinkles(skin, OPTIONS))())
    expect(thrown).toBeInstanceOf(FurrowError)
    expect({ ...thrown, message: thrown.message }).toEqual({ ...expected, message: expected.message })
    expect(running.size).toBe(0)
  })

  it('refuses arrays that were already transferred', async () => {
    const skin = makeSkin()
    structuredClone(skin.positions, { transfer: [(skin.positions as Float32Array).buffer] })
    const { message } = await errorOf(autoWrinklesInWorker(skin, { ...OPTIONS, transfer: true }))
    expect(message).toMatch(/^autoWrinklesInWorker: the skin cannot be sent to the worker, .*; pass arrays/)
  })

  it.each([
    ['cannot start', 'throw new Error("no")', /^autoWrinklesInWorker: the worker cannot start, .*blob:/],
    [
      'throws what is none of ours',
      'onmessage = () => { postMessage({ type: "started" }); throw new RangeError("no memory") }',
      /^autoWrinklesInWorker: the worker ended before .*no memory.*; close other pages/,
    ],
    [
      'dies without a word',
      `onmessage = ({ data: { lock } }) => navigator.locks.request(lock, () => {
        postMessage({ type: 'started', lock })
        setTimeout(close)
        return new Promise(() => {})
      })`,
      /^autoWrinklesInWorker: the worker ended before its work was done; close other pages/,
    ],
  ])('explains the failure when the worker %s', async (_, script, message) => {
    watchWorkers(script)
    const error = await errorOf(autoWrinklesInWorker(makeSkin(), OPTIONS))
    expect(error.message).toMatch(message)
    expect(error.code).toBe('unsupported')
    expect(running.size).toBe(0)
  })
})

async function errorOf(made: Promise<unknown>): Promise<FurrowError> {
  return made.then(
    () => expect.unreachable('nothing was thrown'),
    (error) => error,
  )
}

function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve)
  })
}
