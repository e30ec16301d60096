import { type Bridge, startBridge } from './bridge.ts'
import { IFACIALMOCAP_START } from './ifacialmocap.ts'
import { type Receiver, receive } from './receiver.ts'
import { SOURCES, type SourceName } from './sources.ts'

/** Milliseconds between requests to a phone with iFacialMocap. A request after the app was restarted makes it send again. */
const REQUEST_INTERVAL = 5000

export interface LiveOptions {
  /** Name of the command in errors. */
  who: string
  /** Address and TCP port for pages. */
  host: string
  port: number
  /** Address for packets of devices. */
  devices: string
  /** UDP ports by source. Sources without an entry are off. */
  ports: Partial<Record<SourceName, number>>
  /** Address of a phone with iFacialMocap, which sends only after a request. */
  phone?: string | undefined
  origins: readonly string[]
  token: string
  /** Called when a source sends its first frame, or another device sends. */
  onSender: (source: SourceName, sender: string) => void
}

/** A running bridge. `ports` are the open UDP ports. */
export interface Live {
  readonly port: number
  readonly ports: Partial<Record<SourceName, number>>
  close(): void
}

/**
 * Starts the bridge. Each frame is sent to all pages as JSON: `{ "source": "vmc", "time": 1.5, "scores": { "jawOpen": 0.5 } }`, with the time of
 * arrival in seconds.
 *
 * @throws FurrowError if a port is not available. All other ports are then closed again.
 */
export async function startLive({
  who,
  devices,
  ports,
  phone,
  onSender,
  ...options
}: LiveOptions): Promise<Live> {
  const bridge: Bridge = await startBridge({ who, ...options })
  const receivers = new Map<SourceName, Receiver>()
  let requests: NodeJS.Timeout | undefined
  const close = () => {
    clearInterval(requests)
    for (const receiver of receivers.values()) receiver.close()
    bridge.close()
  }
  try {
    for (const [source, port] of Object.entries(ports) as [SourceName, number][]) {
      let known = ''
      const receiver = await receive(SOURCES[source], { address: devices, port, who }, (scores, sender) => {
        if (sender !== known) onSender(source, sender)
        known = sender
        bridge.send(JSON.stringify({ source, time: performance.now() / 1000, scores }))
      })
      receivers.set(source, receiver)
    }
  } catch (error) {
    close()
    throw error
  }
  const receiver = receivers.get('ifacialmocap')
  if (phone !== undefined && receiver) {
    const request = () => receiver.send(IFACIALMOCAP_START, SOURCES.ifacialmocap.port, phone)
    requests = setInterval(request, REQUEST_INTERVAL)
    request()
  }
  return {
    port: bridge.port,
    ports: Object.fromEntries([...receivers].map(([name, { port }]) => [name, port])),
    close,
  }
}
