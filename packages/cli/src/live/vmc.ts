import { decode } from 'node-osc'
import {
  finiteOrNull,
  type LiveSource,
  MAX_NAME,
  MAX_SCORES,
  type PacketReader,
  type Scores,
} from './source.ts'

/** Decoded packet. The library has no types for it. */
type Packet =
  | { oscType: 'bundle'; elements: Packet[] }
  | { oscType: 'message'; address: string; args: { value: unknown }[] }

/** Maximum nesting of OSC bundles. */
const MAX_DEPTH = 4

/**
 * Virtual Motion Capture protocol, over Open Sound Control: `/VMC/Ext/Blend/Val (string)name (float)value` for each blendshape, then
 * `/VMC/Ext/Blend/Apply`. Other messages are ignored. Source: https://protocol.vmc.info/marionette-spec.html.
 */
export const VMC: LiveSource = { port: 39539, createReader }

function createReader(): PacketReader {
  // Values stay until they are sent again, because some programs send only changes.
  const scores = new Map<string, number>()
  let frame: Scores | null = null
  const read = (packet: Packet, depth: number) => {
    if (packet.oscType === 'bundle') {
      if (depth < MAX_DEPTH) for (const element of packet.elements) read(element, depth + 1)
    } else if (packet.address === '/VMC/Ext/Blend/Val') {
      const [name, value] = packet.args.map((argument) => argument.value)
      if (typeof name !== 'string' || typeof value !== 'number' || name.length > MAX_NAME) return
      if (scores.size < MAX_SCORES || scores.has(name)) scores.set(name, value)
    } else if (packet.address === '/VMC/Ext/Blend/Apply') {
      frame = finiteOrNull(Object.fromEntries(scores))
    }
  }
  return (packet) => {
    frame = null
    try {
      read(decode(Buffer.from(packet)) as Packet, 0)
    } catch {
      return null
    }
    return frame
  }
}
