import { once } from 'node:events'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { WebSocket, WebSocketServer } from 'ws'
import { loudnessOf, scoresOf } from '../../../../studio/src/live/microphone.ts'
import { startPhone } from '../../../../studio/src/live/phone.ts'
import { LIVE_DEFAULTS } from '../../../../studio/src/live/settings.ts'
import { startWebcam } from '../../../../studio/src/live/webcam.ts'

/** Events of a source, in order. */
let events: unknown[]
const handlers = {
  onScores: (...args: unknown[]) => events.push(args),
  onStatus: (status: string) => events.push(status),
  onError: (error: Error) => events.push(error.message),
}

beforeEach(() => {
  events = []
})
afterEach(() => vi.unstubAllGlobals())

describe('a phone or program', () => {
  let server: WebSocketServer
  let address: string

  beforeEach(async () => {
    vi.stubGlobal('WebSocket', WebSocket)
    server = new WebSocketServer({ host: '127.0.0.1', port: 0 })
    await once(server, 'listening')
    address = `ws://127.0.0.1:${(server.address() as { port: number }).port}/?token=x`
  })
  afterEach(() => server.close())

  it('delivers scores with the name of the sender, on the clock of the page', async () => {
    const connected = once(server, 'connection')
    const source = await startPhone({ ...LIVE_DEFAULTS, address: ` ${address} ` }, handlers)
    const [client] = await connected
    for (const time of [100, 100.5]) client.send(JSON.stringify({ source: 'vmc', time, scores: { A: 0.5 } }))
    await vi.waitFor(() => expect(events).toHaveLength(4))
    const [first, second] = events.slice(2) as [object, number, string][]
    expect(events.slice(0, 2)).toEqual(['connecting', 'noScores'])
    expect(first).toEqual([{ A: 0.5 }, expect.any(Number), 'vmc'])
    expect(Math.abs(first[1] - performance.now() / 1000)).toBeLessThan(5)
    expect(second[1] - first[1]).toBeCloseTo(0.5)
    client.terminate()
    await vi.waitFor(() => expect(events.at(-1)).toBe('lost'))
    source.stop()
  })

  it('that does not answer is told after three seconds', async () => {
    vi.useFakeTimers()
    vi.stubGlobal('WebSocket', class { close() {} }) // biome-ignore format: short
    const source = await startPhone({ ...LIVE_DEFAULTS, address: 'ws://127.0.0.1:9/?token=x' }, handlers)
    await vi.advanceTimersByTimeAsync(3000)
    expect(events).toEqual(['connecting', 'noAnswer'])
    source.stop()
    vi.useRealTimers()
  })

  it.each(['', 'http://127.0.0.1', 'npx furrow live'])('with the address %j is refused', async (given) => {
    await expect(startPhone({ ...LIVE_DEFAULTS, address: given }, handlers)).rejects.toThrow(
      'run npx furrow live, and paste the address that it prints',
    )
  })

  it('is refused by a secure page, in words', async () => {
    const refuse = () => {
      throw new DOMException('insecure', 'SecurityError')
    }
    vi.stubGlobal('WebSocket', class { constructor() { refuse() } }) // biome-ignore format: short
    await expect(startPhone({ ...LIVE_DEFAULTS, address: 'ws://192.168.1.7/' }, handlers)).rejects.toThrow(
      'run furrow live on this computer',
    )
  })
})

describe('a webcam', () => {
  const withCamera = (getUserMedia: () => Promise<unknown>) =>
    vi.stubGlobal('navigator', { mediaDevices: { getUserMedia } })

  it.each([
    ['NotAllowedError', 'access to the camera was refused; allow it beside the address'],
    ['NotFoundError', 'no camera was found; connect one'],
    ['NotReadableError', 'the camera does not answer; close other programs'],
    ['AbortError', 'the camera cannot be used (gone); try another camera'],
  ])('is refused with %s in words', async (name, message) => {
    withCamera(() => Promise.reject(new DOMException('gone', name)))
    await expect(startWebcam(LIVE_DEFAULTS, handlers)).rejects.toThrow(message)
  })

  it('needs a secure page', async () => {
    vi.stubGlobal('navigator', {})
    await expect(startWebcam(LIVE_DEFAULTS, handlers)).rejects.toThrow(
      'open this page by https or on localhost',
    )
  })

  it('is released if MediaPipe or its model cannot be loaded', async () => {
    const stop = vi.fn()
    withCamera(async () => ({ getTracks: () => [{ stop }] }))
    await expect(startWebcam({ ...LIVE_DEFAULTS, library: 'file:///none' }, handlers)).rejects.toThrow(
      'MediaPipe cannot be used',
    )
    const library = 'data:text/javascript,export const [FaceLandmarker, FilesetResolver] = [{}, {}] //'
    vi.stubGlobal('fetch', async () => new Response('', { status: 404 }))
    await expect(startWebcam({ ...LIVE_DEFAULTS, library }, handlers)).rejects.toThrow(
      "MediaPipe's model cannot be used (status 404)",
    )
    expect(stop).toHaveBeenCalledTimes(2)
  })

  it('delivers scores of each picture, tells when no face is visible, and ends if MediaPipe fails', async () => {
    const stop = vi.fn()
    withCamera(async () => ({ getTracks: () => [{ stop, addEventListener: () => {} }] }))
    const categories = [{ categoryName: 'jawOpen', score: 0.5 }]
    const results: unknown[] = [[{ categories }], [], null]
    const close = vi.fn()
    const landmarker = { detectForVideo: () => ({ faceBlendshapes: results.shift() }), close }
    vi.stubGlobal('landmarker', landmarker)
    let show = () => {}
    const requestVideoFrameCallback = (call: () => void) => {
      show = call
    }
    vi.stubGlobal('document', { createElement: () => ({ play: async () => {}, requestVideoFrameCallback }) })
    vi.stubGlobal('fetch', async () => new Response('model'))
    const exports = [
      'FilesetResolver = { forVisionTasks: async () => null }',
      'FaceLandmarker = { createFromOptions: async () => globalThis.landmarker }',
    ]
    const library = `data:text/javascript,${exports.map((each) => `export const ${each};`).join('')}//`
    const source = await startWebcam({ ...LIVE_DEFAULTS, library }, handlers)
    for (let i = 0; i < 3; i++) show()
    expect(events).toEqual([
      'noFace',
      [categories, expect.any(Number), 'webcam'],
      'noFace',
      expect.stringContaining('MediaPipe cannot be used'),
    ])
    source.stop()
    expect([stop.mock.calls.length, close.mock.calls.length]).toEqual([1, 1])
    show()
    expect(events).toHaveLength(4)
  })
})

it.each([
  ['silence', 0, 0],
  ['a quiet voice', 0.01, 0.25],
  ['a loud voice', 1, 1],
])('%s opens the mouth accordingly', (_, amplitude, loudness) => {
  const samples = Float32Array.from({ length: 2048 }, () => amplitude)
  expect(loudnessOf(samples)).toBeCloseTo(loudness, 5)
  expect(scoresOf(loudness).jawOpen).toBeCloseTo(0.7 * loudness)
  expect(scoresOf(loudness).browInnerUp).toBeCloseTo(Math.max(0, 2 * loudness - 1))
})
