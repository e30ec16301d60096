import { createSocket, type Socket } from 'node:dgram'
import { once } from 'node:events'
import { FurrowError } from 'furrow'
import type { LiveSource, PacketReader, Scores } from './source.ts'

/** Maximum size of a packet in bytes. */
const MAX_PACKET = 8192

/** Maximum number of packets per second. VMC can send one packet for each blendshape and bone. */
const MAX_PACKETS = 10_000

/** Maximum number of frames per second that are passed on. */
const MAX_FRAMES = 240

/** Seconds without packets after which another sender may take over. */
const SENDER_TIMEOUT = 2

/** An open UDP port of a source. */
export interface Receiver {
  readonly port: number
  /** Sends text to a device, from the port of the receiver. */
  send(text: string, port: number, address: string): void
  close(): void
}

/**
 * Receives the packets of one sender at a time. Larger packets, further senders, and packets above the limit per second are ignored.
 *
 * @param address address of this computer at which packets are accepted.
 * @param port UDP port; 0 for any free port.
 * @param onFrame called with the scores of each frame and the address of the sender.
 * @throws FurrowError if the port is not available.
 */
export async function receive(
  source: LiveSource,
  { address, port, who }: { address: string; port: number; who: string },
  onFrame: (scores: Scores, sender: string) => void,
): Promise<Receiver> {
  const socket = createSocket(address.includes(':') ? 'udp6' : 'udp4')
  await bind(socket, address, port, who)
  socket.on('error', () => {})
  let sender = ''
  let reader: PacketReader = source.createReader()
  let last = Number.NEGATIVE_INFINITY
  const packets = new Limit(MAX_PACKETS)
  const frames = new Limit(MAX_FRAMES)
  socket.on('message', (packet, from) => {
    const now = performance.now() / 1000
    if (packet.byteLength > MAX_PACKET || !packets.allows(now)) return
    const name = `${from.address}:${from.port}`
    if (name !== sender) {
      if (now - last < SENDER_TIMEOUT) return
      const other = source.createReader()
      sender = name
      reader = other
    }
    last = now
    const scores = reader(packet)
    if (scores && frames.allows(now)) onFrame(scores, from.address)
  })
  return {
    port: socket.address().port,
    send: (text, toPort, toAddress) => socket.send(text, toPort, toAddress, () => {}),
    close: () => socket.close(),
  }
}

async function bind(socket: Socket, address: string, port: number, who: string): Promise<void> {
  try {
    socket.bind(port, address)
    await once(socket, 'listening')
  } catch (error) {
    socket.close()
    throw new FurrowError(
      {
        code: 'unsupported',
        who,
        problem: 'cannot receive UDP packets',
        value: `${address}:${port}: ${(error as Error).message}`,
        remedy: 'end the program that uses the port, or choose another port with --udp-port',
      },
      { cause: error },
    )
  }
}

/** Counts events in each second. */
class Limit {
  readonly #perSecond: number
  #second = 0
  #count = 0

  constructor(perSecond: number) {
    this.#perSecond = perSecond
  }

  /** @param now time in seconds. */
  allows(now: number): boolean {
    const second = Math.floor(now)
    if (second !== this.#second) {
      this.#second = second
      this.#count = 0
    }
    return ++this.#count <= this.#perSecond
  }
}
