import { createSocket } from 'node:dgram'
import { once } from 'node:events'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { WebSocket } from 'ws'
import { type Live, type LiveOptions, startLive } from '../../../packages/cli/src/live/live.ts'
import type { SourceName } from '../../../packages/cli/src/live/sources.ts'
import { ifacialmocapPacket, vmcMessages } from './packets.ts'

const closing: (() => void)[] = []
afterEach(() => {
  for (const close of closing.splice(0)) close()
})

async function start(options: Partial<LiveOptions> = {}) {
  const live = await startLive({
    who: 'furrow live',
    host: '127.0.0.1',
    port: 0,
    devices: '127.0.0.1',
    ports: { vmc: 0, ifacialmocap: 0 },
    origins: ['https://example.com'],
    token: 'secret',
    onSender: () => {},
    ...options,
  })
  closing.push(() => live.close())
  return live
}

/** Opens a connection. Resolves to the HTTP status if it is refused, and to 101 if it opens. */
async function connect(
  live: Live,
  { token = 'secret', origin = 'http://localhost:5173' as string | undefined } = {},
) {
  const socket = new WebSocket(`ws://127.0.0.1:${live.port}/?token=${token}`, { origin })
  closing.push(() => socket.terminate())
  const messages: string[] = []
  socket.on('message', (data) => messages.push(String(data)))
  const status = await new Promise<number>((resolve) => {
    socket.on('error', () => {})
    socket.on('open', () => resolve(101))
    socket.on('unexpected-response', (_, { statusCode = 0 }) => resolve(statusCode))
  })
  return { socket, messages, status }
}

/** A sender of UDP packets. */
async function device() {
  const socket = createSocket('udp4')
  socket.bind(0, '127.0.0.1')
  await once(socket, 'listening')
  closing.push(() => socket.close())
  return (live: Live, source: SourceName, ...packets: Uint8Array[]) => {
    for (const packet of packets) socket.send(packet, live.ports[source], '127.0.0.1')
  }
}

describe('furrow live', () => {
  it('passes frames of several sources on to all pages, with the time', async () => {
    const senders: string[] = []
    const live = await start({ onSender: (source, sender) => senders.push(`${source} ${sender}`) })
    const pages = [await connect(live), await connect(live, { origin: 'https://example.com' })]
    const [vmc, phone] = [await device(), await device()]
    vmc(live, 'vmc', ...vmcMessages({ A: 0.5 }))
    phone(live, 'ifacialmocap', ifacialmocapPacket({ jawOpen: 25 }))
    for (const { messages } of pages) {
      await vi.waitFor(() => expect(messages).toHaveLength(2))
      const frames = messages.map((message) => JSON.parse(message))
      expect(frames).toContainEqual({ source: 'vmc', time: expect.any(Number), scores: { A: 0.5 } })
      expect(frames).toContainEqual({
        source: 'ifacialmocap',
        time: expect.any(Number),
        scores: { jawOpen: 0.25 },
      })
    }
    expect(senders.sort()).toEqual(['ifacialmocap 127.0.0.1', 'vmc 127.0.0.1'])
  })

  it.each<[name: string, status: number, given: { token?: string; origin?: string | undefined }]>([
    ['a page of this computer', 101, {}],
    ['a program without an origin', 101, { origin: undefined }],
    ['a wrong token', 401, { token: 'secreT' }],
    ['no token', 401, { token: '' }],
    ['a page of another site', 403, { origin: 'https://evil.example' }],
    ['a page whose host begins with localhost', 403, { origin: 'http://localhost.evil.example' }],
    ['a sandboxed page', 403, { origin: 'null' }],
  ])('answers %s with %i', async (_, status, given) => {
    expect((await connect(await start(), given)).status).toBe(status)
  })

  it('refuses the ninth page, and ends a connection that sends anything', async () => {
    const live = await start()
    const pages = await Promise.all(Array.from({ length: 8 }, () => connect(live)))
    expect(pages.map(({ status }) => status)).toEqual(new Array(8).fill(101))
    expect((await connect(live)).status).toBe(503)
    for (const [{ socket }, message, code] of [
      [pages[0], 'hello', 1008],
      [pages[1], 'x'.repeat(5000), 1006],
    ] as const) {
      socket.send(message)
      expect((await once(socket, 'close'))[0]).toBeOneOf([code, 1009])
    }
    await vi.waitFor(async () => expect((await connect(live)).status).toBe(101))
  })

  it('follows one device per source, and ignores packets above the limits', async () => {
    const live = await start()
    const { messages } = await connect(live)
    const [first, second] = [await device(), await device()]
    first(live, 'ifacialmocap', ifacialmocapPacket({ jawOpen: 25 }))
    await vi.waitFor(() => expect(messages).toHaveLength(1))
    second(live, 'ifacialmocap', ifacialmocapPacket({ jawOpen: 75 }))
    const large = ifacialmocapPacket(
      Object.fromEntries(Array.from({ length: 900 }, (_, i) => [`shape${i}`, 1])),
    )
    expect(large.length).toBeGreaterThan(8192)
    first(live, 'ifacialmocap', large, ifacialmocapPacket({ jawOpen: 50 }))
    await vi.waitFor(() => expect(messages).toHaveLength(2))
    expect(messages.map((message) => JSON.parse(message).scores)).toEqual([
      { jawOpen: 0.25 },
      { jawOpen: 0.5 },
    ])
  })

  it('asks a phone with iFacialMocap to send', async () => {
    const phone = createSocket('udp4')
    phone.bind(49983, '127.0.0.2')
    await once(phone, 'listening')
    closing.push(() => phone.close())
    const request = once(phone, 'message')
    await start({ phone: '127.0.0.2', devices: '127.0.0.1' })
    expect(String((await request)[0])).toBe('iFacialMocap_sahuasouryya9218sauhuiayeta91555dy3719')
  })

  it('reports ports in use in one line, and closes the others', async () => {
    const live = await start()
    await expect(start({ port: live.port })).rejects.toThrow(/^furrow live: cannot listen for pages/)
    await expect(start({ ports: { ifacialmocap: live.ports.vmc! } })).rejects.toThrow(
      /^furrow live: cannot receive UDP packets, got .*EADDRINUSE/,
    )
  })
})
