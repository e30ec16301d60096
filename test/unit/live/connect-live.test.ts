import { once } from 'node:events'
import { connectLive, type LiveFrame } from 'furrow/live'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { WebSocket, WebSocketServer } from 'ws'

let server: WebSocketServer
let address: string

async function listen(port = 0) {
  server = new WebSocketServer({ host: '127.0.0.1', port })
  await once(server, 'listening')
  address = `ws://127.0.0.1:${(server.address() as { port: number }).port}/?token=x`
}

function stop() {
  for (const client of server.clients) client.terminate()
  server.close()
}

beforeEach(async () => {
  vi.stubGlobal('WebSocket', WebSocket)
  await listen()
})
afterEach(() => {
  stop()
  vi.unstubAllGlobals()
})

it('delivers frames, and ignores malformed messages', async () => {
  const frames: LiveFrame[] = []
  const connection = connectLive(address, (frame) => frames.push(frame))
  const [client] = await once(server, 'connection')
  const frame = { source: 'vmc', time: 1.5, scores: { jawOpen: 0.5 } }
  for (const message of [
    'x',
    'null',
    '{}',
    JSON.stringify({ ...frame, scores: { jawOpen: 'x' } }),
    JSON.stringify({ ...frame, time: null }),
    JSON.stringify({ ...frame, source: 'x'.repeat(70_000) }),
    JSON.stringify(frame),
  ]) {
    client.send(message)
  }
  client.send(new Uint8Array(4))
  client.send(JSON.stringify({ ...frame, time: 2 }))
  await vi.waitFor(() => expect(frames).toEqual([frame, { ...frame, time: 2 }]))
  connection.close()
  expect(connection.isConnected).toBe(false)
})

it('connects again after the connection was lost, until it is closed', async () => {
  const changes: boolean[] = []
  const { port } = server.address() as { port: number }
  const connection = connectLive(address, () => {}, { onChange: (isConnected) => changes.push(isConnected) })
  await vi.waitFor(() => expect(changes).toEqual([true]))
  stop()
  await vi.waitFor(() => expect(changes).toEqual([true, false]))
  await listen(port)
  await vi.waitFor(() => expect(changes).toEqual([true, false, true]), { timeout: 4000 })
  connection.close()
})

it.each([['http://localhost'], ['ws'], [null as never]])('refuses the address %s', (wrong) => {
  expect(() => connectLive(wrong, () => {})).toThrow(/^connectLive: invalid address/)
  expect(() => connectLive(address, null as never)).toThrow(/^connectLive: invalid onFrame/)
})
