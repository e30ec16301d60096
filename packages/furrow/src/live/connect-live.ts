import { isObject, wrongArgument } from '../core/argument.ts'

/** Scores of one frame. */
export interface LiveFrame {
  /** Name of the source, such as `vmc`. */
  source: string
  /** Time at which the frame arrived at `furrow live`, seconds since it started. */
  time: number
  /** Scores by blendshape name, for `FaceTracker.set`. Most are 0..1. */
  scores: Readonly<Record<string, number>>
}

/** Options of `connectLive`. */
export interface LiveOptions {
  /** Called when the connection opens or is lost. */
  onChange?: (isConnected: boolean) => void
}

/** A connection to `furrow live`. */
export interface LiveConnection {
  /** Whether the connection is open. */
  readonly isConnected: boolean
  /** Ends the connection. */
  close(): void
}

const WHO = 'connectLive'

/** Delays before attempts to connect again, milliseconds. The last one repeats. */
const DELAYS = [500, 1000, 2000, 5000]

/** Maximum length of a message in characters, and maximum number of scores in it. */
const MAX_MESSAGE = 65_536
const MAX_SCORES = 512

/**
 * Connects to `furrow live`, and connects again when the connection is lost. Malformed messages are ignored.
 *
 * @param address address that `furrow live` prints, such as `ws://127.0.0.1:8765/?token=...`.
 * @param onFrame called for each frame.
 * @throws FurrowError if `address` is not an address of a WebSocket.
 * @example
 * connectLive('ws://127.0.0.1:8765/?token=...', ({ scores, time }) => tracker.set(scores, time))
 */
export function connectLive(
  address: string,
  onFrame: (frame: LiveFrame) => void,
  { onChange = () => {} }: LiveOptions = {},
): LiveConnection {
  if (!URL.canParse(address) || !/^wss?:$/.test(new URL(address).protocol)) {
    throw wrongArgument(WHO, 'address', address, 'a ws:// or wss:// address as furrow live prints it')
  }
  if (typeof onFrame !== 'function') throw wrongArgument(WHO, 'onFrame', onFrame, 'a function')
  let failures = 0
  let isConnected = false
  let timer: ReturnType<typeof setTimeout> | undefined
  let socket = open()

  function open(): WebSocket {
    const opened = new WebSocket(address)
    opened.onopen = () => {
      failures = 0
      isConnected = true
      onChange(true)
    }
    opened.onmessage = ({ data }) => {
      const frame = readFrame(data)
      if (frame) onFrame(frame)
    }
    opened.onclose = () => {
      const wasConnected = isConnected
      isConnected = false
      timer = setTimeout(
        () => {
          socket = open()
        },
        DELAYS[Math.min(failures++, DELAYS.length - 1)],
      )
      if (wasConnected) onChange(false)
    }
    return opened
  }

  return {
    get isConnected() {
      return isConnected
    },
    close() {
      clearTimeout(timer)
      socket.onopen = socket.onmessage = socket.onclose = null
      socket.close()
      isConnected = false
    },
  }
}

/** Parses a message. Returns undefined if it is no frame. */
function readFrame(data: unknown): LiveFrame | undefined {
  if (typeof data !== 'string' || data.length > MAX_MESSAGE) return undefined
  let value: unknown
  try {
    value = JSON.parse(data)
  } catch {
    return undefined
  }
  if (!isObject(value)) return undefined
  const { source, time, scores } = value as Partial<LiveFrame>
  if (typeof source !== 'string' || !Number.isFinite(time) || !isObject(scores)) return undefined
  const numbers = Object.values(scores)
  if (numbers.length > MAX_SCORES || !numbers.every(Number.isFinite)) return undefined
  return { source, time: time!, scores }
}
